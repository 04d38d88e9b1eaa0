//! Whether a surface cuts itself: an edge of one triangle that passes through the inside of another.
//!
//! Signs of determinants are exact: those of `f64` where Shewchuk's bound (Discrete Comput. Geom. 18, 1997, orient3d) lets them
//! count, rational ones elsewhere. Surfaces that only touch do not cut each other.

use bifdiag_numbers::Sign;
use dashu_ratio::RBig;

use super::surface::{Mesh, MeshError};

type Point = [f64; 3];

/// Refuses a mesh that cuts itself.
pub(super) fn check(mesh: &Mesh) -> Result<(), MeshError> {
    let (triangles, corners) = (mesh.triangles(), mesh.corners());
    let boxes: Vec<[Point; 2]> = triangles.iter().map(|triangle| bounds(triangle.map(|k| corners[k]))).collect();
    // Sorted by their least x: those that begin after the end of one need not be compared with it.
    let mut order: Vec<usize> = (0..triangles.len()).collect();
    order.sort_by(|&p, &q| boxes[p][0][0].total_cmp(&boxes[q][0][0]));
    let mut found: Option<(usize, Point, Point)> = None;
    for (place, &p) in order.iter().enumerate() {
        let later = order[place + 1..].iter().take_while(|&&q| boxes[q][0][0] <= boxes[p][1][0]);
        for &q in later.filter(|&&q| overlap(&boxes[p], &boxes[q])) {
            let crossing = [(p, q), (q, p)].into_iter().find_map(|(p, q)| pierced(mesh, triangles[p], triangles[q]));
            if let Some([from, to]) = crossing {
                found = Some(found.map_or((1, from, to), |(count, from, to)| (count + 1, from, to)));
            }
        }
    }
    found.map_or(Ok(()), |(pairs, from, to)| Err(MeshError::Crossing { pairs, from, to }))
}

fn bounds(points: [Point; 3]) -> [Point; 2] {
    let end = |choose: fn(f64, f64) -> f64| -> Point {
        std::array::from_fn(|i| points[1..].iter().fold(points[0][i], |x, point| choose(x, point[i])))
    };
    [end(f64::min), end(f64::max)]
}

fn overlap(p: &[Point; 2], q: &[Point; 2]) -> bool {
    (0..3).all(|i| p[0][i] <= q[1][i] && q[0][i] <= p[1][i])
}

/// An edge of the first triangle that passes through the inside of the second one.
fn pierced(mesh: &Mesh, edges: [usize; 3], face: [usize; 3]) -> Option<[Point; 2]> {
    let at = |k: usize| mesh.corners()[k];
    let [a, b, c] = face.map(at);
    (0..3).map(|k| [edges[k], edges[(k + 1) % 3]]).find_map(|ends| {
        // What shares a corner with the face meets its plane there.
        if ends.iter().any(|end| face.contains(end)) {
            return None;
        }
        let [from, to] = ends.map(at);
        if orientation(a, b, c, from) * orientation(a, b, c, to) != Sign::Negative {
            return None;
        }
        let sides = [orientation(from, to, a, b), orientation(from, to, b, c), orientation(from, to, c, a)];
        (sides[0] != Sign::Zero && sides.iter().all(|side| *side == sides[0])).then_some([from, to])
    })
}

/// The sign of det(a − d, b − d, c − d), exactly.
pub(super) fn orientation(a: Point, b: Point, c: Point, d: Point) -> Sign {
    let [u, v, w] = [a, b, c].map(|p| -> Point { std::array::from_fn(|i| p[i] - d[i]) });
    let (mut sum, mut size) = (0.0, 0.0);
    for i in 0..3 {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        let (plus, minus) = (v[j] * w[k], v[k] * w[j]);
        sum += u[i] * (plus - minus);
        size += u[i].abs() * (plus.abs() + minus.abs());
    }
    // (7 + 56ε)ε with ε = 2^-53; below, products may have underflowed.
    let bound = 7.9e-16 * size;
    if sum.abs() > bound && bound > 1e-280 && size.is_finite() {
        return if sum > 0.0 { Sign::Positive } else { Sign::Negative };
    }
    let exact = |x: f64| RBig::try_from(x).unwrap_or(RBig::ZERO);
    let [u, v, w] = [a, b, c].map(|p| -> [RBig; 3] { std::array::from_fn(|i| exact(p[i]) - exact(d[i])) });
    let minor = |j: usize, k: usize| &v[j] * &w[k] - &v[k] * &w[j];
    let determinant = &u[0] * minor(1, 2) + &u[1] * minor(2, 0) + &u[2] * minor(0, 1);
    determinant.cmp(&RBig::ZERO).into()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The faces of a box with one corner at `from`.
    fn cuboid(from: Point, to: Point) -> Vec<[Point; 3]> {
        let corner = |k: usize| std::array::from_fn(|i| if k >> i & 1 == 0 { from[i] } else { to[i] });
        let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        faces.into_iter().flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]).map(|triangle| triangle.map(corner)).collect()
    }

    fn check_of(faces: Vec<[Point; 3]>) -> Result<(), MeshError> {
        check(&Mesh::from_triangles(faces))
    }

    #[test]
    fn boxes_that_cross_are_found_and_those_that_touch_are_not() {
        let one = cuboid([0.0; 3], [2.0, 4.0, 6.0]);
        assert_eq!(check_of(one.clone()), Ok(()));
        for shift in [[1.0, 1.0, 1.0], [0.3, -1.7, 5.9], [1.999_999_999, 0.5, 0.25]] {
            let other = cuboid(shift, std::array::from_fn(|i| shift[i] + 3.0 + i as f64));
            let both = one.iter().copied().chain(other).collect();
            assert!(matches!(check_of(both), Err(MeshError::Crossing { .. })), "{shift:?}");
        }
        // Side by side, and a cavity.
        for other in [cuboid([2.0, 0.0, 0.0], [3.0, 4.0, 6.0]), cuboid([0.5; 3], [1.5; 3])] {
            assert_eq!(check_of(one.iter().copied().chain(other).collect()), Ok(()));
        }
    }

    /// A tetrahedron whose tip is pushed through the opposite face of a box cut into many triangles.
    #[test]
    fn one_corner_through_a_face_is_found() {
        let (base, tip) = ([[0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [0.0, 1.0, 1.0]], [0.25, 0.25, 0.25]);
        let spike = |tip: Point| {
            let [a, b, c] = base;
            vec![[a, b, tip], [b, c, tip], [c, a, tip]]
        };
        let floor = vec![[[-1.0, -1.0, 0.0], [3.0, -1.0, 0.0], [-1.0, 3.0, 0.0]]];
        let with = |z: f64| spike([tip[0], tip[1], z]).into_iter().chain(floor.clone()).collect::<Vec<_>>();
        assert_eq!(check_of(with(0.25)), Ok(()));
        assert_eq!(check_of(with(0.0)), Ok(()));
        assert!(check_of(with(-1e-300)).is_err());
    }
}
