//! The one legend: symbols with their texts, in rows. The same symbols precede the rows of tables.

use plotters::style::RGBColor;

use super::canvas::{Anchor, Canvas};
use super::color::{FAINT_INK, INK, Ink};
use super::geometry::{Point, Rect};
use super::path::{Dash, Path};
use super::text::{lines, text_width, widest};

const SIZE: f64 = 11.5;
/// Between a symbol and its text, and behind the text.
const GAP: f64 = 7.0;
const BETWEEN: f64 = 22.0;
const ROW: f64 = 20.0;
/// Between lines of one text.
const LINE: f64 = 15.0;
/// Height of a swatch.
const SWATCH: f64 = 12.0;

/// Draws something round a point.
type DrawMark = dyn Fn(&Canvas, Point);

/// What a text explains.
pub enum Symbol {
    /// A text without a symbol.
    None,
    /// An area in one colour, or in stripes of several.
    Swatch(Vec<RGBColor>),
    /// A line in a pattern, of this width.
    Line(Vec<Dash>, f64),
    /// Dots side by side, one in each colour.
    Dots(Vec<RGBColor>),
    /// What draws itself round a point, and what its shape is called.
    Mark(&'static str, Box<DrawMark>),
}

impl Symbol {
    /// A solid line.
    #[must_use]
    pub fn solid(ink: Ink) -> Self {
        Self::Line(vec![(Some(ink.color), 1.0)], ink.width)
    }

    /// The room that it takes before its text, in pixels.
    #[must_use]
    pub fn width(&self) -> f64 {
        match self {
            Self::None => 0.0,
            Self::Swatch(_) => 15.0,
            Self::Line(..) => 30.0,
            Self::Dots(_) => 26.0,
            Self::Mark(..) => 13.0,
        }
    }

    /// Draws the symbol from the middle of its left side.
    pub fn draw(&self, canvas: &Canvas, [x, y]: Point) {
        let width = self.width();
        match self {
            Self::None => {}
            Self::Swatch(colors) => {
                let rect = Rect { x, y: y - SWATCH / 2.0, width, height: SWATCH };
                let mut path = Path::default();
                path.line(&rect.corners(), true);
                canvas.draw(&path, &canvas.fill_striped(colors));
                canvas.outline(&rect.corners(), Ink { color: FAINT_INK, width: 0.6 });
            }
            Self::Line(pattern, thickness) => canvas.dashed(&[[x, y], [x + width, y]], pattern, *thickness),
            Self::Dots(colors) => {
                let step = width / colors.len() as f64;
                for (place, color) in colors.iter().enumerate() {
                    canvas.disc([x + step * (place as f64 + 0.5), y], 2.2, *color);
                }
            }
            Self::Mark(_, mark) => mark(canvas, [x + width / 2.0, y]),
        }
    }
}

/// Texts with their symbols.
pub struct Legend {
    /// Symbols with the lines of their texts.
    entries: Vec<(Symbol, Vec<String>)>,
    rows: Rows,
    widest: f64,
}

impl Legend {
    /// Entries in rows of `width` pixels; a text that is longer is broken into lines.
    pub fn new(entries: Vec<(Symbol, String)>, width: f64) -> Self {
        let before = |symbol: &Symbol| text_at(symbol);
        let widest_entry = entries.iter().map(|(symbol, text)| before(symbol) + text_width(text, SIZE));
        let widest_entry = widest_entry.fold(0.0, f64::max);
        let broken = |(symbol, text): (Symbol, String)| {
            let texts = lines(&text, SIZE, width - before(&symbol));
            (symbol, texts)
        };
        let entries: Vec<(Symbol, Vec<String>)> = entries.into_iter().map(broken).collect();
        let size = |(symbol, texts): &(Symbol, Vec<String>)| {
            [before(symbol) + widest(texts, SIZE), ROW + (texts.len() - 1) as f64 * LINE]
        };
        let rows = Rows::new(entries.iter().map(size), BETWEEN, width);
        Self { entries, rows, widest: widest_entry }
    }

    /// Width of the widest entry in one line.
    #[must_use]
    pub fn widest(&self) -> f64 {
        self.widest
    }

    /// Of all rows, in pixels.
    #[must_use]
    pub fn height(&self) -> f64 {
        self.rows.height
    }

    /// Symbols with their texts.
    pub fn entries(&self) -> impl Iterator<Item = (&Symbol, String)> {
        self.entries.iter().map(|(symbol, texts)| (symbol, texts.join(" ")))
    }

    /// Draws the legend with its top left corner at `at`.
    pub fn draw(&self, canvas: &Canvas, at: Point) {
        for ((symbol, texts), corner) in self.entries.iter().zip(&self.rows.corners) {
            let [x, middle] = [at[0] + corner[0], at[1] + corner[1] + ROW / 2.0];
            symbol.draw(canvas, [x, middle]);
            for (number, text) in texts.iter().enumerate() {
                let base = [x + text_at(symbol), middle + 0.36 * SIZE + number as f64 * LINE];
                canvas.text(text, base, SIZE, INK, Anchor::Start);
            }
        }
    }
}

/// Where the text of a symbol begins.
fn text_at(symbol: &Symbol) -> f64 {
    if symbol.width() > 0.0 { symbol.width() + GAP } else { 0.0 }
}

/// Entries in rows.
pub struct Rows {
    /// Top left corner of each entry, relative to that of the first.
    pub corners: Vec<Point>,
    /// Height of all rows.
    pub height: f64,
}

impl Rows {
    /// Entries of the given widths and heights with `between` pixels between neighbours, as many in each row as `width`
    /// holds; a row is as high as its highest entry.
    pub fn new(entries: impl IntoIterator<Item = [f64; 2]>, between: f64, width: f64) -> Self {
        let [mut x, mut y, mut high] = [0.0_f64; 3];
        let mut corners = Vec::new();
        for [wide, own] in entries {
            if x > 0.0 && x + wide > width {
                (x, y, high) = (0.0, y + high, 0.0);
            }
            corners.push([x, y]);
            x += wide + between;
            high = high.max(own);
        }
        Self { corners, height: y + high }
    }
}
