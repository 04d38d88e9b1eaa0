//! Unions of polygons without the sides along which they meet: a viewer of PDF shows such sides as hairlines.

use std::collections::BTreeMap;

use super::geometry::{Point, to_pixels, to_units};
use super::path::Path;

/// A corner in canvas units.
type Corner = [i32; 2];

/// The points that an odd number of polygons encloses. Polygons meet, if at all, along sides on which the coordinate `fixed`
/// does not change; of these the path has as few as that needs.
pub fn union(polygons: impl IntoIterator<Item = Vec<Point>>, fixed: usize) -> Path {
    let mut path = Path::default();
    for line in outlines(polygons, fixed) {
        path.line(&line, true);
    }
    path
}

/// The same as closed lines.
pub fn outlines(polygons: impl IntoIterator<Item = Vec<Point>>, fixed: usize) -> Vec<Vec<Point>> {
    let polygons: Vec<Vec<Point>> = polygons.into_iter().collect();
    let mut sides: Vec<[Corner; 2]> = Vec::new();
    // The ends of the sides along each line on which polygons may meet.
    let mut shared: BTreeMap<i32, Vec<i32>> = BTreeMap::new();
    for polygon in &polygons {
        let corners: Vec<Corner> = polygon.iter().map(|point| point.map(to_units)).collect();
        for (place, &from) in corners.iter().enumerate() {
            let to = corners[(place + 1) % corners.len()];
            if from[fixed] != to[fixed] {
                sides.push([from, to]);
            } else if from != to {
                shared.entry(from[fixed]).or_default().extend([from[1 - fixed], to[1 - fixed]]);
            }
        }
    }
    let length = |ends: &[i32]| ends.chunks_exact(2).map(|side| i64::from(side[0].abs_diff(side[1]))).sum::<i64>();
    let mut is_shared = false;
    for (line, mut ends) in shared {
        let passed = length(&ends);
        ends.sort_unstable();
        // What is passed an even number of times drops out.
        is_shared |= length(&ends) < passed;
        let corner = |end: i32| if fixed == 0 { [line, end] } else { [end, line] };
        let left = ends.chunks_exact(2).filter(|side| side[0] != side[1]);
        sides.extend(left.map(|side| [corner(side[0]), corner(side[1])]));
    }
    if is_shared { joined(&sides) } else { polygons }
}

/// Closed lines of sides; an even number ends in every corner.
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
    fn parts_that_meet_are_one() {
        // The second lies half a side lower, walked the other way round.
        let mut other = square(1.0, 1.0);
        other.reverse();
        // Along x = 1 the upper and the lower quarter are left.
        assert_eq!(union([square(0.0, 0.0), other], 0).data(), "M0 0l10 0 0 10 10 0 0 20 -10 0 0-10 -10 0z");
        // One on the other, the upper one half a side to the right.
        let turned = |square: Vec<Point>| square.into_iter().map(|[x, y]| [y, x]).collect::<Vec<Point>>();
        let path = union([turned(square(0.0, 0.0)), turned(square(1.0, 1.0))], 1);
        assert_eq!(path.data(), "M0 0l0 10 10 0 0 10 20 0 0-10 -10 0 0-10z");
    }

    #[test]
    fn a_hole_is_left_by_what_lies_round_it() {
        let rect = |x: f64, y: f64, width: f64, height: f64| {
            vec![[x, y + height], [x + width, y + height], [x + width, y], [x, y]]
        };
        let sides = [rect(0.0, 1.0, 1.0, 1.0), rect(2.0, 1.0, 1.0, 1.0)];
        let whole = [rect(0.0, 0.0, 3.0, 1.0), rect(0.0, 2.0, 3.0, 1.0)];
        let path = union(whole.into_iter().chain(sides), 1);
        assert_eq!(path.data().matches('z').count(), 2, "{}", path.data());
    }

    #[test]
    fn parts_that_do_not_meet_stay_as_they_are() {
        let mut path = Path::default();
        path.line(&square(0.0, 0.0), true);
        path.line(&square(3.0, 0.0), true);
        assert_eq!(union([square(0.0, 0.0), square(3.0, 0.0)], 0).data(), path.data());
    }
}
