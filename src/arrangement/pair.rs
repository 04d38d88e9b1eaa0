//! All crossings of two curves, isolated by slope bounds.
//!
//! On an arc the slope dh/dx = 1/J is monotone, so between two abscissae it lies between its end values. If the slope
//! ranges of two arcs are disjoint their gap is monotone and its signs at the ends tell whether they cross, once; else
//! the gap is bounded from its end values and the slope ranges; else the interval is split. Both ends of the half-line
//! are closed by the known limits (MATH §4), so nothing is sampled and nothing missed.

use crate::body::Frame;
use crate::equilibria::{Arc, Curve, Gap, Mu, Orbit, Point, Pole, Shape};
use crate::numerics::UNIT_ROUNDOFF;
use crate::numerics::interval::Interval;
use crate::numerics::root::{Bracket, newton_bracketed};

use super::axis::line_and_pair;
use super::curvature::curvature;
use super::mirror::{MirrorPair, left_is_above};

/// A transversal crossing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PairCrossing {
    /// x = l²/2.
    pub x: f64,
    /// Bound on the error of `x`.
    pub x_error: f64,
    /// h.
    pub h: f64,
    /// Bound on the error of `h`.
    pub h_error: f64,
}

/// Order of two curves over their common range of x.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PairOrder {
    /// Sign of h_a − h_b just right of the lower end of the common range.
    pub initial: i8,
    /// Crossings by rising x.
    pub crossings: Vec<PairCrossing>,
    /// Ranges of x in which rounding hides whether the curves cross (0 or 2 times, or at a neighbouring event).
    pub unresolved: Vec<[f64; 2]>,
    /// Points of curves that were computed.
    pub evaluations: u32,
}

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

impl PairOrder {
    /// Compares two curves; `None` when no x is common to them, or one x only at which they meet.
    #[must_use]
    pub fn of(frame: &Frame, a: &Curve, b: &Curve) -> Option<Self> {
        let from = a.x()[0].max(b.x()[0]);
        let to = a.x()[1].min(b.x()[1]);
        if from == to && from > 0.0 {
            // One ends where the other begins: both live in the empty slab between two events at exactly the same x.
            let gap = Gap::between(frame, &a.point(frame, from), &b.point(frame, from));
            return gap.sign().map(|initial| Self { initial, ..Self::default() });
        }
        if from >= to {
            return None;
        }
        if let Some(sign) = structural_sign(a, b) {
            return Some(Self { initial: sign, ..Self::default() });
        }
        // Lines come before pairs in the list of curves.
        if let Some(order) = line_and_pair(frame, a, b, [from, to]) {
            return Some(order);
        }
        let joint = a.ends.iter().zip(a.x()).find_map(|(end, x)| {
            let shared = b.ends.iter().zip(b.x()).any(|(other, y)| end == other && x == y);
            (shared && x > 0.0 && x.is_finite()).then_some(x)
        });
        let mut whole: Option<Self> = None;
        for arc_a in &a.arcs {
            for arc_b in &b.arcs {
                let range = [arc_a.x[0].max(arc_b.x[0]), arc_a.x[1].min(arc_b.x[1])];
                if range[0] >= range[1] {
                    continue;
                }
                let mut pair = ArcPair { frame, a: arc_a, b: arc_b, joint, order: Self::default(), budget: BUDGET };
                pair.run(range);
                match &mut whole {
                    None => whole = Some(pair.order),
                    Some(whole) => whole.append(pair.order),
                }
            }
        }
        whole
    }

    fn append(&mut self, next: Self) {
        self.crossings.extend(next.crossings);
        self.unresolved.extend(next.unresolved);
        self.evaluations += next.evaluations;
    }

    /// Sign of h_a − h_b after `passed` crossings.
    #[must_use]
    pub fn sign_after(&self, passed: usize) -> i8 {
        if passed % 2 == 0 { self.initial } else { -self.initial }
    }
}

