//! Order from the tolerance, step from the last two coefficients.

use super::series::ROWS;

use crate::integrator::product::product_sum;

/// The largest order.
pub const MAX_ORDER: usize = ROWS - 2;

/// The even order, at least 8, that does the least work for a relative tolerance: about 1 − ln(tol)/2.
///
/// With it, steps are about e⁻² of the radius of convergence. A tolerance below 2⁻⁶⁰ is read as 2⁻⁶⁰.
#[must_use]
pub fn order_for(tolerance: f64) -> usize {
    let tolerance = tolerance.max(f64::EPSILON / 256.0);
    let wanted = 1.0 - 0.5 * libm::log(tolerance);
    let mut order = 8;
    while order < MAX_ORDER && (order as f64) + 0.1 < wanted {
        order += 2;
    }
    order
}

/// log₂ with the mantissa taken as linear: at most 0.087 too small; −1023 for 0.
#[inline(always)]
fn log2_estimate(x: f64) -> f64 {
    (x.to_bits() >> 20) as f64 / f64::from(1u32 << 31) / 2.0 - 1023.0
}

/// 2^y to 0.3 %, for |y| ≤ 1000.
#[inline(always)]
fn exp2_estimate(y: f64) -> f64 {
    // In [2⁵², 2⁵³) doubles are integers: the last bits of the sum are ⌊y⌋ + 1023, the exponent field of 2^⌊y⌋.
    const SHIFT: f64 = (1u64 << 52) as f64 + 1023.0;
    let whole = y.floor();
    let f = y - whole;
    let power = f64::from_bits((whole + SHIFT).to_bits() << 52);
    power * (product_sum(0.34, f, 0.66) * f + 1.0)
}

/// The rule that turns the norms of the last two coefficients into a step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct StepRule {
    log_tolerance: f64,
    inverse_order: f64,
    inverse_order_below: f64,
    log_max: f64,
}

impl StepRule {
    /// For a tolerance, an order and a longest step.
    pub fn new(tolerance: f64, order: usize, longest: f64) -> Self {
        Self {
            log_tolerance: log2_estimate(tolerance),
            inverse_order: 1.0 / order as f64,
            inverse_order_below: 1.0 / (order - 1) as f64,
            log_max: log2_estimate(longest),
        }
    }

    /// min over j of (tol / |x_j|)^{1/j} for the last two orders, |x_j| relative to the state's scale.
    #[inline(always)]
    pub fn step(&self, last: f64, before_last: f64) -> f64 {
        let from_last = (self.log_tolerance - log2_estimate(last)) * self.inverse_order;
        let from_before = (self.log_tolerance - log2_estimate(before_last)) * self.inverse_order_below;
        exp2_estimate(from_last.min(from_before).clamp(-500.0, self.log_max))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn estimates_are_within_their_bounds() {
        for k in 1..1000 {
            let x = f64::from(k) * 0.037;
            let log = libm::log2(x);
            assert!((0.0..0.0871).contains(&(log - log2_estimate(x))), "{x}");
            let y = f64::from(k - 500) * 0.17;
            assert!((exp2_estimate(y) / libm::exp2(y) - 1.0).abs() < 0.004, "{y}");
        }
    }

    #[test]
    fn order_grows_with_the_digits() {
        assert_eq!(order_for(1e-15), 20);
        assert_eq!(order_for(1e-12), 16);
        assert_eq!(order_for(1e-3), 8);
        assert!(order_for(0.0) <= MAX_ORDER);
    }

    #[test]
    fn a_geometric_series_gives_its_radius_over_e_squared() {
        let rule = StepRule::new(1e-15, 20, 10.0);
        let radius: f64 = 0.8;
        let coefficient = |k: i32| (0..k).fold(1.0, |c, _| c / radius);
        let step = rule.step(coefficient(20), coefficient(19));
        assert!((step / (radius * libm::exp(libm::log(1e-15) / 19.0)) - 1.0).abs() < 0.01);
    }
}
