//! Permanent axes: principal ones through the centre of mass, and those of Staude's cone.

use nalgebra::{Matrix3, Vector3};

use bifdiag_body::{Body, BodyAxis};
use bifdiag_numbers::symmetric;
use bifdiag_numbers::vector::{self, cross, dot, norm, normalised};
use dashu_ratio::RBig;

/// An axis about which rotation is permanent at every spin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PermanentAxis {
    /// An axis of the frame with the same moment.
    pub axis: BodyAxis,
    /// A unit vector along it, in principal axes.
    pub direction: [f64; 3],
}

/// The axis nearest to a direction among those that are principal and pass through the fixed point and the centre of mass:
/// r̂ if its moments are equal; where r = 0 every axis of the eigenspaces of A.
#[must_use]
pub fn permanent_axis(body: &Body, up: [f64; 3]) -> Option<PermanentAxis> {
    let moment = |k: BodyAxis| body.moments()[k].value();
    let direction = if body.is_euler() {
        let share = |k: BodyAxis| BodyAxis::ALL.map(|j| if moment(j) == moment(k) { up[j] } else { 0.0 });
        BodyAxis::ALL.map(share).into_iter().max_by(|p, q| norm(*p).total_cmp(&norm(*q)))?
    } else {
        let mut active = BodyAxis::ALL.into_iter().filter(|&k| !body.center()[k].value().is_zero());
        let first = active.next()?;
        if active.any(|k| moment(k) != moment(first)) {
            return None;
        }
        body.center_f64()
    };
    let direction = vector::direction(direction)?;
    let direction = if dot(direction, up) < 0.0 { direction.map(|x| 0.0 - x) } else { direction };
    let axis = BodyAxis::ALL.into_iter().max_by(|&i, &j| direction[i].abs().total_cmp(&direction[j].abs()))?;
    Some(PermanentAxis { axis, direction })
}

/// The axis nearest to a direction among those that are permanent at some spin, and the principal ones.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearestAxis {
    /// A unit vector in the body's principal axes, pointing up.
    pub axis: [f64; 3],
    /// The angle between the two lines, in radians.
    pub angle: f64,
    /// Ω² of the one spin at which the axis is permanent, or −Ω² if it has to point down for it, infinite beyond the range of
    /// doubles; `None` for a principal axis: every spin if the centre of mass lies on it, else none.
    pub squared_spin: Option<f64>,
}

impl NearestAxis {
    /// The spin at which the axis is permanent, pointing up.
    #[must_use]
    pub fn omega(&self) -> Option<f64> {
        self.squared_spin.filter(|s| *s >= 0.0).map(f64::sqrt)
    }
}

/// The axis of Staude's cone nearest to a direction, which points up; where r = 0 or all moments are equal, the nearest axis
/// that is permanent at every spin.
///
/// With n up, γ = −n, and s(n × An) = n × r needs ⟨n, An × r⟩ = 0: a quadratic cone nᵀSn = 0 with
/// S_ij = r_k(A_j − A_i)/2 for cyclic (i, j, k).
#[must_use]
pub fn nearest_permanent(body: &Body, up: [f64; 3]) -> Option<NearestAxis> {
    let up = normalised(up);
    let r = body.center_f64();
    let difference = differences(body);
    if body.is_euler() || difference == [0.0; 3] {
        let PermanentAxis { direction, .. } = permanent_axis(body, up)?;
        return Some(NearestAxis { axis: direction, angle: angle_between(direction, up), squared_spin: None });
    }
    let cone = cone_of(difference, r);
    let scale = cone.amax();
    // Only thirteen digits are known of an axis that was moved onto the cone.
    let (axis, rounding) = if scale == 0.0 || is_on_cone(&cone, up) {
        (up, 0.0)
    } else if let Some(k) = (0..3).find(|&k| difference[k] == 0.0) {
        (nearest_of_a_symmetric_body(k, r, up), 1e-13)
    } else {
        (nearest_on_cone(cone / scale, up), 1e-13)
    };
    Some(NearestAxis {
        axis,
        angle: angle_between(axis, up),
        squared_spin: squared_spin(difference, r, axis, rounding),
    })
}

/// S.
fn cone_of(difference: [f64; 3], r: [f64; 3]) -> Matrix3<f64> {
    let mut cone: Matrix3<f64> = Matrix3::zeros();
    for k in 0..3 {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        let entry = 0.5 * r[k] * difference[k];
        cone[(i, j)] += entry;
        cone[(j, i)] += entry;
    }
    cone
}

