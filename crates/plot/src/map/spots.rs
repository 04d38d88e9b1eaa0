//! Where an entry lies that the map has no room to mark.

use super::model::{MapBodies, MapView};
use bifdiag_page::{Point, distance, short_number};

/// The place of a body, and in both parameters how far from it another entry may lie.
#[derive(Clone, Copy)]
pub(super) struct Spot {
    at: [f64; 2],
    room: [f64; 2],
}

/// The place of a body that shows an entry, as far from borders as one is known; `None` where none is known, or bodies are
/// points.
pub(super) fn spot(bodies: &MapBodies, entry: usize, view: &MapView) -> Option<Spot> {
    match bodies {
        MapBodies::Areas { seen, borders, .. } => {
            let own = seen.iter().filter(|(shown, _)| *shown == entry);
            let (at, clear) =
                own.map(|(_, at)| (*at, clear(view.at(*at), borders, view))).max_by(|(p, room), (q, other)| {
                    let [p, q] = [(p, room), (q, other)].map(|(at, room)| seclusion(view.at(*at), *room, view));
                    p[0].total_cmp(&q[0]).then(p[1].total_cmp(&q[1]))
                })?;
            let at = shortened(at, borders, view);
            let ranges = [(view.x, view.rect.width), (view.y, view.rect.height)];
            let room = [0, 1].map(|axis| {
                let ([from, to], pixels) = ranges[axis];
                clear[axis] * (to - from) / pixels
            });
            Some(Spot { at, room })
        }
        MapBodies::Grid { columns, entries } => {
            let cell = entries.iter().position(|shown| *shown == Some(entry))?;
            let rows = entries.len() / columns;
            let at = |[from, to]: [f64; 2], place: usize, count: usize| {
                from + (to - from) * (place as f64 + 0.5) / count as f64
            };
            let room = [(view.x, *columns), (view.y, rows)].map(|([from, to], count)| (to - from) / count as f64);
            Some(Spot { at: [at(view.x, cell % columns, *columns), at(view.y, cell / columns, rows)], room })
        }
        MapBodies::Points(_) => None,
    }
}

/// A place on a border with few digits in both coordinates, if it lies on that border too and no other is near.
fn shortened(at: [f64; 2], borders: &[[[f64; 2]; 2]], view: &MapView) -> [f64; 2] {
    /// On the page, by how much a place may be off a border on which it lies, and how far it may move along it.
    const ON: f64 = 1e-10;
    const MOVED: f64 = 0.05;
    let off = |place: [f64; 2]| {
        move |ends: &[[f64; 2]; 2]| {
            let [from, to] = ends.map(|end| view.at(end));
            from_segment(view.at(place), from, to)
        }
    };
    let own: Vec<_> = borders.iter().filter(|ends| off(at)(ends) < ON).collect();
    let others = borders.iter().map(off(at)).filter(|distance| *distance >= ON).fold(f64::INFINITY, f64::min);
    let rounded = |digits: usize| at.map(|value| format!("{value:.*e}", digits - 1).parse().unwrap_or(value));
    let is_as_good = |place: &[f64; 2]| {
        own.iter().all(|ends| off(*place)(ends) < ON)
            && distance(view.at(at), view.at(*place)) < MOVED.min(0.3 * others)
    };
    if own.is_empty() { at } else { (4..10).map(rounded).find(is_as_good).unwrap_or(at) }
}

/// How far a point is from a segment.
fn from_segment(point: Point, from: Point, to: Point) -> f64 {
    let [x, y] = [to[0] - from[0], to[1] - from[1]];
    let along = ((point[0] - from[0]) * x + (point[1] - from[1]) * y) / (x * x + y * y);
    let share = if along.is_finite() { along.clamp(0.0, 1.0) } else { 0.0 };
    distance(point, [from[0] + share * x, from[1] + share * y])
}

/// How far on the page the next border is to the left or right of a point, and how far above or below; a border on which
/// the point lies is no bar along itself.
fn clear(point: Point, borders: &[[[f64; 2]; 2]], view: &MapView) -> [f64; 2] {
    let along = |axis: usize| {
        let across = 1 - axis;
        let met = borders.iter().filter_map(|ends| {
            let [from, to] = ends.map(|end| view.at(end));
            let share = (point[across] - from[across]) / (to[across] - from[across]);
            let at = from[axis] + share * (to[axis] - from[axis]);
            (0.0..=1.0).contains(&share).then(|| (at - point[axis]).abs())
        });
        met.fold(f64::INFINITY, f64::min)
    };
    [along(0), along(1)]
}

