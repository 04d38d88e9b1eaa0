//! Where the marks of entries stand: in each patch that has room, and for an entry without one beside its widest patch, with
//! a leader.

use super::free::{CLEAR, beside};
use super::model::{Map, MapBodies, MapLine, MapNote};
use super::names::{Name, named};
use super::places::{inside, patches, thinned, widest};
use super::view::{SIZE, SMALL, View};
use crate::page::{Point, Rect, Taken, between, distance, text_width};

/// A mark inside needs so many pixels of room on each side.
const ROOM: f64 = 6.5;
/// Pixels of a cell by which areas are looked at.
const FINE: f64 = 1.0;
/// Where an area is narrower than two times this and a cell, its two sides have a mark each.
const NECK: usize = 2;
/// Radius of the ring of a note.
pub(super) const RING: f64 = 4.5;
/// Font size of a mark with a leader.
const LED: f64 = SMALL;

/// A mark with its place.
pub(super) struct Mark {
    pub entry: usize,
    pub size: f64,
    pub rect: Rect,
    /// From the patch to the mark.
    pub leader: Option<[Point; 2]>,
}

/// What stands in a map beside its notes.
#[derive(Default)]
pub(super) struct Marked {
    pub marks: Vec<Mark>,
    pub names: Vec<Name>,
}

/// The names of lines and the marks of entries; no marks for bodies that are points.
pub(super) fn marked(map: &Map, view: &View) -> Marked {
    let notes: Vec<Rect> = map.notes.iter().map(|note| note_box(note, view)).collect();
    let mut taken = Taken::default();
    for rect in &notes {
        taken.take_box(rect.grown(CLEAR));
    }
    let mut leaders = Vec::new();
    let names = named(map, view, &mut taken, &mut leaders);
    let boxes: Vec<Rect> = names.iter().map(|name| name.rect).chain(notes).collect();
    Marked { marks: marks(map, view, &boxes, taken, leaders), names }
}

/// The marks of entries where nothing is taken; upon texts in `boxes` none has room.
fn marks(map: &Map, view: &View, boxes: &[Rect], mut taken: Taken, mut leaders: Vec<[Point; 2]>) -> Vec<Mark> {
    let (columns, cells, neck) = match &map.bodies {
        MapBodies::Grid { columns, entries } => (*columns, entries.clone(), 0),
        MapBodies::Areas { pieces, .. } => {
            let (columns, mut cells) = raster(pieces, view);
            let borders = map.lines.iter().filter(|line| is_border(line));
            cut(borders.map(|line| &line.points[..]), columns, &mut cells, view);
            (columns, cells, NECK)
        }
        MapBodies::Points(_) => return Vec::new(),
    };
    let rows = (cells.len() / columns.max(1)).max(1);
    let (wide, high) = (view.rect.width / columns as f64, view.rect.height / rows as f64);
    let (mut patch, shown) = patches(columns, &thinned(columns, &cells, neck));
    let count = shown.len();
    // Places with room are looked for beside lines and boxes, whatever they divide.
    if let MapBodies::Areas { borders, .. } = &map.bodies {
        cut(map.lines.iter().map(|line| &line.points[..]), columns, &mut patch, view);
        cut(borders.iter().map(|ends| &ends[..]), columns, &mut patch, view);
    }
    let cells_of = |rect: &Rect| {
        let from_below = [rect.bottom(), rect.y].map(|y| (view.rect.bottom() - y) / high);
        let from_left = [rect.x, rect.right()].map(|x| (x - view.rect.x) / wide);
        [(from_below, rows), (from_left, columns)].map(|([from, to], count)| cell_range(from - 1.0, to + 1.0, count))
    };
    for [rows, across] in boxes.iter().map(cells_of) {
        for row in rows {
            patch[row * columns..][across.clone()].fill(None);
        }
    }
    let mut marks: Vec<Mark> = Vec::new();
    let on_page = |(column, row): (f64, f64)| [view.rect.x + column * wide, view.rect.bottom() - row * high];
    for (entry, place) in shown.into_iter().zip(widest(columns, &patch, count)) {
        let (Some(shown), Some((column, row, half))) = (map.entries.get(entry), place) else { continue };
        let at = on_page((column, row));
        let room = [0.5 * text_width(&shown.mark, SIZE) + 1.0, ROOM];
        let rect = Rect { x: at[0] - room[0], y: at[1] - room[1], width: 2.0 * room[0], height: 2.0 * room[1] };
        if half * wide >= room[0].max(ROOM) && half * high >= ROOM && taken.admits_box(&rect) {
            taken.take_box(rect.grown(CLEAR));
            marks.push(Mark { entry, size: SIZE, rect, leader: None });
        }
    }
    let (seen, _) = map.bodies.seen(map.entries.len(), view);
    for (entry, tips) in inside(columns, &cells, map.entries.len()).into_iter().enumerate() {
        if !seen[entry] || marks.iter().any(|mark| mark.entry == entry) {
            continue;
        }
        let tips: Vec<Point> = tips.into_iter().map(on_page).collect();
        let size = [text_width(&map.entries[entry].mark, LED) + 4.0, LED + 3.0];
        if let Some((rect, leader)) = beside(&tips, size, view, &taken, &leaders) {
            taken.take_box(rect.grown(CLEAR));
            taken.take_line(leader);
            leaders.push(leader);
            marks.push(Mark { entry, size: LED, rect, leader: Some(leader) });
        }
    }
    marks
}

