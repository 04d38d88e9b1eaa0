//! The order of two branches on both sides of a moment a_i whose r_i is small (an imperfect pitchfork).
//!
//! Both branches are solutions of one family: with ε in the place of r_i and μ = a_i + ε v, where 1/v = s γ_i > 0,
//! P = p/v², Q = q/v² with p = 1 + v² P̂(μ), q = a_i + v² Q̂(μ) (sums over the other axes), x = q²/(2 p^{3/2} v). The branch
//! right of a_i has ε = r_i; the branch left of it, mirrored in γ_i, has ε = −r_i. At fixed x dh/dε = −γ_i (h is
//! stationary in γ). So if x(v, ε) is monotone in v on a box that the solution cannot leave while ε runs from r_i to
//! −r_i, then h_left − h_right = ∫ γ_i dε > 0: the left branch lies above the right one, by 2 r_i γ_i to first order,
//! however small that is (Lemma 7.5 of docs/algorithms.md).

use bifdiag_body::{Axis, Frame};
use bifdiag_equilibria::curves::Mu;
use bifdiag_numbers::Sign;
use bifdiag_numbers::enclosure::{Arithmetic, Enclosure};
use bifdiag_numbers::interval::Interval;

/// The two branches at one abscissa.
#[derive(Clone, Copy)]
pub(super) struct MirrorPair {
    /// On the left of a_i: δ < 0. `None`: x = ∞.
    pub left: Option<Mu>,
    /// On the right of a_i.
    pub right: Option<Mu>,
}

/// True when the branch left of a_i is proved to lie above the branch right of it for all x in the range.
pub(super) fn left_is_above(frame: &Frame, axis: Axis, x: [f64; 2], ends: [MirrorPair; 2]) -> bool {
    let curves = MirroredCurves::new(frame, axis);
    let v = |mu: Option<Mu>| mu.map_or(0.0, |mu| mu.delta.abs() / frame.r[axis]);
    let left = ends.map(|pair| v(pair.left));
    let right = ends.map(|pair| v(pair.right));
    curves.is_monotone_around(x, left, right) || curves.leaves_cusp(x, left, right)
}

/// The family of solutions over one axis, with ε anywhere in [−r_i, r_i].
#[derive(Clone, Copy)]
struct MirroredCurves<'a> {
    frame: &'a Frame,
    axis: Axis,
    a: Interval,
    epsilon: Interval,
}

/// P̂, Q̂ and their derivatives in μ.
struct Sums {
    p: [Interval; 3],
    q: [Interval; 3],
}

impl<'a> MirroredCurves<'a> {
    fn new(frame: &'a Frame, axis: Axis) -> Self {
        let epsilon = Interval::between(-frame.r[axis], frame.r[axis]).widened(2.0);
        Self { frame, axis, a: Interval::rounded(frame.a[axis]), epsilon }
    }

    /// The solution cannot leave a box on which x is monotone in v, while ε runs from one end to the other.
    fn is_monotone_around(&self, x: [f64; 2], left: [f64; 2], right: [f64; 2]) -> bool {
        // Room for the solution to move while ε changes sign: a few times its shift, or more; a wider box is harder to
        // prove monotone.
        let shift = (0..2).map(|k| (left[k] - right[k]).abs() / left[k].min(right[k])).fold(0.0, f64::max);
        let rooms = [1.0 + 1e-12 + 8.0 * shift, 1.02, 1.2, 2.0];
        let all = [left, right].concat();
        let smallest = all.iter().copied().fold(f64::INFINITY, f64::min);
        let largest = all.iter().copied().fold(0.0, f64::max);
        rooms.iter().filter(|room| **room <= 2.0).any(|room| {
            let v = Interval::between(smallest / room, largest * room);
            let Some(sign) = self.slope_sign(v) else { return false };
            let (at_small, at_large) = (self.x(Interval::point(v.lo)), self.x(Interval::point(v.hi)));
            if sign == Sign::Positive {
                at_large.hi < x[0] && at_small.lo > x[1]
            } else {
                at_large.lo > x[1] && at_small.hi < x[0]
            }
        })
    }

