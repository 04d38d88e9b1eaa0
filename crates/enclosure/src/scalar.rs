//! The numbers in which Taylor coefficients are computed: doubles, pairs of doubles, floats of many words.
//!
//! Nothing is rounded outward here. What counts is that every operation has a relative error of at most [`Scalar::unit`].

use std::fmt::Debug;

use bifdiag_numbers::directed::{Directed, Toward};
use dashu_ratio::RBig;

/// A number of some precision.
pub trait Scalar: Clone + Debug {
    /// A type that represents the precision.
    type Precision: Copy + Debug;

    /// The number nearest to a rational, within one unit.
    fn rational(value: &RBig, precision: Self::Precision) -> Self;
    /// A double, exactly.
    fn double(value: f64, precision: Self::Precision) -> Self;
    /// x + y.
    #[must_use]
    fn plus(&self, other: &Self, precision: Self::Precision) -> Self;
    /// x y.
    #[must_use]
    fn times(&self, other: &Self, precision: Self::Precision) -> Self;
    /// −x, exactly.
    #[must_use]
    fn negated(&self) -> Self;
    /// x / k.
    #[must_use]
    fn over(&self, k: u32, precision: Self::Precision) -> Self;
    /// A double within a relative error of 2⁻⁵² (and 1e-300); infinite or NaN after an overflow.
    fn to_double(&self) -> f64;
    /// The number itself; `None` after an overflow.
    fn to_rational(&self) -> Option<RBig>;
    /// The largest relative error of an operation.
    fn unit(precision: Self::Precision) -> f64;
}

impl Scalar for f64 {
    type Precision = ();

    fn rational(value: &RBig, (): ()) -> Self {
        value.to_f64().value()
    }
    fn double(value: f64, (): ()) -> Self {
        value
    }
    #[inline]
    fn plus(&self, other: &Self, (): ()) -> Self {
        self + other
    }
    #[inline]
    fn times(&self, other: &Self, (): ()) -> Self {
        self * other
    }
    fn negated(&self) -> Self {
        -self
    }
    #[inline]
    fn over(&self, k: u32, (): ()) -> Self {
        self / f64::from(k)
    }
    fn to_double(&self) -> f64 {
        *self
    }
    fn to_rational(&self) -> Option<RBig> {
        RBig::try_from(*self).ok()
    }
    fn unit((): ()) -> f64 {
        f64::EPSILON / 2.0
    }
}

/// The unevaluated sum of two doubles, the second within half a unit of the last place of the first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DoubleDouble {
    high: f64,
    low: f64,
}

impl DoubleDouble {
    /// The unit of its whole length.
    #[must_use]
    pub fn full() -> f64 {
        Self::unit(())
    }
}

/// s + e = a + b exactly (Knuth).
#[inline]
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let b_part = sum - a;
    (sum, (a - (sum - b_part)) + (b - b_part))
}

/// The same for |a| ≥ |b| (Dekker).
#[inline]
fn fast_two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    (sum, b - (sum - a))
}

/// p + e = a b exactly, unless it under- or overflows (Veltkamp and Dekker; without a fused multiply-add, so that the cost
/// does not depend on the machine).
#[inline]
fn two_product(a: f64, b: f64) -> (f64, f64) {
    const SPLITTER: f64 = 134_217_729.0;
    let split = |x: f64| {
        let scaled = SPLITTER * x;
        let high = scaled - (scaled - x);
        (high, x - high)
    };
    let product = a * b;
    let ((a_high, a_low), (b_high, b_low)) = (split(a), split(b));
    (product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low)
}

/// Algorithms 6, 11 and 15 of Joldes, Muller and Popescu, "Tight and rigorous error bounds for basic building blocks of
/// double-word arithmetic" (ACM TOMS 44, 2017), whose relative errors are below 10 · 2⁻¹⁰⁶.
impl Scalar for DoubleDouble {
    type Precision = ();

