//! All crossings of two curves, isolated by slope bounds.
//!
//! On an arc the slope dh/dx = 1/J is monotone, so between two abscissae it lies between its end values. If the slope
//! ranges of two arcs are disjoint their gap is monotone and its signs at the ends tell whether they cross, once; else
//! the gap is bounded from its end values and the slope ranges; else the interval is split. Both ends of the half-line
//! are closed by the known limits (Corollary 6.3 of docs/mathematics.md), so nothing is sampled and nothing missed.
//! What proves an order is Lemma 7.1 to Lemma 7.6 there.

use crate::body::Frame;
use crate::curves::{Arc, Asymptote, Curve, Gap, Mu, Orbit, Point, Pole, Shape};
use numbers::UNIT_ROUNDOFF;
use numbers::enclosure::Enclosure;
use numbers::interval::Interval;
use numbers::root::{Bracket, newton_bracketed};

use super::axis::line_and_pair;
use super::curvature::curvature;
use super::mirror::{MirrorPair, left_is_above};
use super::order::{PairCrossing, PairOrder};
use super::pole;

/// The gap h_a − h_b at one abscissa.
#[derive(Clone, Copy)]
enum GapAt {
    /// Exactly zero: the curves meet in a common end.
    Joined,
    /// A number with its bound.
    Value(Gap),
    /// Beyond every bound (x → ∞).
    Infinite(i8),
    /// A limit as x → ∞ with bounds on how far each curve still is from its own limit.
    Limit { gap: Gap },
}

impl GapAt {
    fn sign(&self) -> Option<i8> {
        match self {
            Self::Joined => Some(0),
            Self::Value(gap) | Self::Limit { gap } => gap.sign(),
            Self::Infinite(sign) => Some(*sign),
        }
    }
}

#[derive(Clone, Copy)]
struct Node {
    x: f64,
    gap: GapAt,
    slope: [f64; 2],
    /// The difference of the slopes to relative accuracy, for a pole line near a critical curve.
    slope_gap: Option<Gap>,
    /// The sign of the gap as proved on the left of this node, where its value may be below rounding.
    proved: Option<i8>,
}

impl Node {
    fn sign(&self) -> Option<i8> {
        self.gap.sign().or(self.proved)
    }
}

/// Two arcs over a common range of x.
struct ArcPair<'a> {
    frame: &'a Frame,
    a: &'a Arc,
    b: &'a Arc,
    /// A common end of the two arcs: a cusp or a pitchfork.
    joint: Option<f64>,
    order: PairOrder,
    budget: u32,
}

/// Splitting stops when so many points were computed for one pair of arcs.
const BUDGET: u32 = 600;

/// Compares two curves a and b; `None` when no x is common to them.
pub(super) fn compare(frame: &Frame, a: &Curve, b: &Curve) -> Option<PairOrder> {
    let from = a.x()[0].max(b.x()[0]);
    let to = a.x()[1].min(b.x()[1]);
    if from >= to {
        return None;
    }
    if let Some(sign) = structural_sign(a, b) {
        return Some(PairOrder::constant([from, to], sign));
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
                let mut pair =
                    ArcPair { frame, a: arc_a, b: arc_b, joint, order: PairOrder::default(), budget: BUDGET };
                let (left, right) = (pair.node(range[0]), pair.node(range[1]));
                proved = pair.isolate(Node { proved, ..left }, right, 0);
                whole.append(pair.order);
            }
        }
    }
    Some(whole)
}

