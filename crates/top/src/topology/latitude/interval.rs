//! Closed intervals with outward rounding, just enough for the sweep.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// [lo, hi] with lo ≤ hi. Every operation returns an interval that contains all exact results;
/// adding, subtracting and multiplying by an exact zero is exact, so that what vanishes by symmetry stays zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Interval {
    pub lo: f64,
    pub hi: f64,
}

/// A number below x by at least one unit in the last place; without branches, which costs up to one unit more.
fn down(x: f64) -> f64 {
    x - (x.abs() * f64::EPSILON + f64::MIN_POSITIVE)
}

/// A number above x by at least one unit in the last place.
fn up(x: f64) -> f64 {
    x + (x.abs() * f64::EPSILON + f64::MIN_POSITIVE)
}

impl Interval {
    pub const ZERO: Self = Self::exact(0.0);
    pub const ONE: Self = Self::exact(1.0);

    pub const fn exact(x: f64) -> Self {
        Self { lo: x, hi: x }
    }

    /// A number that is known to one unit in the last place; zero is exact.
    pub fn rounded(x: f64) -> Self {
        if x == 0.0 { Self::ZERO } else { Self { lo: x.next_down(), hi: x.next_up() } }
    }

    pub fn hull(self, other: Self) -> Self {
        Self { lo: self.lo.min(other.lo), hi: self.hi.max(other.hi) }
    }

    /// The part inside [lo, hi], for a quantity that is known to lie there.
    pub fn within(self, lo: f64, hi: f64) -> Self {
        Self { lo: self.lo.clamp(lo, hi), hi: self.hi.clamp(lo, hi) }
    }

    /// Common part of two enclosures of the same quantity.
    pub fn intersect(self, other: Self) -> Self {
        Self { lo: self.lo.max(other.lo), hi: self.hi.min(other.hi) }
    }

    /// An upper bound of |x|.
    pub fn magnitude(self) -> f64 {
        self.hi.max(-self.lo)
    }

    /// The sign, if it is the same (and not zero) for all members.
    pub fn is_positive(self) -> Option<bool> {
        if self.lo > 0.0 {
            Some(true)
        } else if self.hi < 0.0 {
            Some(false)
        } else {
            None
        }
    }

    /// All numbers at most `radius` away.
    pub fn widened(self, radius: f64) -> Self {
        Self { lo: down(self.lo - radius), hi: up(self.hi + radius) }
    }

    /// Twice the interval; exact.
    pub fn twice(self) -> Self {
        Self { lo: 2.0 * self.lo, hi: 2.0 * self.hi }
    }

    /// Half of the interval.
    pub fn half(self) -> Self {
        self * Self::exact(0.5)
    }

    pub fn squared(self) -> Self {
        let (lo, hi) = (self.lo * self.lo, self.hi * self.hi);
        if self == Self::ZERO {
            Self::ZERO
        } else if self.lo >= 0.0 {
            Self { lo: down(lo).max(0.0), hi: up(hi) }
        } else if self.hi <= 0.0 {
            Self { lo: down(hi).max(0.0), hi: up(lo) }
        } else {
            Self { lo: 0.0, hi: up(lo.max(hi)) }
        }
    }

    /// Square root of the non-negative part.
    pub fn sqrt(self) -> Self {
        let root = |x: f64| x.max(0.0).sqrt();
        Self { lo: down(root(self.lo)).max(0.0), hi: up(root(self.hi)) }
    }
}

impl Add for Interval {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        if self == Self::ZERO {
            other
        } else if other == Self::ZERO {
            self
        } else {
            Self { lo: down(self.lo + other.lo), hi: up(self.hi + other.hi) }
        }
    }
}

impl Neg for Interval {
    type Output = Self;

    fn neg(self) -> Self {
        Self { lo: -self.hi, hi: -self.lo }
    }
}

impl Sub for Interval {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Interval {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        if self == Self::ZERO || other == Self::ZERO {
            return Self::ZERO;
        }
        let (a, b) = (self.lo * other.lo, self.lo * other.hi);
        let (c, d) = (self.hi * other.lo, self.hi * other.hi);
        Self { lo: down(a.min(b).min(c.min(d))), hi: up(a.max(b).max(c.max(d))) }
    }
}

impl Div for Interval {
    type Output = Self;

    /// The divisor must be positive.
    fn div(self, other: Self) -> Self {
        if self == Self::ZERO {
            return Self::ZERO;
        }
        let lo = if self.lo >= 0.0 { self.lo / other.hi } else { self.lo / other.lo };
        let hi = if self.hi >= 0.0 { self.hi / other.lo } else { self.hi / other.hi };
        Self { lo: down(lo), hi: up(hi) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_contain_the_exact_value() {
        let third = Interval::ONE / Interval::exact(3.0);
        let one = third * Interval::exact(3.0);
        assert!(one.lo < 1.0 && 1.0 < one.hi && one.hi - one.lo < 1e-15);
        let root = Interval::exact(2.0).sqrt().squared();
        assert!(root.lo < 2.0 && 2.0 < root.hi && root.hi - root.lo < 1e-14);
    }

    #[test]
    fn rounding_is_outward_at_every_size() {
        for x in [0.0, 5e-324, 1e-310, 1.0, 1.0f64.next_down(), 1.5, 2.0, -1.0, -1.999_999_9, 1e300, -7e-200] {
            assert!(down(x) <= x.next_down() && up(x) >= x.next_up(), "{x}");
        }
    }

    #[test]
    fn an_exact_zero_stays_exact() {
        let x = Interval { lo: -1.0, hi: 2.0 };
        assert_eq!(x * Interval::ZERO, Interval::ZERO);
        assert_eq!(x + Interval::ZERO, x);
        assert_eq!(x.squared(), Interval { lo: 0.0, hi: up(4.0) });
        assert_eq!(x.is_positive(), None);
        assert_eq!(Interval { lo: 0.0, hi: 1.0 }.is_positive(), None);
    }
}
