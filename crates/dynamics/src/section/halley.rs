//! The roots of the steps that have exactly one, all lanes at once.

use pulp::Simd;

use super::roots::DEPTH;
use crate::integrator::product::ProductSum;
use crate::integrator::taylor::{ROWS, magnitude};

/// Room for coefficients: a multiple of four.
pub(super) const ROOM: usize = ROWS.next_multiple_of(4);
/// Terms of the slope that are summed: the others are below 2⁻³⁰ of it, like what it is multiplied with at the end.
const SLOPE_TERMS: usize = 14;
/// Terms of a first approximation.
const LEADING: usize = 8;
/// Terms of the curvature, which only corrects.
const CURVATURE_TERMS: usize = 8;
/// Steps below this are the last, if the slope changes along them by less than this part: what they leave is of the order of
/// their cube.
const CONVERGED: f64 = 1.0 / (1u64 << 17) as f64;
const SLIGHT: f64 = 1.0 / (1u64 << 10) as f64;

/// For each wanted lane the root in [0, 1] of Σ c_k xᵏ, which changes sign there exactly once; `end` is its value
/// at 1. The other lanes hold no meaning. The coefficients from `terms` on are 0.
///
/// Halley's method inside a bracket: two or three steps, where Newton's takes four or five as long ones. A lane that
/// has converged is left unchanged while others continue, so its result does not depend on them.
#[inline(always)]
pub(super) fn single_roots<S: Simd>(
    simd: S,
    c: &[S::f64s; ROOM],
    terms: usize,
    end: S::f64s,
    wanted: S::m64s,
) -> S::f64s {
    let (zero, half, one) = (simd.splat_f64s(0.0), simd.splat_f64s(0.5), simd.splat_f64s(1.0));
    let rises = simd.less_than_or_equal_f64s(zero, end);
    let (mut low, mut high) = (zero, one);
    let mut going = wanted;
    let slopes: [S::f64s; SLOPE_TERMS] = derivative(simd, c);
    let curvatures: [S::f64s; CURVATURE_TERMS] = derivative(simd, &slopes);
    let mut x = inverse_parabola(simd, c, end);
    x = simd.select_f64s(strictly_between(simd, zero, x, one), x, half);
    // The first step needs the leading terms only: the others are of the size of what it leaves.
    let square = simd.mul_f64s(x, x);
    let guess = halley(
        simd,
        x,
        sum::<S, LEADING>(simd, c, x, square),
        sum::<S, { LEADING - 1 }>(simd, &slopes, x, square),
        sum::<S, { LEADING - 2 }>(simd, &curvatures, x, square),
    );
    x = simd.select_f64s(strictly_between(simd, zero, guess, one), guess, x);
    for _ in 0..2 * DEPTH {
        let square = simd.mul_f64s(x, x);
        let value = value_at(simd, &c[..terms.next_multiple_of(4)], x, square);
        let slope = sum::<S, SLOPE_TERMS>(simd, &slopes, x, square);
        let curvature = sum::<S, CURVATURE_TERMS>(simd, &curvatures, x, square);
        let above = simd.xor_m64s(simd.less_than_f64s(value, zero), rises);
        high = simd.select_f64s(above, x, high);
        low = simd.select_f64s(above, low, x);
        let better = halley(simd, x, value, slope, curvature);
        let inside =
            simd.and_m64s(simd.less_than_or_equal_f64s(low, better), simd.less_than_or_equal_f64s(better, high));
        let next = simd.select_f64s(inside, better, simd.mul_f64s(simd.add_f64s(low, high), half));
        let change = magnitude(simd, simd.sub_f64s(next, x));
        x = simd.select_f64s(going, next, x);
        let close = simd.and_m64s(inside, simd.less_than_or_equal_f64s(change, simd.splat_f64s(CONVERGED)));
        let turn = magnitude(simd, simd.mul_f64s(curvature, change));
        let slight = simd.mul_f64s(magnitude(simd, slope), simd.splat_f64s(SLIGHT));
        let close = simd.and_m64s(close, simd.less_than_or_equal_f64s(turn, slight));
        let still = simd.less_than_f64s(simd.splat_f64s(f64::EPSILON), change);
        // going and not (close or no longer moving)
        going =
            simd.and_m64s(going, simd.and_m64s(still, simd.xor_m64s(close, simd.less_than_or_equal_f64s(zero, one))));
        if simd.first_true_m64s(going) == S::F64_LANES {
            break;
        }
    }
    x
}

/// Halley's step x − p p′/(p′² − p p″/2), and Newton's x − p/p′ where |p p″| > p′²/2: there Halley's can be short far from a
/// root, at an extremum of p.
#[inline(always)]
fn halley<S: Simd>(simd: S, x: S::f64s, value: S::f64s, slope: S::f64s, curvature: S::f64s) -> S::f64s {
    let bend = simd.mul_f64s(simd.mul_f64s(value, simd.splat_f64s(0.5)), curvature);
    let square = simd.mul_f64s(slope, slope);
    let straight = simd.less_than_or_equal_f64s(magnitude(simd, bend), simd.mul_f64s(square, simd.splat_f64s(0.25)));
    let bend = simd.select_f64s(straight, bend, simd.splat_f64s(0.0));
    let bottom = simd.product_sum(slope, slope, simd.sub_f64s(simd.splat_f64s(0.0), bend));
    simd.sub_f64s(x, simd.div_f64s(simd.mul_f64s(value, slope), bottom))
}

