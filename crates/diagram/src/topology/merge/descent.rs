//! Downhill paths that prove to which minimum a point belongs.

use super::super::potential::{Potential, Vector, combination};
use super::slide::slide;
use bifdiag_body::Axis;
use bifdiag_numbers::vector::{dot, normalised};

/// A minimum of U, or a circle of minima in the plane of two axes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Floor {
    /// A minimum.
    pub gamma: Vector,
    /// For a circle: its axes are this one and the next.
    pub circle: Option<Axis>,
}

impl Floor {
    /// The point of the floor in the direction of γ.
    fn towards(&self, gamma: Vector) -> Vector {
        let Some(axis) = self.circle else { return self.gamma };
        let next = axis.next();
        let radius = |v: Vector| (v[axis] * v[axis] + v[next] * v[next]).sqrt();
        let scale = radius(self.gamma) / radius(gamma);
        if !scale.is_finite() {
            return self.gamma;
        }
        let mut point = self.gamma;
        point[axis] = scale * gamma[axis];
        point[next] = scale * gamma[next];
        point
    }
}

/// Steps after which a descent gives up.
const MAX_STEPS: u32 = 200;

/// Follows U downhill from a point until an arc that stays below the current height reaches one of the minima: its number;
/// `None` when no path could be proved.
///
/// Each step is an arc of a great circle along which U ≤ U(start) is proved; so start and minimum lie in one component
/// of {U ≤ U(start)}. The direction is Newton's with the absolute values of the Hessian's eigenvalues, which descends
/// everywhere, is not slowed by narrow valleys, and leaves saddles.
pub(super) fn descend(potential: &Potential, start: Vector, minima: &[Floor]) -> Option<usize> {
    let mut gamma = start;
    let ceiling = potential.value(start) + potential.value_error(start);
    for _ in 0..MAX_STEPS {
        if let Some(minimum) = nearest_joined(potential, gamma, minima, ceiling) {
            return Some(minimum);
        }
        // A straight step that had to be shortened much meets a curved valley: then follow the circle of latitude.
        let straight = step(potential, gamma, ceiling);
        let next = if let Some(Step { end, shortened: false }) = straight {
            Some(end)
        } else {
            let along = slide(potential, gamma).filter(|end| potential.value(*end) < potential.value(gamma));
            let ends = straight.map(|step| step.end).into_iter().chain(along);
            ends.min_by(|p, q| potential.value(*p).total_cmp(&potential.value(*q)))
        };
        gamma = next?;
    }
    None
}

/// The nearest minimum that a direct arc below the ceiling reaches.
fn nearest_joined(potential: &Potential, gamma: Vector, minima: &[Floor], ceiling: f64) -> Option<usize> {
    (0..minima.len()).filter(|&m| potential.arc_stays_below(gamma, minima[m].towards(gamma), ceiling)).max_by(
        |&p, &q| {
            let near = |m: usize| dot(gamma, minima[m].towards(gamma));
            near(p).total_cmp(&near(q))
        },
    )
}

/// A straight step.
#[derive(Clone, Copy)]
struct Step {
    end: Vector,
    /// Shorter than an eighth of what was wanted.
    shortened: bool,
}

/// One downhill step, or `None` when no step descends by more than rounding.
fn step(potential: &Potential, gamma: Vector, ceiling: f64) -> Option<Step> {
    const LONGEST: f64 = 0.5;
    let basis = Potential::tangent_basis(gamma);
    let (gradient, hessian) = potential.derivatives(gamma, basis);
    let direction = positive_newton(gradient, hessian);
    let norm = (direction[0] * direction[0] + direction[1] * direction[1]).sqrt();
    if norm == 0.0 || !norm.is_finite() {
        return None;
    }
    let mut scale = (LONGEST / norm).min(1.0);
    let wanted = scale;
    let here = potential.value(gamma);
    let slope = gradient[0] * direction[0] + gradient[1] * direction[1];
    for _ in 0..60 {
        let move_by = combination(scale * direction[0], basis[0], scale * direction[1], basis[1]);
        let next = normalised(combination(1.0, gamma, 1.0, move_by));
        // Armijo's rule, and the proof that the arc does not leave the sublevel set.
        if potential.value(next) <= here + 1e-4 * scale * slope && potential.arc_stays_below(gamma, next, ceiling) {
            return Some(Step { end: next, shortened: scale < 0.125 * wanted });
        }
        scale *= 0.5;
    }
    None
}

/// −|H|⁻¹ g with the eigenvalues of H replaced by their absolute values, bounded away from 0.
fn positive_newton(gradient: [f64; 2], hessian: [[f64; 2]; 2]) -> [f64; 2] {
    const FLOOR: f64 = 1e-6;
    let (values, first) = eigen(hessian);
    let second = [-first[1], first[0]];
    let largest = values[0].abs().max(values[1].abs());
    let mut direction = [0.0; 2];
    for (value, vector) in values.into_iter().zip([first, second]) {
        let along = gradient[0] * vector[0] + gradient[1] * vector[1];
        let curvature = value.abs().max(FLOOR * largest);
        direction[0] -= along / curvature * vector[0];
        direction[1] -= along / curvature * vector[1];
    }
    direction
}

