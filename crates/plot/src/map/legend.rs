//! The legend of a map: beside it as far as there is room, the rest below.

use plotters::style::RGBColor;

use super::colors::{fill, line as line_color};
use super::marks::Mark;
use super::model::{Map, MapBodies};
use super::spots::{short_place, spot};
use super::view::{SIZE, SMALL, View};
use crate::page::{Anchor, Canvas, FAINT_INK, INK, Ink, Pattern, Point, Rect, Rows, lines, pattern, text_width};

const ROW: f64 = 17.0;
/// In short.
const SHORT_ROW: f64 = 15.0;
const SWATCH: f64 = 13.0;
/// Widths of lines, and of borders between areas.
pub(super) const LINE: f64 = 1.4;
pub(super) const BORDER: f64 = 0.8;
/// Between lines of one text.
const LINE_PITCH: f64 = 14.0;
/// Between columns, and between what stands in a row.
const BETWEEN: f64 = 16.0;
/// Between a symbol and its text, between mark and name, and before the note.
const GAP: f64 = 7.0;
/// Between all of these in short.
const SHORT_GAP: f64 = 5.0;
/// Before a place.
const AT: &str = "at ";
/// Letters of a name in short, at least.
const NAME: usize = 6;
const BEFORE_NOTE: f64 = 11.0;

/// How a line is drawn.
pub(super) fn line_pattern(dashed: bool, color: RGBColor) -> Pattern {
    if dashed { vec![(Some(color), 6.0), (None, 4.0)] } else { vec![(Some(color), 1.0)] }
}

/// The places for a legend: beside the map so wide and high, and below it so wide and, if that can be, no higher.
#[derive(Clone, Copy)]
pub(super) struct Places {
    pub beside: [f64; 2],
    pub below: [f64; 2],
}

/// The lines of a legend, with the top left corner of each: relative to that of the place beside the map, and to that below.
pub(super) struct Legend {
    beside: Vec<(Line, Point)>,
    below: Vec<(Line, Point)>,
    height_below: f64,
}

/// The mark of an entry, its name, and what is told of it; the names and the notes of all entries begin below each other.
#[derive(Clone)]
struct Entry {
    fill: RGBColor,
    mark: String,
    name: String,
    note: String,
    is_placed: bool,
}

enum Line {
    Note(Vec<String>),
    Entry(Entry, Columns),
    Stroke { dashed: bool, color: RGBColor, width: f64, texts: Vec<String> },
}

/// Where names and notes begin, and how large marks and names are.
#[derive(Clone, Copy)]
struct Columns {
    name: f64,
    note: f64,
    size: f64,
    /// Before a name.
    gap: f64,
    /// Width of the swatches with what is beside them; 0 where there are none.
    swatch: f64,
}

impl Legend {
    /// Each entry is told with its number, and where it lies if no mark in the map says that.
    pub(super) fn new(map: &Map, view: &View, marks: &[Mark], places: Places) -> Self {
        let mut unmarked = false;
        let mut entries: Vec<Entry> = Vec::with_capacity(map.entries.len());
        for (number, entry) in map.entries.iter().enumerate() {
            let is_marked = marks.iter().any(|mark| mark.entry == number);
            let place = if is_marked { None } else { spot(&map.bodies, number, view) };
            unmarked |= place.is_some();
            entries.push(Entry {
                is_placed: place.is_some(),
                fill: fill(map, Some(number)),
                mark: if entry.mark == entry.name { String::new() } else { entry.mark.clone() },
                name: entry.name.clone(),
                note: place.map_or_else(|| entry.note.clone(), |place| format!("{AT}({})", short_place(place))),
            });
        }
        let (_, unknown) = map.bodies.seen(map.entries.len(), view);
        if unknown {
            let [mark, note] = [String::new(), String::new()];
            let is_placed = false;
            entries.push(Entry { fill: fill(map, None), mark, name: map.unknown.clone(), note, is_placed });
        }
        let full = Self::laid_out(entries.clone(), others(map, unmarked, places.below[0]), places, false);
        if full.height_below <= places.below[1] {
            return full;
        }
        // In short only what tells which entry it is and where.
        for entry in &mut entries {
            entry.note = if entry.is_placed { entry.note.replacen(AT, "", 1) } else { String::new() };
        }
        let shortened = shorten(&mut entries);
        let mut others = others(map, unmarked, places.below[0]);
        if shortened {
            others.push(Line::Note(lines("names by their first digits", SMALL, places.below[0])));
        }
        Self::laid_out(entries, others, places, true)
    }