/// Whether a line is a border as `borders` of areas are: no patch reaches across a full black one.
fn is_border(line: &MapLine) -> bool {
    !line.dashed && line.hue == 0
}

/// Empties the small cells on lines.
fn cut<'a>(lines: impl Iterator<Item = &'a [[f64; 2]]>, columns: usize, cells: &mut [Option<usize>], view: &View) {
    let rows = cells.len() / columns.max(1);
    for line in lines {
        let points: Vec<Point> = line.iter().map(|point| view.at(*point)).collect();
        for ends in points.windows(2) {
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "some hundreds of pixels")]
            let steps = (2.0 * distance(ends[0], ends[1]) / FINE).ceil().max(1.0) as usize;
            for [x, y] in (0..=steps).map(|k| between(ends[0], ends[1], k as f64 / steps as f64)) {
                // So thick that no two cells on different sides touch.
                let near = |at: f64, count: usize| cell_range(at / FINE - 1.5, at / FINE + 1.5, count);
                for row in near(view.rect.bottom() - y, rows) {
                    for column in near(x - view.rect.x, columns) {
                        cells[row * columns + column] = None;
                    }
                }
            }
        }
    }
}

/// What areas show in small cells, row by row from below.
fn raster(pieces: &[(Option<usize>, Vec<[f64; 2]>)], view: &View) -> (usize, Vec<Option<usize>>) {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "some hundreds of pixels")]
    let [columns, rows] = [view.rect.width, view.rect.height].map(|length| (length / FINE) as usize);
    let mut cells = vec![None; columns * rows];
    for (entry, corners) in pieces {
        let corners: Vec<Point> = corners.iter().map(|corner| view.at(*corner)).collect();
        let heights = corners.iter().map(|corner| (view.rect.bottom() - corner[1]) / FINE);
        let (least, most) = heights.fold((f64::INFINITY, 0.0_f64), |(least, most), y| (least.min(y), most.max(y)));
        for row in cell_range(least, most, rows) {
            let y = view.rect.bottom() - (row as f64 + 0.5) * FINE;
            let next = corners.iter().cycle().skip(1);
            let crossed = corners.iter().zip(next).filter(|(p, q)| (p[1] > y) != (q[1] > y));
            let mut ends: Vec<f64> = crossed
                .map(|(p, q)| (p[0] + (y - p[1]) / (q[1] - p[1]) * (q[0] - p[0]) - view.rect.x) / FINE)
                .collect();
            ends.sort_by(f64::total_cmp);
            for pair in ends.chunks_exact(2) {
                for column in cell_range(pair[0], pair[1], columns) {
                    cells[row * columns + column] = *entry;
                }
            }
        }
    }
    (columns, cells)
}

/// The cells whose middles lie between two places.
fn cell_range(from: f64, to: f64, count: usize) -> std::ops::Range<usize> {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to the cells")]
    let [from, to] = [from, to].map(|at| (at + 0.5).floor().clamp(0.0, count as f64) as usize);
    from..to
}

