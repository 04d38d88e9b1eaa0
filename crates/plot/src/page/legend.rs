//! Legends: symbols with their names, in rows.

use super::canvas::{Anchor, Canvas};
use super::font::text_width;
use super::geometry::Point;
use super::ink::INK;
use super::rows::{Rows, lines};

const SIZE: f64 = 11.5;
/// Between a symbol and its name, and behind the name.
const GAP: f64 = 7.0;
const BETWEEN: f64 = 22.0;
const ROW: f64 = 20.0;
/// Between lines of one name.
const LINE: f64 = 15.0;

/// The entries of a legend.
pub(crate) struct Legend<S> {
    /// Symbols with the lines of their names.
    entries: Vec<(S, Vec<String>)>,
    symbol_width: fn(&S) -> f64,
    rows: Rows,
    widest: f64,
}

impl<S> Legend<S> {
    /// Entries in rows of `width` pixels; a name that is longer is broken into lines.
    pub(crate) fn new(entries: Vec<(S, String)>, symbol_width: fn(&S) -> f64, width: f64) -> Self {
        let before = |symbol: &S| symbol_width(symbol) + GAP;
        let widest = entries.iter().map(|(symbol, name)| before(symbol) + text_width(name, SIZE)).fold(0.0, f64::max);
        let broken = |(symbol, name): (S, String)| {
            let names = lines(&name, SIZE, width - before(&symbol));
            (symbol, names)
        };
        let entries: Vec<(S, Vec<String>)> = entries.into_iter().map(broken).collect();
        let sizes = entries.iter().map(|(symbol, names)| {
            let wide = names.iter().map(|name| text_width(name, SIZE)).fold(0.0, f64::max);
            [before(symbol) + wide, ROW + (names.len() - 1) as f64 * LINE]
        });
        let rows = Rows::new(sizes, BETWEEN, width);
        Self { entries, symbol_width, rows, widest }
    }

    /// Width of the widest entry in one line.
    pub(crate) fn widest(&self) -> f64 {
        self.widest
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
        for ((symbol, [x, middle]), (_, names)) in self.symbols(at).zip(&self.entries) {
            paint(symbol, [x, middle]);
            for (number, name) in names.iter().enumerate() {
                let base = [x + (self.symbol_width)(symbol) + GAP, middle + 0.36 * SIZE + number as f64 * LINE];
                canvas.text(name, base, SIZE, INK, Anchor::Start);
            }
        }
    }
}
