//! Placement of the names of lines and the marks of entries: a name beside its line, a mark in each patch that has
//! room, and for an entry without one beside what shows it, with a leader.

use super::model::{Map, MapBodies, MapLine, MapNote, MapView, SIZE, SMALL};
use bifdiag_page::{
    Areas, Labelled, NOTHING, Point, Rect, Sums, Taken, all_over, between, distance, pixel, text_width,
};

/// Room of a mark inside of its patch, above and below its middle.
const ROOM: f64 = 6.5;
/// Where an area is narrower than two times this, in pixels, its two sides have a mark each.
const NECK: f64 = 2.0;
/// Radius of the ring of a note.
pub(super) const RING: f64 = 4.5;
/// Free pixels round names and marks.
const CLEAR: f64 = 2.0;
/// Lengths of leaders, and the steps of the places that are tried for their texts.
const LEADER: [f64; 2] = [9.0, 260.0];
const STEP: f64 = 5.0;
/// The cost of placing a name on a line.
const UPON_LINE: f64 = 1000.0;
/// Lines are examined in parts of this many pixels.
const PART: f64 = 4.0;
/// The most points of a line from which a leader is tried.
const TIPS: usize = 48;

/// A text with its place.
pub(super) struct MapMark {
    /// The number of its line or entry.
    pub of: usize,
    pub size: f64,
    pub rect: Rect,
    /// From what it names to the text.
    pub leader: Option<[Point; 2]>,
}

/// The contents of a map besides its notes.
pub(super) struct Marked {
    /// Marks of entries.
    pub marks: Vec<MapMark>,
    /// Names of lines.
    pub names: Vec<MapMark>,
}

/// The names of lines and the marks of entries; no marks for bodies that are points.
pub(super) fn marked(map: &Map, view: &MapView) -> Marked {
    let notes: Vec<Rect> = map.notes.iter().map(|note| note_box(note, view)).collect();
    let mut taken = Taken::default();
    for rect in &notes {
        taken.take_box(*rect);
    }
    let names = names(map, view, &mut taken);
    let boxes: Vec<Rect> = names.iter().map(|name| name.rect).chain(notes).collect();
    Marked { marks: marks(map, view, &boxes, &mut taken), names }
}

/// The names of all lines that have one and are seen; takes their places.
fn names(map: &Map, view: &MapView, taken: &mut Taken) -> Vec<MapMark> {
    if map.lines.iter().all(|line| line.name.is_empty()) {
        return Vec::new();
    }
    let parts: Vec<Vec<Point>> = map.lines.iter().map(|line| parts(line, view)).collect();
    let mut drawn = Taken::default();
    for ends in parts.iter().flat_map(|points| points.windows(2)) {
        drawn.take_line([ends[0], ends[1]]);
    }
    let mut names = Vec::new();
    for (of, points) in parts.iter().enumerate().filter(|(line, _)| !map.lines[*line].name.is_empty()) {
        let size = [text_width(&map.lines[of].name, SMALL) + 4.0, SMALL + 4.0];
        let seen: Vec<Point> = points.iter().copied().filter(|point| view.rect.contains(*point)).collect();
        let tips: Vec<Point> = seen.iter().copied().step_by(seen.len().div_ceil(TIPS).max(1)).collect();
        let cost = |rect: &Rect| if drawn.admits_box(&rect.grown(CLEAR)) { 0.0 } else { UPON_LINE };
        names.extend(beside(of, size, &tips, view, taken, cost));
    }
    names
}

/// The nearest free place with a leader from one of the tips; `cost` is what speaks against a place.
fn beside(
    of: usize,
    size: [f64; 2],
    tips: &[Point],
    view: &MapView,
    taken: &mut Taken,
    cost: impl Fn(&Rect) -> f64,
) -> Option<MapMark> {
    let labelled = Labelled { tips, lengths: LEADER, clearance: CLEAR };
    let places = all_over(view.rect.grown(-2.0), size, STEP).map(|rect| (cost(&rect), rect));
    let (rect, leader) = taken.place_with_leader(&labelled, places, |_| 0.0)?;
    Some(MapMark { of, size: SMALL, rect, leader: Some(leader) })
}