/// The other axes of Staude's cone that are as near to a direction as `nearest`, about which rotation is steady at some
/// spin, if it is about this one. On a quadratic cone only a direction in a plane of symmetry has several nearest lines: a
/// line and its reflection in that plane. With two equal moments the cone is a pair of planes, of which only that of r and
/// the third axis counts, and one axis of it is nearest.
#[must_use]
pub fn equally_near(body: &Body, up: [f64; 3], nearest: [f64; 3]) -> Vec<[f64; 3]> {
    /// Angles and cosines that are smaller are 0.
    const TIE: f64 = 1e-9;
    let cone = cone_of(differences(body), body.center_f64());
    let scale = cone.amax();
    if scale == 0.0 || differences(body).contains(&0.0) {
        return Vec::new();
    }
    let (up, mut found) = (normalised(up), vec![nearest]);
    for across in (cone / scale).symmetric_eigen().eigenvectors.column_iter() {
        let across: [f64; 3] = [across[0], across[1], across[2]];
        if dot(across, up).abs() > TIE {
            continue;
        }
        for line in found.clone() {
            let share = 2.0 * dot(line, across);
            let image: [f64; 3] = std::array::from_fn(|k| line[k] - share * across[k]);
            // What is left of 0 is rounding.
            let image = image.map(|x| if x.abs() < 1e-15 { 0.0 } else { x });
            let is_known = |known: &[f64; 3]| norm(cross(*known, image)) <= TIE;
            if !found.iter().any(is_known) {
                found.push(image);
            }
        }
    }
    let mut others = found.split_off(1);
    let is_steady = |axis| is_steady_at_some_spin(body, axis);
    others.retain(|axis| is_steady(*axis) || !is_steady(nearest));
    others
}

/// Of an axis of Staude's cone, within rounding.
fn is_steady_at_some_spin(body: &Body, axis: [f64; 3]) -> bool {
    match squared_spin(differences(body), body.center_f64(), axis, 1e-9) {
        Some(squared) => squared != 0.0,
        None => permanent_axis(body, axis).is_some_and(|found| norm(cross(found.direction, axis)) <= 1e-9),
    }
}

/// Whether Staude's cone is circular about an axis (given in the axes in which the body was, of any length), so that all of its
/// lines are as near to it: S is a multiple of 3 u uᵀ − |u|² E. Exact.
#[must_use]
pub fn is_axis_of_circular_cone(body: &Body, axis: &[RBig; 3]) -> bool {
    let center = body.center_as_given();
    let unit = |k: usize| [0, 1, 2].map(|i| RBig::from(u8::from(i == k)));
    let turned = [0, 1, 2].map(|k| body.angular_momentum_as_given(&unit(k)));
    // ⟨e_i, A e_j × r⟩
    let entry = |i: usize, j: usize| {
        let (next, last) = ((i + 1) % 3, (i + 2) % 3);
        &turned[j][next] * &center[last] - &turned[j][last] * &center[next]
    };
    let cone = |i: usize, j: usize| entry(i, j) + entry(j, i);
    let length = symmetric::dot(axis, axis);
    let wanted =
        |i: usize, j: usize| RBig::from(3) * &axis[i] * &axis[j] - if i == j { length.clone() } else { RBig::ZERO };
    // uᵀSu, twice, and 2 |u|⁴: the multiple is their quotient.
    let along = (0..3).flat_map(|i| (0..3).map(move |j| (i, j))).map(|(i, j)| cone(i, j) * &axis[i] * &axis[j]);
    let (along, size) = (along.fold(RBig::ZERO, |sum, x| sum + x), RBig::from(2) * length.sqr());
    let is_multiple = (0..3).all(|i| (i..3).all(|j| cone(i, j) * &size == &along * wanted(i, j)));
    !along.is_zero() && is_multiple
}

/// With A_i = A_j the cone is two planes: that of the equal moments, whose axes are principal and steady at no spin unless r
/// lies on them, and that of e_k and r. The axis of the latter nearest to `up`.
fn nearest_of_a_symmetric_body(k: usize, r: [f64; 3], up: [f64; 3]) -> [f64; 3] {
    let across: [f64; 3] = std::array::from_fn(|i| if i == k { 0.0 } else { r[i] });
    let across = normalised(across);
    let part = dot(up, across);
    let nearest: [f64; 3] = std::array::from_fn(|i| if i == k { up[k] } else { part * across[i] });
    // Where `up` is orthogonal to the plane, all of its axes are as near.
    normalised(if norm(nearest) > 0.0 { nearest } else { r })
}