    /// Everything beside the map where there is room for it, else only entries as far as they fit; in short all of them below
    /// it, those with a place in columns of their own.
    fn laid_out(entries: Vec<Entry>, others: Vec<Line>, places: Places, in_short: bool) -> Self {
        let [room, _] = places.below;
        let (mut beside, mut below, mut height_below) = (Vec::new(), Vec::new(), 0.0);
        let mut together = false;
        if in_short {
            let (placed, marked): (Vec<Entry>, Vec<Entry>) = entries.into_iter().partition(|entry| entry.is_placed);
            for group in [marked, placed] {
                height_below += in_columns(Columns::lines(group, true), [room, SHORT_ROW], height_below, &mut below);
            }
        } else {
            beside = Columns::lines(entries, false);
            let rows = if widest(&beside) <= places.beside[0] { whole(places.beside[1] / ROW) } else { 0 };
            together = beside.len() + others.len() <= rows && widest(&others) <= places.beside[0];
            let rest = beside.split_off(beside.len().min(rows));
            height_below = in_columns(rest, [room, ROW], 0.0, &mut below);
        }
        if together {
            beside.extend(others);
        } else if !others.is_empty() {
            let top = height_below + if height_below > 0.0 { 6.0 } else { 0.0 };
            let corners = Rows::new(others.iter().map(|line| [line.width(), line.height()]), BETWEEN, room);
            height_below = top + corners.height;
            below.extend(others.into_iter().zip(corners.corners).map(|(line, [x, y])| (line, [x, top + y])));
        }
        let beside = beside.into_iter().enumerate().map(|(row, line)| (line, [0.0, row as f64 * ROW])).collect();
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

/// Leaves of long names that are one word as many letters as tell them apart; tells whether it did.
fn shorten(entries: &mut [Entry]) -> bool {
    let long =
        |entry: &&mut Entry| entry.name.len() > NAME && entry.name.bytes().all(|byte| byte.is_ascii_alphanumeric());
    let mut names: Vec<&mut Entry> = entries.iter_mut().filter(long).collect();
    let mut sorted: Vec<String> = names.iter().map(|entry| entry.name.clone()).collect();
    sorted.sort();
    let common = |pair: &[String]| pair[0].bytes().zip(pair[1].bytes()).take_while(|(a, b)| a == b).count();
    let needed = sorted.windows(2).map(common).fold(NAME - 1, usize::max) + 1;
    for entry in &mut names {
        entry.name.truncate(needed);
    }
    !names.is_empty()
}

/// Adds lines, one for each `row` pixels, in columns from `top` on, and tells their height.
fn in_columns(lines: Vec<Line>, [room, row]: [f64; 2], top: f64, below: &mut Vec<(Line, Point)>) -> f64 {
    let pitch = widest(&lines) + BETWEEN;
    let in_column = lines.len().div_ceil(whole((room + BETWEEN) / pitch).max(1));
    for (place, line) in lines.into_iter().enumerate() {
        below.push((line, [(place / in_column) as f64 * pitch, top + (place % in_column) as f64 * row]));
    }
    in_column as f64 * row
}

fn widest(lines: &[Line]) -> f64 {
    lines.iter().map(Line::width).fold(0.0, f64::max)
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "some dozens")]
fn whole(number: f64) -> usize {
    number.floor() as usize
}

impl Columns {
    /// Entries as lines of a legend.
    fn lines(entries: Vec<Entry>, in_short: bool) -> Vec<Line> {
        let (size, gap, before_note) = if in_short { (SMALL, SHORT_GAP, SHORT_GAP) } else { (SIZE, GAP, BEFORE_NOTE) };
        let widest =
            |text: fn(&Entry) -> &str| entries.iter().map(|entry| text_width(text(entry), size)).fold(0.0, f64::max);
        let mark = widest(|entry| &entry.mark);
        // What has no number in the map can hardly be seen there: no colour helps to find it.
        let swatch = if in_short && entries.iter().all(|entry| entry.is_placed) { 0.0 } else { SWATCH + gap };
        let name = swatch + if mark > 0.0 { mark + gap } else { 0.0 };
        let columns = Self { name, note: name + widest(|entry| &entry.name) + before_note, size, gap, swatch };
        entries.into_iter().map(|entry| Line::Entry(entry, columns)).collect()
    }
}

/// What lines mean, and what a place in a note is, in texts of at most so many pixels.
fn others(map: &Map, unmarked: bool, room: f64) -> Vec<Line> {
    let mut others = strokes(map, room);
    if unmarked {
        let [x, y] = [&map.x.name, &map.y.name];
        let note = format!("{AT}({x}, {y}): a body in an area without room for its number");
        others.push(Line::Note(lines(&note, SMALL, room)));
    }
    others
}

/// What lines mean, each meaning once.
fn strokes(map: &Map, room: f64) -> Vec<Line> {
    let stroke = |dashed, color, width, text: &str| {
        let texts = lines(text, SIZE, room - 2.0 * SWATCH - GAP);
        Line::Stroke { dashed, color, width, texts }
    };
    let mut strokes = Vec::new();
    if let MapBodies::Areas { borders, told, .. } = &map.bodies
        && !borders.is_empty()
    {
        strokes.push(stroke(false, line_color(0), BORDER, told));
    }
    let mut told: Vec<&str> = Vec::new();
    for line in &map.lines {
        if !line.text.is_empty() && !told.contains(&line.text.as_str()) {
            told.push(&line.text);
            strokes.push(stroke(line.dashed, line_color(line.hue), LINE, &line.text));
        }
    }
    strokes
}

impl Line {
    fn width(&self) -> f64 {
        let widest = |texts: &[String], size| texts.iter().map(|text| text_width(text, size)).fold(0.0, f64::max);
        match self {
            Self::Entry(entry, columns) if entry.note.is_empty() => {
                columns.name + text_width(&entry.name, columns.size)
            }
            Self::Entry(entry, columns) => columns.note + text_width(&entry.note, SMALL),
            Self::Note(texts) => widest(texts, SMALL),
            Self::Stroke { texts, .. } => 2.0 * SWATCH + GAP + widest(texts, SIZE),
        }
    }