/// The points of a line on the page, at this distance.
fn parts(line: &MapLine, view: &MapView) -> Vec<Point> {
    let mut points: Vec<Point> = Vec::new();
    let all = view.parts(line).concat();
    for (place, point) in all.iter().enumerate() {
        if place + 1 == all.len() || points.last().is_none_or(|last| distance(*last, *point) >= PART) {
            points.push(*point);
        }
    }
    points
}

/// The marks of entries where nothing is taken; none may cover texts in `boxes`.
fn marks(map: &Map, view: &MapView, boxes: &[Rect], taken: &mut Taken) -> Vec<MapMark> {
    if let MapBodies::Points(_) = &map.bodies {
        return Vec::new();
    }
    let [borders, all] = lines(map, view);
    let shown = Areas::new(&view.rect, |size, of| {
        fill(&map.bodies, view, size, of);
        cut(&borders, view, size, of);
    });
    let (patch_of, entries) = patches(&shown);
    // Places with room are looked for beside lines and boxes, whatever they divide.
    let patches = Areas::new(&view.rect, |size, of| {
        of.copy_from_slice(&patch_of);
        cut(&all, view, size, of);
        for [columns, rows] in boxes.iter().map(|rect| shown.span(rect)) {
            rows.for_each(|row| of[row * size[0]..][columns.clone()].fill(NOTHING));
        }
    });
    let mut marks: Vec<MapMark> = Vec::new();
    for (patch, (&entry, depth)) in entries.iter().zip(patches.depths(entries.len())).enumerate() {
        let size = [text_width(&map.entries[entry].mark, SIZE) + 2.0, 2.0 * ROOM];
        if depth < ROOM - NECK || map.entries[entry].mark.is_empty() {
            continue;
        }
        let others = Sums::new(&patches, |at| usize::try_from(patches.of[at]) != Ok(patch));
        if let Some(rect) = patches.inside(patch, &others, size, 0.0, taken) {
            taken.take_box(rect);
            marks.push(MapMark { of: entry, size: SIZE, rect, leader: None });
        }
    }
    let (seen, _) = map.bodies.seen(map.entries.len(), view);
    for (of, entry) in map.entries.iter().enumerate() {
        if seen[of] && !entry.mark.is_empty() && !marks.iter().any(|mark| mark.of == of) {
            let size = [text_width(&entry.mark, SMALL) + 4.0, SMALL + 3.0];
            marks.extend(beside(of, size, &shown.tips(of, taken), view, taken, |_| 0.0));
        }
    }
    marks
}

/// The patches of neighbouring pixels that show one entry: the patch of each pixel, and the entry of each patch. Patches that
/// meet only in a narrow place are two.
fn patches(shown: &Areas) -> (Vec<i32>, Vec<usize>) {
    let mut patch = vec![NOTHING; shown.of.len()];
    let mut entries = Vec::new();
    for start in 0..shown.of.len() {
        let Ok(entry) = usize::try_from(shown.of[start]) else { continue };
        if patch[start] != NOTHING || shown.depth[start] < NECK {
            continue;
        }
        let number = i32::try_from(entries.len()).unwrap_or(NOTHING);
        patch[start] = number;
        let mut open = vec![start];
        while let Some(at) = open.pop() {
            // The pixels on the edge are never deep.
            for next in [at - 1, at + 1, at - shown.width, at + shown.width] {
                if shown.of[next] == shown.of[start] && shown.depth[next] >= NECK && patch[next] == NOTHING {
                    patch[next] = number;
                    open.push(next);
                }
            }
        }
        entries.push(entry);
    }
    (patch, entries)
}

