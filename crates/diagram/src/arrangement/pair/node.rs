//! What is known of two curves at one abscissa.

use std::cmp::Ordering;

use bifdiag_equilibria::curves::Gap;
use bifdiag_numbers::UNIT_ROUNDOFF;

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
