//! The rules by which the order of two arcs between two nodes follows from what is known there.

use std::cmp::Ordering;

use super::arcs::ArcPair;
use super::mirror::{MirrorPair, left_is_above};
use super::node::{GapAt, Node, curvature, slope_order};
use bifdiag_equilibria::curves::{Arc, Mu};
use bifdiag_numbers::Sign;
use bifdiag_numbers::enclosure::Enclosure;
use bifdiag_numbers::interval::Interval;

impl ArcPair<'_> {
    /// The order between two nodes, if it is proved to be the same all along.
    pub fn constant_order(&self, left: &Node, right: &Node) -> Option<Ordering> {
        by_slopes(left, right).or_else(|| self.by_bounds(left, right)).or_else(|| self.by_mirror(left, right))
    }

    /// Neither from its ends nor from a joint does the gap come to zero, by bounds on its first or second derivative.
    fn by_bounds(&self, left: &Node, right: &Node) -> Option<Ordering> {
        let (from, to) = (left.order()?, right.order()?);
        let range = |k: usize| Interval::between(left.slope[k], right.slope[k]).widened(8.0);
        let slope = match (left.slope_gap, right.slope_gap) {
            (Some(p), Some(q)) => Interval {
                lo: (p.value - p.error).min(q.value - q.error),
                hi: (p.value + p.error).max(q.value + q.error),
            },
            _ => range(0) - range(1),
        };
        let order = from.then(to);
        let separate = if from.is_eq() || to.is_eq() {
            order.is_ne() && self.curvature_separates(left, right)
        } else {
            from == to && self.bounded_away(left, right, slope, order)
        };
        separate.then_some(order)
    }

    /// The order of two branches on both sides of one moment.
    fn by_mirror(&self, left: &Node, right: &Node) -> Option<Ordering> {
        let at = |arc: &Arc, x: f64| if x.is_finite() { arc.mu(self.frame, x) } else { None };
        if left.x == 0.0 {
            return None;
        }
        let (p, q) = (at(self.a, left.x)?, at(self.b, left.x)?);
        if p.base != q.base || p.delta * q.delta >= 0.0 {
            return None;
        }
        let (end_p, end_q) = (at(self.a, right.x), at(self.b, right.x));
        let same_side = |mu: Option<Mu>, from: Mu, arc: &Arc| match mu {
            Some(mu) => mu.base == from.base && mu.delta * from.delta > 0.0,
            None => self.limit(arc).axis == Some(from.base),
        };
        if !same_side(end_p, p, self.a) || !same_side(end_q, q, self.b) {
            return None;
        }
        let a_is_left = p.delta < 0.0;
        let pair = |a: Option<Mu>, b: Option<Mu>| {
            if a_is_left { MirrorPair { left: a, right: b } } else { MirrorPair { left: b, right: a } }
        };
        let ends = [pair(Some(p), Some(q)), pair(end_p, end_q)];
        left_is_above(self.frame, p.base, [left.x, right.x], ends).then_some(if a_is_left {
            Ordering::Greater
        } else {
            Ordering::Less
        })
    }

    /// True when the gap, with a slope in this range, is proved not to vanish between two nodes of this order.
    fn bounded_away(&self, left: &Node, right: &Node, slope: Interval, order: Ordering) -> bool {
        let s = f64::from(Sign::from(order));
        // With D = s · gap > 0 at both ends, and dD/dx in [lo, hi].
        let slope = slope * s;
        match (left.gap, right.gap) {
            (GapAt::Value(p), GapAt::Value(q)) => {
                let (p, q) = (s * p.value - p.error, s * q.value - q.error);
                let length = right.x - left.x;
                let bound = if slope.lo >= 0.0 {
                    p
                } else if slope.hi <= 0.0 {
                    q
                } else {
                    let t = (q - p - slope.hi * length) / (slope.lo - slope.hi);
                    p + slope.lo * t.clamp(0.0, length)
                };
                bound > 0.0
            }
            (GapAt::Value(_), GapAt::Limit(gap)) => {
                let slack = self.deviation(self.a, left.x) + self.deviation(self.b, left.x);
                gap.value.abs() - gap.error > slack
            }
            _ => false,
        }
    }

    /// At a joint the gap vanishes with its derivative; if its second derivative keeps one sign it does not vanish again.
    fn curvature_separates(&self, left: &Node, right: &Node) -> bool {
        if !right.x.is_finite() || left.x == 0.0 {
            return false;
        }
        let range = [left.x, right.x];
        let (p, q) = (curvature(self.frame, self.a, range), curvature(self.frame, self.b, range));
        matches!((p, q), (Some(p), Some(q)) if (p - q).strict_sign().is_some())
    }
}

/// A gap that only moves one way stays on its side of zero, from one end or from the other. Towards infinity the
/// slopes differ by less than their rounding: there both ends must agree.
fn by_slopes(left: &Node, right: &Node) -> Option<Ordering> {
    let direction = slope_order(left, right)?;
    let admits = |node: &Node, order: Ordering| node.order().is_some_and(|own| own.is_eq() || own == order);
    let (onward, back) = (direction, direction.reverse());
    let order = if admits(left, onward) { Some(onward) } else { admits(right, back).then_some(back) };
    order.filter(|&order| right.x.is_finite() || admits(left, order) && admits(right, order))
}
