//! Polynomials with integer coefficients.

use dashu_base::{BitTest, Gcd};
use dashu_int::{IBig, UBig};
use dashu_ratio::RBig;

use super::rational::over_one_denominator;
use crate::Sign;
use crate::enclosure::Arithmetic;
use crate::modular::surely_coprime;

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
    fn primitive(self) -> Self {
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
        // q is a power of two but for the first ends of a root that was found from its inverse.
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

    /// Greatest common divisor, primitive; by pseudo-remainders.
    #[must_use]
    pub fn gcd(&self, other: &Self) -> Self {
        let (mut a, mut b) = (self.clone().primitive(), other.clone().primitive());
        if a.c.len() < b.c.len() {
            std::mem::swap(&mut a, &mut b);
        }
        while !b.is_zero() {
            let remainder = a.pseudo_remainder(&b).primitive();
            a = b;
            b = remainder;
        }
        a.primitive()
    }

    /// True only if no common factor exists; false may mean either.
    #[must_use]
    pub fn is_surely_coprime_to(&self, other: &Self) -> bool {
        surely_coprime(&self.c, &other.c)
    }

    /// True only if every root is simple; false may mean either.
    pub(super) fn is_surely_squarefree(&self) -> bool {
        self.is_surely_coprime_to(&self.derivative())
    }

    fn pseudo_remainder(&self, divisor: &Self) -> Self {
        let mut rest = self.c.clone();
        let n = divisor.c.len();
        let lead = &divisor.c[n - 1];
        while rest.len() >= n {
            let top = rest[rest.len() - 1].clone();
            let offset = rest.len() - n;
            for c in &mut rest {
                *c *= lead;
            }
            for (k, d) in divisor.c.iter().enumerate() {
                rest[offset + k] -= d * &top;
            }
            rest.pop();
        }
        Self::new(rest)
    }

    /// self / divisor, which must divide.
    fn quotient(&self, divisor: &Self) -> Self {
        let mut rest: Vec<RBig> = self.c.iter().map(|c| RBig::from(c.clone())).collect();
        let n = divisor.c.len();
        let lead = RBig::from(divisor.c[n - 1].clone());
        let mut quotient = vec![RBig::ZERO; (rest.len() + 1).saturating_sub(n)];
        while rest.len() >= n {
            let factor = &rest[rest.len() - 1] / &lead;
            let offset = rest.len() - n;
            for (k, d) in divisor.c.iter().enumerate() {
                rest[offset + k] -= RBig::from(d.clone()) * &factor;
            }
            quotient[offset] = factor;
            rest.pop();
        }
        Self::from_rationals(&quotient)
    }

    /// p / gcd(p, p′): the same roots, each simple.
    #[must_use]
    pub fn squarefree(&self) -> Self {
        if self.is_surely_squarefree() {
            return self.clone();
        }
        let shared = self.gcd(&self.derivative());
        if shared.degree() == 0 { self.clone() } else { self.quotient(&shared) }
    }

    /// p on [lo, hi] mapped to [0, 1].
    pub(super) fn on(&self, lo: &RBig, hi: &RBig) -> Self {
        self.composed(lo, &(hi - lo))
    }
}

fn magnitude(x: &IBig) -> UBig {
    x.clone().into_parts().1
}
