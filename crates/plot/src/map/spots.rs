//! Where an entry lies that the map has no room to mark.

use super::model::MapBodies;
use super::view::{View, area};
use crate::page::short_number;

/// A place, and how far from it another entry may lie.
pub(super) struct Spot {
    at: [f64; 2],
    room: f64,
}

/// A place inside of the largest piece that shows an entry; `None` where nothing shows it, or bodies are points.
pub(super) fn spot(bodies: &MapBodies, entry: usize, view: &View) -> Option<Spot> {
    match bodies {
        MapBodies::Areas { pieces, .. } => {
            let own = pieces.iter().filter(|(shown, _)| *shown == Some(entry));
            let largest = own.max_by(|(_, p), (_, q)| area(p, view).total_cmp(&area(q, view)))?;
            Some(inside(&largest.1))
        }
        MapBodies::Grid { columns, entries } => {
            let cell = entries.iter().position(|shown| *shown == Some(entry))?;
            let rows = entries.len() / columns;
            let at = |[from, to]: [f64; 2], place: usize, count: usize| {
                from + (to - from) * (place as f64 + 0.5) / count as f64
            };
            let room = (view.x[1] - view.x[0]) / *columns as f64;
            Some(Spot { at: [at(view.x, cell % columns, *columns), at(view.y, cell / columns, rows)], room })
        }
        MapBodies::Points(_) => None,
    }
}

/// The middle of the widest level chord of a polygon, of those half-way between the heights of its corners.
fn inside(corners: &[[f64; 2]]) -> Spot {
    let mut heights: Vec<f64> = corners.iter().map(|corner| corner[1]).collect();
    heights.sort_by(f64::total_cmp);
    heights.dedup();
    let mut best = Spot { at: corners.first().copied().unwrap_or_default(), room: 0.0 };
    for pair in heights.windows(2) {
        let y = f64::midpoint(pair[0], pair[1]);
        let next = corners.iter().cycle().skip(1);
        let crossed = corners.iter().zip(next).filter(|(p, q)| (p[1] > y) != (q[1] > y));
        let mut ends: Vec<f64> = crossed.map(|(p, q)| p[0] + (y - p[1]) / (q[1] - p[1]) * (q[0] - p[0])).collect();
        ends.sort_by(f64::total_cmp);
        for chord in ends.chunks_exact(2) {
            if chord[1] - chord[0] > best.room {
                best = Spot { at: [f64::midpoint(chord[0], chord[1]), y], room: chord[1] - chord[0] };
            }
        }
    }
    best
}

/// A place with the digits that its room needs, four at least and eight at most.
pub(super) fn short_place(Spot { at, room }: Spot) -> String {
    let digits = |value: f64| {
        let needed = libm::log10(value.abs().max(f64::MIN_POSITIVE) / (0.1 * room).max(f64::MIN_POSITIVE)).ceil();
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped")]
        let digits = needed.clamp(4.0, 8.0) as usize;
        digits
    };
    at.map(|value| short_number(value, digits(value))).join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_spot_of_a_bent_area_lies_inside_of_it() {
        // A horseshoe, whose middle of gravity lies between its arms.
        let horseshoe =
            [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [3.0, 4.0], [3.0, 1.0], [1.0, 1.0], [1.0, 4.0], [0.0, 4.0]];
        let Spot { at, room } = inside(&horseshoe);
        assert_eq!((at, room), ([2.0, 0.5], 4.0));
        assert_eq!(short_place(Spot { at: [0.933_333_333, -2.0], room: 1e-3 }), "0.9333, −2");
        assert_eq!(short_place(Spot { at: [0.933_333_333, -2.0], room: 1e-4 }), "0.93333, −2");
    }
}
