//! The order of two branches on both sides of a moment a_i whose r_i is small (an imperfect pitchfork).
//!
//! Both branches are solutions of one family: with ε in the place of r_i and μ = a_i + ε v, where 1/v = s γ_i > 0,
//! P = p/v², Q = q/v² with p = 1 + v² P̂(μ), q = a_i + v² Q̂(μ) (sums over the other axes), x = q²/(2 p^{3/2} v). The branch
//! right of a_i has ε = r_i; the branch left of it, mirrored in γ_i, has ε = −r_i. At fixed x dh/dε = −γ_i (h is
//! stationary in γ). So if x(v, ε) is monotone in v on a box that the solution cannot leave while ε runs from r_i to
//! −r_i, then h_left − h_right = ∫ γ_i dε > 0: the left branch lies above the right one, by 2 r_i γ_i to first order,
//! however small that is (derived).

use crate::body::Frame;
use crate::equilibria::Mu;
use crate::numerics::interval::Interval;

/// The two branches at one abscissa.
#[derive(Clone, Copy)]
pub(super) struct MirrorPair {
    /// On the left of a_i: δ < 0. `None`: x = ∞.
    pub left: Option<Mu>,
    /// On the right of a_i.
    pub right: Option<Mu>,
}

/// True when the branch left of a_i is proved to lie above the branch right of it for all x in the range.
pub(super) fn left_is_above(frame: &Frame, axis: usize, x: [f64; 2], ends: [MirrorPair; 2]) -> bool {
    // Room for the solution to move while ε changes sign; a wider box is harder to prove monotone.
    const ROOMS: [f64; 3] = [1.02, 1.2, 2.0];
    let v = |mu: Option<Mu>| mu.map_or(0.0, |mu| mu.delta.abs() / frame.r[axis]);
    let all = ends.map(|pair| [v(pair.left), v(pair.right)]);
    let smallest = all.iter().flatten().copied().fold(f64::INFINITY, f64::min);
    let largest = all.iter().flatten().copied().fold(0.0, f64::max);
    let epsilon = Interval::between(-frame.r[axis], frame.r[axis]).widened(2.0);
    ROOMS.iter().any(|room| {
        let v = Interval::between(smallest / room, largest * room);
        let Some(sign) = Family { frame, axis, epsilon }.slope_sign(v) else { return false };
        let at = |v: f64| Family { frame, axis, epsilon }.x(Interval::point(v));
        let (at_small, at_large) = (at(v.lo), at(v.hi));
        if sign > 0 { at_large.hi < x[0] && at_small.lo > x[1] } else { at_large.lo > x[1] && at_small.hi < x[0] }
    })
}

#[derive(Clone, Copy)]
struct Family<'a> {
    frame: &'a Frame,
    axis: usize,
    epsilon: Interval,
}

/// P̂, Q̂ and their derivatives in μ.
struct Sums {
    p: Interval,
    q: Interval,
    p_slope: Interval,
    q_slope: Interval,
}

impl Family<'_> {
    fn sums(&self, v: Interval) -> Sums {
        let zero = Interval::point(0.0);
        let mut sums = Sums { p: zero, q: zero, p_slope: zero, q_slope: zero };
        for j in (0..3).filter(|&j| j != self.axis && self.frame.r[j] > 0.0) {
            let value = |x: f64| Interval::point(x).widened(1.0);
            let inverse = (value(self.frame.diff[self.axis][j]) + self.epsilon * v).recip();
            let square = (value(self.frame.r[j]) * inverse).square();
            let slope = square * inverse * -2.0;
            let a = value(self.frame.a[j]);
            sums.p = sums.p + square;
            sums.q = sums.q + a * square;
            sums.p_slope = sums.p_slope + slope;
            sums.q_slope = sums.q_slope + a * slope;
        }
        sums
    }

    fn p_and_q(&self, v: Interval, sums: &Sums) -> (Interval, Interval) {
        let a = Interval::point(self.frame.a[self.axis]).widened(1.0);
        (Interval::point(1.0) + v.square() * sums.p, a + v.square() * sums.q)
    }

    /// Sign of −dx/dv on a box: of (4 a_i p − 3 q) − ε v³ (2 Q̂' p − (3/2) P̂' q).
    fn slope_sign(&self, v: Interval) -> Option<i8> {
        let sums = self.sums(v);
        let (p, q) = self.p_and_q(v, &sums);
        let a = Interval::point(self.frame.a[self.axis]).widened(1.0);
        let main = a * p * 4.0 - q * 3.0;
        let correction = self.epsilon * v * v.square() * (sums.q_slope * p * 2.0 - sums.p_slope * q * 1.5);
        let sign = (main - correction).sign()?;
        (sign != 0).then_some(sign)
    }

    /// x at v; the whole half-line when v = 0.
    fn x(&self, v: Interval) -> Interval {
        if v.lo <= 0.0 {
            return Interval { lo: f64::INFINITY, hi: f64::INFINITY };
        }
        let (p, q) = self.p_and_q(v, &self.sums(v));
        q.square() * (p * p.sqrt() * v).recip() * 0.5
    }
}