/// Orders that hold by structure, whatever the rounding (Proposition 4.3 and Proposition 5.2).
///
/// - The piece that reaches +r̂ at l = 0 (μ above every moment) is the global minimum throughout.
/// - The piece of the leftmost interval that starts at −r̂ has slope above 1/J_r and starts on P−: it stays above P−.
/// - P− lies 2r above P+.
/// - A symmetric pair has a cusp only when R̂ < 0; then J = a_i − R̂/s² falls with s, and of the two arms that start at
///   the cusp the one that goes to s = ∞ has the larger slope 1/J: it lies above.
fn structural_sign(a: &Curve, b: &Curve) -> Option<i8> {
    use crate::curves::{Branch, End};
    let is_minimum =
        |c: &Curve| c.is_critical() && c.index == Some(0) && c.ends[0] == End::Origin && c.orbit == Orbit::Point;
    let from_south = |c: &Curve| c.branch == Branch::Generic(0) && c.ends[0] == End::Origin;
    let line = |c: &Curve| match c.orbit {
        Orbit::Pole(pole) => Some(pole),
        _ => None,
    };
    if is_minimum(a) {
        return Some(-1);
    }
    if is_minimum(b) {
        return Some(1);
    }
    // The arms of a symmetric pair's cusp share the family on which J falls towards infinity.
    if let (Branch::Symmetric(i), Branch::Symmetric(j)) = (a.branch, b.branch) {
        let born_together = matches!(a.ends[0], End::Cusp(_)) && a.ends[0] == b.ends[0];
        if i == j && born_together {
            return match (a.ends[1], b.ends[1]) {
                (End::Infinity, _) => Some(1),
                (_, End::Infinity) => Some(-1),
                _ => None,
            };
        }
    }
    match (line(a), line(b)) {
        (Some(Pole::Plus), Some(Pole::Minus)) => Some(-1),
        (Some(Pole::Minus), Some(Pole::Plus)) => Some(1),
        (Some(Pole::Minus), None) if from_south(b) => Some(-1),
        (None, Some(Pole::Minus)) if from_south(a) => Some(1),
        _ => None,
    }
}

