//! Sum, product and difference of polynomials with rational coefficients, to build the integer ones from.

use dashu_ratio::RBig;

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
    let mut product = vec![RBig::ZERO; p.len() + q.len() - 1];
    for (i, a) in p.iter().enumerate() {
        for (j, b) in q.iter().enumerate() {
            product[i + j] += a * b;
        }
    }
    product
}

/// p′.
#[must_use]
pub fn derivative(p: &[RBig]) -> Vec<RBig> {
    p.iter().enumerate().skip(1).map(|(k, c)| c * RBig::from(k)).collect()
}
