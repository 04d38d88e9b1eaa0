//! What interval arithmetic must offer, and its first stage: ends that are `f64`.

use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

use dashu_base::Approximation;
use dashu_ratio::RBig;

/// A closed set of reals that contains the exact value; every operation keeps that true.
///
/// A quotient by an enclosure that holds 0, or any overflow, is the whole line: a sign is then unknown, never wrong.
pub trait Enclosure:
    Clone + Debug + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// How many bits the ends carry.
    type Precision: Copy + Debug;

    /// The smallest enclosure of an exact number.
    fn rational(value: &RBig, precision: Self::Precision) -> Self;

    /// A double, as a point.
    fn double(value: f64, precision: Self::Precision) -> Self;

    /// Square root of the part that is not negative.
    #[must_use]
    fn sqrt(&self) -> Self;

    /// x², never negative.
    #[must_use]
    fn square(&self) -> Self;

    /// The sign that all members share; `Some(0)` only for the point 0.
    fn sign(&self) -> Option<i8>;

    /// The smallest enclosure of both.
    #[must_use]
    fn hull(&self, other: &Self) -> Self;

    /// Common part of two enclosures of one value.
    #[must_use]
    fn meet(&self, other: &Self) -> Self;

    /// The lower end, as a point.
    #[must_use]
    fn lower(&self) -> Self;

    /// The upper end, as a point.
    #[must_use]
    fn upper(&self) -> Self;

    /// A point between the ends (or an end).
    #[must_use]
    fn middle(&self) -> Self;

    /// Ends rounded outward to `f64`.
    fn bounds(&self) -> [f64; 2];

    /// The ends, exactly; `None` when one is infinite.
    fn exact_bounds(&self) -> Option<[RBig; 2]>;

    /// Relative spacing of the ends' numbers, with a few bits to spare.
    fn resolution(precision: Self::Precision) -> f64;

    /// Every member is less than every member of `other`.
    fn is_below(&self, other: &Self) -> bool {
        (other.clone() - self.clone()).sign() == Some(1)
    }

    /// A small whole number, as a point.
    fn small(value: i32, precision: Self::Precision) -> Self {
        Self::double(f64::from(value), precision)
    }
}

/// Ends in `f64`, moved outward by one unit in the last place after each operation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Narrow {
    lo: f64,
    hi: f64,
}

impl Narrow {
    fn outward(lo: f64, hi: f64) -> Self {
        Self {
            lo: if lo.is_nan() { f64::NEG_INFINITY } else { lo.next_down() },
            hi: if hi.is_nan() { f64::INFINITY } else { hi.next_up() },
        }
    }

    const LINE: Self = Self { lo: f64::NEG_INFINITY, hi: f64::INFINITY };

    fn is_zero(self) -> bool {
        self.lo == 0.0 && self.hi == 0.0
    }
}

/// NaN, which `0 · ∞` gives, makes the bound unknown.
fn least(values: [f64; 4]) -> f64 {
    if values.iter().any(|v| v.is_nan()) { f64::NAN } else { values.into_iter().fold(f64::INFINITY, f64::min) }
}

fn greatest(values: [f64; 4]) -> f64 {
    if values.iter().any(|v| v.is_nan()) { f64::NAN } else { values.into_iter().fold(f64::NEG_INFINITY, f64::max) }
}

impl Add for Narrow {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        if self.is_zero() {
            return other;
        }
        if other.is_zero() {
            return self;
        }
        Self::outward(self.lo + other.lo, self.hi + other.hi)
    }
}

impl Sub for Narrow {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Neg for Narrow {
    type Output = Self;
    fn neg(self) -> Self {
        Self { lo: -self.hi, hi: -self.lo }
    }
}

impl Mul for Narrow {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        if self.is_zero() || other.is_zero() {
            return Self { lo: 0.0, hi: 0.0 };
        }
        let products = [self.lo * other.lo, self.lo * other.hi, self.hi * other.lo, self.hi * other.hi];
        Self::outward(least(products), greatest(products))
    }
}

impl Div for Narrow {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        if other.lo <= 0.0 && other.hi >= 0.0 {
            return Self::LINE;
        }
        if self.is_zero() {
            return self;
        }
        let quotients = [self.lo / other.lo, self.lo / other.hi, self.hi / other.lo, self.hi / other.hi];
        Self::outward(least(quotients), greatest(quotients))
    }
}

impl Enclosure for Narrow {
    type Precision = ();

    fn rational(value: &RBig, (): ()) -> Self {
        match value.to_f64() {
            Approximation::Exact(x) => Self { lo: x, hi: x },
            Approximation::Inexact(x, _) => Self::outward(x, x),
        }
    }

    fn double(value: f64, (): ()) -> Self {
        Self { lo: value, hi: value }
    }

    fn sqrt(&self) -> Self {
        if self.is_zero() {
            return *self;
        }
        Self { lo: self.lo.max(0.0).sqrt().next_down().max(0.0), hi: self.hi.max(0.0).sqrt().next_up() }
    }

    fn square(&self) -> Self {
        if self.is_zero() {
            return *self;
        }
        let (a, b) = (self.lo * self.lo, self.hi * self.hi);
        let lo = if self.lo <= 0.0 && self.hi >= 0.0 { 0.0 } else { a.min(b).next_down().max(0.0) };
        Self { lo, hi: a.max(b).next_up() }
    }

    fn sign(&self) -> Option<i8> {
        if self.lo > 0.0 {
            Some(1)
        } else if self.hi < 0.0 {
            Some(-1)
        } else if self.is_zero() {
            Some(0)
        } else {
            None
        }
    }

    fn hull(&self, other: &Self) -> Self {
        Self { lo: self.lo.min(other.lo), hi: self.hi.max(other.hi) }
    }

    fn meet(&self, other: &Self) -> Self {
        Self { lo: self.lo.max(other.lo), hi: self.hi.min(other.hi) }
    }

    fn lower(&self) -> Self {
        Self { lo: self.lo, hi: self.lo }
    }

    fn upper(&self) -> Self {
        Self { lo: self.hi, hi: self.hi }
    }

    fn middle(&self) -> Self {
        let middle = (self.lo + 0.5 * (self.hi - self.lo)).clamp(self.lo, self.hi);
        Self { lo: middle, hi: middle }
    }

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

    #[test]
    fn rationals_lie_inside() {
        let third = Narrow::rational(&RBig::from_parts(1.into(), 3u8.into()), ());
        let [lo, hi] = third.exact_bounds().unwrap();
        let exact = RBig::from_parts(1.into(), 3u8.into());
        assert!(lo < exact && exact < hi);
        assert_eq!(Narrow::rational(&RBig::from(3), ()).bounds(), [3.0, 3.0]);
    }

    #[test]
    fn a_quotient_by_zero_is_the_whole_line() {
        let (one, around) = (Narrow::double(1.0, ()), Narrow { lo: -1.0, hi: 1.0 });
        assert_eq!((one / around).bounds(), [f64::NEG_INFINITY, f64::INFINITY]);
        assert_eq!(((one / around) * Narrow::double(0.0, ())).sign(), Some(0));
        assert_eq!(((one / around) * around).sign(), None);
    }

    #[test]
    fn overflow_loses_the_sign_and_nothing_else() {
        let huge = Narrow::double(1e300, ());
        let product = huge * huge;
        assert!(product.lo <= f64::MAX && product.hi == f64::INFINITY);
        assert_eq!((product - product).sign(), None);
    }
}
