//! Where an entry lies that the map has no room to mark.

use super::model::MapBodies;
use super::view::View;
use crate::page::{Point, distance, short_number};

/// The place of a body, and in both parameters how far from it another entry may lie.
#[derive(Clone, Copy)]
pub(super) struct Spot {
    at: [f64; 2],
    room: [f64; 2],
}

/// The place of a body that shows an entry, as far from borders as one is known; `None` where none is known, or bodies are
/// points.
pub(super) fn spot(bodies: &MapBodies, entry: usize, view: &View) -> Option<Spot> {
    match bodies {
        MapBodies::Areas { seen, borders, .. } => {
            let own = seen.iter().filter(|(shown, _)| *shown == entry);
            let spots = own.map(|(_, at)| (clearance(view.at(*at), borders, view), *at));
            let (clear, at) = spots.max_by(|(p, _), (q, _)| p.total_cmp(q))?;
            let room = [(view.x, view.rect.width), (view.y, view.rect.height)]
                .map(|([from, to], pixels)| clear * (to - from) / pixels);
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

/// Distance on the page from the nearest border, or edge of the map.
fn clearance(point: Point, borders: &[[[f64; 2]; 2]], view: &View) -> f64 {
    let rect = &view.rect;
    let edges = [point[0] - rect.x, rect.right() - point[0], point[1] - rect.y, rect.bottom() - point[1]];
    let edge = edges.into_iter().map(f64::abs).filter(|edge| *edge > 0.0).fold(f64::INFINITY, f64::min);
    borders.iter().map(|ends| from_line(point, ends.map(|end| view.at(end)))).fold(edge, f64::min)
}

/// Distance of a point from a straight line between two others.
fn from_line(point: Point, [from, to]: [Point; 2]) -> f64 {
    let along = [to[0] - from[0], to[1] - from[1]];
    let square = along[0] * along[0] + along[1] * along[1];
    let share = ((point[0] - from[0]) * along[0] + (point[1] - from[1]) * along[1]) / square.max(f64::MIN_POSITIVE);
    let share = share.clamp(0.0, 1.0);
    distance(point, [from[0] + share * along[0], from[1] + share * along[1]])
}

/// Digits that tell any number exactly.
const EXACT: f64 = 17.0;

/// A place with the digits that its room needs, four at least.
pub(super) fn short_place(Spot { at, room }: Spot) -> String {
    let digits = |value: f64, room: f64| {
        let needed = libm::log10(value.abs().max(f64::MIN_POSITIVE) / (0.1 * room).max(f64::MIN_POSITIVE)).ceil();
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped")]
        let digits = needed.clamp(4.0, EXACT) as usize;
        digits
    };
    [0, 1].map(|axis| short_number(at[axis], digits(at[axis], room[axis]))).join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::page::Rect;

    fn view() -> View {
        View { x: [0.0, 1.0], y: [0.0, 2.0], rect: Rect { x: 0.0, y: 0.0, width: 100.0, height: 100.0 } }
    }

    fn areas(seen: Vec<(usize, [f64; 2])>) -> MapBodies {
        let borders = vec![[[0.5, 0.0], [0.5, 2.0]], [[1.0 / 3.0, 0.0], [1.0 / 3.0, 2.0]]];
        MapBodies::Areas { pieces: Vec::new(), seen, borders, told: String::new() }
    }

    #[test]
    fn the_place_of_an_entry_is_that_of_its_body_farthest_from_borders() {
        let bodies = areas(vec![(0, [0.45, 1.0]), (0, [0.4, 1.0]), (1, [0.75, 1.0])]);
        let Spot { at, room } = spot(&bodies, 0, &view()).unwrap();
        let nearest = 0.4 - 1.0 / 3.0;
        assert!(at == [0.4, 1.0] && (room[0] - nearest).abs() < 1e-12 && (room[1] - 2.0 * nearest).abs() < 1e-12);
        assert!(spot(&bodies, 2, &view()).is_none());
    }

    #[test]
    fn a_place_on_a_border_is_told_exactly() {
        let bodies = areas(vec![(0, [0.5, 1.0]), (1, [1.0 / 3.0, 1.0])]);
        assert_eq!(spot(&bodies, 0, &view()).map(short_place).as_deref(), Some("0.5, 1"));
        let third = spot(&bodies, 1, &view()).map(short_place).unwrap();
        assert_eq!(third.strip_suffix(", 1").unwrap().parse(), Ok(1.0 / 3.0));
    }

    #[test]
    fn places_have_the_digits_that_their_room_needs() {
        let place = |room| short_place(Spot { at: [0.933_333_333, -2.0], room: [room; 2] });
        assert_eq!((place(1e-3).as_str(), place(1e-4).as_str()), ("0.9333, −2", "0.93333, −2"));
    }
}
