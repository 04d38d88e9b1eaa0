//! Sum, product and difference of polynomials with rational coefficients, to build the integer ones from.

use dashu_base::Gcd;
use dashu_int::{IBig, UBig};
use dashu_ratio::RBig;

/// Whole numbers and the least denominator over which they are these coefficients.
#[must_use]
pub fn over_one_denominator(c: &[RBig]) -> (Vec<IBig>, UBig) {
    let common = c.iter().fold(UBig::ONE, |common, x| {
        let d = x.denominator();
        let shared = (&common).gcd(d);
        common / shared * d
    });
    let whole = c.iter().map(|x| x.numerator() * IBig::from(&common / x.denominator())).collect();
    (whole, common)
}

/// p + q.
#[must_use]
pub fn add(p: &[RBig], q: &[RBig]) -> Vec<RBig> {
    let n = p.len().max(q.len());
    let at = |s: &[RBig], k: usize| s.get(k).cloned().unwrap_or(RBig::ZERO);
    (0..n).map(|k| at(p, k) + at(q, k)).collect()
}

/// c p.
#[must_use]
pub fn scale(p: &[RBig], factor: &RBig) -> Vec<RBig> {
    p.iter().map(|c| c * factor).collect()
}

/// p − q.
#[must_use]
pub fn sub(p: &[RBig], q: &[RBig]) -> Vec<RBig> {
    add(p, &scale(q, &RBig::from(-1)))
}

/// p q.
#[must_use]
pub fn mul(p: &[RBig], q: &[RBig]) -> Vec<RBig> {
    if p.is_empty() || q.is_empty() {
        return Vec::new();
    }
    // In whole numbers: fractions would be brought to lowest terms at every sum.
    let ((p, first), (q, second)) = (over_one_denominator(p), over_one_denominator(q));
    let mut product = vec![IBig::ZERO; p.len() + q.len() - 1];
    for (i, a) in p.iter().enumerate() {
        for (j, b) in q.iter().enumerate() {
            product[i + j] += a * b;
        }
    }
    let common = first * second;
    product.into_iter().map(|c| RBig::from_parts(c, common.clone())).collect()
}

/// p′.
#[must_use]
pub fn derivative(p: &[RBig]) -> Vec<RBig> {
    p.iter().enumerate().skip(1).map(|(k, c)| c * RBig::from(k)).collect()
}
