//! Functions of one variable on a range, as polynomials with a bound on what they leave (Taylor models).
//!
//! A [`TaylorModel`] holds every function f with |f(τ) − Σ c_k τᵏ| ≤ `rest` for |τ| ≤ 1. As an [`Enclosure`] it stands for
//! the values on the whole range; but what depends on τ in the same way cancels, which it does not in intervals. Roundings
//! go into the rest, reciprocals and roots are verified afterwards: 1/f − p = (1 − pf)/f and √f − p = (f − p²)/(√f + p).

use std::ops::{Add, Div, Mul, Neg, Sub};

use dashu_ratio::RBig;

use super::UNIT_ROUNDOFF;
use super::enclosure::{Arithmetic, Enclosure};
use super::interval::Interval;
use crate::Sign;

/// Coefficients of a polynomial.
const TERMS: usize = 8;

/// Roundings of a sum of products of all coefficients, and of its bound.
const ROUNDINGS: f64 = 4.0 * 8.0 * UNIT_ROUNDOFF;

/// What the bounds themselves may have been rounded by.
const SLACK: f64 = 1.0 + 1e-13;

/// Below this products lose digits.
const TINIEST: f64 = 1e-290;

/// A polynomial on |τ| ≤ 1 with a bound on what it leaves.
#[derive(Clone, Copy, Debug)]
pub struct TaylorModel {
    coefficients: [f64; TERMS],
    /// Infinite: nothing is known.
    rest: f64,
}

impl TaylorModel {
    const LINE: Self = Self { coefficients: [0.0; TERMS], rest: f64::INFINITY };

    fn of(coefficients: [f64; TERMS], rest: f64) -> Self {
        let is_finite = rest.is_finite() && coefficients.iter().all(|c| c.is_finite());
        if is_finite { Self { coefficients, rest } } else { Self::LINE }
    }

    fn point(value: f64) -> Self {
        let mut coefficients = [0.0; TERMS];
        coefficients[0] = value;
        Self::of(coefficients, 0.0)
    }

    /// A constant that lies in an interval.
    #[must_use]
    pub fn constant(value: Interval) -> Self {
        let middle = value.lo + 0.5 * (value.hi - value.lo);
        let rest = (value.hi - middle).max(middle - value.lo) * SLACK;
        Self { rest, ..Self::point(middle) }
    }

    /// The variable that runs from `from` to `to`.
    #[must_use]
    pub fn variable(from: f64, to: f64) -> Self {
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let mut coefficients = [0.0; TERMS];
        (coefficients[0], coefficients[1]) = (middle, half);
        Self::of(coefficients, 4.0 * UNIT_ROUNDOFF * (from.abs() + to.abs()))
    }

    fn is_exact(&self) -> bool {
        self.rest == 0.0 && self.coefficients[1..] == [0.0; TERMS - 1]
    }

    /// A multiple by an exact number.
    fn scaled(self, factor: f64) -> Self {
        let size = self.size();
        Self::of(
            self.coefficients.map(|c| factor * c),
            (factor.abs() * (self.rest + UNIT_ROUNDOFF * size) + TINIEST) * SLACK,
        )
    }

    fn is_zero(&self) -> bool {
        self.rest == 0.0 && self.coefficients == [0.0; TERMS]
    }

    /// A bound on |Σ c_k τᵏ|.
    fn size(&self) -> f64 {
        self.coefficients.iter().map(|c| c.abs()).sum::<f64>() * SLACK
    }

    /// A bound on |f − c₀|.
    fn radius(&self) -> f64 {
        (self.coefficients[1..].iter().map(|c| c.abs()).sum::<f64>() + self.rest) * SLACK
    }

    /// A lower bound on |f|, if it is positive.
    fn least(&self) -> Option<f64> {
        let least = (self.coefficients[0].abs() - self.radius()) * (2.0 - SLACK);
        (least > TINIEST).then_some(least)
    }

    fn inverse(self) -> Self {
        let Some(least) = self.least() else { return Self::LINE };
        let c = self.coefficients;
        let mut p = [0.0; TERMS];
        p[0] = 1.0 / c[0];
        for k in 1..TERMS {
            let sum: f64 = (1..=k).map(|j| c[j] * p[k - j]).sum();
            p[k] = -sum / c[0];
        }
        let inverse = Self::of(p, 0.0);
        let defect = Self::point(1.0) - inverse * self;
        Self::of(p, (defect.size() + defect.rest) / least * SLACK)
    }
}

impl Add for TaylorModel {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        if self.is_zero() {
            return other;
        }
        if other.is_zero() {
            return self;
        }
        let sum: [f64; TERMS] = std::array::from_fn(|k| self.coefficients[k] + other.coefficients[k]);
        let rounding = 2.0 * UNIT_ROUNDOFF * sum.iter().map(|c| c.abs()).sum::<f64>();
        Self::of(sum, (self.rest + other.rest + rounding) * SLACK)
    }
}

impl Neg for TaylorModel {
    type Output = Self;
    fn neg(self) -> Self {
        Self { coefficients: self.coefficients.map(|c| -c), rest: self.rest }
    }
}

impl Sub for TaylorModel {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for TaylorModel {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        if self.is_zero() || other.is_zero() {
            return Self::point(0.0);
        }
        if self.is_exact() {
            return other.scaled(self.coefficients[0]);
        }
        if other.is_exact() {
            return self.scaled(other.coefficients[0]);
        }
        let (p, q) = (&self.coefficients, &other.coefficients);
        let mut product = [0.0; TERMS];
        let mut beyond = 0.0;
        for i in 0..TERMS {
            for j in 0..TERMS - i {
                product[i + j] += p[i] * q[j];
            }
        }
        // Σ |p_i| |q_j| over i + j ≥ TERMS.
        let mut tail = 0.0;
        for i in 1..TERMS {
            tail += q[TERMS - i].abs();
            beyond += p[i].abs() * tail;
        }
        let (size, other_size) = (self.size(), other.size());
        let rounding = ROUNDINGS * size * other_size + TINIEST;
        let rest = beyond + rounding + self.rest * (other_size + other.rest) + size * other.rest;
        Self::of(product, rest * SLACK)
    }
}

