//! Whether triangles form closed surfaces with one orientation, none inside out.

use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::f64::consts::TAU;

use bifdiag_numbers::Sign;
use bifdiag_numbers::table::Partition;
use bifdiag_numbers::vector::{cross, dot, norm};

use super::crossing::orientation;
use super::integrals::VolumeIntegrals;
use super::surface::{Mesh, MeshError};

/// Whether an edge with the triangles at it is wrong.
type Wrong<'a> = dyn Fn(&[usize; 2], &[(usize, bool)]) -> bool + 'a;

/// The closed surfaces of a mesh, one for each side that a solid turns to the outside or to a cavity, as lists of triangles.
/// Where solids touch, more than two triangles may meet at an edge: those beside a wedge of material belong together.
pub(super) fn surfaces(mesh: &Mesh) -> Result<Vec<Vec<[usize; 3]>>, MeshError> {
    if mesh.triangles().is_empty() {
        return Err(MeshError::Empty);
    }
    // The triangles at each edge, and whether they pass it forward.
    let mut passed: BTreeMap<[usize; 2], Vec<(usize, bool)>> = BTreeMap::new();
    for (number, triangle) in mesh.triangles().iter().enumerate() {
        for k in 0..3 {
            let (a, b) = (triangle[k], triangle[(k + 1) % 3]);
            passed.entry([a.min(b), a.max(b)]).or_default().push((number, a < b));
        }
    }
    let wrong = |is: &Wrong<'_>| {
        let mut found = passed.iter().filter(|(ends, at)| is(ends, at)).map(|(ends, _)| *ends);
        let first = found.next()?;
        Some((1 + found.count(), mesh.corners()[first[0]], mesh.corners()[first[1]]))
    };
    let forward = |at: &[(usize, bool)]| at.iter().filter(|(_, forward)| *forward).count();
    if let Some((edges, from, to)) = wrong(&|_, at| at.len() == 1) {
        return Err(MeshError::Open { edges, from, to });
    }
    if let Some((edges, from, to)) = wrong(&|_, at| at.len() == 2 && forward(at) != 1) {
        return Err(MeshError::Mixed { edges, from, to });
    }
    if let Some((edges, from, to)) = wrong(&|ends, at| at.len() > 2 && wedges(mesh, *ends, at).is_none()) {
        return Err(MeshError::Branched { edges, from, to });
    }
    let mut joined = Partition::new(mesh.triangles().len());
    for (ends, at) in &passed {
        for [first, second] in wedges(mesh, *ends, at).unwrap_or_default() {
            joined.unite(first, second);
        }
    }
    let mut surfaces: BTreeMap<usize, Vec<[usize; 3]>> = BTreeMap::new();
    for (number, triangle) in mesh.triangles().iter().enumerate() {
        surfaces.entry(joined.find(number)).or_default().push(*triangle);
    }
    Ok(surfaces.into_values().collect())
}