/// The box of a note's text.
pub(super) fn note_box(note: &MapNote, view: &View) -> Rect {
    let place = view.at(note.at);
    let half = 0.5 * text_width(&note.text, SMALL) + 3.0;
    let [left, right] = [view.rect.x, view.rect.right()];
    let wanted = match note.ring {
        false => place[0],
        true if place[0] + 2.0 * RING + 2.0 * half <= right => place[0] + 2.0 * RING + half,
        true => place[0] - 2.0 * RING - half,
    };
    // Inside of the map, as far as the text fits.
    let x = wanted.min(right - half).max(left + half);
    Rect { x: x - half, y: place[1] - 0.5 * SMALL - 2.0, width: 2.0 * half, height: SMALL + 4.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::map::{MapAxis, MapEntry};

    fn area(entry: usize, from: [f64; 2], to: [f64; 2]) -> (Option<usize>, Vec<[f64; 2]>) {
        (Some(entry), vec![from, [to[0], from[1]], to, [from[0], to[1]]])
    }

    /// A map of areas over the unit square.
    fn map(pieces: Vec<(Option<usize>, Vec<[f64; 2]>)>, count: usize, lines: Vec<MapLine>) -> Map {
        let entry = |number: usize| MapEntry {
            name: String::new(),
            note: String::new(),
            mark: number.to_string(),
            color: number,
        };
        let axis = || MapAxis { name: String::new(), range: [0.0, 1.0] };
        Map {
            title: String::new(),
            subtitle: String::new(),
            x: axis(),
            y: axis(),
            entries: (0..count).map(entry).collect(),
            ordered: false,
            unknown: String::new(),
            bodies: MapBodies::Areas { pieces, seen: Vec::new(), borders: Vec::new(), told: String::new() },
            lines,
            notes: Vec::new(),
        }
    }

    fn view() -> View {
        let rect = Rect { x: 0.0, y: 0.0, width: 500.0, height: 500.0 };
        View { x: [0.0, 1.0], y: [0.0, 1.0], rect }
    }

    #[test]
    fn a_number_keeps_clear_of_lines_and_their_names() {
        let points = vec![[0.0, 0.45], [1.0, 0.55]];
        let line = MapLine { points, hue: 1, name: "a line with a name".to_owned(), ..MapLine::default() };
        let map = map(vec![area(0, [0.0, 0.0], [1.0, 1.0])], 1, vec![line]);
        let Marked { marks, names } = marked(&map, &view());
        let mut taken = Taken::default();
        taken.take_line(
            map.lines[0].points.iter().map(|point| view().at(*point)).collect::<Vec<_>>().try_into().unwrap(),
        );
        taken.take_box(names[0].rect);
        assert!(marks.len() == 1 && marks[0].leader.is_none() && taken.admits_box(&marks[0].rect));
    }

    #[test]
    fn a_number_stands_upon_no_border_between_equals() {
        // On a line through the area bodies show something else, as where two moments are equal.
        let mut map = map(vec![area(0, [0.0, 0.0], [1.0, 1.0])], 1, Vec::new());
        let MapBodies::Areas { borders, .. } = &mut map.bodies else { unreachable!("areas") };
        borders.extend((0..10).map(|k| [0.1 * f64::from(k), 0.1 * f64::from(k + 1)].map(|x| [x, x])));
        let mut taken = Taken::default();
        taken.take_line([view().at([0.0, 0.0]), view().at([1.0, 1.0])]);
        let marks = marked(&map, &view()).marks;
        assert!(marks.len() == 1 && taken.admits_box(&marks[0].rect));
    }

    #[test]
    fn narrow_areas_are_marked_beside_and_nothing_overlaps() {
        // Two wide areas, and between them ten strips of two pixels.
        let mut pieces = vec![area(0, [0.0, 0.0], [0.4, 1.0]), area(1, [0.44, 0.0], [1.0, 1.0])];
        let strip = |k: usize| 0.4 + 0.004 * k as f64;
        pieces.extend((0..10).map(|k| area(2 + k, [strip(k), 0.0], [strip(k + 1), 1.0])));
        let map = map(pieces, 12, Vec::new());
        let view = view();
        let marks = marked(&map, &view).marks;
        for entry in 0..12 {
            let own: Vec<&Mark> = marks.iter().filter(|mark| mark.entry == entry).collect();
            assert_eq!(own.len(), 1, "entry {entry}");
            let tip = own[0].leader.map_or(own[0].rect.center(), |leader| leader[0]);
            let inside = if entry < 2 { None } else { Some([500.0 * strip(entry - 2), 500.0 * strip(entry - 1)]) };
            assert_eq!(own[0].leader.is_some(), inside.is_some());
            assert!(inside.is_none_or(|[from, to]| (from..=to).contains(&tip[0])), "entry {entry} at {tip:?}");
        }
        for (place, one) in marks.iter().enumerate() {
            for other in &marks[..place] {
                let [a, b] = [one.rect, other.rect];
                let apart = a.right() <= b.x || b.right() <= a.x || a.bottom() <= b.y || b.bottom() <= a.y;
                assert!(apart, "{} and {}", one.entry, other.entry);
            }
        }
    }
}