    /// Next to a cusp of one of the branches, where x is not monotone on a whole box.
    ///
    /// With t = 1/v, the sign of dx/dt is that of g = t³(4 a_i P − 3 Q) − ε m, m = 2 Q̂'P − (3/2) P̂'Q, and that of dx/dε
    /// is that of m. Let the branch with the smaller t start at ε₀ = ∓r_i on the far side of its cusp, s = sign dx/dt ≥ 0
    /// there. If s g grows with t and as ε leaves ε₀, and m drives t upwards, then dx/dt keeps its sign along the way to
    /// −ε₀ and t only grows: the solution arrives at the other branch.
    fn leaves_cusp(&self, x: [f64; 2], left: [f64; 2], right: [f64; 2]) -> bool {
        const ROOM: f64 = 1.5;
        if left.iter().chain(&right).any(|v| *v <= 0.0) {
            return false;
        }
        let (start, goal, direction) = if left[0].max(left[1]) >= right[0].max(right[1]) {
            (left, right, Sign::Positive)
        } else {
            (right, left, Sign::Negative)
        };
        let (t_start, t_goal) = (start.map(|v| 1.0 / v), goal.map(|v| 1.0 / v));
        if (0..2).any(|k| t_goal[k] < t_start[k]) {
            return false;
        }
        let s = if t_start[1] > t_start[0] { Sign::Positive } else { Sign::Negative };
        let top = t_start.iter().chain(&t_goal).copied().fold(0.0, f64::max) * ROOM;
        let t = Interval { lo: t_start[0].min(t_start[1]), hi: top };
        let slopes = self.slopes_of_g(t);
        let proved = slopes.0.sign() == Some(s)
            && slopes.1.sign() == Some(s * direction)
            && slopes.2.sign() == Some(-s * direction);
        if !proved {
            return false;
        }
        let edge = self.x(Interval::point(1.0 / top));
        if s == Sign::Positive { edge.lo > x[1] } else { edge.hi < x[0] }
    }

    fn sums(&self, v: Interval) -> Sums {
        let mut sums = Sums { p: [Interval::ZERO; 3], q: [Interval::ZERO; 3] };
        for j in Axis::ALL.into_iter().filter(|&j| j != self.axis && self.frame.r[j] > 0.0) {
            let value = Interval::rounded;
            let inverse = Interval::ONE / (value(self.frame.diff[self.axis][j]) + self.epsilon * v);
            let square = (value(self.frame.r[j]) * inverse).square();
            let terms = [square, square * inverse * -2.0, square * inverse.square() * 6.0];
            let a = value(self.frame.a[j]);
            for (k, term) in terms.into_iter().enumerate() {
                sums.p[k] = sums.p[k] + term;
                sums.q[k] = sums.q[k] + a * term;
            }
        }
        sums
    }

    fn p_and_q(&self, v: Interval, sums: &Sums) -> (Interval, Interval) {
        (Interval::ONE + v.square() * sums.p[0], self.a + v.square() * sums.q[0])
    }

    /// Sign of −dx/dv on a box: of (4 a_i p − 3 q) − ε v³ (2 Q̂' p − (3/2) P̂' q).
    fn slope_sign(&self, v: Interval) -> Option<Sign> {
        let sums = self.sums(v);
        let (p, q) = self.p_and_q(v, &sums);
        let main = self.a * p * 4.0 - q * 3.0;
        let correction = self.epsilon * v * v.square() * (sums.q[1] * p * 2.0 - sums.p[1] * q * 1.5);
        (main - correction).strict_sign()
    }

    /// ∂g/∂t, ∂g/∂ε and m on a box of t.
    fn slopes_of_g(&self, t: Interval) -> (Interval, Interval, Interval) {
        let v = Interval::ONE / t;
        let Sums { p: [p0, p1, p2], q: [q0, q1, q2] } = self.sums(v);
        let (square, e) = (t.square(), self.epsilon);
        let (p, q) = (p0 + square, q0 + self.a * square);
        let k = self.a * p0 * 4.0 - q0 * 3.0;
        let k_slope = self.a * p1 * 4.0 - q1 * 3.0;
        let m = q1 * p * 2.0 - p1 * q * 1.5;
        let m_slope = q2 * p * 2.0 - p2 * q * 1.5;
        let ev2 = e * v.square();
        let in_t = square * (k * 3.0 + self.a * square * 5.0)
            - e * t * k_slope
            - e * (q1 * (t * 2.0 - p1 * ev2) * 2.0 - p1 * (self.a * t * 2.0 - q1 * ev2) * 1.5)
            + (e * v).square() * m_slope;
        let in_epsilon = square * k_slope - m - e * v * (m_slope + q1 * p1 * 0.5);
        (in_t, in_epsilon, m)
    }

    /// x at v; beyond all bounds when v = 0.
    fn x(&self, v: Interval) -> Interval {
        if v.lo <= 0.0 {
            return Interval { lo: f64::MAX, hi: f64::INFINITY };
        }
        let (p, q) = self.p_and_q(v, &self.sums(v));
        q.square() / (p * p.sqrt() * v) * 0.5
    }
}
