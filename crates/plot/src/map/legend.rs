//! The legend of a map: beside it as far as there is room, the rest below.

use plotters::style::RGBColor;

use super::colors::{fill, line as line_color};
use super::marks::Mark;
use super::model::{Map, MapBodies, MapEntry};
use super::spots::{short_place, spot};
use super::view::{SIZE, SMALL, View};
use crate::page::{Anchor, Canvas, FAINT_INK, INK, Ink, Pattern, Point, Rect, Rows, pattern, text_width};

const ROW: f64 = 17.0;
const SWATCH: f64 = 13.0;
/// Widths of lines, and of borders between areas.
pub(super) const LINE: f64 = 1.4;
pub(super) const BORDER: f64 = 0.8;
/// Between columns, and between what stands in a row.
const BETWEEN: f64 = 16.0;

/// How a line is drawn.
pub(super) fn line_pattern(dashed: bool, color: RGBColor) -> Pattern {
    if dashed { vec![(Some(color), 6.0), (None, 4.0)] } else { vec![(Some(color), 1.0)] }
}

/// The places for a legend: beside the map so wide and high, and below it so wide.
#[derive(Clone, Copy)]
pub(super) struct Places {
    pub beside: [f64; 2],
    pub below: f64,
}

/// The lines of a legend, with the top left corner of each: relative to that of the place beside the map, and to that below.
pub(super) struct Legend {
    beside: Vec<(Line, Point)>,
    below: Vec<(Line, Point)>,
    height_below: f64,
}

enum Line {
    Note(String),
    Entry { fill: RGBColor, text: String, note: String },
    Stroke { dashed: bool, color: RGBColor, width: f64, text: String },
}

impl Legend {
    /// Each entry is told with its number, and where it lies if no mark in the map says that.
    pub(super) fn new(map: &Map, view: &View, marks: &[Mark], places: Places) -> Self {
        let mut unmarked = false;
        let mut entries: Vec<Line> = Vec::with_capacity(map.entries.len());
        for (number, entry) in map.entries.iter().enumerate() {
            let is_marked = marks.iter().any(|mark| mark.entry == number);
            let place = if is_marked { None } else { spot(&map.bodies, number, view) };
            unmarked |= place.is_some();
            entries.push(Line::Entry {
                fill: fill(map, Some(number)),
                text: named(entry),
                note: place.map_or_else(|| entry.note.clone(), |place| format!("at ({})", short_place(place))),
            });
        }
        let (_, unknown) = map.bodies.seen(map.entries.len(), view);
        if unknown {
            entries.push(Line::Entry { fill: fill(map, None), text: map.unknown.clone(), note: String::new() });
        }
        let mut others = strokes(map);
        if unmarked {
            let [x, y] = [&map.x.name, &map.y.name];
            others.push(Line::Note(format!("at ({x}, {y}): a place in an area without room for its number")));
        }
        Self::laid_out(entries, others, places)
    }

    /// Everything beside the map where there is room for it, else only entries as far as they fit.
    fn laid_out(mut entries: Vec<Line>, others: Vec<Line>, places: Places) -> Self {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "some dozens")]
        let whole = |number: f64| number.max(1.0).floor() as usize;
        let widest = |lines: &[Line]| lines.iter().map(Line::width).fold(0.0, f64::max);
        let rows = whole(places.beside[1] / ROW);
        let together = entries.len() + others.len() <= rows && widest(&others) <= places.beside[0];
        let mut rest = entries.split_off(entries.len().min(rows));
        let mut below = Vec::new();
        let columns = whole((places.below + BETWEEN) / (widest(&rest) + BETWEEN));
        let in_column = rest.len().div_ceil(columns);
        let pitch = widest(&rest) + BETWEEN;
        for (place, line) in rest.drain(..).enumerate() {
            below.push((line, [(place / in_column) as f64 * pitch, (place % in_column) as f64 * ROW]));
        }
        let mut height_below = in_column as f64 * ROW;
        if together {
            entries.extend(others);
        } else if !others.is_empty() {
            let top = height_below + if height_below > 0.0 { 6.0 } else { 0.0 };
            let corners = Rows::new(others.iter().map(|line| [line.width(), ROW]), BETWEEN, places.below);
            height_below = top + corners.height;
            below.extend(others.into_iter().zip(corners.corners).map(|(line, [x, y])| (line, [x, top + y])));
        }
        let beside = entries.into_iter().enumerate().map(|(row, line)| (line, [0.0, row as f64 * ROW])).collect();
        Self { beside, below, height_below }
    }

    /// Width of what stands beside the map.
    pub(super) fn width_beside(&self) -> f64 {
        self.beside.iter().map(|(line, _)| line.width()).fold(0.0, f64::max)
    }

    /// Height of what stands below it.
    pub(super) fn height_below(&self) -> f64 {
        self.height_below
    }

    pub(super) fn draw(&self, canvas: &Canvas, beside: Point, below: Point) {
        for (lines, [x, y]) in [(&self.beside, beside), (&self.below, below)] {
            for (line, corner) in lines {
                line.draw(canvas, [x + corner[0], y + corner[1]]);
            }
        }
    }
}

/// An entry with its number.
fn named(entry: &MapEntry) -> String {
    if entry.mark == entry.name { entry.name.clone() } else { format!("{}  {}", entry.mark, entry.name) }
}

/// What lines mean, each meaning once.
fn strokes(map: &Map) -> Vec<Line> {
    let mut lines = Vec::new();
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
    lines
}

impl Line {
    fn width(&self) -> f64 {
        match self {
            Self::Entry { text, note, .. } => {
                let note = if note.is_empty() { 0.0 } else { 8.0 + text_width(note, SMALL) };
                SWATCH + 7.0 + text_width(text, SIZE) + note
            }
            Self::Note(text) => text_width(text, SMALL),
            Self::Stroke { text, .. } => 2.0 * SWATCH + 7.0 + text_width(text, SIZE),
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
                let x = at[0] + SWATCH + 7.0;
                canvas.text(text, [x, base], SIZE, INK, Anchor::Start);
                canvas.text(note, [x + text_width(text, SIZE) + 8.0, base], SMALL, FAINT_INK, Anchor::Start);
            }
            Self::Note(text) => canvas.text(text, [at[0], base], SMALL, FAINT_INK, Anchor::Start),
            Self::Stroke { dashed, color, width, text } => {
                let middle = at[1] + 0.5 * ROW;
                let ends = [[at[0], middle], [at[0] + 2.0 * SWATCH, middle]];
                pattern::draw(canvas, &ends, &line_pattern(*dashed, *color), *width);
                canvas.text(text, [at[0] + 2.0 * SWATCH + 7.0, base], SIZE, INK, Anchor::Start);
            }
        }
    }
}