/// The pairs of triangles with material between them, round an edge; `None` where space would be counted twice or less than
/// not at all.
///
/// Seen along the edge, material lies behind a triangle that passes it forward and ahead of one that passes it backward, by
/// rising angle: in their order round the edge they must take turns. Two at one angle touch, in either order.
fn wedges(mesh: &Mesh, [a, b]: [usize; 2], at: &[(usize, bool)]) -> Option<Vec<[usize; 2]>> {
    if let [(first, one), (second, other)] = at {
        return (one != other).then(|| vec![[*first, *second]]);
    }
    let [from, to] = [a, b].map(|k| mesh.corners()[k]);
    let opposite = |number: usize| {
        let corner = mesh.triangles()[number].into_iter().find(|&k| k != a && k != b);
        corner.map(|k| mesh.corners()[k])
    };
    let first = opposite(at.first()?.0)?;
    // 0: at the angle of the first, 1: ahead of it up to a half turn, 2: opposite, 3: behind.
    let sector = |tip: [f64; 3]| match orientation(from, to, first, tip) {
        Sign::Negative => 1,
        Sign::Positive => 3,
        Sign::Zero => {
            let edge: [f64; 3] = std::array::from_fn(|i| to[i] - from[i]);
            let across = |tip: [f64; 3]| cross(edge, std::array::from_fn(|i| tip[i] - from[i]));
            if dot(across(first), across(tip)) > 0.0 { 0 } else { 2 }
        }
    };
    let mut order = Vec::with_capacity(at.len());
    for &(number, forward) in at {
        let tip = opposite(number)?;
        order.push((sector(tip), tip, number, forward));
    }
    let angle = |p: &(i32, [f64; 3], usize, bool), q: &(i32, [f64; 3], usize, bool)| {
        p.0.cmp(&q.0).then_with(|| match orientation(from, to, p.1, q.1) {
            Sign::Negative => Ordering::Less,
            Sign::Positive => Ordering::Greater,
            Sign::Zero => Ordering::Equal,
        })
    };
    order.sort_by(angle);
    [false, true].into_iter().find_map(|inside| {
        let mut rest = order.clone();
        let (mut inside, mut turns) = (inside, Vec::new());
        while let Some(next) = rest.first().copied() {
            // Of those at the same angle, the next one in turn.
            let alike = rest.iter().take_while(|other| angle(&next, other) == Ordering::Equal);
            let place = alike.into_iter().position(|(.., forward)| *forward == inside)?;
            let (.., number, forward) = rest.remove(place);
            inside = !forward;
            turns.push((number, forward));
        }
        let start = turns.iter().position(|(_, forward)| !forward)?;
        turns.rotate_left(start);
        Some(turns.chunks(2).map(|pair| [pair[0].0, pair[pair.len() - 1].0]).collect())
    })
}

/// Checks that each closed surface has material, once, on its inner side.
pub(super) fn check_sides(mesh: &Mesh, surfaces: &[Vec<[usize; 3]>]) -> Result<(), MeshError> {
    for triangles in surfaces {
        let around = winding(mesh, mesh.triangles().iter(), inside(mesh, triangles));
        let count = triangles.len();
        if around > 1.5 {
            return Err(MeshError::Nested { triangles: count });
        }
        if around < 0.5 {
            let volume = VolumeIntegrals::over(mesh, triangles).volume.to_f64().value();
            return Err(MeshError::Inverted { triangles: count, volume });
        }
    }
    Ok(())
}

/// A point just behind the middle of the largest triangle of a surface.
fn inside(mesh: &Mesh, triangles: &[[usize; 3]]) -> [f64; 3] {
    /// Relative to the height of the triangle.
    const DEPTH: f64 = 1e-8;
    let corners = |triangle: &[usize; 3]| triangle.map(|k| mesh.corners()[k]);
    let normal = |[a, b, c]: [[f64; 3]; 3]| {
        let side = |p: [f64; 3]| std::array::from_fn(|i| p[i] - a[i]);
        cross(side(b), side(c))
    };
    let area = |triangle: &&[usize; 3]| norm(normal(corners(triangle)));
    let largest = triangles.iter().max_by(|p, q| area(p).total_cmp(&area(q)));
    let Some([a, b, c]) = largest.map(corners) else { return [0.0; 3] };
    let normal = normal([a, b, c]);
    let length = |p: [f64; 3], q: [f64; 3]| norm(std::array::from_fn(|i| p[i] - q[i]));
    let longest = length(a, b).max(length(b, c)).max(length(c, a));
    std::array::from_fn(|i| (a[i] + b[i] + c[i]) / 3.0 - DEPTH * normal[i] / longest)
}

/// How often triangles wind around a point: their solid angles over 4π (van Oosterom and Strackee 1983).
fn winding<'a>(mesh: &Mesh, triangles: impl Iterator<Item = &'a [usize; 3]>, point: [f64; 3]) -> f64 {
    let mut half_angles = 0.0;
    for triangle in triangles {
        let [a, b, c] = triangle.map(|k| std::array::from_fn::<f64, 3, _>(|i| mesh.corners()[k][i] - point[i]));
        let [x, y, z] = [a, b, c].map(norm);
        let across = dot(a, cross(b, c));
        let along = x * y * z + dot(a, b) * z + dot(b, c) * x + dot(c, a) * y;
        half_angles += libm::atan2(across, along);
    }
    half_angles / TAU
}
