//! The legend beside a map.

use plotters::style::RGBColor;

use super::colors::fill;
use super::model::{Map, MapBodies, MapEntry};
use crate::page::{Anchor, Canvas, FAINT_INK, INK, Ink, Pattern, Point, Rect, pattern, text_width};

const ROW: f64 = 19.0;
/// Font sizes of texts and of notes.
pub(super) const SIZE: f64 = 11.5;
pub(super) const SMALL: f64 = 10.0;
const SWATCH: f64 = 14.0;
/// Entries that the legend lists; the rest is counted.
const LISTED: usize = 27;
const WIDTH_MIN: f64 = 120.0;

/// How a line is drawn.
pub(super) fn line_pattern(dashed: bool) -> Pattern {
    if dashed { vec![(Some(INK), 6.0), (None, 4.0)] } else { vec![(Some(INK), 1.0)] }
}

/// The lines of a legend.
pub(super) struct Legend {
    lines: Vec<Line>,
}

enum Line {
    Entry { fill: RGBColor, text: String, note: String },
    Stroke { dashed: bool, text: String },
    Text(String),
}

impl Legend {
    pub(super) fn new(map: &Map) -> Self {
        let entry = |(number, entry): (usize, &MapEntry)| Line::Entry {
            fill: fill(Some(number)),
            text: if entry.mark == entry.name { entry.name.clone() } else { format!("{}  {}", entry.mark, entry.name) },
            note: entry.note.clone(),
        };
        let mut lines: Vec<Line> = map.entries.iter().enumerate().take(LISTED).map(entry).collect();
        if map.entries.len() > LISTED {
            lines.push(Line::Text(format!("and {} more", map.entries.len() - LISTED)));
        }
        let unknown = match &map.bodies {
            MapBodies::Grid { entries, .. } => entries.iter().any(Option::is_none),
            MapBodies::Points(points) => points.iter().any(|(_, entry)| entry.is_none()),
        };
        if unknown {
            lines.push(Line::Entry { fill: fill(None), text: map.unknown.clone(), note: String::new() });
        }
        let mut told: Vec<&str> = Vec::new();
        for line in &map.lines {
            if !line.text.is_empty() && !told.contains(&line.text.as_str()) {
                told.push(&line.text);
                lines.push(Line::Stroke { dashed: line.dashed, text: line.text.clone() });
            }
        }
        Self { lines }
    }

    pub(super) fn width(&self) -> f64 {
        self.lines.iter().map(Line::width).fold(WIDTH_MIN, f64::max)
    }

    pub(super) fn height(&self) -> f64 {
        ROW * (self.lines.len() as f64 + 0.5)
    }

    pub(super) fn draw(&self, canvas: &Canvas, [x, y]: Point) {
        for (number, line) in self.lines.iter().enumerate() {
            line.draw(canvas, [x, y + ROW * number as f64]);
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
            Self::Stroke { text, .. } => 2.0 * SWATCH + 8.0 + text_width(text, SIZE),
            Self::Text(text) => text_width(text, SIZE),
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
            Self::Stroke { dashed, text } => {
                let middle = at[1] + 0.5 * ROW;
                let ends = [[at[0], middle], [at[0] + 2.0 * SWATCH, middle]];
                pattern::draw(canvas, &ends, &line_pattern(*dashed), 1.2);
                canvas.text(text, [at[0] + 2.0 * SWATCH + 8.0, base], SIZE, INK, Anchor::Start);
            }
            Self::Text(text) => canvas.text(text, [at[0], base], SIZE, FAINT_INK, Anchor::Start),
        }
    }
}