impl ArcPair<'_> {
    fn node(&mut self, x: f64) -> Node {
        if x == 0.0 {
            return Node {
                x,
                gap: self.gap_at_origin(),
                slope: [self.a.slope[0], self.b.slope[0]],
                slope_gap: None,
                proved: None,
            };
        }
        if x.is_infinite() {
            let slope = [self.a.slope[1], self.b.slope[1]];
            return Node { x, gap: self.gap_at_infinity(), slope, slope_gap: self.final_slope_gap(), proved: None };
        }
        self.order.evaluations += 2;
        let at = [self.a, self.b].map(|arc| arc.point_and_mu(self.frame, x));
        let [(p, _), (q, _)] = at;
        let end_slope = |arc: &Arc, point: &Point| {
            // At a common end both arcs take the slope of the end itself.
            if x == arc.x[0] {
                arc.slope[0]
            } else if x == arc.x[1] {
                arc.slope[1]
            } else {
                point.slope()
            }
        };
        let refined = pole_gaps(self.frame, [self.a, self.b], &at);
        let plain = Gap::between(self.frame, &p, &q);
        let gap = match refined {
            _ if self.joint == Some(x) => GapAt::Joined,
            Some([gap, _]) if gap.error < plain.error => GapAt::Value(gap),
            _ => GapAt::Value(plain),
        };
        let slope = [end_slope(self.a, &p), end_slope(self.b, &q)];
        Node { x, gap, slope, slope_gap: refined.map(|[_, slope]| slope), proved: None }
    }

    /// At l = 0 a curve starts at h = −⟨γ, r⟩ with γ = ±r̂, or at 0 when r = 0.
    fn gap_at_origin(&self) -> GapAt {
        let height = |arc: &Arc| match &arc.shape {
            Shape::Straight { gamma, .. } => -(0..3).map(|k| gamma[k] * self.frame.r[k]).sum::<f64>(),
            Shape::Generic(segments) => -segments[0].sign * self.frame.r_norm,
            Shape::Symmetric { .. } => 0.0,
        };
        let (p, q) = (height(self.a), height(self.b));
        if (p > 0.0) == (q > 0.0) && (p < 0.0) == (q < 0.0) {
            return GapAt::Joined;
        }
        let error = 8.0 * UNIT_ROUNDOFF * (p.abs() + q.abs());
        GapAt::Value(Gap { value: p - q, error })
    }

    /// As l → ∞, h = x/J∞ − ρ∞ + O(1/x) (Proposition 6.2).
    fn gap_at_infinity(&self) -> GapAt {
        let (p, q) = (self.limit(self.a), self.limit(self.b));
        let moment_gap = p.moment_gap(self.frame, &q);
        if moment_gap != 0.0 {
            return GapAt::Infinite(if moment_gap > 0.0 { 1 } else { -1 });
        }
        let error = 8.0 * UNIT_ROUNDOFF * (p.rho.abs() + q.rho.abs());
        GapAt::Limit { gap: Gap { value: q.rho - p.rho, error } }
    }

    /// The limit of the difference of slopes of a pole line and a curve: 1/J_r − 1/a = (a − J_r)/(a J_r).
    fn final_slope_gap(&self) -> Option<Gap> {
        let frame = self.frame;
        let (axis, sign) = match (self.limit(self.a).axis, self.limit(self.b).axis) {
            (None, Some(axis)) => (axis, 1.0),
            (Some(axis), None) => (axis, -1.0),
            _ => return None,
        };
        let value = sign * frame.offset[axis] / (frame.a[axis] * frame.j_r);
        Some(Gap { value, error: 8.0 * UNIT_ROUNDOFF * value.abs() })
    }

    fn limit(&self, arc: &Arc) -> Asymptote {
        arc.asymptote(self.frame)
    }

    /// How far h − x/J∞ is from its limit −ρ∞; it approaches monotonically.
    fn deviation(&self, arc: &Arc, x: f64) -> f64 {
        let limit = self.limit(arc);
        let Some(axis) = limit.axis else { return 0.0 };
        let mut gamma = [0.0; 3];
        gamma[axis] = if limit.rho < 0.0 { -1.0 } else { 1.0 };
        let mut asymptote = Point::over(self.frame, x, gamma, self.frame.a[axis]);
        asymptote.rho = limit.rho;
        let gap = Gap::between(self.frame, &arc.point(self.frame, x), &asymptote);
        gap.value.abs() + gap.error
    }

    /// Finds the order between two nodes; returns the sign of the gap at the right one, if proved.
    fn isolate(&mut self, left: Node, right: Node, depth: u32) -> Option<i8> {
        let x = [left.x, right.x];
        if let (Some(sl), Some(sr)) = (left.sign(), right.sign())
            && sl * sr < 0
            && slope_order(&left, &right).is_some()
        {
            self.locate(left, right, sl);
            return Some(sr);
        }
        if let Some(sign) = self.constant_sign(&left, &right) {
            self.order.push(x, Some(sign));
            return (right.gap.sign() != Some(0)).then_some(sign);
        }
        let exhausted = right.x.is_finite() && right.x - left.x <= 64.0 * UNIT_ROUNDOFF * right.x;
        if exhausted || depth > 120 || self.budget == 0 || is_noise(&left, &right) {
            self.order.push(x, None);
            return right.gap.sign().filter(|sign| *sign != 0);
        }
        self.budget -= 1;
        let middle = self.split(&left, &right);
        let proved = self.isolate(left, middle, depth + 1);
        self.isolate(Node { proved, ..middle }, right, depth + 1)
    }

    /// The sign of the gap between two nodes, if it is proved to be the same all along.
    fn constant_sign(&self, left: &Node, right: &Node) -> Option<i8> {
        let (sl, sr) = (left.sign(), right.sign());
        if let Some(direction) = slope_order(left, right) {
            // A gap that only moves one way stays on its side of zero, from one end or from the other. Towards infinity
            // the slopes differ by less than their rounding: there both ends must agree.
            let from_left = sl.filter(|sign| sign * direction >= 0).map(|_| direction);
            let from_right = sr.filter(|sign| sign * direction <= 0).map(|_| -direction);
            let agreed = from_left.or(from_right).filter(|sign| {
                right.x.is_finite() || [sl, sr].iter().all(|end| end.is_some_and(|end| end * sign >= 0))
            });
            if agreed.is_some() {
                return agreed;
            }
        }
        if let (Some(sl), Some(sr)) = (sl, sr) {
            let range = |k: usize| Interval::between(left.slope[k], right.slope[k]).widened(8.0);
            let either = if sl == 0 { sr } else { sl };
            let difference = match (left.slope_gap, right.slope_gap) {
                (Some(p), Some(q)) => Interval {
                    lo: (p.value - p.error).min(q.value - q.error),
                    hi: (p.value + p.error).max(q.value + q.error),
                },
                _ => range(0) - range(1),
            };
            let separate = sl * sr > 0 && self.bounded_away(left, right, difference, sl)
                || sl * sr == 0 && either != 0 && self.curvature_separates(left, right);
            if separate {
                return Some(either);
            }
        }
        self.mirror_sign(left, right)
    }

    /// The sign of the gap of two branches on both sides of one moment, where it is proved to be constant.
    fn mirror_sign(&self, left: &Node, right: &Node) -> Option<i8> {
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
        left_is_above(self.frame, p.base, [left.x, right.x], ends).then_some(if a_is_left { 1 } else { -1 })
    }

    /// A splitting point at which the sign of the gap is certain, if one of a few is.
    fn split(&mut self, left: &Node, right: &Node) -> Node {
        let mut node = self.node(between(left.x, right.x, 0.5));
        for t in [0.4, 0.6, 0.3] {
            if node.gap.sign().is_some() {
                break;
            }
            node = self.node(between(left.x, right.x, t));
        }
        node
    }

    /// True when the gap is proved not to vanish between two nodes at which it has the sign `sign`.
    fn bounded_away(&self, left: &Node, right: &Node, slope: Interval, sign: i8) -> bool {
        let s = f64::from(sign);
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
            (GapAt::Value(_), GapAt::Limit { gap }) => {
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
        matches!((p, q), (Some(p), Some(q)) if (p - q).sign().is_some_and(|sign| sign != 0))
    }

    /// The crossing between two nodes where the gap is monotone and changes sign.
    fn locate(&mut self, left: Node, right: Node, sign: i8) {
        let rising = sign < 0;
        let bracket = if rising {
            Bracket { negative: left.x, positive: right.x }
        } else {
            Bracket { negative: right.x, positive: left.x }
        };
        let (frame, a, b) = (self.frame, self.a, self.b);
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
        let root = newton_bracketed(bracket, guess, 0.0, |x| {
            let (gap, slope, _) = at(x);
            // Below an eighth of its bound the gap is noise.
            (if gap.value.abs() <= gap.error / 8.0 { 0.0 } else { gap.value }, slope)
        });
        self.order.evaluations += 2 * root.evaluations;
        let x = root.at;
        let (gap, slope, point) = at(x);
        let x_error = (gap.error / slope.abs()).min(right.x - left.x) + 4.0 * UNIT_ROUNDOFF * x;
        let h_error = point.h_error() + x_error * point.slope();
        let crossing = PairCrossing { x, x_error, h: point.h(), h_error };
        self.order.push_crossing([left.x, right.x], sign, crossing);
    }
}