/// The shorter and the longer of the two ways that are clear, within the map.
fn seclusion(point: Point, clear: [f64; 2], view: &MapView) -> [f64; 2] {
    let rect = &view.rect;
    let x = clear[0].min(point[0] - rect.x).min(rect.right() - point[0]);
    let y = clear[1].min(point[1] - rect.y).min(rect.bottom() - point[1]);
    [x.min(y), x.max(y)]
}

/// A place with the digits that its room needs, four at least.
pub(super) fn short_place(Spot { at, room }: Spot) -> String {
    /// Digits that represent any double exactly.
    const EXACT: usize = 17;
    /// The part of its room by which a coordinate may be off, so that both together leave the place clear of a slanted border.
    const OFF: f64 = 0.3;
    let digits = |value: f64, room: f64| {
        let is_near = |listed: f64| (listed - value).abs() <= OFF * room;
        let is_enough = |digits: &usize| format!("{value:.*e}", digits - 1).parse().is_ok_and(is_near);
        (4..EXACT).find(is_enough).unwrap_or(EXACT)
    };
    [0, 1].map(|axis| short_number(at[axis], digits(at[axis], room[axis]))).join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use bifdiag_page::Rect;

    fn view() -> MapView {
        MapView { x: [0.0, 1.0], y: [0.0, 2.0], rect: Rect { x: 0.0, y: 0.0, width: 100.0, height: 100.0 } }
    }

    fn areas(seen: Vec<(usize, [f64; 2])>) -> MapBodies {
        let borders = vec![[[0.5, 0.0], [0.5, 2.0]], [[1.0 / 3.0, 0.0], [1.0 / 3.0, 2.0]]];
        MapBodies::Areas { pieces: Vec::new(), seen, borders, legend: String::new() }
    }

    #[test]
    fn the_place_of_an_entry_is_that_of_its_body_farthest_from_borders() {
        let bodies = areas(vec![(0, [0.45, 1.0]), (0, [0.4, 1.0]), (1, [0.75, 1.0])]);
        let Spot { at, room } = spot(&bodies, 0, &view()).unwrap();
        let nearest = 0.4 - 1.0 / 3.0;
        assert!(at == [0.4, 1.0] && (room[0] - nearest).abs() < 1e-12 && room[1] == f64::INFINITY);
        assert!(spot(&bodies, 2, &view()).is_none());
    }

    #[test]
    fn a_place_on_a_border_is_told_exactly() {
        let bodies = areas(vec![(0, [0.5, 1.0]), (1, [1.0 / 3.0, 1.123_456])]);
        assert_eq!(spot(&bodies, 0, &view()).map(short_place).as_deref(), Some("0.5, 1"));
        // Its height is free.
        let third = spot(&bodies, 1, &view()).map(short_place).unwrap();
        assert_eq!(third.strip_suffix(", 1.123").unwrap().parse(), Ok(1.0 / 3.0));
    }

    #[test]
    fn a_place_on_a_slanted_border_is_told_in_few_digits_where_they_lie_on_it_too() {
        let at = [1.370_108_695_652_174; 2];
        let view = MapView { x: [0.0, 2.0], y: [0.0, 2.0], rect: Rect { x: 0.0, y: 0.0, width: 500.0, height: 500.0 } };
        let diagonal = [[1.0, 1.0], [2.0, 2.0]];
        assert_eq!(shortened(at, &[diagonal], &view), [1.37; 2]);
        // Not off another one.
        let steep = [[at[0], 0.0], [at[0], 2.0]];
        assert_eq!(shortened(at, &[diagonal, steep], &view), at);
        assert_eq!(shortened(at, &[], &view), at);
    }

    #[test]
    fn places_have_the_digits_that_their_room_needs() {
        let place = |room| short_place(Spot { at: [0.933_333_333, -2.0], room: [room; 2] });
        assert_eq!((place(1e-3).as_str(), place(1e-4).as_str()), ("0.9333, −2", "0.93333, −2"));
    }
}
