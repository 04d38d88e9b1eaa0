//! The table of the relative equilibria: where each stands, whether it is stable, and how fast what starts beside it moves.

use bifdiag_schema::{Multiplicity, RelativeEquilibriumDocument, small_motions};

use super::marks::{self, MARK, Mark, letter};
use super::scene::SphereScene;
use crate::page::{Canvas, Point, Table, short_number, short_time};

/// Significant digits of an energy, at least and at most.
const DIGITS: [usize; 2] = [5, 12];
/// Energies are equal when they differ by less, relative to the largest: those of pairs do by rounding.
const EQUAL: f64 = 1e-11;

/// As many digits as tell different energies apart, rising as they are given.
fn energies(h: &[f64]) -> Vec<String> {
    let largest = h.iter().fold(0.0_f64, |largest, h| largest.max(h.abs()));
    let printed = |digits: usize| h.iter().map(|h| short_number(*h, digits)).collect::<Vec<_>>();
    let are_apart = |texts: &Vec<String>| {
        let mut pairs = h.windows(2).zip(texts.windows(2));
        pairs.all(|(h, texts)| h[1] - h[0] <= EQUAL * largest || texts[0] != texts[1])
    };
    (DIGITS[0]..DIGITS[1]).map(printed).find(are_apart).unwrap_or_else(|| printed(DIGITS[1]))
}

/// Columns that are left out where all would be too high, the least first: from which on, and what is told of them.
const LEFT_OUT: [(usize, &str); 2] =
    [(6, "periods and growth: bifdiag critical tells them"), (4, "types and stability: bifdiag critical tells them")];

/// One row for each relative equilibrium, as each has its letter in the views, and as many columns as find room.
pub(super) fn table(scene: &SphereScene<'_>, [width, height]: [f64; 2]) -> Table<Mark> {
    let full = columns(scene, width, usize::MAX);
    let shorter = LEFT_OUT.into_iter().map(|(count, told)| columns(scene, width, count).told(told));
    let mut last = full;
    for table in shorter {
        if last.height() <= height {
            break;
        }
        last = table;
    }
    last
}

/// The first columns of the table.
fn columns(scene: &SphereScene<'_>, room: f64, count: usize) -> Table<Mark> {
    let times = if scene.time_unit.is_empty() { String::new() } else { format!(" in {}", scene.time_unit) };
    let heading = ["", "relative equilibrium", "h", "of U", "linear type", "stable"].map(str::to_owned);
    let motions = format!("period of small oscillations, growth by the factor e{times}");
    let heading = heading.into_iter().chain([motions]).take(count).collect();
    let h: Vec<f64> = scene.equilibria.iter().map(|point| point.h).collect();
    let rows = scene.equilibria.iter().zip(energies(&h)).enumerate().map(|(place, (point, h))| {
        let cells = [
            letter(place),
            format!("{}, {}", point.branch, point.branch_name),
            h,
            kind(point).to_owned(),
            point.stability.word().to_owned(),
            point.stable.word().to_owned(),
            small_motions(&[point.eigenvalues], short_time),
        ];
        (Mark::Equilibrium(point.index), cells.into_iter().take(count).collect())
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn energies_have_the_digits_that_tell_them_apart() {
        assert_eq!(energies(&[1.0 / 3.0, 2.0 / 3.0]), ["0.33333", "0.66667"]);
        assert_eq!(energies(&[-1.0, 1.793_331_2, 1.793_331_9]), ["−1", "1.793331", "1.793332"]);
        // A pair, equal but for rounding.
        assert_eq!(energies(&[0.1 + 0.2, 0.3 + 1e-15]), ["0.3", "0.3"]);
    }
}