/// A_j − A_i for cyclic (i, j, k), rounded once.
fn differences(body: &Body) -> [f64; 3] {
    let moment = |k: usize| body.moments()[k % 3].value();
    [0, 1, 2].map(|k: usize| (moment(k + 2) - moment(k + 1)).to_f64().value())
}

/// The angle between two vectors, also when it is small.
#[must_use]
pub fn angle_between(v: [f64; 3], w: [f64; 3]) -> f64 {
    libm::atan2(norm(cross(v, w)), dot(v, w))
}

/// Whether uᵀSu vanishes within rounding.
fn is_on_cone(cone: &Matrix3<f64>, up: [f64; 3]) -> bool {
    let terms = [(0, 1), (1, 2), (2, 0)].map(|(i, j)| cone[(i, j)] * up[i] * up[j]);
    let size = terms.iter().map(|term| term.abs()).sum::<f64>();
    terms.iter().sum::<f64>().abs() <= 4.0 * f64::EPSILON * size
}

/// The line of vᵀSv = 0 nearest to u: v solves (E + λS)v = u, and λ is a root of uᵀ(E + λS)⁻¹S(E + λS)⁻¹u. S has trace 0, so
/// that it has eigenvalues of both signs; where E + λS is positive definite that function falls, and its root is the nearest
/// of all. Where u has no share along an extreme eigenvector, λ may be the end of that interval, and the share is free.
fn nearest_on_cone(cone: Matrix3<f64>, up: [f64; 3]) -> [f64; 3] {
    /// Nearer to the end of the interval the share follows from vᵀSv = 0.
    const SINGULAR: f64 = 1e-6;
    let eigen = cone.symmetric_eigen();
    let (sigma, u) = (eigen.eigenvalues, eigen.eigenvectors.transpose() * Vector3::from(up));
    let (least, most) = (sigma.imin(), sigma.imax());
    let at = |lambda: f64| Vector3::from_fn(|k, _| u[k] / (1.0 + lambda * sigma[k]));
    let value = |v: Vector3<f64>| (0..3).map(|k| sigma[k] * v[k] * v[k]).sum::<f64>();
    let (mut low, mut high) = (-1.0 / sigma[most], -1.0 / sigma[least]);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            break;
        }
        if value(at(middle)) > 0.0 { low = middle } else { high = middle }
    }
    let lambda = 0.5 * (low + high);
    let mut v = at(lambda);
    let end = if lambda < 0.0 { most } else { least };
    if 1.0 + lambda * sigma[end] < SINGULAR {
        for k in (0..3).filter(|&k| 1.0 + lambda * sigma[k] < SINGULAR) {
            v[k] = 0.0;
        }
        v[end] = (-value(v) / sigma[end]).max(0.0).sqrt() * if u[end] < 0.0 { -1.0 } else { 1.0 };
    }
    onto_cone(&cone, eigen.eigenvectors * v)
}

/// A line near the cone moved onto it along the gradient 2Sv of vᵀSv, to the last digits that bisection leaves open.
fn onto_cone(cone: &Matrix3<f64>, mut v: Vector3<f64>) -> [f64; 3] {
    for _ in 0..3 {
        v.normalize_mut();
        let gradient = 2.0 * cone * v;
        if is_on_cone(cone, v.into()) || gradient.norm_squared() == 0.0 {
            break;
        }
        v -= gradient * (0.5 * v.dot(&gradient) / gradient.norm_squared());
    }
    normalised(v.into())
}

