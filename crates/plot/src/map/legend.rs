//! The legend of a map: its entries beside it while there is room, the rest below, with what lines mean.

use super::colors::{fill, line as line_color};
use super::marks::MapMark;
use super::model::{Map, MapBodies, MapView};
use super::spots::{short_place, spot};
use bifdiag_page::{Canvas, Dash, FAINT_INK, Ink, Legend, Path, Point, Rect, Symbol, Table, pixel};
use plotters::style::RGBColor;

/// What is said of places without a body.
pub(super) const NO_BODY: &str = "no body exists: a moment exceeds the sum of the others";
/// The side of the swatch that says it.
const HATCHED: f64 = 12.0;
/// Widths of lines, and of borders between areas.
pub(super) const LINE: f64 = 1.4;
pub(super) const BORDER: f64 = 0.8;
/// Between columns of entries.
const BETWEEN: f64 = 16.0;
/// Between parts of the legend.
const APART: f64 = 6.0;
/// Before a place.
const AT: &str = "at ";
/// Letters of a name in short, at least.
const NAME: usize = 6;

/// How a line is drawn.
pub(super) fn line_pattern(dashed: bool, color: RGBColor) -> Vec<Dash> {
    if dashed { vec![(Some(color), 6.0), (None, 4.0)] } else { vec![(Some(color), 1.0)] }
}

/// The places for a legend: width and height beside the map, and below it the width and, if possible, the greatest
/// height.
#[derive(Clone, Copy)]
pub(super) struct Places {
    pub beside: [f64; 2],
    pub below: [f64; 2],
}

/// Entries in a table beside the map, and below it in columns; below these what lines mean.
pub(super) struct MapLegend {
    beside: Table,
    below: Vec<Table>,
    others: Legend,
    room: f64,
}

/// The mark of an entry, its name, and what is said of it, or where it lies.
#[derive(Clone)]
struct Entry {
    fill: RGBColor,
    mark: String,
    name: String,
    note: String,
    is_placed: bool,
}

impl MapLegend {
    /// Each entry is listed with its number, and where it lies if no mark in the map says that.
    pub(super) fn new(map: &Map, view: &MapView, marks: &[MapMark], places: Places) -> Self {
        let mut entries: Vec<Entry> = Vec::with_capacity(map.entries.len());
        for (number, entry) in map.entries.iter().enumerate() {
            let is_marked = marks.iter().any(|mark| mark.of == number);
            let place = if is_marked || entry.mark.is_empty() { None } else { spot(&map.bodies, number, view) };
            entries.push(Entry {
                is_placed: place.is_some(),
                fill: fill(map, Some(number)),
                mark: if entry.mark == entry.name { String::new() } else { entry.mark.clone() },
                name: entry.name.clone(),
                note: place.map_or_else(|| entry.note.clone(), |place| format!("{AT}({})", short_place(place))),
            });
        }
        let is_placed = entries.iter().any(|entry| entry.is_placed);
        let others = || {
            let [x, y] = [&map.x.name, &map.y.name];
            let note = format!("{AT}({x}, {y}): a body where there is no room for its number");
            let mut others = strokes(map);
            others.extend(is_placed.then_some((Symbol::None, note)));
            others
        };
        let (_, has_unknown) = map.bodies.seen(map.entries.len(), view);
        if has_unknown {
            let (fill, name) = (fill(map, None), map.unknown.clone());
            entries.push(Entry { fill, mark: String::new(), name, note: String::new(), is_placed: false });
        }
        let full = Self::full(&entries, others(), places);
        if full.height_below() <= places.below[1] {
            return full;
        }
        Self::short(entries, others(), places.below[0])
    }

    /// The descriptions of the entries, beside the map if they fit.
    fn full(entries: &[Entry], others: Vec<(Symbol, String)>, places: Places) -> Self {
        let table = |entries: &[Entry]| {
            let rows = entries.iter().map(|entry| {
                let cells = [&entry.mark, &entry.name, &entry.note].map(Clone::clone);
                (Symbol::Swatch(vec![entry.fill]), cells.to_vec())
            });
            Table::new(Vec::new(), rows.collect(), f64::INFINITY)
        };
        let all = table(entries);
        let fits = all.width() <= places.beside[0];
        let count = if fits { pixel(places.beside[1] / all.line(), entries.len()) } else { 0 };
        let (beside, below) = entries.split_at(count);
        let [room, _] = places.below;
        Self { beside: table(beside), below: vec![table(below)], others: Legend::new(others, room), room }
    }

