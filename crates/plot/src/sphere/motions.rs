//! The table of the relative equilibria: where each stands, whether it is stable, and how fast what starts beside it moves.

use schema::{Multiplicity, RelativeEquilibriumDocument, small_motions};

use super::marks::{self, MARK, Mark, letter};
use super::scene::SphereScene;
use crate::page::{Canvas, Point, Table, short_number, short_time};

const DIGITS: usize = 5;

/// One row for each relative equilibrium, `room` pixels wide.
pub(super) fn table(scene: &SphereScene<'_>, room: f64) -> Table<Mark> {
    let times = if scene.time_unit.is_empty() { String::new() } else { format!(" in {}", scene.time_unit) };
    let heading = ["", "relative equilibrium", "h", "of U", "linear type", "stable"].map(str::to_owned);
    let motions = format!("period of small oscillations, growth by the factor e{times}");
    let heading = heading.into_iter().chain([motions]).collect();
    let rows = scene.equilibria.iter().enumerate().map(|(place, point)| {
        let cells = [
            letter(place),
            format!("{}, {}", point.branch, point.branch_name),
            short_number(point.h, DIGITS),
            kind(point).to_owned(),
            point.stability.word().to_owned(),
            point.stable.word().to_owned(),
            small_motions(&[point.eigenvalues], short_time),
        ];
        (Mark::Equilibrium(point.index), cells.to_vec())
    });
    Table::new(2.0 * MARK, heading, rows.collect(), room)
}

fn kind(point: &RelativeEquilibriumDocument) -> &'static str {
    match (point.multiplicity, point.index) {
        (Multiplicity::Sphere, _) => "constant",
        (Multiplicity::Circle, 0) => "circle of minima",
        (Multiplicity::Circle, _) => "circle of maxima",
        (Multiplicity::Points(_), 0) => "minimum",
        (Multiplicity::Points(_), 1) => "saddle",
        (Multiplicity::Points(_), _) => "maximum",
    }
}

/// Draws the table with its top left corner at `at`.
pub(super) fn draw(table: &Table<Mark>, canvas: &Canvas, at: Point) {
    table.draw(canvas, at, |mark, [x, middle]| marks::draw(canvas, *mark, [x + MARK, middle]));
}
