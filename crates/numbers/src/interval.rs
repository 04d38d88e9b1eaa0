//! Intervals with ends in `f64`.
//!
//! Ends move by one unit in the last place after each operation, which encloses the exact result on every IEEE machine
//! without switching rounding modes.

use std::ops::{Add, Div, Mul, Neg, Sub};

use dashu_base::Approximation;
use dashu_ratio::RBig;

use super::UNIT_ROUNDOFF;
use super::enclosure::{Arithmetic, Enclosure};
use crate::Sign;

/// The reals from `lo` to `hi`, under the contract of [`Enclosure`]; `lo` ≤ `hi`, and neither is NaN.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// Lower end; −∞ when there is no bound.
    pub lo: f64,
    /// Upper end; ∞ when there is no bound.
    pub hi: f64,
}

/// What lies between a double and the next one, and a little less than twice that at most.
///
/// Rump, Zimmermann, Boldo, Melquiond, "Computing predecessor and successor in rounding to nearest" (BIT 49, 2009):
/// x ± step(x), rounded, is the next double or, for |x| near 10^−308, the second next.
#[inline]
fn step(x: f64) -> f64 {
    const TINIEST: f64 = f64::from_bits(1);
    x.abs() * (UNIT_ROUNDOFF * (1.0 + f64::EPSILON)) + TINIEST
}

/// A lower bound below a rounded number: none for NaN and after an overflow.
#[inline]
fn down(x: f64) -> f64 {
    let below = x - step(x);
    if below.is_nan() { f64::NEG_INFINITY } else { below }
}

/// An upper bound above a rounded number: none for NaN and after an overflow.
#[inline]
fn up(x: f64) -> f64 {
    let above = x + step(x);
    if above.is_nan() { f64::INFINITY } else { above }
}

/// The hull of four candidates, rounded outward; NaN, which 0 · ∞ gives, makes both bounds unknown.
fn span(values: [f64; 4]) -> Interval {
    if values.iter().sum::<f64>().is_nan() {
        return Interval::LINE;
    }
    let least = |a, b| if b < a { b } else { a };
    let greatest = |a, b| if b > a { b } else { a };
    let [a, b, c, d] = values;
    Interval { lo: down(least(least(a, b), least(c, d))), hi: up(greatest(greatest(a, b), greatest(c, d))) }
}

impl Interval {
    /// The point 0.
    pub const ZERO: Self = Self::point(0.0);
    /// The point 1.
    pub const ONE: Self = Self::point(1.0);
    /// All reals.
    pub const LINE: Self = Self { lo: f64::NEG_INFINITY, hi: f64::INFINITY };

    /// One finite double.
    #[must_use]
    pub const fn point(x: f64) -> Self {
        Self { lo: x, hi: x }
    }

    /// The interval between two doubles, in any order.
    #[must_use]
    #[inline]
    pub fn between(a: f64, b: f64) -> Self {
        Self { lo: a.min(b), hi: a.max(b) }
    }

    /// A number that is known to one unit in the last place; zero is exact.
    #[must_use]
    #[inline]
    pub fn rounded(x: f64) -> Self {
        if x == 0.0 { Self::ZERO } else { Self { lo: down(x), hi: up(x) } }
    }

    /// The interval widened by `units` of roundoff relative to its larger end, for inputs that are themselves rounded.
    #[must_use]
    pub fn widened(self, units: f64) -> Self {
        let slack = units * UNIT_ROUNDOFF * self.magnitude();
        Self { lo: down(self.lo - slack), hi: up(self.hi + slack) }
    }

    /// Twice the interval, without rounding.
    #[must_use]
    pub fn twice(self) -> Self {
        Self { lo: (2.0 * self.lo).min(f64::MAX), hi: (2.0 * self.hi).max(f64::MIN) }
    }

    /// The largest |x| of its members.
    #[must_use]
    #[inline]
    pub fn magnitude(self) -> f64 {
        self.hi.max(-self.lo)
    }

    /// The sign, if it is the same (and not zero) for all members.
    #[must_use]
    #[inline]
    pub fn is_positive(self) -> Option<bool> {
        if self.lo > 0.0 {
            Some(true)
        } else if self.hi < 0.0 {
            Some(false)
        } else {
            None
        }
    }

    #[inline]
    fn is_zero(self) -> bool {
        self.lo == 0.0 && self.hi == 0.0
    }

    #[inline]
    fn holds_zero(self) -> bool {
        self.lo <= 0.0 && self.hi >= 0.0
    }
}

impl Add for Interval {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        if self.is_zero() {
            return other;
        }
        if other.is_zero() {
            return self;
        }
        Self { lo: down(self.lo + other.lo), hi: up(self.hi + other.hi) }
    }
}

impl Sub for Interval {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Neg for Interval {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self { lo: -self.hi, hi: -self.lo }
    }
}