    fn height(&self) -> f64 {
        match self {
            Self::Entry(..) => ROW,
            Self::Note(texts) | Self::Stroke { texts, .. } => ROW + (texts.len().max(1) - 1) as f64 * LINE_PITCH,
        }
    }

    fn draw(&self, canvas: &Canvas, at: Point) {
        let base = at[1] + 0.5 * ROW + 0.36 * SIZE;
        let texts = |texts: &[String], x: f64, size, color| {
            for (number, text) in texts.iter().enumerate() {
                canvas.text(text, [x, base + number as f64 * LINE_PITCH], size, color, Anchor::Start);
            }
        };
        match self {
            Self::Entry(entry, columns) => {
                let Columns { name, size, gap, swatch, .. } = *columns;
                if swatch > 0.0 {
                    let top = at[1] + 0.5 * (ROW - SWATCH);
                    let rect = Rect { x: at[0], y: top, width: SWATCH, height: SWATCH };
                    canvas.patch(&rect.corners(), entry.fill);
                    canvas.outline(&rect.corners(), Ink { color: FAINT_INK, width: 0.6 });
                }
                canvas.text(&entry.mark, [at[0] + name - gap, base], size, INK, Anchor::End);
                canvas.text(&entry.name, [at[0] + name, base], size, INK, Anchor::Start);
                canvas.text(&entry.note, [at[0] + columns.note, base], SMALL, FAINT_INK, Anchor::Start);
            }
            Self::Note(notes) => texts(notes, at[0], SMALL, FAINT_INK),
            Self::Stroke { dashed, color, width, texts: names } => {
                let middle = at[1] + 0.5 * ROW;
                let ends = [[at[0], middle], [at[0] + 2.0 * SWATCH, middle]];
                pattern::draw(canvas, &ends, &line_pattern(*dashed, *color), *width);
                texts(names, at[0] + 2.0 * SWATCH + GAP, SIZE, INK);
            }
        }
    }
}