impl Div for TaylorModel {
    type Output = Self;
    // a/b is a · (1/b).
    #[allow(clippy::suspicious_arithmetic_impl)]
    fn div(self, other: Self) -> Self {
        if other.least().is_none() {
            return Self::LINE;
        }
        if self.is_zero() { self } else { self * other.inverse() }
    }
}

impl Arithmetic for TaylorModel {
    type Precision = ();

    fn line((): ()) -> Self {
        Self::LINE
    }

    fn rational(value: &RBig, (): ()) -> Self {
        Self::constant(Interval::rational(value, ()))
    }

    fn double(value: f64, (): ()) -> Self {
        Self::point(value)
    }

    fn sqrt(&self) -> Self {
        if self.is_zero() {
            return *self;
        }
        let c = self.coefficients;
        let Some(least) = self.least().filter(|_| c[0] > 0.0) else { return Self::LINE };
        let mut p = [0.0; TERMS];
        p[0] = c[0].sqrt();
        for k in 1..TERMS {
            let sum: f64 = (1..k).map(|j| p[j] * p[k - j]).sum();
            p[k] = (c[k] - sum) / (2.0 * p[0]);
        }
        let root = Self::of(p, 0.0);
        let defect = *self - root * root;
        let (of_root, of_p) = (least.sqrt(), p[0] - root.radius());
        let sum = (of_root + of_p) * (2.0 - SLACK);
        if sum <= 0.5 * of_root {
            return Self::LINE;
        }
        Self::of(p, (defect.size() + defect.rest) / sum * SLACK)
    }

    fn square(&self) -> Self {
        *self * *self
    }

    fn meet(&self, other: &Self) -> Option<Self> {
        let [p, q] = [self.bounds(), other.bounds()];
        let narrower = if self.rest <= other.rest { self } else { other };
        (p[0] <= q[1] && q[0] <= p[1]).then_some(*narrower)
    }
}

impl Enclosure for TaylorModel {
    fn sign(&self) -> Option<Sign> {
        if self.is_zero() {
            return Some(Sign::Zero);
        }
        self.least().map(|_| if self.coefficients[0] > 0.0 { Sign::Positive } else { Sign::Negative })
    }

    fn hull(&self, other: &Self) -> Self {
        let [p, q] = [self.bounds(), other.bounds()];
        let [lo, hi] = [p[0].min(q[0]), p[1].max(q[1])];
        if lo.is_finite() && hi.is_finite() { Self::constant(Interval::between(lo, hi)) } else { Self::LINE }
    }

    fn lower(&self) -> Self {
        Self::point(self.bounds()[0])
    }

    fn upper(&self) -> Self {
        Self::point(self.bounds()[1])
    }

    fn middle(&self) -> Self {
        if self.rest.is_finite() { Self::point(self.coefficients[0]) } else { Self::LINE }
    }

    fn bounds(&self) -> [f64; 2] {
        let radius = self.radius() * SLACK;
        [(self.coefficients[0] - radius).next_down(), (self.coefficients[0] + radius).next_up()]
    }

    fn exact_bounds(&self) -> Option<[RBig; 2]> {
        let [lo, hi] = self.bounds();
        Some([RBig::try_from(lo).ok()?, RBig::try_from(hi).ok()?])
    }

    fn resolution((): ()) -> f64 {
        8.0 * f64::EPSILON
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn value(model: &TaylorModel, tau: f64) -> f64 {
        model.coefficients.iter().rev().fold(0.0, |sum, c| sum * tau + c)
    }

    proptest! {
        /// Each operation holds the function at every point of the range.
        #[test]
        fn operations_hold_their_functions(from in 0.5..3.0_f64, width in 0.0..0.4_f64, share in -1.0..1.0_f64, k in 0.1..2.0_f64) {
            let x = TaylorModel::variable(from, from + width);
            let at = from + width * 0.5 * (share + 1.0);
            let y = TaylorModel::point(k);
            let cases = [
                (x * x * y - x, at * at * k - at),
                (y / (x * x + y), k / (at * at + k)),
                ((x * y + y).sqrt(), (at * k + k).sqrt()),
                ((x.square() + y).sqrt() / x - x, (at * at + k).sqrt() / at - at),
            ];
            let ratio = (width / from) * (width / from);
            for (model, known) in cases {
                let error = (value(&model, share) - known).abs();
                prop_assert!(error <= model.rest + 1e-14, "{} {:?}", known, model);
                prop_assert!(model.rest < 1e-3 * ratio * ratio * ratio + 1e-12, "{:?}", model);
                let [lo, hi] = model.bounds();
                prop_assert!(lo - 1e-14 <= known && known <= hi + 1e-14);
            }
        }
    }

    #[test]
    fn signs_and_the_line() {
        let x = TaylorModel::variable(-1.0, 1.0);
        assert_eq!(x.sign(), None);
        assert_eq!((x - x).sign(), None);
        assert_eq!((x.square() + TaylorModel::point(2.0)).sign(), Some(Sign::Positive));
        assert_eq!(TaylorModel::point(0.0).sign(), Some(Sign::Zero));
        assert_eq!((TaylorModel::point(1.0) / x).bounds(), [f64::NEG_INFINITY, f64::INFINITY]);
        assert_eq!((TaylorModel::point(0.0) * TaylorModel::line(())).sign(), Some(Sign::Zero));
    }
}