/// Lines on the page: the full black ones, which are borders as those of areas are, so that no patch reaches across them; and
/// all, with the borders of areas.
fn lines(map: &Map, view: &MapView) -> [Vec<Vec<Point>>; 2] {
    let on_page = |points: &[[f64; 2]]| points.iter().map(|point| view.at(*point)).collect::<Vec<Point>>();
    let is_border = |line: &&MapLine| !line.dashed && line.hue == 0;
    let of_areas = match &map.bodies {
        MapBodies::Areas { borders, .. } => &borders[..],
        MapBodies::Grid { .. } | MapBodies::Points(_) => &[],
    };
    let drawn = map.lines.iter().flat_map(|line| view.parts(line));
    [
        map.lines.iter().filter(is_border).flat_map(|line| view.parts(line)).collect(),
        drawn.chain(of_areas.iter().map(|ends| on_page(ends))).collect(),
    ]
}

/// Empties the pixels on lines, and beside them, so that no two on different sides touch.
fn cut(lines: &[Vec<Point>], view: &MapView, [width, height]: [usize; 2], of: &mut [i32]) {
    for ends in lines.iter().flat_map(|line| line.windows(2)) {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "some hundreds of pixels")]
        let steps = (2.0 * distance(ends[0], ends[1])).ceil().max(1.0) as usize;
        for [x, y] in (0..=steps).map(|k| between(ends[0], ends[1], k as f64 / steps as f64)) {
            let near = |at: f64, count: usize| pixel(at - 1.0, count)..pixel(at + 2.0, count);
            for row in near(y - view.rect.y, height) {
                of[row * width..][near(x - view.rect.x, width)].fill(NOTHING);
            }
        }
    }
}

/// What bodies show in each pixel.
fn fill(bodies: &MapBodies, view: &MapView, [width, height]: [usize; 2], of: &mut [i32]) {
    let code = |entry: Option<usize>| entry.and_then(|entry| i32::try_from(entry).ok()).unwrap_or(NOTHING);
    match bodies {
        MapBodies::Points(_) => {}
        MapBodies::Grid { columns, entries } => {
            let rows = entries.len() / (*columns).max(1);
            for (at, pixel) in of.iter_mut().enumerate() {
                let (row, column) = ((height - 1 - at / width) * rows / height, at % width * columns / width);
                *pixel = code(entries[row * columns + column]);
            }
        }
        MapBodies::Areas { pieces, .. } => {
            for (entry, corners) in pieces {
                let corners: Vec<Point> = corners.iter().map(|corner| view.at(*corner)).collect();
                let heights = corners.iter().map(|corner| corner[1] - view.rect.y);
                let (top, bottom) = heights.fold((f64::INFINITY, 0.0_f64), |(top, low), y| (top.min(y), low.max(y)));
                for row in middles(top, bottom, height) {
                    let y = view.rect.y + row as f64 + 0.5;
                    let next = corners.iter().cycle().skip(1);
                    let crossed = corners.iter().zip(next).filter(|(p, q)| (p[1] > y) != (q[1] > y));
                    let mut ends: Vec<f64> =
                        crossed.map(|(p, q)| p[0] + (y - p[1]) / (q[1] - p[1]) * (q[0] - p[0]) - view.rect.x).collect();
                    ends.sort_by(f64::total_cmp);
                    for pair in ends.chunks_exact(2) {
                        of[row * width..][middles(pair[0], pair[1], width)].fill(code(*entry));
                    }
                }
            }
        }
    }
}

/// The pixels whose middles lie between two positions.
fn middles(from: f64, to: f64, count: usize) -> std::ops::Range<usize> {
    pixel((from + 0.5).floor(), count)..pixel((to + 0.5).floor(), count)
}

