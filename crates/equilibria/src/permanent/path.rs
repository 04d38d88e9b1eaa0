//! The axis of a steady rotation over the spin, followed by Newton's method from infinite spin down: the middle of the squares
//! in which the rotations of parts near the nominal one are searched.

use bifdiag_numbers::vector::{cross, dot, norm, normalised};
use nalgebra::Matrix3;

/// A nominal body in any frame: its tensor, and r.
#[derive(Clone, Copy, Debug)]
pub struct NominalBody {
    /// A, symmetric.
    pub tensor: [[f64; 3]; 3],
    /// r.
    pub center: [f64; 3],
}

/// A steady rotation of a nominal body that moves with the spin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NominalRotation {
    /// The axis that it tends to at fast spins, with either end first, in the frame of the body.
    pub fast: [f64; 3],
    /// The spin at which it begins.
    pub slowest: f64,
}

/// Axes that point up, by falling parameter from 2 (infinite spin) on, as long as the rotation can be followed.
#[derive(Clone, Debug)]
pub struct Path {
    body: NominalBody,
    unit: f64,
    nodes: Vec<(f64, [f64; 3])>,
}

/// The longest step of the parameter, and the shortest, at which the rotation is given up: a fold.
const STEPS: [f64; 2] = [1.0 / 256.0, 1e-7];
/// The axis turns by no more between neighbours, in radians.
const TURN: f64 = 0.02;

impl Path {
    /// Follows a rotation from fast spins, with the end of its axis up that is nearer to `up`, down to the spin at which it begins;
    /// `None` where it tends to an axis in a plane of equal moments, at which Newton's method cannot begin.
    /// s = θ·unit up to θ = 1; beyond it r is scaled by 2 − θ at s = unit.
    #[must_use]
    pub fn new(body: NominalBody, unit: f64, up: [f64; 3], rotation: &NominalRotation) -> Option<Self> {
        let s = rotation.slowest * rotation.slowest;
        let least = if s <= unit { s / unit } else { 2.0 - unit / s };
        let mut path = Self { body, unit, nodes: Vec::new() };
        path.nodes.push((2.0, path.refined(2.0, path.principal(up, rotation.fast)?)?));
        let mut step = STEPS[0];
        while step >= STEPS[1] {
            let &(theta, axis) = path.nodes.last()?;
            if theta <= least {
                break;
            }
            let next = (theta - step).max(least);
            match path.refined(next, axis).filter(|found| angle(*found, axis) <= TURN) {
                Some(found) => {
                    path.nodes.push((next, found));
                    step = (2.0 * step).min(STEPS[0]);
                }
                None => step *= 0.5,
            }
        }
        Some(path)
    }

    /// The axis at a parameter; `None` below the fold at which the rotation begins.
    #[must_use]
    pub fn at(&self, theta: f64) -> Option<[f64; 3]> {
        let place = self.nodes.partition_point(|(at, _)| *at >= theta);
        let (_, before) = *self.nodes.get(place.checked_sub(1)?)?;
        if place == self.nodes.len() && self.nodes.last()?.0 > theta {
            return None;
        }
        self.refined(theta, before).filter(|found| angle(*found, before) <= TURN)
    }

    /// The unit eigenvector of A along an axis, with the end first that is nearer to `up`.
    fn principal(&self, up: [f64; 3], fast: [f64; 3]) -> Option<[f64; 3]> {
        /// Farther apart, in radians, they are not one: any axis in a plane of equal moments is an eigenvector.
        const SAME: f64 = 1e-6;
        let eigen = Matrix3::from_fn(|i, j| self.body.tensor[i][j]).symmetric_eigen();
        let axes = (0..3).map(|k| [0, 1, 2].map(|i| eigen.eigenvectors[(i, k)]));
        let nearest = axes.max_by(|p, q| dot(*p, fast).abs().total_cmp(&dot(*q, fast).abs()))?;
        let is_along = norm(cross(nearest, fast)) <= SAME * norm(fast);
        is_along.then(|| if dot(nearest, up) < 0.0 { nearest.map(|x| 0.0 - x) } else { nearest })
    }

    fn turned(&self, v: [f64; 3]) -> [f64; 3] {
        self.body.tensor.map(|row| dot(row, v))
    }

    /// Newton's method for s A γ + r along γ, γ = −up.
    fn refined(&self, theta: f64, up: [f64; 3]) -> Option<[f64; 3]> {
        let (s, weight) = if theta <= 1.0 { (self.unit * theta, 1.0) } else { (self.unit, 2.0 - theta) };
        let r = self.body.center.map(|x| weight * x);
        let mut gamma = normalised(up.map(|x| -x));
        for _ in 0..40 {
            let helper = if gamma[0].abs() < 0.6 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] };
            let e = normalised(cross(gamma, helper));
            let f = cross(gamma, e);
            let turned = self.turned(gamma);
            let force: [f64; 3] = std::array::from_fn(|k| s * turned[k] + r[k]);
            let along = dot(force, gamma);
            let form = |u: [f64; 3], v: [f64; 3]| s * dot(u, self.turned(v)) - along * dot(u, v);
            let (p, q) = (dot(force, e), dot(force, f));
            let (m11, m12, m22) = (form(e, e), form(e, f), form(f, f));
            let determinant = m11 * m22 - m12 * m12;
            let step = [(m12 * q - m22 * p) / determinant, (m12 * p - m11 * q) / determinant];
            let length = (step[0] * step[0] + step[1] * step[1]).sqrt();
            if !length.is_finite() || length > 0.2 {
                return None;
            }
            gamma = normalised(std::array::from_fn(|k| gamma[k] + step[0] * e[k] + step[1] * f[k]));
            if length < 1e-14 {
                return Some(gamma.map(|x| 0.0 - x));
            }
        }
        // Rounding may keep the steps from vanishing.
        Some(gamma.map(|x| 0.0 - x))
    }
}

fn angle(p: [f64; 3], q: [f64; 3]) -> f64 {
    libm::atan2(norm(cross(p, q)), dot(p, q))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Down to rest the axis of the fastest family ends on ±r̂; a family that begins in a fold ends there.
    #[test]
    fn rotations_are_followed_to_rest_or_to_their_fold() {
        let tensor = [[2.0, 0.0, 0.0], [0.0, 1.1, 0.0], [0.0, 0.0, 1.0]];
        let body = NominalBody { tensor, center: [0.94868, 0.0, 0.61623] };
        let path = |up| Path::new(body, 0.5, up, &NominalRotation { fast: up, slowest: 0.0 }).unwrap();
        let hanging = path([-1.0, 0.0, 0.0]);
        let at_rest = hanging.at(0.0).unwrap();
        let size = norm(body.center);
        assert!((0..3).all(|k| (at_rest[k] + body.center[k] / size).abs() < 1e-12), "{at_rest:?}");
        assert!(path([1.0, 0.0, 0.0]).at(0.0).is_none() && path([1.0, 0.0, 0.0]).at(1.99).is_some());
        for theta in [0.1, 0.7, 1.0, 1.3, 1.9] {
            let up = hanging.at(theta).unwrap();
            let (s, weight) = if theta <= 1.0 { (0.5 * theta, 1.0) } else { (0.5, 2.0 - theta) };
            let force: [f64; 3] = std::array::from_fn(|k| -s * tensor[k][k] * up[k] + weight * body.center[k]);
            assert!(norm(cross(force, up)) < 1e-13, "{theta} {up:?}");
        }
    }
}