impl Mul for Interval {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        if self.is_zero() || other.is_zero() {
            return Self::ZERO;
        }
        let ([a, b], [c, d]) = ([self.lo, self.hi], [other.lo, other.hi]);
        // The result of `span` where the signs show which products are least and greatest, and these are finite.
        let [low, high] = if a >= 0.0 {
            [if c >= 0.0 { a * c } else { b * c }, if d >= 0.0 { b * d } else { a * d }]
        } else if b <= 0.0 {
            [if d >= 0.0 { a * d } else { b * d }, if c >= 0.0 { b * c } else { a * c }]
        } else if c >= 0.0 {
            [a * d, b * d]
        } else if d <= 0.0 {
            [b * c, a * c]
        } else {
            [f64::NAN; 2]
        };
        if low.abs() < f64::INFINITY && high.abs() < f64::INFINITY {
            return Self { lo: down(low), hi: up(high) };
        }
        span([a * c, a * d, b * c, b * d])
    }
}

impl Mul<f64> for Interval {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        self * Self::point(factor)
    }
}

impl Div for Interval {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        if other.holds_zero() {
            return Self::LINE;
        }
        if self.is_zero() {
            return self;
        }
        if self.lo >= 0.0 && other.lo > 0.0 && self.hi < f64::INFINITY && other.hi < f64::INFINITY {
            return Self { lo: down(self.lo / other.hi), hi: up(self.hi / other.lo) };
        }
        span([self.lo / other.lo, self.lo / other.hi, self.hi / other.lo, self.hi / other.hi])
    }
}

impl Arithmetic for Interval {
    type Precision = ();

    fn line((): ()) -> Self {
        Self::LINE
    }

    fn rational(value: &RBig, (): ()) -> Self {
        match value.to_f64() {
            Approximation::Exact(x) => Self::point(x),
            Approximation::Inexact(x, _) => Self { lo: down(x), hi: up(x) },
        }
    }

    #[inline]
    fn double(value: f64, (): ()) -> Self {
        if value.is_finite() { Self::point(value) } else { Self::LINE }
    }

    fn sqrt(&self) -> Self {
        if self.is_zero() {
            return *self;
        }
        if self.hi < 0.0 {
            return Self::LINE;
        }
        Self { lo: down(self.lo.max(0.0).sqrt()).max(0.0), hi: up(self.hi.sqrt()) }
    }

    fn square(&self) -> Self {
        if self.is_zero() {
            return *self;
        }
        let (a, b) = (self.lo * self.lo, self.hi * self.hi);
        Self { lo: if self.holds_zero() { 0.0 } else { down(a.min(b)).max(0.0) }, hi: up(a.max(b)) }
    }

    fn meet(&self, other: &Self) -> Option<Self> {
        let common = Self { lo: self.lo.max(other.lo), hi: self.hi.min(other.hi) };
        (common.lo <= common.hi).then_some(common)
    }
}

impl Enclosure for Interval {
    #[inline]
    fn sign(&self) -> Option<Sign> {
        if self.is_zero() {
            Some(Sign::Zero)
        } else {
            self.is_positive().map(|positive| if positive { Sign::Positive } else { Sign::Negative })
        }
    }

    #[inline]
    fn hull(&self, other: &Self) -> Self {
        Self { lo: self.lo.min(other.lo), hi: self.hi.max(other.hi) }
    }

    #[inline]
    fn lower(&self) -> Self {
        Self::double(self.lo, ())
    }

    #[inline]
    fn upper(&self) -> Self {
        Self::double(self.hi, ())
    }

    fn middle(&self) -> Self {
        // NaN or infinite for an infinite end; an end when the width overflows.
        let middle = self.lo + 0.5 * (self.hi - self.lo);
        Self::double(middle.clamp(self.lo, self.hi), ())
    }

    #[inline]
    fn bounds(&self) -> [f64; 2] {
        [self.lo, self.hi]
    }

    fn exact_bounds(&self) -> Option<[RBig; 2]> {
        Some([RBig::try_from(self.lo).ok()?, RBig::try_from(self.hi).ok()?])
    }

    fn resolution((): ()) -> f64 {
        8.0 * f64::EPSILON
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn ends_move_to_the_next_double(x in proptest::num::f64::ANY) {
            prop_assume!(!x.is_nan());
            prop_assert!(down(x) <= x.next_down() && up(x) >= x.next_up());
            if x.is_finite() && x.abs() > 1e-300 {
                prop_assert_eq!((down(x), up(x)), (x.next_down(), x.next_up()));
            }
        }
    }

    #[test]
    fn ends_move_at_every_size() {
        for x in [0.0, 5e-324, 1e-310, f64::MIN_POSITIVE, 1.0, 1.0f64.next_down(), 2.0, -1.0, f64::MAX, f64::MIN] {
            assert!(down(x) <= x.next_down() && up(x) >= x.next_up(), "{x}");
        }
        assert_eq!((down(f64::INFINITY), up(f64::NEG_INFINITY)), (f64::NEG_INFINITY, f64::INFINITY));
        assert_eq!((down(f64::NAN), up(f64::NAN)), (f64::NEG_INFINITY, f64::INFINITY));
    }

    #[test]
    fn signs_are_claimed_only_when_certain() {
        assert_eq!((Interval::point(0.1) + Interval::point(0.2) - Interval::point(0.3)).sign(), None);
        assert_eq!(Interval::between(0.0, 1.0).sign(), None);
        assert_eq!(Interval::between(1.0, 0.0).is_positive(), None);
        assert_eq!(Interval::ZERO.sign(), Some(Sign::Zero));
    }
}
