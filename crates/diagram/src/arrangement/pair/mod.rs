//! All crossings of two curves, isolated by slope bounds.
//!
//! On an arc the slope dh/dx = 1/J is monotone, so between two abscissae it lies between its end values. If the slope
//! ranges of two arcs are disjoint their gap is monotone and its signs at the ends decide whether they cross, once; else
//! the gap is bounded from its end values and the slope ranges; else the interval is split. Both ends of the half-line
//! are closed by the known limits (Corollary 6.3 of docs/mathematics.md), so nothing is sampled and nothing missed.
//! What proves an order is Lemma 7.1 to Lemma 7.6 there.

mod arcs;
mod mirror;
mod node;
mod pole;
mod rules;
mod structure;

use std::cmp::Ordering;

use super::order::{PairCrossing, PairOrder};
use arcs::{ArcPair, pole_gaps};
use bifdiag_body::Frame;
use bifdiag_equilibria::curves::{Curve, Gap};
use bifdiag_numbers::UNIT_ROUNDOFF;
use bifdiag_numbers::root::{Bracket, newton_bracketed};
use node::{GapAt, Node, is_noise, slope_order};
use structure::line_and_pair;
use structure::structural_order;

/// Splitting stops after this number of points for one pair of arcs.
const BUDGET: u32 = 600;

/// Compares two curves a and b; `None` when no x is common to them.
pub(super) fn compare(frame: &Frame, a: &Curve, b: &Curve) -> Option<PairOrder> {
    let from = a.x()[0].max(b.x()[0]);
    let to = a.x()[1].min(b.x()[1]);
    if from >= to {
        return None;
    }
    if let Some(order) = structural_order(a, b) {
        return Some(PairOrder::constant([from, to], order));
    }
    // Lines come before pairs in the list of curves.
    if let Some(order) = line_and_pair(frame, a, b, [from, to]) {
        return Some(order);
    }
    let joint = a.ends.iter().zip(a.x()).find_map(|(end, x)| {
        let shared = b.ends.iter().zip(b.x()).any(|(other, y)| end == other && x == y);
        (shared && x > 0.0 && x.is_finite()).then_some(x)
    });
    let mut whole = PairOrder::default();
    let mut proved = None;
    for arc_a in &a.arcs {
        for arc_b in &b.arcs {
            let range = [arc_a.x[0].max(arc_b.x[0]), arc_a.x[1].min(arc_b.x[1])];
            if range[0] < range[1] {
                let pair = ArcPair { frame, a: arc_a, b: arc_b, joint };
                let mut isolation = Isolation { pair, order: PairOrder::default(), budget: BUDGET };
                let [left, right] = range.map(|x| isolation.node(x));
                proved = isolation.isolate(Node { proved, ..left }, right, 0);
                whole.append(isolation.order);
            }
        }
    }
    Some(whole)
}

/// The crossings of two arcs in the making.
struct Isolation<'a> {
    pair: ArcPair<'a>,
    order: PairOrder,
    budget: u32,
}

impl Isolation<'_> {
    fn node(&mut self, x: f64) -> Node {
        if x > 0.0 && x.is_finite() {
            self.order.evaluations += 2;
        }
        self.pair.node(x)
    }

    /// Finds the order between two nodes; returns the order at the right one, if proved.
    fn isolate(&mut self, left: Node, right: Node, depth: u32) -> Option<Ordering> {
        let x = [left.x, right.x];
        if let (Some(before), Some(after)) = (left.order(), right.order())
            && before.is_ne()
            && before == after.reverse()
            && slope_order(&left, &right).is_some()
        {
            self.locate(left, right, before);
            return Some(after);
        }
        if let Some(order) = self.pair.constant_order(&left, &right) {
            self.order.push(x, Some(order));
            return (right.gap.order() != Some(Ordering::Equal)).then_some(order);
        }
        let exhausted = right.x.is_finite() && right.x - left.x <= 64.0 * UNIT_ROUNDOFF * right.x;
        if exhausted || depth > 120 || self.budget == 0 || is_noise(&left, &right) {
            self.order.push(x, None);
            return right.gap.order().filter(|order| order.is_ne());
        }
        self.budget -= 1;
        let middle = self.split(&left, &right);
        let proved = self.isolate(left, middle, depth + 1);
        self.isolate(Node { proved, ..middle }, right, depth + 1)
    }

    /// A splitting point at which the order is certain, if one of a few is.
    fn split(&mut self, left: &Node, right: &Node) -> Node {
        let mut node = self.node(between(left.x, right.x, 0.5));
        for t in [0.4, 0.6, 0.3] {
            if node.gap.order().is_some() {
                break;
            }
            node = self.node(between(left.x, right.x, t));
        }
        node
    }

    /// The crossing between two nodes where the gap is monotone and changes its sign.
    fn locate(&mut self, left: Node, right: Node, before: Ordering) {
        let bracket = if before.is_lt() {
            Bracket { negative: left.x, positive: right.x }
        } else {
            Bracket { negative: right.x, positive: left.x }
        };
        let (frame, a, b) = (self.pair.frame, self.pair.a, self.pair.b);
        let at = |x: f64| {
            let at = [a, b].map(|arc| arc.point_and_mu(frame, x));
            let [(p, _), (q, _)] = at;
            let plain = (Gap::between(frame, &p, &q), p.slope() - q.slope());
            let (gap, slope) = match pole_gaps(frame, [a, b], &at) {
                Some([gap, slope]) => (if gap.error < plain.0.error { gap } else { plain.0 }, slope.value),
                None => plain,
            };
            (gap, slope, p)
        };
        let guess = match (left.gap, right.gap) {
            (GapAt::Value(p), GapAt::Value(q)) => left.x + (right.x - left.x) * p.value / (p.value - q.value),
            _ => f64::NAN,
        };
        let mut evaluations = 0;
        let x = newton_bracketed(bracket, guess, 0.0, |x| {
            evaluations += 2;
            let (gap, slope, _) = at(x);
            // Below an eighth of its bound the gap is noise.
            (if gap.value.abs() <= gap.error / 8.0 { 0.0 } else { gap.value }, slope)
        });
        self.order.evaluations += evaluations;
        let (gap, slope, point) = at(x);
        let x_error = (gap.error / slope.abs()).min(right.x - left.x) + 4.0 * UNIT_ROUNDOFF * x;
        let h_error = point.h_error() + x_error * point.slope();
        let crossing = PairCrossing { x, x_error, h: point.h(), h_error };
        self.order.push_crossing([left.x, right.x], before, crossing);
    }
}

/// A point between two abscissae, the left of which may be 0 and the right ∞; geometric when they differ much.
fn between(left: f64, right: f64, t: f64) -> f64 {
    if right.is_infinite() {
        return if left == 0.0 { 1.0 + t } else { left * (1.0 + 30.0 * t) };
    }
    if left == 0.0 {
        return right * t / 8.0;
    }
    if right > 4.0 * left {
        // left^(1−t) right^t for t near ½, by square roots only.
        left.sqrt() * right.sqrt() * (0.5 + t)
    } else {
        left + t * (right - left)
    }
}
