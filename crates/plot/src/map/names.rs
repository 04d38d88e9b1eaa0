//! Where the names of lines stand: beside the line, upon no other.

use super::free::{CLEAR, beside};
use super::model::{Map, MapLine};
use super::view::{SMALL, View};
use crate::page::{Point, Rect, Taken, distance, text_width};

/// Lines are looked at in parts of so many pixels.
const PART: f64 = 4.0;
/// The most points of a line from which a leader is tried.
const TIPS: usize = 48;

/// A name with its place.
pub(super) struct Name {
    /// The index of its line.
    pub line: usize,
    pub rect: Rect,
    /// From the line to the name.
    pub leader: [Point; 2],
}

/// The names of all lines that have one and are seen; takes their places.
pub(super) fn named(map: &Map, view: &View, taken: &mut Taken, leaders: &mut Vec<[Point; 2]>) -> Vec<Name> {
    if map.lines.iter().all(|line| line.name.is_empty()) {
        return Vec::new();
    }
    let parts: Vec<Vec<Point>> = map.lines.iter().map(|line| parts(line, view)).collect();
    let mut drawn = taken.clone();
    for ends in parts.iter().flat_map(|points| points.windows(2)) {
        drawn.take_line([ends[0], ends[1]]);
    }
    let mut names = Vec::new();
    for (line, points) in parts.iter().enumerate().filter(|(line, _)| !map.lines[*line].name.is_empty()) {
        let size = [text_width(&map.lines[line].name, SMALL) + 4.0, SMALL + 4.0];
        let seen: Vec<Point> = points.iter().copied().filter(|point| view.rect.contains(*point)).collect();
        let tips: Vec<Point> = seen.iter().copied().step_by(seen.len().div_ceil(TIPS).max(1)).collect();
        // Upon other lines only where nothing else is free.
        let place = beside(&tips, size, view, &drawn, leaders).or_else(|| beside(&tips, size, view, taken, leaders));
        let Some((rect, leader)) = place else { continue };
        for taken in [&mut drawn, &mut *taken] {
            taken.take_box(rect.grown(CLEAR));
            taken.take_line(leader);
        }
        leaders.push(leader);
        names.push(Name { line, rect, leader });
    }
    names
}

/// The points of a line on the page, so far apart.
fn parts(line: &MapLine, view: &View) -> Vec<Point> {
    let mut points: Vec<Point> = Vec::new();
    let all: Vec<Point> = line.points.iter().map(|point| view.at(*point)).collect();
    for (place, point) in all.iter().enumerate() {
        if place + 1 == all.len() || points.last().is_none_or(|last| distance(*last, *point) >= PART) {
            points.push(*point);
        }
    }
    points
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::map::{MapAxis, MapBodies};

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
            notes: Vec::new(),
        };
        let view = View { x: [0.0, 1.0], y: [0.0, 1.0], rect: Rect { x: 0.0, y: 0.0, width: 500.0, height: 500.0 } };
        let names = named(&map, &view, &mut Taken::default(), &mut Vec::new());
        assert_eq!(names.iter().map(|name| name.line).collect::<Vec<_>>(), [0, 1, 2]);
        let mut lines = Taken::default();
        for shift in [0.1, 0.12, 0.14] {
            lines.take_line([view.at([0.0, shift]), view.at([1.0, 0.6 + shift])]);
        }
        for (place, name) in names.iter().enumerate() {
            assert!(lines.admits_box(&name.rect) && view.rect.contains(name.rect.center()));
            let [x, y] = name.leader[0];
            let line = view.at([x / 500.0, 0.6 * x / 500.0 + [0.1, 0.12, 0.14][name.line]]);
            assert!((line[1] - y).abs() < 1e-9, "the leader begins on its line");
            for other in &names[..place] {
                let mut taken = Taken::default();
                taken.take_box(other.rect);
                assert!(taken.admits_box(&name.rect));
            }
        }
    }
}
