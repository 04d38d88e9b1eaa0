//! Intervals with outward rounding.
//!
//! Ends move by one unit in the last place after each operation (`next_down`, `next_up`), which encloses the
//! exact result on every IEEE machine without switching rounding modes.

use std::ops::{Add, Mul, Neg, Sub};

/// The set of reals between `lo` and `hi`, both included.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// Lower end.
    pub lo: f64,
    /// Upper end.
    pub hi: f64,
}

impl Interval {
    /// The interval between two reals, in any order.
    #[must_use]
    pub fn between(a: f64, b: f64) -> Self {
        Self { lo: a.min(b), hi: a.max(b) }
    }

    /// One double.
    #[must_use]
    pub fn point(a: f64) -> Self {
        Self { lo: a, hi: a }
    }

    /// The interval widened by `units` of roundoff relative to its larger end, for inputs that are themselves rounded.
    #[must_use]
    pub fn widened(self, units: f64) -> Self {
        let slack = units * super::UNIT_ROUNDOFF * self.lo.abs().max(self.hi.abs());
        Self { lo: (self.lo - slack).next_down(), hi: (self.hi + slack).next_up() }
    }

    /// 1/x; the whole line when 0 lies inside.
    #[must_use]
    pub fn recip(self) -> Self {
        if self.lo <= 0.0 && self.hi >= 0.0 {
            return Self { lo: f64::NEG_INFINITY, hi: f64::INFINITY };
        }
        Self { lo: (1.0 / self.hi).next_down(), hi: (1.0 / self.lo).next_up() }
    }

    /// x², never negative.
    #[must_use]
    pub fn square(self) -> Self {
        let (a, b) = (self.lo * self.lo, self.hi * self.hi);
        let lo = if self.lo <= 0.0 && self.hi >= 0.0 { 0.0 } else { a.min(b).next_down().max(0.0) };
        Self { lo, hi: a.max(b).next_up() }
    }

    /// √x of the part that is not negative.
    #[must_use]
    pub fn sqrt(self) -> Self {
        Self { lo: self.lo.max(0.0).sqrt().next_down().max(0.0), hi: self.hi.max(0.0).sqrt().next_up() }
    }

    /// The sign shared by all of the interval, if any: −1, 0 (the point 0) or 1.
    #[must_use]
    pub fn sign(self) -> Option<i8> {
        if self.lo > 0.0 {
            Some(1)
        } else if self.hi < 0.0 {
            Some(-1)
        } else if self.lo == 0.0 && self.hi == 0.0 {
            Some(0)
        } else {
            None
        }
    }
}

impl Add for Interval {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { lo: (self.lo + other.lo).next_down(), hi: (self.hi + other.hi).next_up() }
    }
}

impl Sub for Interval {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self { lo: (self.lo - other.hi).next_down(), hi: (self.hi - other.lo).next_up() }
    }
}

impl Neg for Interval {
    type Output = Self;
    fn neg(self) -> Self {
        Self { lo: -self.hi, hi: -self.lo }
    }
}

impl Mul for Interval {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let products = [self.lo * other.lo, self.lo * other.hi, self.hi * other.lo, self.hi * other.hi];
        let lo = products.iter().copied().fold(f64::INFINITY, f64::min);
        let hi = products.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        Self { lo: lo.next_down(), hi: hi.next_up() }
    }
}

impl Mul<f64> for Interval {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        self * Self::point(factor)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn operations_enclose_their_points(
            a in -1e3..1e3f64, b in -1e3..1e3f64, c in -1e3..1e3f64, d in -1e3..1e3f64, t in 0.0..1.0f64, u in 0.0..1.0f64,
        ) {
            let (x, y) = (Interval::between(a, b), Interval::between(c, d));
            let (p, q) = ((x.lo + t * (x.hi - x.lo)).clamp(x.lo, x.hi), (y.lo + u * (y.hi - y.lo)).clamp(y.lo, y.hi));
            for (set, value) in [(x + y, p + q), (x - y, p - q), (x * y, p * q), (x.square(), p * p), (-x, -p), (y.recip(), 1.0 / q)] {
                prop_assert!(set.lo <= value && value <= set.hi, "{set:?} misses {value}");
            }
        }
    }

    #[test]
    fn signs_are_claimed_only_when_certain() {
        assert_eq!(Interval::between(1.0, 2.0).sign(), Some(1));
        assert_eq!(Interval::between(-1.0, 2.0).sign(), None);
        assert_eq!(Interval::point(0.0).sign(), Some(0));
        assert_eq!((Interval::point(0.1) + Interval::point(0.2) - Interval::point(0.3)).sign(), None);
    }
}
