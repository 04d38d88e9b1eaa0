//! Tables: texts in columns under a heading, each row behind a symbol.

use super::canvas::{Anchor, Canvas};
use super::font::text_width;
use super::geometry::Point;
use super::ink::{FAINT_INK, INK};
use super::rows::lines;

const SIZE: f64 = 11.0;
const LINE: f64 = 17.0;
/// Between columns.
const GAP: f64 = 14.0;
/// Between rows of several lines.
const APART: f64 = 4.0;

/// Rows of texts, each with a symbol before it.
pub(crate) struct Table<S> {
    heading: Row,
    rows: Vec<(S, Row)>,
    /// What is told of the rows or columns for which there is no room.
    rest: Option<String>,
    width: f64,
}

/// The lines of a row, each with what stands in it and where that begins.
struct Row(Vec<Vec<(f64, String)>>);

impl<S> Table<S> {
    /// A table whose symbols are `symbol` pixels wide. Columns for which `room` pixels are too few stand below the first.
    pub(crate) fn new(symbol: f64, heading: Vec<String>, rows: Vec<(S, Vec<String>)>, room: f64) -> Self {
        let left = symbol + GAP / 2.0;
        let mut columns: Vec<Vec<f64>> = Vec::new();
        let [mut x, mut width] = [left; 2];
        for (place, name) in heading.iter().enumerate() {
            let cells = rows.iter().filter_map(|(_, cells)| cells.get(place));
            let wide = cells.map(|cell| text_width(cell, SIZE)).fold(text_width(name, SIZE), f64::max);
            match columns.last_mut() {
                Some(line) if x + wide <= room => line.push(x),
                _ => {
                    x = left;
                    columns.push(vec![x]);
                }
            }
            width = width.max((x + wide).min(room.max(left)));
            x += wide + GAP;
        }
        let row = |cells: Vec<String>| Row::new(cells, &columns, room);
        Self {
            heading: row(heading),
            rows: rows.into_iter().map(|(symbol, cells)| (symbol, row(cells))).collect(),
            rest: None,
            width,
        }
    }

    /// The rows for which `room` pixels are high enough, and a line that tells how many there are besides.
    pub(crate) fn shortened(mut self, room: f64, tell: impl Fn(usize) -> String) -> Self {
        if self.height() > room {
            let mut height = self.heading.height() + LINE;
            let fits = self.rows.iter().take_while(|(_, row)| {
                height += row.height();
                height <= room
            });
            let fits = fits.count().max(1);
            let rest = self.rows.len() - fits;
            self.rows.truncate(fits);
            self.rest = (rest > 0).then(|| tell(rest));
        }
        self
    }

    /// The same with a last line.
    pub(crate) fn told(self, rest: &str) -> Self {
        Self { rest: Some(rest.to_owned()), ..self }
    }

    pub(crate) fn width(&self) -> f64 {
        self.width
    }

    /// Nothing where there are no rows.
    pub(crate) fn height(&self) -> f64 {
        if self.rows.is_empty() {
            return 0.0;
        }
        let rest = if self.rest.is_some() { LINE } else { 0.0 };
        self.heading.height() + self.rows.iter().map(|(_, row)| row.height()).sum::<f64>() + rest
    }

    /// Draws the table with its top left corner at `at`, and each symbol with `paint` from the middle of its left side.
    pub(crate) fn draw(&self, canvas: &Canvas, at: Point, paint: impl Fn(&S, Point)) {
        if self.rows.is_empty() {
            return;
        }
        let text = |row: &Row, top: f64, color| {
            for (number, line) in row.0.iter().enumerate() {
                let base = top + number as f64 * LINE + 0.5 * LINE + 0.36 * SIZE;
                for (x, cell) in line {
                    canvas.text(cell, [at[0] + x, base], SIZE, color, Anchor::Start);
                }
            }
        };
        text(&self.heading, at[1], FAINT_INK);
        let mut top = at[1] + self.heading.height();
        for (symbol, row) in &self.rows {
            paint(symbol, [at[0], top + 0.5 * LINE]);
            text(row, top, INK);
            top += row.height();
        }
        if let Some(rest) = &self.rest {
            canvas.text(rest, [at[0], top + 0.5 * LINE + 0.36 * SIZE], SIZE, FAINT_INK, Anchor::Start);
        }
    }
}

impl Row {
    /// Cells at their columns: what is too wide for a line of its own goes on below.
    fn new(cells: Vec<String>, columns: &[Vec<f64>], room: f64) -> Self {
        let mut cells = cells.into_iter();
        let mut all = Vec::new();
        for line in columns {
            let mut own: Vec<Vec<(f64, String)>> = Vec::new();
            for (x, cell) in line.iter().zip(&mut cells) {
                for (number, part) in lines(&cell, SIZE, room - x).into_iter().enumerate() {
                    if number == own.len() {
                        own.push(Vec::new());
                    }
                    own[number].push((*x, part));
                }
            }
            all.extend(own);
        }
        Self(all)
    }

    fn height(&self) -> f64 {
        self.0.len() as f64 * LINE + if self.0.len() > 1 { APART } else { 0.0 }
    }
}
