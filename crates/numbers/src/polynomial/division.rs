//! Divisibility: common factors and squarefree parts.
//!
//! Coprimality is proved modulo a prime, at the price of machine words: if the leading coefficients survive, the gcd over
//! the rationals keeps its degree modulo the prime and divides the gcd there. So polynomials that are coprime modulo the
//! prime are coprime; the converse may fail.

use dashu_int::{IBig, UBig};
use dashu_ratio::RBig;

use super::integer::Polynomial;
use crate::Sign;

impl Polynomial {
    /// Greatest common divisor, primitive, by pseudo-remainders.
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

    /// self / divisor, which must divide and have the leading coefficient 1.
    #[must_use]
    pub fn over_monic(&self, divisor: &Self) -> Self {
        let mut rest = self.c.clone();
        let n = divisor.c.len();
        let mut quotient = vec![IBig::ZERO; (rest.len() + 1).saturating_sub(n)];
        while rest.len() >= n {
            let Some(factor) = rest.pop() else { break };
            let offset = rest.len() + 1 - n;
            for (k, d) in divisor.c[..n - 1].iter().enumerate() {
                rest[offset + k] -= d * &factor;
            }
            quotient[offset] = factor;
        }
        Self::new(quotient)
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

    /// How often x is a root; 0 for the zero polynomial.
    pub(crate) fn multiplicity_at(&self, x: &RBig) -> usize {
        let mut derivative = self.clone();
        let mut multiplicity = 0;
        while !derivative.is_zero() && derivative.sign_at(x) == Sign::Zero {
            derivative = derivative.derivative();
            multiplicity += 1;
        }
        multiplicity
    }
}

/// 2⁶¹ − 1, a prime.
const PRIME: u64 = (1 << 61) - 1;

fn reduced(c: &IBig) -> u64 {
    let (sign, magnitude) = c.clone().into_parts();
    let rest = u64::try_from(magnitude % UBig::from(PRIME)).unwrap_or(0);
    if sign == dashu_base::Sign::Negative && rest > 0 { PRIME - rest } else { rest }
}

fn product(a: u64, b: u64) -> u64 {
    let wide = u128::from(a) * u128::from(b) % u128::from(PRIME);
    u64::try_from(wide).unwrap_or(0)
}

fn difference(a: u64, b: u64) -> u64 {
    if a >= b { a - b } else { a + PRIME - b }
}

/// a⁻¹ = a^(p − 2), by Fermat's little theorem.
fn inverse(a: u64) -> u64 {
    let (mut power, mut result, mut exponent) = (a, 1, PRIME - 2);
    while exponent > 0 {
        if exponent & 1 == 1 {
            result = product(result, power);
        }
        power = product(power, power);
        exponent >>= 1;
    }
    result
}

fn trimmed(mut c: Vec<u64>) -> Vec<u64> {
    while c.last() == Some(&0) {
        c.pop();
    }
    c
}

/// True only if the polynomials with these coefficients, by rising power, have no common factor over the rationals.
fn surely_coprime(p: &[IBig], q: &[IBig]) -> bool {
    let residues = |c: &[IBig]| c.iter().map(reduced).collect::<Vec<_>>();
    let (mut a, mut b) = (residues(p), residues(q));
    if a.last().is_none_or(|lead| *lead == 0) || b.last().is_none_or(|lead| *lead == 0) {
        return false;
    }
    while !b.is_empty() {
        let scale = inverse(b[b.len() - 1]);
        while a.len() >= b.len() {
            let factor = product(a[a.len() - 1], scale);
            let offset = a.len() - b.len();
            for (k, c) in b.iter().enumerate() {
                a[offset + k] = difference(a[offset + k], product(factor, *c));
            }
            a.pop();
        }
        (a, b) = (b, trimmed(a));
    }
    a.len() == 1
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn integers(c: &[i64]) -> Vec<IBig> {
        c.iter().map(|&c| IBig::from(c)).collect()
    }

    fn times(p: &[i64], q: &[i64]) -> Vec<i64> {
        let mut all = vec![0; p.len() + q.len() - 1];
        for (i, a) in p.iter().enumerate() {
            for (k, b) in q.iter().enumerate() {
                all[i + k] += a * b;
            }
        }
        all
    }

    proptest! {
        #[test]
        fn a_common_factor_is_never_denied(
            p in prop::collection::vec(-50i64..50, 3), q in prop::collection::vec(-50i64..50, 4), root in -20i64..20,
        ) {
            let (p, q) = (times(&p, &[-root, 1]), times(&q, &[-root, 1]));
            prop_assert!(!surely_coprime(&integers(&p), &integers(&q)));
        }

        #[test]
        fn different_roots_are_told_apart(a in -20i64..20, b in -20i64..20, c in 21i64..40) {
            prop_assert!(surely_coprime(&integers(&times(&[-a, 1], &[-b, 1])), &integers(&[-c, 1])));
        }
    }
}