    fn rational(value: &RBig, (): ()) -> Self {
        let high = value.to_f64().value();
        let low = RBig::try_from(high).map_or(0.0, |high| (value - high).to_f64().value());
        Self { high, low }
    }
    fn double(value: f64, (): ()) -> Self {
        Self { high: value, low: 0.0 }
    }
    #[inline]
    fn plus(&self, other: &Self, (): ()) -> Self {
        let (sum, error) = two_sum(self.high, other.high);
        let (low, low_error) = two_sum(self.low, other.low);
        let (sum, error) = fast_two_sum(sum, error + low);
        let (high, low) = fast_two_sum(sum, error + low_error);
        Self { high, low }
    }
    #[inline]
    fn times(&self, other: &Self, (): ()) -> Self {
        let (product, error) = two_product(self.high, other.high);
        let crossed = self.high * other.low + self.low * other.high;
        let (high, low) = fast_two_sum(product, error + crossed);
        Self { high, low }
    }
    fn negated(&self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
    #[inline]
    fn over(&self, k: u32, (): ()) -> Self {
        let k = f64::from(k);
        let quotient = self.high / k;
        let (product, error) = two_product(quotient, k);
        let rest = ((self.high - product) - error) + self.low;
        let (high, low) = fast_two_sum(quotient, rest / k);
        Self { high, low }
    }
    fn to_double(&self) -> f64 {
        self.high
    }
    fn to_rational(&self) -> Option<RBig> {
        Some(RBig::try_from(self.high).ok()? + RBig::try_from(self.low).ok()?)
    }
    fn unit((): ()) -> f64 {
        // 16 · 2⁻¹⁰⁶.
        f64::EPSILON * f64::EPSILON * 4.0
    }
}

/// A float of `numbers`; `None` after an overflow.
#[derive(Clone, Debug)]
pub struct Float<F: Directed>(Option<F>);

impl<F: Directed> Scalar for Float<F> {
    type Precision = F::Precision;

    fn rational(value: &RBig, precision: F::Precision) -> Self {
        Self(F::rational(value, precision, Toward::Down))
    }
    fn double(value: f64, precision: F::Precision) -> Self {
        Self(F::double(value, precision))
    }
    fn plus(&self, other: &Self, precision: F::Precision) -> Self {
        Self(self.0.as_ref().zip(other.0.as_ref()).and_then(|(a, b)| a.plus(b, precision, Toward::Down)))
    }
    fn times(&self, other: &Self, precision: F::Precision) -> Self {
        Self(self.0.as_ref().zip(other.0.as_ref()).and_then(|(a, b)| a.times(b, precision, Toward::Down)))
    }
    fn negated(&self) -> Self {
        Self(self.0.as_ref().map(F::negated))
    }
    fn over(&self, k: u32, precision: F::Precision) -> Self {
        let divisor = F::double(f64::from(k), precision);
        Self(self.0.as_ref().zip(divisor).and_then(|(a, k)| a.over(&k, precision, Toward::Down)))
    }
    fn to_double(&self) -> f64 {
        self.0.as_ref().map_or(f64::NAN, F::to_double)
    }
    fn to_rational(&self) -> Option<RBig> {
        self.0.as_ref().map(F::to_rational)
    }
    fn unit(precision: F::Precision) -> f64 {
        // One unit of the last place, since it rounds in one direction.
        (1..F::bits(precision)).fold(1.0, |unit, _| 0.5 * unit)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use bifdiag_numbers::directed::Big;
    use bifdiag_numbers::wide::FixedFloat;
    use support::random::SplitMix64;

    /// Every operation is within a unit of the exact result.
    fn holds<S: Scalar>(precision: S::Precision) {
        let mut random = SplitMix64::new(7);
        let mut number = || {
            let digit = |random: &mut SplitMix64| RBig::try_from(random.between(-1.0, 1.0)).unwrap();
            digit(&mut random) + digit(&mut random) / RBig::from(1u64 << 54)
        };
        let unit = RBig::try_from(S::unit(precision)).unwrap();
        let check = |found: S, exact: RBig| {
            let error = found.to_rational().unwrap() - exact.clone();
            let size = if exact < RBig::ZERO { -exact } else { exact };
            assert!((if error < RBig::ZERO { -error } else { error }) <= size * unit.clone(), "{found:?}");
        };
        for round in 0..2000 {
            let (x, y) = (number(), if round % 3 == 0 { -number() / RBig::from(1u64 << 50) } else { number() });
            check(S::rational(&x, precision), x.clone());
            let (a, b) = (S::rational(&x, precision), S::rational(&y, precision));
            // Close to −a: what is lost when the leading digits cancel.
            let b = if round % 2 == 0 { a.negated().plus(&b.times(&b, precision), precision) } else { b };
            let (x, y) = (a.to_rational().unwrap(), b.to_rational().unwrap());
            check(a.plus(&b, precision), &x + &y);
            check(a.times(&b, precision), &x * &y);
            check(a.over(1 + round, precision), x / RBig::from(1 + round));
        }
    }

    #[test]
    fn every_operation_is_within_a_unit() {
        holds::<f64>(());
        holds::<DoubleDouble>(());
        holds::<Float<FixedFloat<4>>>(());
        holds::<Float<Big>>(200);
    }
}