/// s with s(n × An) = n × r on the cone; `None` for a principal axis (within `rounding`), where the left side vanishes.
fn squared_spin(difference: [f64; 3], r: [f64; 3], up: [f64; 3], rounding: f64) -> Option<f64> {
    let products = [up[1] * up[2], up[2] * up[0], up[0] * up[1]];
    if (0..3).all(|k| difference[k] == 0.0 || products[k].abs() <= rounding) {
        return None;
    }
    let (left, right) = ([0, 1, 2].map(|k| difference[k] * products[k]), cross(up, r));
    // Beside a principal axis the square of the left side would leave the range of doubles.
    let size = left.into_iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let left = left.map(|x| x / size);
    let s = if norm(right) <= 1e-13 * norm(r) { 0.0 } else { dot(left, right) / dot(left, left) / size };
    Some(s)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn body(a: [&str; 3], r: [&str; 3]) -> Body {
        Body::parse(&a, &r).unwrap()
    }

    #[test]
    fn only_principal_axes_of_the_centre_of_mass_are_permanent() {
        let axis = |a: [&str; 3], r: [&str; 3], up| permanent_axis(&body(a, r), up).map(|found| found.direction);
        let (apart, symmetric) = (["1", "2", "3"], ["1", "1", "2"]);
        assert_eq!(axis(apart, ["0", "1", "0"], [0.6, -0.8, 0.0]), Some([0.0, -1.0, 0.0]));
        assert_eq!(axis(apart, ["0", "0", "0"], [0.6, 0.8, 0.0]), Some([0.0, 1.0, 0.0]));
        assert_eq!(axis(apart, ["0", "1", "1"], [0.0, 1.0, 0.0]), None);
        // Every axis across that of symmetry is principal.
        assert_eq!(axis(symmetric, ["3", "4", "0"], [1.0, 0.0, 0.0]), Some([0.6, 0.8, 0.0]));
        assert_eq!(axis(symmetric, ["0", "0", "0"], [0.6, 0.8, 0.0]), Some([0.6, 0.8, 0.0]));
        assert_eq!(axis(["1", "1", "1"], ["0", "3", "-4"], [0.0, 0.0, 1.0]), Some([0.0, -0.6, 0.8]));
    }

    /// s A γ + r is along γ, with γ = −axis up or down.
    fn assert_steady(body: &Body, found: &NearestAxis) {
        let (a, r, s) = (body.moments_f64(), body.center_f64(), found.squared_spin.unwrap());
        let gamma = found.axis.map(|x| if s < 0.0 { x } else { -x });
        let force: [f64; 3] = std::array::from_fn(|k| s.abs() * a[k] * gamma[k] + r[k]);
        assert!(norm(cross(force, gamma)) < 1e-9, "{found:?}");
    }

    /// The nearest permanent axis of a body whose centre of mass lies on none: on Staude's cone, with its spin.
    #[test]
    fn the_nearest_axis_lies_on_the_cone_of_staude() {
        let (body, up) = (body(["2", "1", "1.5"], ["0.3", "0.4", "0.5"]), [0.6, 0.0, 0.8]);
        // With one of its ends up it is permanent, with the other it would need s < 0.
        let both = [up, up.map(|x: f64| -x)].map(|up| nearest_permanent(&body, up).unwrap());
        assert!(both.iter().filter(|found| found.omega().is_some()).count() == 1, "{both:?}");
        for found in both {
            assert_steady(&body, &found);
            assert!(found.angle < 0.6);
        }
    }

    /// An axis given with all its digits is on the cone however near it is to a principal one.
    #[test]
    fn an_axis_beside_a_principal_one_has_its_own_spin() {
        let body = body(["3", "1", "2"], ["0.5", "0.25", "1"]);
        for omega in [1e3_f64, 1e10, 1e30, 1e80] {
            // s(A - A₂)n = r across the axis, in the limit of large s.
            let s = omega * omega;
            let found = nearest_permanent(&body, [0.5 / (2.0 * s), 1.0, 1.0 / s]).unwrap();
            let spin = found.squared_spin.unwrap();
            assert!(found.angle < 1e-6 && (spin.abs() / s - 1.0).abs() < 1e-5, "{omega} {found:?}");
        }
    }

    /// r_1 (A_3 − A_2) = r_2 (A_1 − A_3) = r_3 (A_2 − A_1).
    #[test]
    fn a_cone_is_circular_about_one_axis() {
        let is_axis =
            |r: [&str; 3], axis: [i32; 3]| is_axis_of_circular_cone(&body(["1", "2", "3"], r), &axis.map(RBig::from));
        assert!(is_axis(["2", "-1", "2"], [1, 1, 1]) && is_axis(["2", "-1", "2"], [-5, -5, -5]));
        assert!(is_axis(["2", "1", "2"], [1, -1, 1]));
        assert!(!is_axis(["2", "-1", "2"], [1, -1, 1]) && !is_axis(["2", "-1", "2.00000000000001"], [1, 1, 1]));
        assert!(!is_axis(["0", "0", "1"], [1, 1, 0]) && !is_axis(["0", "0", "0"], [1, 1, 1]));
    }

    /// Midway between the two planes into which the cone falls the nearest axis is not the one that is asked about.
    #[test]
    fn an_axis_midway_between_planes_of_the_cone_is_not_on_it() {
        let found = nearest_permanent(&body(["1", "2", "3"], ["0", "0", "1"]), [1.0, 1.0, 0.0]).unwrap();
        assert!((found.angle.to_degrees() - 45.0).abs() < 1e-9, "{found:?}");
    }
}
