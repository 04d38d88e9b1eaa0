//! Interval arithmetic on integers: both ends are multiples of 2⁻²⁵⁶.

use std::ops::{Add, Mul, Neg, Sub};

use dashu_base::{Signed, SquareRoot};
use dashu_int::IBig;
use dashu_ratio::RBig;

/// Fractional bits.
const BITS: usize = 256;

/// All reals between two multiples of 2⁻²⁵⁶.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Fixed {
    lo: IBig,
    hi: IBig,
}

/// ⌊n/2²⁵⁶⌋: the shift of a negative number rounds down.
fn floor_shift(n: IBig) -> IBig {
    n >> BITS
}

fn ceil_shift(n: IBig) -> IBig {
    -((-n) >> BITS)
}

fn floor_div(n: &IBig, d: &IBig) -> IBig {
    let (n, d) = if d.is_negative() { (-n, -d) } else { (n.clone(), d.clone()) };
    let quotient = &n / &d;
    if n.is_negative() && &quotient * &d != n { quotient - IBig::ONE } else { quotient }
}

impl Fixed {
    pub fn of(x: &RBig) -> Self {
        let (n, d) = (x.numerator() << BITS, IBig::from(x.denominator().clone()));
        Self { lo: floor_div(&n, &d), hi: -floor_div(&-n, &d) }
    }

    pub fn between(lo: &RBig, hi: &RBig) -> Self {
        Self { lo: Self::of(lo).lo, hi: Self::of(hi).hi }
    }

    pub fn whole(n: i32) -> Self {
        let n = IBig::from(n) << BITS;
        Self { lo: n.clone(), hi: n }
    }

    pub fn sign(&self) -> Option<i8> {
        let zero = IBig::ZERO;
        if self.lo > zero {
            Some(1)
        } else if self.hi < zero {
            Some(-1)
        } else if self.lo == zero && self.hi == zero {
            Some(0)
        } else {
            None
        }
    }

    pub fn is_positive(&self) -> bool {
        self.sign() == Some(1)
    }

    /// self / other; `None` when the divisor may vanish.
    pub fn over(&self, other: &Self) -> Option<Self> {
        if !matches!(other.sign(), Some(1 | -1)) {
            return None;
        }
        let mut ends = Vec::with_capacity(4);
        for n in [&self.lo, &self.hi] {
            for d in [&other.lo, &other.hi] {
                ends.push((floor_div(&(n << BITS), d), -floor_div(&-(n << BITS), d)));
            }
        }
        let lo = ends.iter().map(|e| e.0.clone()).min()?;
        let hi = ends.into_iter().map(|e| e.1).max()?;
        Some(Self { lo, hi })
    }

    /// Square root of the part that is not negative.
    pub fn root(&self) -> Self {
        let root = |n: &IBig| {
            let (_, magnitude) = (n << BITS).max(IBig::ZERO).into_parts();
            IBig::from(magnitude.sqrt())
        };
        Self { lo: root(&self.lo), hi: root(&self.hi) + IBig::ONE }
    }

    pub fn square(&self) -> Self {
        let product = self * self;
        Self { lo: product.lo.max(IBig::ZERO), hi: product.hi }
    }

    pub fn hull(&self, other: &Self) -> Self {
        Self { lo: self.lo.clone().min(other.lo.clone()), hi: self.hi.clone().max(other.hi.clone()) }
    }

    /// Common part of two enclosures of one number; `None` when they contradict each other.
    pub fn meet(&self, other: &Self) -> Option<Self> {
        let met = Self { lo: self.lo.clone().max(other.lo.clone()), hi: self.hi.clone().min(other.hi.clone()) };
        (met.lo <= met.hi).then_some(met)
    }

    pub fn middle(&self) -> Self {
        let sum = &self.lo + &self.hi;
        let middle: IBig = sum >> 1usize;
        Self { lo: middle.clone(), hi: middle }
    }

    /// Every number here is below every number there.
    pub fn below(&self, other: &Self) -> bool {
        self.hi < other.lo
    }

    /// Every number here is at most every number there.
    pub fn at_most(&self, other: &Self) -> bool {
        self.hi <= other.lo
    }

    /// All of this lies in `other`.
    pub fn inside(&self, other: &Self) -> bool {
        other.lo <= self.lo && self.hi <= other.hi
    }

    pub fn to_f64(&self) -> f64 {
        let sum = RBig::from(&self.lo + &self.hi) / RBig::from(IBig::ONE << (BITS + 1));
        sum.to_f64().value()
    }
}

impl Add for &Fixed {
    type Output = Fixed;
    fn add(self, other: Self) -> Fixed {
        Fixed { lo: &self.lo + &other.lo, hi: &self.hi + &other.hi }
    }
}

impl Sub for &Fixed {
    type Output = Fixed;
    fn sub(self, other: Self) -> Fixed {
        Fixed { lo: &self.lo - &other.hi, hi: &self.hi - &other.lo }
    }
}

impl Neg for &Fixed {
    type Output = Fixed;
    fn neg(self) -> Fixed {
        Fixed { lo: -&self.hi, hi: -&self.lo }
    }
}

impl Mul for &Fixed {
    type Output = Fixed;
    fn mul(self, other: Self) -> Fixed {
        let products = [&self.lo * &other.lo, &self.lo * &other.hi, &self.hi * &other.lo, &self.hi * &other.hi];
        let (mut least, mut greatest) = (products[0].clone(), products[0].clone());
        for product in &products[1..] {
            if *product < least {
                least.clone_from(product);
            }
            if *product > greatest {
                greatest.clone_from(product);
            }
        }
        Fixed { lo: floor_shift(least), hi: ceil_shift(greatest) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn ratio(p: i64, q: u32) -> RBig {
        RBig::from_parts(p.into(), q.into())
    }

    fn holds(set: &Fixed, x: &RBig) -> bool {
        Fixed::of(x).inside(&Fixed { lo: &set.lo - IBig::ONE, hi: &set.hi + IBig::ONE })
    }

    proptest! {
        #[test]
        fn operations_enclose(p in -9999i64..9999, q in -9999i64..9999, s in 1u32..999, t in 1u32..999) {
            let (x, y) = (ratio(p, s), ratio(q, t));
            let (a, b) = (Fixed::of(&x), Fixed::of(&y));
            prop_assert!(holds(&(&a + &b), &(&x + &y)));
            prop_assert!(holds(&(&a - &b), &(&x - &y)));
            prop_assert!(holds(&(&a * &b), &(&x * &y)));
            if q != 0 {
                prop_assert!(holds(&a.over(&b).unwrap(), &(&x / &y)));
            }
            let root = a.square().root();
            let expected = x.clone().max(-x.clone());
            prop_assert!(holds(&root, &expected));
            prop_assert_eq!((&a - &b).sign() == Some(1), x > y);
        }
    }
}