/// A point between two abscissae of which the left may be 0 and the right ∞; geometric when they differ much.
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

/// True when the whole gap between two nodes is below the rounding error.
fn is_noise(left: &Node, right: &Node) -> bool {
    let (GapAt::Value(p), GapAt::Value(q)) = (left.gap, right.gap) else { return false };
    if p.sign().is_some() || q.sign().is_some() {
        return false;
    }
    let spread = (left.slope[0] - left.slope[1]).abs().max((right.slope[0] - right.slope[1]).abs());
    spread * (right.x - left.x) <= 4.0 * (p.error + q.error)
}

/// Gap and difference of slopes of two arcs of which one is a pole line and the other a critical curve near it.
fn pole_gaps(frame: &Frame, [a, b]: [&Arc; 2], [(p, p_mu), (q, q_mu)]: &[(Point, Option<Mu>); 2]) -> Option<[Gap; 2]> {
    let is_line = |arc: &Arc| matches!(arc.shape, Shape::Straight { .. });
    match (is_line(a), is_line(b)) {
        (true, false) => pole::gaps(frame, p, q, (*q_mu)?),
        (false, true) => {
            let gaps = pole::gaps(frame, q, p, (*p_mu)?)?;
            Some(gaps.map(|gap| Gap { value: -gap.value, ..gap }))
        }
        _ => None,
    }
}

/// 1 when the gap cannot fall between two nodes, −1 when it cannot rise.
///
/// Slopes are compared with room for their rounding, except at an end that both arcs share: there they are the very
/// same number.
fn slope_order(left: &Node, right: &Node) -> Option<i8> {
    // Beside a straight line the difference of slopes is monotone itself.
    let sign = |node: &Node| node.slope_gap.as_ref().and_then(Gap::sign);
    if let (Some(p), Some(q)) = (sign(left), sign(right)) {
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
        Some(1)
    } else if steeper(1, 0) {
        Some(-1)
    } else {
        None
    }
}