/// low < x < high.
#[inline(always)]
fn strictly_between<S: Simd>(simd: S, low: S::f64s, x: S::f64s, high: S::f64s) -> S::m64s {
    simd.and_m64s(simd.less_than_f64s(low, x), simd.less_than_f64s(x, high))
}

/// (k+1) c_{k+1}, the first of them.
#[inline(always)]
fn derivative<S: Simd, const TERMS: usize>(simd: S, c: &[S::f64s]) -> [S::f64s; TERMS] {
    let mut slopes = [simd.splat_f64s(0.0); TERMS];
    for (k, slope) in slopes.iter_mut().enumerate() {
        *slope = simd.mul_f64s(c[k + 1], simd.splat_f64s((k + 1) as f64));
    }
    slopes
}

/// Σ c_k xᵏ of the first `TERMS`, the even and the odd ones apart: half the latency of one long chain.
#[inline(always)]
fn sum<S: Simd, const TERMS: usize>(simd: S, c: &[S::f64s], x: S::f64s, square: S::f64s) -> S::f64s {
    let (mut even, mut odd) = (simd.splat_f64s(0.0), simd.splat_f64s(0.0));
    for k in (0..TERMS).rev() {
        let half = if k % 2 == 0 { &mut even } else { &mut odd };
        *half = simd.product_sum(*half, square, c[k]);
    }
    simd.product_sum(x, odd, even)
}

/// Σ c_k xᵏ in four chains; their number is a multiple of four.
#[inline(always)]
fn value_at<S: Simd>(simd: S, c: &[S::f64s], x: S::f64s, square: S::f64s) -> S::f64s {
    let fourth = simd.mul_f64s(square, square);
    let mut sums = [simd.splat_f64s(0.0); 4];
    for four in c.chunks_exact(4).rev() {
        for (sum, &c) in sums.iter_mut().zip(four) {
            *sum = simd.product_sum(*sum, fourth, c);
        }
    }
    let low = simd.product_sum(x, sums[1], sums[0]);
    let high = simd.product_sum(x, sums[3], sums[2]);
    simd.product_sum(square, high, low)
}

/// The zero of the parabola x(S) through both ends with the slope at 0, or of the chord where that is outside.
#[inline(always)]
fn inverse_parabola<S: Simd>(simd: S, c: &[S::f64s], end: S::f64s) -> S::f64s {
    let (zero, one) = (simd.splat_f64s(0.0), simd.splat_f64s(1.0));
    let rise = simd.sub_f64s(end, c[0]);
    let chord = simd.div_f64s(simd.sub_f64s(zero, c[0]), rise);
    let ratio = simd.div_f64s(rise, c[1]);
    // t (m + (1 − m) t)
    let inner = simd.product_sum(simd.sub_f64s(one, ratio), chord, ratio);
    let x = simd.mul_f64s(chord, inner);
    simd.select_f64s(strictly_between(simd, zero, x, one), x, chord)
}

#[cfg(test)]
mod tests {
    use super::*;
    use pulp::Scalar;

    fn one_root(c: &[f64], end: f64) -> f64 {
        let mut padded = [0.0; ROOM];
        padded[..c.len()].copy_from_slice(c);
        single_roots(Scalar::new(), &padded, c.len(), end, true)
    }

    fn root(c: &[f64]) -> f64 {
        one_root(c, c.iter().sum())
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
    fn beside_an_extremum_no_step_is_short() {
        // (x − e)² − d beside e, where Halley's own step would be −2(x − e).
        for beside in [1e-3, 1e-6, 1e-9, -1e-7] {
            let (value, slope, curvature) = (beside * beside - 0.25, 2.0 * beside, 2.0);
            let x = 0.3 + beside;
            assert!((halley(Scalar::new(), x, value, slope, curvature) - x).abs() > 10.0, "{beside}");
        }
    }

    #[test]
    fn a_guess_at_an_extremum_is_no_root() {
        // (x − e)² − d with its only root in [0, 1] beyond e: many have a guess close to e.
        for k in 1..40_000 {
            let e = 0.9 * f64::from(k) / 40_000.0;
            let d = e * e + (1.0 - 2.0 * e).max(0.0) * 0.3 + 1e-3 * f64::from(k % 7);
            if d.sqrt() + e < 1.0 {
                let c = [e * e - d, -2.0 * e, 1.0];
                assert!((root(&c) - e - d.sqrt()).abs() < 1e-14, "{e} {d} {}", root(&c));
            }
        }
    }

    #[test]
    fn a_root_that_rounding_pushes_over_the_end_is_put_there() {
        // The neighbour says that S has changed its sign at 1; the polynomial does not show it.
        let c = [-1.0, 1.0 - 1e-16];
        assert_eq!(one_root(&c, 1e-17), 1.0);
    }
}
