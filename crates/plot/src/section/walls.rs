//! Areas without the upright sides along which their parts meet: a viewer of PDF shows such sides as hairlines.

use std::collections::BTreeMap;

use crate::page::{Path, Point, to_pixels, to_units};

/// A corner in canvas units.
type Corner = [i32; 2];

/// The points that an odd number of closed lines encloses, bounded by as few upright sides as that needs.
pub(super) fn area(loops: impl Iterator<Item = Vec<Point>>) -> Path {
    let loops: Vec<Vec<Point>> = loops.collect();
    let mut sides: Vec<[Corner; 2]> = Vec::new();
    // The ends of upright sides along each of their lines.
    let mut uprights: BTreeMap<i32, Vec<i32>> = BTreeMap::new();
    for line in &loops {
        let corners: Vec<Corner> = line.iter().map(|point| point.map(to_units)).collect();
        for (place, &from) in corners.iter().enumerate() {
            let to = corners[(place + 1) % corners.len()];
            if from[0] != to[0] {
                sides.push([from, to]);
            } else if from != to {
                uprights.entry(from[0]).or_default().extend([from[1], to[1]]);
            }
        }
    }
    let length = |ends: &[i32]| ends.chunks_exact(2).map(|side| i64::from(side[0].abs_diff(side[1]))).sum::<i64>();
    let mut is_shared = false;
    for (x, mut ends) in uprights {
        let passed = length(&ends);
        ends.sort_unstable();
        // What is passed an even number of times drops out.
        is_shared |= length(&ends) < passed;
        let left = ends.chunks_exact(2).filter(|side| side[0] != side[1]);
        sides.extend(left.map(|side| [[x, side[0]], [x, side[1]]]));
    }
    let mut path = Path::default();
    if is_shared {
        for line in joined(&sides) {
            path.line(&line, true);
        }
    } else {
        for line in &loops {
            path.line(line, true);
        }
    }
    path
}

/// Closed lines of sides, of which an even number ends in every corner.
fn joined(sides: &[[Corner; 2]]) -> Vec<Vec<Point>> {
    let mut at_corner: BTreeMap<Corner, Vec<usize>> = BTreeMap::new();
    for (number, ends) in sides.iter().enumerate().rev() {
        for corner in ends {
            at_corner.entry(*corner).or_default().push(number);
        }
    }
    let mut is_left = vec![true; sides.len()];
    let mut lines = Vec::new();
    for number in 0..sides.len() {
        if !is_left[number] {
            continue;
        }
        let mut at = sides[number][0];
        let mut line = Vec::new();
        while let Some(next) = at_corner.get_mut(&at).and_then(|own| {
            own.retain(|side| is_left[*side]);
            own.pop()
        }) {
            is_left[next] = false;
            line.push(at.map(to_pixels));
            let [from, to] = sides[next];
            at = if at == from { to } else { from };
        }
        lines.push(line);
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(x: f64, y: f64) -> Vec<Point> {
        vec![[x, y], [x + 1.0, y], [x + 1.0, y + 2.0], [x, y + 2.0]]
    }

    #[test]
    fn parts_that_meet_in_a_wall_are_one() {
        // The second lies half a side lower, walked the other way round.
        let mut other = square(1.0, 1.0);
        other.reverse();
        let path = area([square(0.0, 0.0), other].into_iter());
        assert_eq!(path.data().matches('M').count(), 1, "{}", path.data());
        // Along x = 1 the upper and the lower quarter are left.
        assert_eq!(path.data(), "M0 0l10 0 0 10 10 0 0 20 -10 0 0-10 -10 0z");
    }

    #[test]
    fn areas_without_a_common_wall_stay_as_they_are() {
        let mut path = Path::default();
        path.line(&square(0.0, 0.0), true);
        path.line(&square(3.0, 0.0), true);
        assert_eq!(area([square(0.0, 0.0), square(3.0, 0.0)].into_iter()).data(), path.data());
    }
}
