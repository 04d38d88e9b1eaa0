//! Tables: texts in columns under a heading, each row behind a symbol.

use std::ops::Range;

use plotters::style::RGBColor;

use super::canvas::{Anchor, Canvas};
use super::color::{FAINT_INK, INK};
use super::geometry::Point;
use super::legend::Symbol;
use super::text::{lines, widest};

const SIZE: f64 = 11.0;
/// Heights of lines, and distances of columns, of a table and of a dense one.
const LINE: [f64; 2] = [17.0, 15.0];
const GAP: [f64; 2] = [14.0, 5.0];
/// Between rows of several lines.
const APART: f64 = 4.0;

/// Rows of texts, each with a symbol before it.
pub struct Table {
    /// Nothing where no column has a name.
    heading: Row,
    rows: Vec<(Symbol, Row)>,
    /// A last line, about columns that are left out.
    rest: Option<String>,
    width: f64,
    line: f64,
}

/// The lines of a row, each with its cells and where these begin.
struct Row(Vec<Vec<(f64, String)>>);

impl Table {
    /// A table in `room` pixels. Columns that do not fit are placed below the first.
    #[must_use]
    pub fn new(heading: Vec<String>, rows: Vec<(Symbol, Vec<String>)>, room: f64) -> Self {
        Self::with(heading, rows, room, 0)
    }

    /// A table without heading, as narrow and low as it can be read.
    #[must_use]
    pub fn dense(rows: Vec<(Symbol, Vec<String>)>) -> Self {
        Self::with(Vec::new(), rows, f64::INFINITY, 1)
    }

    fn with(heading: Vec<String>, rows: Vec<(Symbol, Vec<String>)>, room: f64, density: usize) -> Self {
        let gap = GAP[density];
        let symbol = rows.iter().map(|(symbol, _)| symbol.width()).fold(0.0, f64::max);
        let left = if symbol > 0.0 { symbol + gap.min(7.0) } else { 0.0 };
        let mut columns: Vec<Vec<f64>> = Vec::new();
        let [mut x, mut width] = [left; 2];
        let count = rows.iter().map(|(_, cells)| cells.len()).fold(heading.len(), usize::max);
        for place in 0..count {
            let cells = rows.iter().filter_map(|(_, cells)| cells.get(place)).chain(heading.get(place));
            let wide = widest(cells, SIZE);
            match columns.last_mut() {
                Some(line) if x + wide <= room => line.push(x),
                _ => {
                    x = left;
                    columns.push(vec![x]);
                }
            }
            width = width.max((x + wide).min(room.max(left)));
            x += wide + if wide > 0.0 { gap } else { 0.0 };
        }
        let row = |cells: Vec<String>| Row::new(cells, &columns, room);
        Self {
            heading: if heading.is_empty() { Row(Vec::new()) } else { row(heading) },
            rows: rows.into_iter().map(|(symbol, cells)| (symbol, row(cells))).collect(),
            rest: None,
            width,
            line: LINE[density],
        }
    }

    /// The same with a last line.
    #[must_use]
    pub fn with_note(self, note: &str) -> Self {
        Self { rest: Some(note.to_owned()), ..self }
    }

    /// Of all columns, in pixels.
    #[must_use]
    pub fn width(&self) -> f64 {
        self.width
    }

    /// Number of rows.
    #[must_use]
    pub fn row_count(&self) -> usize {
        self.rows.len()
    }

    /// The height of a row of one line.
    #[must_use]
    pub fn line(&self) -> f64 {
        self.line
    }

    /// Nothing where there are no rows.
    #[must_use]
    pub fn height(&self) -> f64 {
        if self.rows.is_empty() {
            return 0.0;
        }
        let rest = if self.rest.is_some() { self.line } else { 0.0 };
        self.heading.height(self.line) + self.rows.iter().map(|(_, row)| row.height(self.line)).sum::<f64>() + rest
    }

    /// Draws the table with its top left corner at `at`.
    pub fn draw(&self, canvas: &Canvas, at: Point) {
        if self.rows.is_empty() {
            return;
        }
        self.heading.draw(canvas, at, self.line, FAINT_INK);
        let top = self.draw_rows(canvas, 0..self.rows.len(), [at[0], at[1] + self.heading.height(self.line)]);
        if let Some(rest) = &self.rest {
            let base = top + 0.5 * self.line + 0.36 * SIZE;
            canvas.text(rest, [at[0], base], SIZE, FAINT_INK, Anchor::Start);
        }
    }

    /// Draws some rows from `at` down to the position that is returned.
    pub fn draw_rows(&self, canvas: &Canvas, rows: Range<usize>, [x, mut y]: Point) -> f64 {
        for (symbol, row) in &self.rows[rows] {
            symbol.draw(canvas, [x, y + 0.5 * self.line]);
            row.draw(canvas, [x, y], self.line, INK);
            y += row.height(self.line);
        }
        y
    }
}

impl Row {
    /// Cells at their columns: what is too wide for its line is continued below.
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

    fn height(&self, line: f64) -> f64 {
        self.0.len() as f64 * line + if self.0.len() > 1 { APART } else { 0.0 }
    }

    fn draw(&self, canvas: &Canvas, [x, y]: Point, pitch: f64, color: RGBColor) {
        for (number, cells) in self.0.iter().enumerate() {
            let base = y + (number as f64 + 0.5) * pitch + 0.36 * SIZE;
            for (left, cell) in cells {
                canvas.text(cell, [x + left, base], SIZE, color, Anchor::Start);
            }
        }
    }
}
