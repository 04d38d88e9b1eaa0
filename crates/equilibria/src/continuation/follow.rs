//! The loop: predict, correct, judge, accept, until l is reached.

use super::branch::{Branch, Point, Tangent};
use super::newton::Condition;
use crate::stability::RelativeEquilibrium;
use bifdiag_body::{Axis, Frame};

/// Below this a step is lost in the rounding of the point that it starts from.
const SMALLEST_STEP: f64 = 1e-11;
const LARGEST_STEP: f64 = 0.5;
const MAX_STEPS: usize = 100_000;
/// Cosine of the largest angle between successive tangents.
const LARGEST_TURN: f64 = 0.9;
/// Largest difference between the change of l over a step and that by the trapezoidal rule, as a share of the larger slope:
/// a pair of cusps inside the step would show in it. Where l leaves a pitchfork with the fourth power, the share is ¼.
const LARGEST_DIP: f64 = 0.3;
/// Roundings of l: beside a pitchfork unfolded by a tiny r_j it stays the same double for many steps.
const ROUNDING: f64 = 1e-13;

/// A point of a branch from which l rises, and the way to go there.
#[derive(Clone, Copy, Debug)]
pub struct Start {
    /// γ in the frame.
    pub gamma: [f64; 3],
    /// Ω ≥ 0.
    pub omega: f64,
    /// The axis i of a symmetric pair: r_i = 0, and γ_i ≥ 0 is free.
    pub pair: Option<Axis>,
    /// At a cusp, where l rises both ways: whether μ = λ/Ω² rises (on a pair Ω). Elsewhere `None`.
    pub rising: Option<bool>,
}

/// Follows a branch from `start`, with l rising, to the relative equilibrium at l.
///
/// `None` when it is lost: steps below rounding, a fold before l is reached, or too many steps.
#[must_use]
pub fn follow(frame: &Frame, start: &Start, l: f64) -> Option<RelativeEquilibrium> {
    let sign = std::array::from_fn(|j| if frame.r[j] == 0.0 { 0.0 } else { start.gamma[j].signum() });
    let branch = Branch { frame, pair: start.pair, sign };
    let mut base = branch.point(start.gamma, start.omega);
    let mut tangent = branch.tangent(&base);
    if !sets_out(&branch, start, &base, &tangent) {
        tangent = tangent.reversed();
    }
    let mut step = 0.1;
    for _ in 0..MAX_STEPS {
        if step < SMALLEST_STEP {
            return None;
        }
        let Some((end, ahead)) = advance(&branch, (&base, &tangent), step) else {
            step *= 0.5;
            continue;
        };
        if branch.l(&end) < l {
            (base, tangent) = (end, ahead);
            step = (1.5 * step).min(LARGEST_STEP);
        } else if let Some(point) = land(&branch, (&base, &tangent), (&end, step), l) {
            return Some(RelativeEquilibrium { gamma: point.gamma, omega: point.omega, gap: branch.gaps(&point) });
        } else {
            step *= 0.5;
        }
    }
    None
}

/// Whether the tangent points where the start says.
fn sets_out(branch: &Branch, start: &Start, base: &Point, tangent: &Tangent) -> bool {
    match (start.rising, branch.pair) {
        (Some(rising), Some(_)) => (tangent.omega > 0.0) == rising,
        // μ − A_i = B_i/Ω².
        (Some(rising), None) => {
            let growth = tangent.x - 2.0 * tangent.omega * tangent.scale / base.omega;
            (growth * base.gap > 0.0) == rising
        }
        // From a pitchfork the only way is along the pair.
        (None, Some(axis)) if base.gamma[axis] == 0.0 => tangent.gamma[axis] > 0.0,
        (None, _) => tangent.l > 0.0,
    }
}

/// A step, and the tangent at its end; `None` where it is too long.
fn advance(branch: &Branch, (base, tangent): (&Point, &Tangent), step: f64) -> Option<(Point, Tangent)> {
    let predicted = branch.predict(base, tangent, step)?;
    let end = branch.correct(predicted, Condition::Plane(tangent), tangent.scale, 0.5 * step)?;
    let end = branch.reanchored(end);
    let mut ahead = branch.tangent(&end);
    if ahead.dot(tangent) < 0.0 {
        ahead = ahead.reversed();
    }
    let dip = (branch.l(&end) - branch.l(base)) / step - 0.5 * (tangent.l + ahead.l);
    let noise = ROUNDING * branch.l(&end) / step;
    let smooth = dip.abs() <= LARGEST_DIP * tangent.l.max(ahead.l) + noise;
    (ahead.dot(tangent) >= LARGEST_TURN && ahead.l > -noise && smooth).then_some((end, ahead))
}

/// The point at l inside a step, from the share of the step that the secant gives.
fn land(branch: &Branch, (base, tangent): (&Point, &Tangent), (end, step): (&Point, f64), l: f64) -> Option<Point> {
    let [from, to] = [base, end].map(|point| branch.l(point));
    let share = if to > from { (l - from) / (to - from) } else { 1.0 };
    let predicted = branch.predict(base, tangent, share * step)?;
    branch.correct(predicted, Condition::Momentum(l), tangent.scale, step.max(1e-6))
}