/// Orders that hold by structure, whatever the rounding (MATH §2 and §3).
///
/// - The piece that reaches +r̂ at l = 0 (μ above every moment) is the global minimum throughout.
/// - The piece of the leftmost interval that starts at −r̂ has slope above 1/J_r and starts on P−: it stays above P−.
/// - P− lies 2r above P+.
/// - A symmetric pair has a cusp only when R̂ < 0; then J = a_i − R̂/s² falls with s, and of the two arms that start at
///   the cusp the one that goes to s = ∞ has the larger slope 1/J: it lies above.
fn structural_sign(a: &Curve, b: &Curve) -> Option<i8> {
    use crate::equilibria::{Branch, End};
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
    fn run(&mut self, range: [f64; 2]) {
        let (left, right) = (self.node(range[0]), self.node(range[1]));
        let before = self.order.crossings.len();
        self.isolate(left, right, 0);
        let crossed = self.order.crossings.len() - before;
        // The sign at the left end; where that is a joint or uncertain, from the right end and the crossings between.
        self.order.initial = match (left.gap.sign(), right.gap.sign()) {
            (Some(sign), _) if sign != 0 => sign,
            (_, Some(sign)) if sign != 0 => {
                if crossed % 2 == 0 {
                    sign
                } else {
                    -sign
                }
            }
            _ => self.sign_between(range),
        };
    }

    /// The sign somewhere between two ends that do not tell.
    fn sign_between(&mut self, range: [f64; 2]) -> i8 {
        let fractions = [0.5, 0.25, 0.75];
        let signs = fractions.map(|t| self.node(between(range[0], range[1], t)).gap.sign());
        let first = signs.iter().flatten().find(|sign| **sign != 0).copied();
        first.unwrap_or_else(|| {
            self.order.unresolved.push(range);
            1
        })
    }

    fn node(&mut self, x: f64) -> Node {
        if x == 0.0 {
            return Node { x, gap: self.gap_at_origin(), slope: [self.a.slope[0], self.b.slope[0]] };
        }
        if x.is_infinite() {
            return Node { x, gap: self.gap_at_infinity(), slope: [self.a.slope[1], self.b.slope[1]] };
        }
        self.order.evaluations += 2;
        let (p, q) = (self.a.point(self.frame, x), self.b.point(self.frame, x));
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
        let gap = if self.joint == Some(x) { GapAt::Joined } else { GapAt::Value(Gap::between(self.frame, &p, &q)) };
        Node { x, gap, slope: [end_slope(self.a, &p), end_slope(self.b, &q)] }
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

    /// As l → ∞, h = x/J∞ − ρ∞ + O(1/x) (MATH §4).
    fn gap_at_infinity(&self) -> GapAt {
        let (p, q) = (self.limit(self.a), self.limit(self.b));
        let moment_gap = match (p.axis, q.axis) {
            (Some(i), Some(j)) => self.frame.diff[j][i],
            (None, Some(j)) => self.frame.offset[j],
            (Some(i), None) => -self.frame.offset[i],
            (None, None) => 0.0,
        };
        if moment_gap != 0.0 {
            return GapAt::Infinite(if moment_gap > 0.0 { 1 } else { -1 });
        }
        let error = 8.0 * UNIT_ROUNDOFF * (p.rho.abs() + q.rho.abs());
        GapAt::Limit { gap: Gap { value: q.rho - p.rho, error } }
    }

    fn limit(&self, arc: &Arc) -> Limit {
        let frame = self.frame;
        match &arc.shape {
            Shape::Straight { gamma, .. } => {
                let axis = (0..3).find(|&k| gamma[k].abs() == 1.0);
                Limit { axis, rho: (0..3).map(|k| gamma[k] * frame.r[k]).sum() }
            }
            Shape::Generic(segments) => {
                let last = segments[segments.len() - 1];
                Limit { axis: Some(last.base), rho: last.sign * frame.r[last.base] }
            }
            Shape::Symmetric { family, .. } => Limit { axis: Some(family.axis), rho: 0.0 },
        }
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

    /// Finds the crossings between two nodes; returns the sign of the gap just right of the left one, if proved.
    fn isolate(&mut self, left: Node, right: Node, depth: u32) -> Option<i8> {
        let range = |k: usize| Interval::between(left.slope[k], right.slope[k]).widened(8.0);
        // Without widening: where an end is shared both arcs have the very same slope there.
        let (p, q) =
            (Interval::between(left.slope[0], right.slope[0]), Interval::between(left.slope[1], right.slope[1]));
        let monotone = p.lo >= q.hi || p.hi <= q.lo;
        if let (Some(sl), Some(sr)) = (left.gap.sign(), right.gap.sign()) {
            let either = if sl == 0 { sr } else { sl };
            let separate = sl * sr > 0 && self.bounded_away(&left, &right, range(0) - range(1), sl)
                || sl * sr == 0 && either != 0 && self.curvature_separates(&left, &right);
            if monotone && sl * sr < 0 {
                self.locate(left, right);
                return Some(sl);
            }
            if (monotone && sl * sr >= 0 || separate) && either != 0 {
                return Some(either);
            }
        }
        if let Some(sign) = self.mirror_sign(&left, &right) {
            return Some(sign);
        }
        let exhausted = right.x.is_finite() && right.x - left.x <= 64.0 * UNIT_ROUNDOFF * right.x;
        if exhausted || depth > 120 || self.budget == 0 || self.is_noise(&left, &right) {
            self.order.unresolved.push([left.x, right.x]);
            return left.gap.sign().filter(|sign| *sign != 0);
        }
        self.budget -= 1;
        let middle = self.split(&left, &right);
        let first = self.isolate(left, middle, depth + 1);
        self.isolate(middle, right, depth + 1);
        first
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

    /// True when the whole gap between two nodes is below the rounding error.
    fn is_noise(&self, left: &Node, right: &Node) -> bool {
        let (GapAt::Value(p), GapAt::Value(q)) = (left.gap, right.gap) else { return false };
        if p.sign().is_some() || q.sign().is_some() {
            return false;
        }
        let spread = (left.slope[0] - left.slope[1]).abs().max((right.slope[0] - right.slope[1]).abs());
        spread * (right.x - left.x) <= 4.0 * (p.error + q.error)
    }

    /// The crossing between two nodes where the gap is monotone and changes sign.
    fn locate(&mut self, left: Node, right: Node) {
        let rising = right.gap.sign().unwrap_or(1) > 0;
        let bracket = if rising {
            Bracket { negative: left.x, positive: right.x }
        } else {
            Bracket { negative: right.x, positive: left.x }
        };
        let (frame, a, b) = (self.frame, self.a, self.b);
        let at = |x: f64| {
            let (p, q) = (a.point(frame, x), b.point(frame, x));
            (Gap::between(frame, &p, &q), p.slope() - q.slope(), p)
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
        self.order.crossings.push(PairCrossing { x, x_error, h: point.h(), h_error });
    }
}

#[derive(Clone, Copy)]
struct Limit {
    axis: Option<usize>,
    rho: f64,
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
