//! Whether triangles form closed surfaces with one orientation, none inside out.

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use bifdiag_numbers::table::Partition;
use bifdiag_numbers::vector::{cross, dot, norm};

use super::integrals::VolumeIntegrals;
use super::surface::{Mesh, MeshError};

/// Checks that each edge belongs to two triangles that pass it in opposite directions.
pub(super) fn check_edges(mesh: &Mesh) -> Result<(), MeshError> {
    if mesh.triangles().is_empty() {
        return Err(MeshError::Empty);
    }
    // How often each edge is passed forward and backward.
    let mut passed: BTreeMap<[usize; 2], [usize; 2]> = BTreeMap::new();
    for triangle in mesh.triangles() {
        for k in 0..3 {
            let (a, b) = (triangle[k], triangle[(k + 1) % 3]);
            passed.entry([a.min(b), a.max(b)]).or_default()[usize::from(a > b)] += 1;
        }
    }
    let wrong = |is: fn([usize; 2]) -> bool| {
        let mut found = passed.iter().filter(|(_, count)| is(**count)).map(|(ends, _)| *ends);
        let first = found.next()?;
        Some((1 + found.count(), mesh.corners()[first[0]], mesh.corners()[first[1]]))
    };
    if let Some((edges, from, to)) = wrong(|[forward, back]| forward + back > 2) {
        return Err(MeshError::Branched { edges, from, to });
    }
    if let Some((edges, from, to)) = wrong(|[forward, back]| forward + back == 1) {
        return Err(MeshError::Open { edges, from, to });
    }
    if let Some((edges, from, to)) = wrong(|[forward, back]| forward != back) {
        return Err(MeshError::Mixed { edges, from, to });
    }
    Ok(())
}

/// Checks that each closed surface is turned outward, or inward inside another one.
pub(super) fn check_sides(mesh: &Mesh) -> Result<(), MeshError> {
    let mut joined = Partition::new(mesh.corners().len());
    for [a, b, c] in mesh.triangles() {
        joined.unite(*a, *b);
        joined.unite(*b, *c);
    }
    let mut surfaces: BTreeMap<usize, Vec<[usize; 3]>> = BTreeMap::new();
    for triangle in mesh.triangles() {
        surfaces.entry(joined.find(triangle[0])).or_default().push(*triangle);
    }
    for (own, triangles) in &surfaces {
        let volume = VolumeIntegrals::over(mesh, triangles).volume.to_f64().value();
        let others = surfaces.iter().filter(|(other, _)| *other != own).flat_map(|(_, triangles)| triangles);
        let around = winding(mesh, others, mesh.corners()[triangles[0][0]]);
        let triangles = triangles.len();
        if volume <= 0.0 && around < 0.5 {
            return Err(MeshError::Inverted { triangles, volume });
        }
        if volume > 0.0 && around > 0.5 {
            return Err(MeshError::Nested { triangles });
        }
    }
    Ok(())
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
