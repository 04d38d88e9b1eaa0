//! Exact decisions: points that lie on a straight curve, by rational arithmetic.

use dashu_ratio::RBig;

use bifdiag_body::{Body, Number};

/// True when h = l²/(2 J_r) ∓ r or, for r = 0, h = l²/(2 A_i) holds exactly.
#[must_use]
pub fn on_straight_curve(body: &Body, h: &Number, l: &Number) -> bool {
    let x = l.value() * l.value() / RBig::from(2);
    let norm_squared = body.center_squared();
    if norm_squared.is_zero() {
        return on_axis_line(body, h.value(), &x);
    }
    // J_r = Σ r_i² A_i / r².
    let offset = h.value() - x * &norm_squared / body.weighted_moment();
    &offset * &offset == norm_squared
}

/// h = x / A_i for a body with r = 0: x/h is a moment.
fn on_axis_line(body: &Body, h: &RBig, x: &RBig) -> bool {
    if h.is_zero() {
        return false;
    }
    let at = x / h;
    match body.tensor() {
        Some(tensor) => {
            let powers = tensor.matrix().characteristic();
            powers.iter().rev().fold(RBig::ZERO, |sum, c| sum * &at + c).is_zero()
        }
        None => body.moments().iter().any(|a| *a.value() == at),
    }
}

/// Compares |h| with r, exactly: for l = 0 the critical values are ∓r.
#[must_use]
pub fn compare_with_r(body: &Body, h: &Number) -> std::cmp::Ordering {
    (h.value() * h.value()).cmp(&body.center_squared())
}