    /// In short only the identity of an entry and its position: all of it below the map, entries with a place in
    /// columns of their own.
    fn short(mut entries: Vec<Entry>, mut others: Vec<(Symbol, String)>, room: f64) -> Self {
        if shorten(&mut entries) {
            others.push((Symbol::None, "names by their first digits".to_owned()));
        }
        let (placed, marked): (Vec<Entry>, Vec<Entry>) = entries.into_iter().partition(|entry| entry.is_placed);
        // What has no number in the map can hardly be seen there: no colour helps to find it.
        let placed = placed
            .into_iter()
            .map(|entry| (Symbol::None, vec![entry.mark, entry.name, entry.note.trim_start_matches(AT).to_owned()]));
        let marked = marked.into_iter().map(|entry| (Symbol::Swatch(vec![entry.fill]), vec![entry.mark, entry.name]));
        let below = vec![Table::dense(marked.collect()), Table::dense(placed.collect())];
        Self { beside: Table::dense(Vec::new()), below, others: Legend::new(others, room), room }
    }

    /// The number of rows of a table in each column below the map.
    fn rows(&self, table: &Table) -> usize {
        let columns = pixel((self.room + BETWEEN) / (table.width() + BETWEEN), table.row_count()).max(1);
        table.row_count().div_ceil(columns)
    }

    /// Width of the contents beside the map.
    pub(super) fn width_beside(&self) -> f64 {
        if self.beside.row_count() > 0 { self.beside.width() } else { 0.0 }
    }

    /// Height of the contents below it.
    pub(super) fn height_below(&self) -> f64 {
        let tables: f64 = self.below.iter().map(|table| self.rows(table) as f64 * table.line()).sum();
        tables + if self.others.height() > 0.0 { APART + self.others.height() } else { 0.0 }
    }

    pub(super) fn draw(&self, canvas: &Canvas, beside: Point, [x, mut y]: Point) {
        self.beside.draw(canvas, beside);
        for table in &self.below {
            let rows = self.rows(table);
            for column in 0..table.row_count().div_ceil(rows.max(1)) {
                let own = column * rows..((column + 1) * rows).min(table.row_count());
                table.draw_rows(canvas, own, [x + column as f64 * (table.width() + BETWEEN), y]);
            }
            y += rows as f64 * table.line();
        }
        self.others.draw(canvas, [x, y + APART]);
    }
}

/// Shortens long one-word names to as many letters as tell them apart; true if there are any.
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

/// What lines mean, each meaning once.
fn strokes(map: &Map) -> Vec<(Symbol, String)> {
    let mut strokes = Vec::new();
    if !map.impossible.is_empty() {
        let hatched = |canvas: &Canvas, [x, y]: Point| {
            let rect = Rect { x: x - HATCHED / 2.0, y: y - HATCHED / 2.0, width: HATCHED, height: HATCHED };
            let mut path = Path::default();
            path.line(&rect.corners(), true);
            canvas.draw(&path, &canvas.fill_hatched());
            canvas.outline(&rect.corners(), Ink { color: FAINT_INK, width: 0.6 });
        };
        strokes.push((Symbol::Mark("hatched", Box::new(hatched)), NO_BODY.to_owned()));
    }
    if let MapBodies::Areas { borders, legend, .. } = &map.bodies
        && !borders.is_empty()
    {
        strokes.push((Symbol::Line(line_pattern(false, line_color(0)), BORDER), legend.clone()));
    }
    let mut explained: Vec<&str> = Vec::new();
    for line in &map.lines {
        if !line.text.is_empty() && !explained.contains(&line.text.as_str()) {
            explained.push(&line.text);
            strokes.push((Symbol::Line(line_pattern(line.dashed, line_color(line.hue)), LINE), line.text.clone()));
        }
    }
    strokes
}