/// The box of a note's text.
pub(super) fn note_box(note: &MapNote, view: &MapView) -> Rect {
    let place = view.at(note.at);
    let half = 0.5 * text_width(&note.text, SMALL) + 3.0;
    let [left, right] = [view.rect.x, view.rect.right()];
    let wanted = match note.ring {
        false => place[0],
        true if place[0] + 2.0 * RING + 2.0 * half <= right => place[0] + 2.0 * RING + half,
        true => place[0] - 2.0 * RING - half,
    };
    // Inside the map, if the text fits.
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
            key: String::new(),
            color: Some(number),
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
            bodies: MapBodies::Areas { pieces, seen: Vec::new(), borders: Vec::new(), legend: String::new() },
            impossible: Vec::new(),
            lines,
            notes: Vec::new(),
            key: Vec::new(),
        }
    }

    fn view() -> MapView {
        let rect = Rect { x: 0.0, y: 0.0, width: 500.0, height: 500.0 };
        MapView { x: [0.0, 1.0], y: [0.0, 1.0], rect }
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
            let own: Vec<&MapMark> = marks.iter().filter(|mark| mark.of == entry).collect();
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
                assert!(apart, "{} and {}", one.of, other.of);
            }
        }
    }

    #[test]
    fn patches_that_meet_in_a_narrow_place_fall_apart() {
        // Two squares of entry 0 that meet in four pixels, and two of entry 1.
        let rect = Rect { x: 0.0, y: 0.0, width: 60.0, height: 60.0 };
        let shown = Areas::new(&rect, |[width, _], of| {
            for (at, pixel) in of.iter_mut().enumerate() {
                let (x, y) = (at % width, at / width);
                *pixel = i32::from(if x < 30 { y > 31 } else { y < 28 });
            }
        });
        let (patch, entries) = patches(&shown);
        assert_eq!(entries, [0, 1, 0, 1]);
        let at = |x: usize, y: usize| patch[y * 60 + x];
        assert_eq!([at(10, 10), at(50, 10), at(50, 50), at(10, 50)], [0, 1, 2, 3]);
    }

    #[test]
    fn a_name_stands_beside_its_line_and_upon_none() {
        let axis = || MapAxis { name: String::new(), range: [0.0, 1.0] };
        let slope = |shift: f64| (0..=100).map(|k| 0.01 * f64::from(k)).map(|x| [x, 0.6 * x + shift]).collect();
        let line =
            |shift: f64, name: &str| MapLine { points: slope(shift), name: name.to_owned(), ..MapLine::default() };
        let map = Map {
            title: String::new(),
            subtitle: String::new(),
            x: axis(),
            y: axis(),
            entries: Vec::new(),
            ordered: false,
            unknown: String::new(),
            bodies: MapBodies::Points(Vec::new()),
            // Between the first three there is no room for a name.
            lines: vec![line(0.1, "the lowest"), line(0.12, "between"), line(0.14, "the highest"), line(3.0, "unseen")],
            impossible: Vec::new(),
            notes: Vec::new(),
            key: Vec::new(),
        };
        let view = MapView { x: [0.0, 1.0], y: [0.0, 1.0], rect: Rect { x: 0.0, y: 0.0, width: 500.0, height: 500.0 } };
        let names = names(&map, &view, &mut Taken::default());
        assert_eq!(names.iter().map(|name| name.of).collect::<Vec<_>>(), [0, 1, 2]);
        let mut lines = Taken::default();
        for shift in [0.1, 0.12, 0.14] {
            lines.take_line([view.at([0.0, shift]), view.at([1.0, 0.6 + shift])]);
        }
        for (place, name) in names.iter().enumerate() {
            assert!(lines.admits_box(&name.rect) && view.rect.contains(name.rect.center()));
            let [x, y] = name.leader.unwrap()[0];
            let line = view.at([x / 500.0, 0.6 * x / 500.0 + [0.1, 0.12, 0.14][name.of]]);
            assert!((line[1] - y).abs() < 1e-9, "the leader begins on its line");
            for other in &names[..place] {
                let mut taken = Taken::default();
                taken.take_box(other.rect);
                assert!(taken.admits_box(&name.rect));
            }
        }
    }
}
