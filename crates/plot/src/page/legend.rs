//! Legends: symbols with their names, in rows.

use super::canvas::{Anchor, Canvas};
use super::font::text_width;
use super::geometry::Point;
use super::ink::INK;
use super::rows::Rows;

const SIZE: f64 = 11.5;
/// Between a symbol and its name, and behind the name.
const GAP: f64 = 7.0;
const BETWEEN: f64 = 22.0;
const ROW: f64 = 20.0;

/// The entries of a legend.
pub(crate) struct Legend<S> {
    entries: Vec<(S, String)>,
    symbol_width: fn(&S) -> f64,
    rows: Rows,
}

impl<S> Legend<S> {
    /// Entries in rows of `width` pixels.
    pub(crate) fn new(entries: Vec<(S, String)>, symbol_width: fn(&S) -> f64, width: f64) -> Self {
        let widths = entries.iter().map(|(symbol, name)| symbol_width(symbol) + GAP + text_width(name, SIZE));
        let rows = Rows::new(widths, BETWEEN, width, ROW);
        Self { entries, symbol_width, rows }
    }

    /// Width of the widest entry.
    pub(crate) fn widest(&self) -> f64 {
        let width = |(symbol, name): &(S, String)| (self.symbol_width)(symbol) + GAP + text_width(name, SIZE);
        self.entries.iter().map(width).fold(0.0, f64::max)
    }

    pub(crate) fn height(&self) -> f64 {
        self.rows.height
    }

    /// The middle of the left side of each symbol, for a legend whose top left corner is `at`.
    pub(crate) fn symbols(&self, at: Point) -> impl Iterator<Item = (&S, Point)> {
        let place = move |corner: &Point| [at[0] + corner[0], at[1] + corner[1] + ROW / 2.0];
        self.entries.iter().map(|(symbol, _)| symbol).zip(self.rows.corners.iter().map(place))
    }

    /// Draws each symbol with `paint`, and its name.
    pub(crate) fn draw(&self, canvas: &Canvas, at: Point, paint: impl Fn(&S, Point)) {
        for ((symbol, [x, middle]), (_, name)) in self.symbols(at).zip(&self.entries) {
            paint(symbol, [x, middle]);
            let base = [x + (self.symbol_width)(symbol) + GAP, middle + 0.36 * SIZE];
            canvas.text(name, base, SIZE, INK, Anchor::Start);
        }
    }
}
