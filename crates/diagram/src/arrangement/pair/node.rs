//! What is known of two curves at one abscissa.
//!
//! Enclosures of the curvature d²h/dx² of an arc.

use std::cmp::Ordering;

use bifdiag_body::{Axis, Frame};
use bifdiag_equilibria::curves::{Arc, Gap, Shape, SymmetricFamily};
use bifdiag_numbers::UNIT_ROUNDOFF;
use bifdiag_numbers::enclosure::Arithmetic;
use bifdiag_numbers::interval::Interval;

/// The gap h_a − h_b at one abscissa.
#[derive(Clone, Copy)]
pub(super) enum GapAt {
    /// Exactly zero: the curves meet in a common end.
    Joined,
    /// A number with its bound.
    Value(Gap),
    /// Beyond every bound (x → ∞).
    Infinite(Ordering),
    /// A limit as x → ∞ with bounds on how far each curve still is from its own limit.
    Limit(Gap),
}

impl GapAt {
    pub fn order(&self) -> Option<Ordering> {
        match self {
            Self::Joined => Some(Ordering::Equal),
            Self::Value(gap) | Self::Limit(gap) => gap.order(),
            Self::Infinite(order) => Some(*order),
        }
    }
}

#[derive(Clone, Copy)]
pub(super) struct Node {
    pub x: f64,
    pub gap: GapAt,
    pub slope: [f64; 2],
    /// The difference of the slopes to relative accuracy, for a pole line near a critical curve.
    pub slope_gap: Option<Gap>,
    /// The order as proved on the left of this node, where the gap may be below rounding.
    pub proved: Option<Ordering>,
}

impl Node {
    pub fn order(&self) -> Option<Ordering> {
        self.gap.order().or(self.proved)
    }
}

/// True when the whole gap between two nodes is below the rounding error.
pub(super) fn is_noise(left: &Node, right: &Node) -> bool {
    let (GapAt::Value(p), GapAt::Value(q)) = (left.gap, right.gap) else { return false };
    if p.order().is_some() || q.order().is_some() {
        return false;
    }
    let spread = (left.slope[0] - left.slope[1]).abs().max((right.slope[0] - right.slope[1]).abs());
    spread * (right.x - left.x) <= 4.0 * (p.error + q.error)
}

/// How the slopes of the two arcs compare all along: greater when the gap cannot fall between two nodes, less when it
/// cannot rise.
///
/// Slopes are compared with room for their rounding, except at an end that both arcs share: there they are the very
/// same number.
pub(super) fn slope_order(left: &Node, right: &Node) -> Option<Ordering> {
    // Beside a straight line the difference of slopes is monotone itself.
    let order = |node: &Node| node.slope_gap.as_ref().and_then(Gap::order);
    if let (Some(p), Some(q)) = (order(left), order(right)) {
        return (p == q).then_some(p);
    }
    let shared = |node: &Node| {
        let joined = matches!(node.gap, GapAt::Joined) || node.x.is_infinite();
        joined && node.slope[0] == node.slope[1]
    };
    let nodes = [left, right];
    let steeper = |p: usize, q: usize| {
        nodes.iter().all(|m| {
            nodes.iter().all(|n| {
                let room = if shared(m) || shared(n) { 1.0 } else { 1.0 + 16.0 * UNIT_ROUNDOFF };
                m.slope[p] >= n.slope[q] * room
            })
        })
    };
    if steeper(0, 1) {
        Some(Ordering::Greater)
    } else if steeper(1, 0) {
        Some(Ordering::Less)
    } else {
        None
    }
}

/// Units of roundoff by which computed inputs are widened.
const SLACK: f64 = 32.0;

/// d²h/dx² over a finite range of x inside the arc; `None` where no finite enclosure was found.
///
/// Along the generic family d²h/dx² = −2V/(J x (T J + 4V)); over μ = a_i it is −4R̂/(s³ J³ (a_i + 3R̂/s²)); on a
/// straight line 0 (Lemma 7.3 of docs/algorithms.md).
pub(super) fn curvature(frame: &Frame, arc: &Arc, x: [f64; 2]) -> Option<Interval> {
    let enclosure = match &arc.shape {
        Shape::Straight { .. } => Interval::ZERO,
        Shape::Generic(_) => {
            let (from, to) = (arc.mu(frame, x[0])?, arc.mu(frame, x[1])?);
            // Ends measured from different moments lie on both sides of the middle between these: there the change of
            // base costs one rounding of the larger distance.
            let first = if from.base == to.base { from.delta } else { from.delta + frame.diff[from.base][to.base] };
            generic(frame, to.base, Interval::between(first, to.delta).widened(SLACK))
        }
        Shape::Symmetric { family, .. } => {
            let s = |x: f64| {
                let point = arc.point(frame, x);
                // s J²/2 = x.
                2.0 * x / (point.j * point.j)
            };
            symmetric(frame, family, Interval::between(s(x[0]), s(x[1])).widened(SLACK))
        }
    };
    (enclosure.lo.is_finite() && enclosure.hi.is_finite()).then_some(enclosure)
}

fn generic(frame: &Frame, base: Axis, delta: Interval) -> Interval {
    let active = frame.active();
    let value = Interval::rounded;
    let tau: Vec<Interval> = active.iter().map(|&k| delta + value(frame.diff[base][k])).collect();
    let inverse: Vec<Interval> = tau.iter().map(|t| Interval::ONE / *t).collect();
    let g2: Vec<Interval> =
        active.iter().zip(&inverse).map(|(&k, inverse)| (value(frame.r[k]) * *inverse).square()).collect();
    let zero = Interval::ZERO;
    let p = g2.iter().fold(zero, |sum, g| sum + *g);
    let w: Vec<Interval> = g2.iter().map(|g| *g / p).collect();
    let j = active.iter().zip(&w).fold(zero, |sum, (&k, w)| sum + value(frame.a[k]) * *w);
    let t = w.iter().zip(&inverse).fold(zero, |sum, (w, inverse)| sum + *w * *inverse);
    let mut v = zero;
    for m in 0..active.len() {
        for n in m + 1..active.len() {
            let d = value(frame.diff[active[m]][active[n]]).square();
            v = v + w[m] * w[n] * d * inverse[m] * inverse[n];
        }
    }
    let x = p.sqrt() * j.square() * 0.5;
    -(v * 2.0) / (j * x * (t * j + v * 4.0))
}

fn symmetric(frame: &Frame, family: &SymmetricFamily, s: Interval) -> Interval {
    let r_sum = Interval::point(family.r_sum).widened(8.0);
    let a = Interval::rounded(frame.a[family.axis]);
    let shift = r_sum / s.square();
    let j = a - shift;
    -(r_sum * 4.0) / (s * s.square() * j * j.square() * (a + shift * 3.0))
}
