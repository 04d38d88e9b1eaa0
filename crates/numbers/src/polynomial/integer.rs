//! The ring of polynomials with integer coefficients.

use dashu_base::{BitTest, Gcd};
use dashu_int::{IBig, UBig};
use dashu_ratio::RBig;

use super::rational::over_one_denominator;
use crate::Sign;
use crate::enclosure::Arithmetic;

/// c\[0\] + c\[1\] t + …; no trailing zeros.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Polynomial {
    pub(super) c: Vec<IBig>,
}

impl Polynomial {
    /// From coefficients by rising power.
    #[must_use]
    pub fn new(mut c: Vec<IBig>) -> Self {
        while c.last().is_some_and(|last| *last == IBig::ZERO) {
            c.pop();
        }
        Self { c }
    }

    /// The polynomial times the common denominator of these coefficients, which is positive.
    #[must_use]
    pub fn from_rationals(c: &[RBig]) -> Self {
        Self::new(over_one_denominator(c).0).primitive()
    }

    /// Its coefficients by rising power; the last one is not 0.
    #[must_use]
    pub fn coefficients(&self) -> &[IBig] {
        &self.c
    }

    /// The zero polynomial.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.c.is_empty()
    }

    /// Its degree; 0 for constants.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.c.len().saturating_sub(1)
    }

    /// Divided by the greatest common divisor of the coefficients.
    #[must_use]
    pub fn primitive(self) -> Self {
        let content = self.c.iter().fold(UBig::ZERO, |content, c| {
            if content == UBig::ONE || *c == IBig::ZERO {
                content
            } else if content == UBig::ZERO {
                magnitude(c)
            } else {
                content.gcd(magnitude(c))
            }
        });
        if content <= UBig::ONE {
            return self;
        }
        let content = IBig::from(content);
        Self { c: self.c.into_iter().map(|c| c / &content).collect() }
    }

    /// The sign at p/q.
    #[must_use]
    pub fn sign_at(&self, at: &RBig) -> Sign {
        Sign::from(&self.homogeneous(at.numerator(), &IBig::from(at.denominator().clone())))
    }

    /// Its coefficients in one arithmetic.
    #[must_use]
    pub fn enclosed<E: Arithmetic>(&self, precision: E::Precision) -> Vec<E> {
        self.c.iter().map(|c| E::rational(&RBig::from(c.clone()), precision)).collect()
    }

    /// qⁿ p(p/q).
    pub(super) fn homogeneous(&self, p: &IBig, q: &IBig) -> IBig {
        // q is a power of two, except for the first ends of a root found from its inverse.
        let zeros = q.trailing_zeros().filter(|zeros| q.bit_len() == zeros + 1);
        let mut power = IBig::ONE;
        let mut value = IBig::ZERO;
        for (k, c) in self.c.iter().rev().enumerate() {
            value *= p;
            if let Some(zeros) = zeros {
                value += c << (k * zeros);
            } else {
                value += c * &power;
                power *= q;
            }
        }
        value
    }

    /// p(x).
    #[must_use]
    pub fn at(&self, x: &RBig) -> RBig {
        self.c.iter().rev().fold(RBig::ZERO, |sum, c| sum * x + RBig::from(c.clone()))
    }

    /// p′.
    #[must_use]
    pub fn derivative(&self) -> Self {
        Self::new(self.c.iter().enumerate().skip(1).map(|(k, c)| c * IBig::from(k)).collect())
    }

    /// p(shift + scale t).
    #[must_use]
    pub fn composed(&self, shift: &RBig, scale: &RBig) -> Self {
        // With shift = s/m and scale = e/m: mⁿ p((s + u)/m) by Horner's rule, then u = e t.
        let (whole, common) = over_one_denominator(&[shift.clone(), scale.clone()]);
        let ([s, e], m) = ([&whole[0], &whole[1]], IBig::from(common));
        let mut result: Vec<IBig> = Vec::with_capacity(self.c.len());
        let mut power = IBig::ONE;
        for c in self.c.iter().rev() {
            result.insert(0, c * &power);
            for k in 1..result.len() {
                let lower = &result[k] * s;
                result[k - 1] += lower;
            }
            power *= &m;
        }
        let mut power = IBig::ONE;
        for c in &mut result {
            *c *= &power;
            power *= e;
        }
        Self::new(result).primitive()
    }

    /// tⁿ p(1/t).
    #[must_use]
    pub fn reversed(&self) -> Self {
        Self::new(self.c.iter().rev().cloned().collect())
    }

    /// p on [lo, hi] mapped to [0, 1].
    pub(super) fn on(&self, lo: &RBig, hi: &RBig) -> Self {
        self.composed(lo, &(hi - lo))
    }
}

fn magnitude(x: &IBig) -> UBig {
    x.clone().into_parts().1
}

impl Polynomial {
    /// A constant.
    #[must_use]
    pub fn constant(value: IBig) -> Self {
        Self::new(vec![value])
    }

    /// t − root.
    #[must_use]
    pub fn linear(root: &IBig) -> Self {
        Self::new(vec![-root.clone(), IBig::ONE])
    }

    /// p + q.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        let (long, short) = if self.coefficients().len() >= other.coefficients().len() {
            (self.coefficients(), other.coefficients())
        } else {
            (other.coefficients(), self.coefficients())
        };
        let mut sum = long.to_vec();
        for (at, c) in sum.iter_mut().zip(short) {
            *at += c;
        }
        Self::new(sum)
    }

    /// p q.
    #[must_use]
    pub fn times(&self, other: &Self) -> Self {
        let (p, q) = (self.coefficients(), other.coefficients());
        if p.is_empty() || q.is_empty() {
            return Self::new(Vec::new());
        }
        let mut product = vec![IBig::ZERO; p.len() + q.len() - 1];
        for (i, a) in p.iter().enumerate() {
            for (j, b) in q.iter().enumerate() {
                product[i + j] += a * b;
            }
        }
        Self::new(product)
    }

    /// c p.
    #[must_use]
    pub fn scaled(&self, factor: &IBig) -> Self {
        Self::new(self.coefficients().iter().map(|c| c * factor).collect())
    }

    /// p − q.
    #[must_use]
    pub fn minus(&self, other: &Self) -> Self {
        self.plus(&other.scaled(&IBig::NEG_ONE))
    }

    /// p².
    #[must_use]
    pub fn squared(&self) -> Self {
        self.times(self)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn polynomial(c: &[i32]) -> Polynomial {
        Polynomial::new(c.iter().map(|&c| IBig::from(c)).collect())
    }

    proptest! {
        #[test]
        fn the_ring_of_polynomials_maps_to_values(
            p in proptest::collection::vec(-9i32..9, 0..6),
            q in proptest::collection::vec(-9i32..9, 0..6),
            at in -5i32..5,
        ) {
            let value = |c: &Polynomial| {
                c.coefficients().iter().rev().fold(IBig::ZERO, |sum, c| sum * IBig::from(at) + c)
            };
            let (p, q) = (polynomial(&p), polynomial(&q));
            prop_assert_eq!(value(&p.plus(&q)), value(&p) + value(&q));
            prop_assert_eq!(value(&p.minus(&q)), value(&p) - value(&q));
            prop_assert_eq!(value(&p.times(&q)), value(&p) * value(&q));
            prop_assert_eq!(value(&p.squared()), value(&p) * value(&p));
            prop_assert_eq!(p.minus(&p).sign_at(&RBig::from(at)), crate::Sign::Zero);
        }
    }
}
