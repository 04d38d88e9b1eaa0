//! The roots of the steps that have exactly one, all lanes at once.

use pulp::Simd;

use super::roots::{CONVERGED, DEPTH};
use crate::integrator::product::ProductSum;
use crate::integrator::taylor::{lane_values, magnitude};

/// For each wanted lane the root in [0, 1] of Σ c_k xᵏ, which changes sign there exactly once; `end` is its value
/// at 1. The other lanes hold no meaning.
///
/// Newton's method inside a bracket, as for a single polynomial. A lane that has converged is left alone while
/// others go on, so that it does not depend on them.
#[inline(always)]
pub(super) fn single_roots<S: Simd>(simd: S, c: &[S::f64s], end: S::f64s, wanted: S::m64s) -> S::f64s {
    let (zero, half, one) = (simd.splat_f64s(0.0), simd.splat_f64s(0.5), simd.splat_f64s(1.0));
    let rises = simd.less_than_or_equal_f64s(zero, end);
    let (mut low, mut high) = (zero, one);
    let guess = parabola(simd, c, end);
    let usable = simd.and_m64s(simd.less_than_f64s(zero, guess), simd.less_than_f64s(guess, one));
    let mut x = simd.select_f64s(usable, guess, half);
    let mut going = wanted;
    for _ in 0..2 * DEPTH {
        let (value, slope) = value_and_slope(simd, c, x);
        let above = simd.xor_m64s(simd.less_than_f64s(value, zero), rises);
        high = simd.select_f64s(above, x, high);
        low = simd.select_f64s(above, low, x);
        let newton = simd.sub_f64s(x, simd.div_f64s(value, slope));
        let inside =
            simd.and_m64s(simd.less_than_or_equal_f64s(low, newton), simd.less_than_or_equal_f64s(newton, high));
        let next = simd.select_f64s(inside, newton, simd.mul_f64s(simd.add_f64s(low, high), half));
        let change = magnitude(simd, simd.sub_f64s(next, x));
        x = simd.select_f64s(going, next, x);
        let close = simd.and_m64s(inside, simd.less_than_or_equal_f64s(change, simd.splat_f64s(CONVERGED)));
        let still = simd.less_than_f64s(simd.splat_f64s(f64::EPSILON), change);
        // going and not (close or no longer moving)
        going =
            simd.and_m64s(going, simd.and_m64s(still, simd.xor_m64s(close, simd.less_than_or_equal_f64s(zero, one))));
        let going = [simd.select_f64s(going, one, zero)];
        if lane_values::<S>(&going).iter().all(|&x| x == 0.0) {
            break;
        }
    }
    x
}

/// The zero of the parabola through both ends with the slope at 0; Muller's form has no cancellation.
#[inline(always)]
fn parabola<S: Simd>(simd: S, c: &[S::f64s], end: S::f64s) -> S::f64s {
    let zero = simd.splat_f64s(0.0);
    let curvature = simd.sub_f64s(simd.sub_f64s(end, c[0]), c[1]);
    let product = simd.mul_f64s(curvature, simd.mul_f64s(c[0], simd.splat_f64s(4.0)));
    let discriminant = simd.sub_f64s(simd.mul_f64s(c[1], c[1]), product);
    let root = simd.sqrt_f64s(simd.max_f64s(discriminant, zero));
    let root = simd.select_f64s(simd.less_than_f64s(c[1], zero), simd.sub_f64s(zero, root), root);
    simd.div_f64s(simd.mul_f64s(c[0], simd.splat_f64s(-2.0)), simd.add_f64s(c[1], root))
}

/// p(x) and p′(x), by Horner's rule for the even and the odd part: half the latency of one long chain.
#[inline(always)]
fn value_and_slope<S: Simd>(simd: S, c: &[S::f64s], x: S::f64s) -> (S::f64s, S::f64s) {
    let zero = simd.splat_f64s(0.0);
    let square = simd.mul_f64s(x, x);
    let (mut even, mut even_slope, mut odd, mut odd_slope) = (zero, zero, zero, zero);
    for pair in c.chunks(2).rev() {
        even_slope = simd.product_sum(even_slope, square, even);
        even = simd.product_sum(even, square, pair[0]);
        odd_slope = simd.product_sum(odd_slope, square, odd);
        odd = simd.product_sum(odd, square, if pair.len() > 1 { pair[1] } else { zero });
    }
    // p′ = 2x (x o′ + e′) + o
    let inner = simd.product_sum(x, odd_slope, even_slope);
    let slope = simd.product_sum(simd.add_f64s(x, x), inner, odd);
    (simd.product_sum(x, odd, even), slope)
}

#[cfg(test)]
mod tests {
    use super::*;
    use pulp::Scalar;

    fn root(c: &[f64]) -> f64 {
        single_roots(Scalar::new(), c, c.iter().sum(), true)
    }

    #[test]
    fn single_roots_are_found_to_rounding() {
        for k in 0..200 {
            let planted = (f64::from(k) + 0.5) / 200.0;
            // (x − planted)(1 + 0.3x² ± …)
            for factor in [[1.0, 0.0, 0.3], [-2.0, 0.5, -0.7], [1.0, -0.9, 0.2]] {
                let mut c = [0.0; 4];
                for (i, f) in factor.iter().enumerate() {
                    c[i] -= planted * f;
                    c[i + 1] += f;
                }
                assert!((root(&c) - planted).abs() < 1e-15, "{planted} {}", root(&c));
            }
        }
    }

    #[test]
    fn a_root_that_rounding_pushes_over_the_end_is_put_there() {
        // The neighbour says that S has changed its sign at 1; the polynomial does not show it.
        let c = [-1.0, 1.0 - 1e-16];
        assert_eq!(single_roots(Scalar::new(), &c, 1e-17, true), 1.0);
    }
}
