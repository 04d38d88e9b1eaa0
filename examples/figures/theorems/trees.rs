//! Figure 4 of docs/mathematics.md: the trees of Proposition 9.5 of all accessible regions that are not excluded (Proposition
//! 11.9).

use std::f64::consts::TAU;

use bifdiag_diagram::topology::accessible_regions;
use bifdiag_plot::page::{Anchor, Canvas, INK, Ink, Picture, PlotError, Point, Theme, render, rgb};

const COLUMNS: usize = 6;
const CELL: [f64; 2] = [96.0, 116.0];
/// Length of an edge.
const EDGE: f64 = 28.0;
const TEXT: f64 = 13.0;
const LINE: Ink = Ink { color: INK, width: 1.4 };

/// Numbers of boundary circles of the components, each list once.
fn circles() -> Vec<Vec<u32>> {
    let mut all: Vec<Vec<u32>> = accessible_regions()
        .iter()
        .map(|region| region.iter().map(|component| component.boundary_circles).collect())
        .collect();
    for list in &mut all {
        list.sort_unstable();
    }
    all.sort_by_key(|list| (list.len(), list.iter().sum::<u32>()));
    all.dedup();
    all
}

fn name(circles: &[u32]) -> String {
    match circles {
        [0] => "S²".to_owned(),
        [1] => "disc".to_owned(),
        [2] => "annulus".to_owned(),
        [k] => format!("k = {k}"),
        [1, 2] => "disc, annulus".to_owned(),
        discs => format!("{} discs", discs.len()),
    }
}

/// A component of the accessible region, filled, or of its complement.
fn vertex(canvas: &Canvas, at: Point, is_accessible: bool) {
    canvas.disc(at, 6.0, INK);
    if !is_accessible {
        canvas.disc(at, 4.4, rgb(0xff_ff_ff));
    }
}

/// A vertex with others around it, in which the two kinds take turns.
fn star(canvas: &Canvas, center: Point, rays: u32, is_accessible: bool) {
    let end = |k: u32| {
        let (sin, cos) = libm::sincos(TAU * (f64::from(k) / f64::from(rays) - 0.25));
        [center[0] + EDGE * cos, center[1] + EDGE * sin]
    };
    let ends: Vec<Point> = (0..rays).map(end).collect();
    for end in &ends {
        canvas.path(&[center, *end], LINE);
    }
    for end in ends {
        vertex(canvas, end, !is_accessible);
    }
    vertex(canvas, center, is_accessible);
}

pub(super) fn draw(theme: Theme) -> Result<Picture, PlotError> {
    let all = circles();
    let rows = all.len().div_ceil(COLUMNS);
    #[allow(clippy::cast_precision_loss)]
    let size = [CELL[0] * COLUMNS as f64, CELL[1] * rows as f64];
    render(size, "Trees of components", theme, |canvas| {
        for (number, list) in all.iter().enumerate() {
            #[allow(clippy::cast_precision_loss)]
            let [column, row] = [number % COLUMNS, number / COLUMNS].map(|k| k as f64);
            let center = [CELL[0] * (column + 0.5), CELL[1] * row + 46.0];
            match list[..] {
                [1, 2] => {
                    let at = |k: u32| [center[0] + EDGE * (f64::from(k) - 1.5), center[1]];
                    canvas.path(&[at(0), at(3)], LINE);
                    for k in 0..4 {
                        vertex(canvas, at(k), k % 2 == 0);
                    }
                }
                [k] => star(canvas, center, k, true),
                _ => star(canvas, center, u32::try_from(list.len()).unwrap_or(u32::MAX), false),
            }
            canvas.text(&name(list), [center[0], center[1] + 56.0], TEXT, INK, Anchor::Middle);
        }
    })
}
