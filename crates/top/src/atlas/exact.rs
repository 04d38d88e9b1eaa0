//! Exact decisions: points that lie on a straight curve, by rational arithmetic.

use dashu_ratio::RBig;

use crate::body::{Body, Number};

/// True when h = l²/(2 J_r) ∓ r or, for r = 0, h = l²/(2 A_i) holds exactly.
#[must_use]
pub fn on_straight_curve(body: &Body, h: &Number, l: &Number) -> bool {
    let a = body.moments().each_ref().map(Number::value);
    let r = body.center().each_ref().map(Number::value);
    let x = l.value() * l.value() / RBig::from(2);
    let squared = r.map(|c| c * c);
    let norm_squared = &squared[0] + &squared[1] + &squared[2];
    if norm_squared.is_zero() {
        return a.iter().any(|a| *h.value() == &x / *a);
    }
    let weighted = &squared[0] * a[0] + &squared[1] * a[1] + &squared[2] * a[2];
    // J_r = Σ r_i² A_i / r².
    let offset = h.value() - x * &norm_squared / weighted;
    &offset * &offset == norm_squared
}

/// Compares |h| with r, exactly: for l = 0 the critical values are ∓r.
#[must_use]
pub fn compare_with_r(body: &Body, h: &Number) -> std::cmp::Ordering {
    let norm_squared = body.center().iter().fold(RBig::ZERO, |sum, c| sum + c.value() * c.value());
    (h.value() * h.value()).cmp(&norm_squared)
}
