//! Tables: texts in columns under a heading, each row behind a symbol.

use super::canvas::{Anchor, Canvas};
use super::font::text_width;
use super::geometry::Point;
use super::ink::{FAINT_INK, INK};

const SIZE: f64 = 11.0;
const ROW: f64 = 17.0;
/// Between columns.
const GAP: f64 = 14.0;

/// Rows of texts, each with a symbol before it.
pub(crate) struct Table<S> {
    heading: Vec<String>,
    rows: Vec<(S, Vec<String>)>,
    /// Where the columns begin.
    columns: Vec<f64>,
    width: f64,
}

impl<S> Table<S> {
    /// A table whose symbols are `symbol` pixels wide.
    pub(crate) fn new(symbol: f64, heading: Vec<String>, rows: Vec<(S, Vec<String>)>) -> Self {
        let mut columns = Vec::new();
        let mut x = symbol + GAP / 2.0;
        for (place, name) in heading.iter().enumerate() {
            columns.push(x);
            let cells = rows.iter().filter_map(|(_, cells)| cells.get(place));
            x += cells.map(|cell| text_width(cell, SIZE)).fold(text_width(name, SIZE), f64::max) + GAP;
        }
        Self { heading, rows, columns, width: x - GAP }
    }

    pub(crate) fn width(&self) -> f64 {
        self.width
    }

    /// Nothing where there are no rows.
    pub(crate) fn height(&self) -> f64 {
        if self.rows.is_empty() { 0.0 } else { (self.rows.len() + 1) as f64 * ROW }
    }

    /// Draws the table with its top left corner at `at`, and each symbol with `paint` from the middle of its left side.
    pub(crate) fn draw(&self, canvas: &Canvas, at: Point, paint: impl Fn(&S, Point)) {
        if self.rows.is_empty() {
            return;
        }
        let line = |cells: &[String], row: usize, color| {
            let base = at[1] + row as f64 * ROW + 0.5 * ROW + 0.36 * SIZE;
            for (cell, x) in cells.iter().zip(&self.columns) {
                canvas.text(cell, [at[0] + x, base], SIZE, color, Anchor::Start);
            }
        };
        line(&self.heading, 0, FAINT_INK);
        for (number, (symbol, cells)) in self.rows.iter().enumerate() {
            paint(symbol, [at[0], at[1] + (number + 1) as f64 * ROW + 0.5 * ROW]);
            line(cells, number + 1, INK);
        }
    }
}
