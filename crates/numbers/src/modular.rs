//! Polynomials modulo a prime: coprimality is proved there at the price of machine words.
//!
//! If the leading coefficients survive, the gcd over the rationals keeps its degree modulo the prime and divides the
//! gcd there. So polynomials that are coprime modulo the prime are coprime; the converse may fail.

use dashu_int::{IBig, UBig};

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

/// Fermat's inverse.
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

/// Coefficients by rising power: surely without a common factor over the rationals.
pub(crate) fn surely_coprime(p: &[IBig], q: &[IBig]) -> bool {
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