/// Eigenvalues of a symmetric 2×2 matrix, ascending, and the unit eigenvector of the first.
pub(super) fn eigen(h: [[f64; 2]; 2]) -> ([f64; 2], [f64; 2]) {
    let half_trace = 0.5 * (h[0][0] + h[1][1]);
    let half_difference = 0.5 * (h[0][0] - h[1][1]);
    let radius = (half_difference * half_difference + h[0][1] * h[0][1]).sqrt();
    // The eigenvector of the smaller eigenvalue, from the row without cancellation.
    let vector =
        if half_difference > 0.0 { [-h[0][1], half_difference + radius] } else { [radius - half_difference, -h[0][1]] };
    let norm = (vector[0] * vector[0] + vector[1] * vector[1]).sqrt();
    let unit = if norm > 0.0 { [vector[0] / norm, vector[1] / norm] } else { [1.0, 0.0] };
    ([half_trace - radius, half_trace + radius], unit)
}

/// The two sides of a saddle: points to which U falls monotonically along great circles in the direction of negative
/// curvature. `None` when the fall is within rounding.
pub(super) fn sides_of_saddle(potential: &Potential, saddle: Vector) -> Option<[Vector; 2]> {
    let along = steepest_curvature(potential, saddle);
    let side = |sign: f64| falling_arc(potential, saddle, along.map(|c| sign * c));
    Some([side(1.0)?, side(-1.0)?])
}

/// A point below a maximum, or below any point at which the gradient is too small to follow.
pub(super) fn kick(potential: &Potential, gamma: Vector) -> Option<Vector> {
    let along = steepest_curvature(potential, gamma);
    let basis = Potential::tangent_basis(gamma);
    let (gradient, _) = potential.derivatives(gamma, basis);
    let slope = gradient[0] * dot(basis[0], along) + gradient[1] * dot(basis[1], along);
    falling_arc(potential, gamma, if slope > 0.0 { along.map(|c| -c) } else { along })
}

/// True if the gradient is so small compared with the curvature that a kick is needed.
pub(super) fn is_nearly_critical(potential: &Potential, gamma: Vector) -> bool {
    const SMALL: f64 = 1e-6;
    let basis = Potential::tangent_basis(gamma);
    let (gradient, hessian) = potential.derivatives(gamma, basis);
    let (values, _) = eigen(hessian);
    let norm = (gradient[0] * gradient[0] + gradient[1] * gradient[1]).sqrt();
    values[0] < 0.0 && norm <= SMALL * values[0].abs()
}

/// The unit tangent vector along which U curves down most.
fn steepest_curvature(potential: &Potential, gamma: Vector) -> Vector {
    let basis = Potential::tangent_basis(gamma);
    let (_, hessian) = potential.derivatives(gamma, basis);
    let (_, first) = eigen(hessian);
    combination(first[0], basis[0], first[1], basis[1])
}

/// The end of an arc on which d²U/dt² < 0 is proved; from a start with dU/dt ≤ 0, U falls all along it.
///
/// On γ(t) = γ cos t + e sin t both J = α + β cos 2t + κ sin 2t and ⟨γ, r⟩ are known with their derivatives; their
/// ranges on [0, t] follow from the values at 0 and the bounds 2√(β²+κ²) on the higher derivatives.
fn falling_arc(potential: &Potential, gamma: Vector, e: Vector) -> Option<Vector> {
    let (moment, r) = (potential.inertia(gamma), potential.frame.r);
    let (j0, j1) = (dot(gamma, moment), 2.0 * dot(e, moment));
    let j_e = dot(e, potential.inertia(e));
    let j2 = 2.0 * (j_e - j0);
    let amplitude = 0.5 * ((j0 - j_e) * (j0 - j_e) + j1 * j1).sqrt();
    let (rho, rho_e) = (dot(gamma, r), dot(e, r));
    let mut t: f64 = 0.25;
    for _ in 0..60 {
        // |J'''| ≤ 8, |J''| ≤ 4 amplitudes.
        let second = [j2 - 8.0 * amplitude * t, j2 + 8.0 * amplitude * t];
        let first = j1.abs() + 4.0 * amplitude * t;
        let lowest = j0 - first * t;
        if lowest > 0.0 {
            let highest = j0 + first * t;
            // U'' = x (2J'²/J³ − J''/J²) + ⟨γ(t), r⟩.
            let rising = 2.0 * first * first / (lowest * lowest * lowest);
            let bending =
                if second[0] > 0.0 { -second[0] / (highest * highest) } else { -second[0] / (lowest * lowest) };
            let pull = rho + rho.abs() * 0.5 * t * t + rho_e.abs() * t;
            if potential.x * (rising + bending) + pull < 0.0 {
                break;
            }
        }
        t *= 0.5;
    }
    // A rational point of the great circle: tan-half-angle, so that no platform-dependent sine is needed.
    let half = 0.5 * t;
    let end = normalised(combination(1.0 - half * half, gamma, 2.0 * half, e));
    let fall = potential.value(gamma) - potential.value(end);
    (fall > 2.0 * potential.value_error(gamma)).then_some(end)
}
