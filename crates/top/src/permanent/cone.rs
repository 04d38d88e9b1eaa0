//! Permanent axes: principal ones through the centre of mass, and the cone of Staude.

use nalgebra::{Matrix3, Vector3};

use crate::body::{Body, BodyAxis};
use numbers::vector::{dot, normalised};

/// The principal axis nearest to a direction in the body's principal axes, and the cosine of their angle with its sign.
#[must_use]
pub fn nearest_axis(direction: [f64; 3]) -> (BodyAxis, f64) {
    let norm = direction.iter().map(|x| x * x).sum::<f64>().sqrt();
    let [first, ..] = BodyAxis::ALL;
    let longest =
        BodyAxis::ALL.into_iter().max_by(|&i, &j| direction[i].abs().total_cmp(&direction[j].abs())).unwrap_or(first);
    (longest, direction[longest] / norm)
}

/// The axes through the fixed point and the centre of mass that are principal: rotation about each is permanent at every
/// spin. All three (of a basis) where r = 0.
#[must_use]
pub fn permanent_axes(body: &Body) -> Vec<BodyAxis> {
    let carries = |k: BodyAxis| !body.center()[k].value().is_zero();
    BodyAxis::ALL.into_iter().filter(|k| !k.others().into_iter().any(carries)).collect()
}

/// The permanent axis nearest to a direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearestAxis {
    /// A unit vector in the body's principal axes, pointing up.
    pub axis: [f64; 3],
    /// The angle between the two lines, in radians.
    pub angle: f64,
    /// The one spin at which the axis is permanent, pointing up as it does; `None`: every spin.
    pub omega: Option<f64>,
}

/// The axis of Staude's cone nearest to a direction, which points up.
///
/// With n up, γ = −n, and s(Aγ × γ) = γ × r needs ⟨n, An × r⟩ = 0: a quadratic cone nᵀSn = 0 with
/// S_ij = (A_j − A_i) …/2. The nearest point v of it to u solves (E + λS) v = u, so λ is a root of
/// uᵀ(E + λS)⁻¹ S (E + λS)⁻¹ u.
#[must_use]
pub fn nearest_permanent(a: [f64; 3], r: [f64; 3], up: [f64; 3]) -> NearestAxis {
    let up = normalised(up);
    // ⟨n, An × r⟩ = Σ n_i n_j r_k (A_j − A_i) over cyclic (i, j, k).
    let mut cone: Matrix3<f64> = Matrix3::zeros();
    for k in 0..3 {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        let entry = 0.5 * r[k] * (a[j] - a[i]);
        cone[(i, j)] += entry;
        cone[(j, i)] += entry;
    }
    let scale = cone.amax();
    if scale == 0.0 {
        return NearestAxis { axis: up, angle: 0.0, omega: spin_about(&a, &r, &up) };
    }
    let eigen = (cone / scale).symmetric_eigen();
    let (sigma, u) = (eigen.eigenvalues, eigen.eigenvectors.transpose() * Vector3::from(up));
    let at = |lambda: f64| Vector3::from_fn(|k, _| u[k] / (1.0 + lambda * sigma[k]));
    let value = |lambda: f64| (0..3).map(|k| sigma[k] * at(lambda)[k] * at(lambda)[k]).sum::<f64>();
    let mut best: Option<([f64; 3], f64)> = None;
    // Between the poles −1/σ the value falls; all roots lie where Σ σ u²/(1 + λσ)² changes sign.
    let steps: Vec<f64> = (-4000..=4000).map(|k| f64::from(k) / 4000.0).map(|t| t / (1.0 - t * t).max(1e-12)).collect();
    for pair in steps.windows(2) {
        let (mut low, mut high) = (pair[0], pair[1]);
        let (first, last) = (value(low), value(high));
        let pole = (0..3).any(|k| (1.0 + low * sigma[k]) * (1.0 + high * sigma[k]) <= 0.0);
        if pole || first * last > 0.0 || !first.is_finite() || !last.is_finite() {
            continue;
        }
        for _ in 0..100 {
            let middle = 0.5 * (low + high);
            if (value(middle) > 0.0) == (first > 0.0) { low = middle } else { high = middle }
        }
        let v = normalised((eigen.eigenvectors * at(low)).into());
        let cosine = dot(v, up);
        let v = if cosine < 0.0 { v.map(|x| -x) } else { v };
        if best.is_none_or(|(_, known)| cosine.abs() > known) {
            best = Some((v, cosine.abs()));
        }
    }
    let (axis, cosine) = best.unwrap_or((up, 1.0));
    NearestAxis { axis, angle: libm::acos(cosine.min(1.0)), omega: spin_about(&a, &r, &axis) }
}

/// The spin at which an axis of the cone is permanent, pointing up: s (Aγ × γ) = γ × r with γ = −n. `None` where it would
/// have to point down, or is permanent at every spin.
fn spin_about(a: &[f64; 3], r: &[f64; 3], up: &[f64; 3]) -> Option<f64> {
    let gamma = Vector3::from(*up) * -1.0;
    let weighted = Vector3::from_fn(|k, _| a[k] * gamma[k]);
    let left = weighted.cross(&gamma);
    let s = left.dot(&gamma.cross(&Vector3::from(*r))) / left.norm_squared();
    (s > 0.0).then(|| s.sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_axis_of_the_centre_of_mass_is_permanent() {
        let axes = |r: [&str; 3]| permanent_axes(&Body::parse(&["1", "2", "3"], &r).unwrap());
        assert_eq!(axes(["0", "1", "0"]), [BodyAxis::ALL[1]]);
        assert_eq!(axes(["0", "0", "0"]), BodyAxis::ALL);
        assert!(axes(["0", "1", "1"]).is_empty());
    }

    /// The nearest permanent axis of a body whose centre of mass lies on none: on Staude's cone, with its spin.
    #[test]
    fn the_nearest_axis_lies_on_the_cone_of_staude() {
        let (a, r, up) = ([2.0, 1.0, 1.5], [0.3, 0.4, 0.5], [0.6, 0.0, 0.8]);
        // With one of its ends up it is permanent, with the other it would need s < 0.
        let both = [up, up.map(|x: f64| -x)].map(|up| nearest_permanent(a, r, up));
        assert!(both.iter().filter(|found| found.omega.is_some()).count() == 1, "{both:?}");
        let found = both.into_iter().find(|found| found.omega.is_some()).unwrap();
        let [x, y, z] = found.axis;
        // s A γ + r is along γ, with γ = −axis.
        let s = found.omega.unwrap() * found.omega.unwrap();
        let gamma = [-x, -y, -z];
        let force: [f64; 3] = std::array::from_fn(|k| s * a[k] * gamma[k] + r[k]);
        let along = (0..3).map(|k| force[k] * gamma[k]).sum::<f64>();
        for k in 0..3 {
            assert!((force[k] - along * gamma[k]).abs() < 1e-9, "{found:?}");
        }
        assert!(found.angle < 0.6);
    }
}
