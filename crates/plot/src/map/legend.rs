//! The legend beside a map.

use plotters::style::RGBColor;

use super::colors::{fill, line as line_color};
use super::model::{Map, MapBodies, MapEntry};
use super::view::{SEEN, View};
use crate::page::{Anchor, Canvas, FAINT_INK, INK, Ink, Pattern, Point, Rect, pattern, text_width};

const ROW: f64 = 19.0;
/// Font sizes of texts and of notes.
pub(super) const SIZE: f64 = 11.5;
pub(super) const SMALL: f64 = 10.0;
const SWATCH: f64 = 14.0;
/// Widths of lines, and of borders between areas.
pub(super) const LINE: f64 = 1.4;
pub(super) const BORDER: f64 = 0.8;
/// Lines in a column, and between columns.
const LINES: usize = 29;
const BETWEEN: f64 = 22.0;
const WIDTH_MIN: f64 = 120.0;

/// How a line is drawn.
pub(super) fn line_pattern(dashed: bool, color: RGBColor) -> Pattern {
    if dashed { vec![(Some(color), 6.0), (None, 4.0)] } else { vec![(Some(color), 1.0)] }
}

/// The lines of a legend.
pub(super) struct Legend {
    lines: Vec<Line>,
}

enum Line {
    Note(String),
    Entry { fill: RGBColor, text: String, note: String },
    Stroke { dashed: bool, color: RGBColor, width: f64, text: String },
}

impl Legend {
    /// Entries of areas that are too small to be seen are told by their number.
    pub(super) fn new(map: &Map, view: &View) -> Self {
        let (seen, unknown) = map.bodies.seen(map.entries.len(), view);
        let entry = |(number, entry): (usize, &MapEntry)| Line::Entry {
            fill: fill(map, Some(number)),
            text: if entry.mark == entry.name { entry.name.clone() } else { format!("{}  {}", entry.mark, entry.name) },
            note: entry.note.clone(),
        };
        let told = map.entries.iter().enumerate().filter(|(number, _)| seen[*number]);
        let mut lines: Vec<Line> = told.map(entry).collect();
        let unseen = seen.iter().filter(|seen| !**seen).count();
        if unseen > 0 {
            lines.push(Line::Note(format!("and {unseen} more on less than {SEEN} pixels each")));
        }
        if unknown {
            lines.push(Line::Entry { fill: fill(map, None), text: map.unknown.clone(), note: String::new() });
        }
        if let MapBodies::Areas { borders, told, .. } = &map.bodies
            && !borders.is_empty()
        {
            lines.push(Line::Stroke { dashed: false, color: line_color(0), width: BORDER, text: told.clone() });
        }
        let mut told: Vec<&str> = Vec::new();
        for line in &map.lines {
            if !line.text.is_empty() && !told.contains(&line.text.as_str()) {
                told.push(&line.text);
                let color = line_color(line.hue);
                lines.push(Line::Stroke { dashed: line.dashed, color, width: LINE, text: line.text.clone() });
            }
        }
        Self { lines }
    }

    /// The columns with their widths.
    fn columns(&self) -> impl Iterator<Item = (&[Line], f64)> {
        let width = |lines: &[Line]| lines.iter().map(Line::width).fold(WIDTH_MIN, f64::max);
        self.lines.chunks(LINES).map(move |lines| (lines, width(lines)))
    }

    pub(super) fn width(&self) -> f64 {
        let widths: Vec<f64> = self.columns().map(|(_, width)| width).collect();
        widths.iter().sum::<f64>() + BETWEEN * widths.len().saturating_sub(1) as f64
    }

    pub(super) fn height(&self) -> f64 {
        ROW * (self.lines.len().min(LINES) as f64 + 0.5)
    }

    pub(super) fn draw(&self, canvas: &Canvas, [mut x, y]: Point) {
        for (lines, width) in self.columns() {
            for (number, line) in lines.iter().enumerate() {
                line.draw(canvas, [x, y + ROW * number as f64]);
            }
            x += width + BETWEEN;
        }
    }
}

impl Line {
    fn width(&self) -> f64 {
        match self {
            Self::Entry { text, note, .. } => {
                let note = if note.is_empty() { 0.0 } else { 8.0 + text_width(note, SMALL) };
                SWATCH + 8.0 + text_width(text, SIZE) + note
            }
            Self::Note(text) => text_width(text, SMALL),
            Self::Stroke { text, .. } => 2.0 * SWATCH + 8.0 + text_width(text, SIZE),
        }
    }

    fn draw(&self, canvas: &Canvas, at: Point) {
        let base = at[1] + 0.5 * ROW + 0.36 * SIZE;
        match self {
            Self::Entry { fill, text, note } => {
                let top = at[1] + 0.5 * (ROW - SWATCH);
                let rect = Rect { x: at[0], y: top, width: SWATCH, height: SWATCH };
                canvas.polygon(&rect.corners(), *fill);
                canvas.outline(&rect.corners(), Ink { color: FAINT_INK, width: 0.6 });
                let x = at[0] + SWATCH + 8.0;
                canvas.text(text, [x, base], SIZE, INK, Anchor::Start);
                canvas.text(note, [x + text_width(text, SIZE) + 8.0, base], SMALL, FAINT_INK, Anchor::Start);
            }
            Self::Note(text) => canvas.text(text, [at[0], base], SMALL, FAINT_INK, Anchor::Start),
            Self::Stroke { dashed, color, width, text } => {
                let middle = at[1] + 0.5 * ROW;
                let ends = [[at[0], middle], [at[0] + 2.0 * SWATCH, middle]];
                pattern::draw(canvas, &ends, &line_pattern(*dashed, *color), *width);
                canvas.text(text, [at[0] + 2.0 * SWATCH + 8.0, base], SIZE, INK, Anchor::Start);
            }
        }
    }
}
