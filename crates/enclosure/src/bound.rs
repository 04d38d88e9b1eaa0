//! Upper bounds in doubles.
//!
//! A sum of products of n numbers that are not negative is computed with a relative error below 2n roundings, and each
//! product that underflows adds less than 1e-307. [`up`] covers n up to 10⁵, which no bound here comes near.

/// What a number is enlarged by, relative and absolute.
const SLACK: f64 = 1.0 + 1e-10;
const TINIEST: f64 = 1e-300;

/// A bound for what was computed from numbers that are not negative with fewer than 10⁵ operations; infinite for NaN.
#[must_use]
#[inline]
pub fn up(x: f64) -> f64 {
    let bound = x * SLACK + TINIEST;
    if bound.is_nan() { f64::INFINITY } else { bound }
}

/// A bound for eˣ, 0 ≤ x: (1 − x/16)⁻¹⁶; infinite from x = 16 on.
#[must_use]
pub fn exp(x: f64) -> f64 {
    let base = 1.0 - up(x) / 16.0;
    if base > 0.0 {
        let mut power = up(1.0 / base);
        for _ in 0..4 {
            power *= power;
        }
        up(power)
    } else {
        f64::INFINITY
    }
}

/// A bound for the Euclidean length of a vector.
#[must_use]
#[inline]
pub fn norm<const N: usize>(v: &[f64; N]) -> f64 {
    up(v.iter().map(|x| x * x).sum::<f64>().sqrt())
}

/// A bound for the Frobenius norm of a matrix.
#[must_use]
pub fn frobenius<const N: usize>(matrix: &[[f64; N]; N]) -> f64 {
    up(matrix.as_flattened().iter().map(|x| x * x).sum::<f64>().sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_exponential_is_bounded_from_above_and_closely() {
        for k in 0..300 {
            let x = f64::from(k) / 100.0;
            assert!(exp(x) >= libm::exp(x) && exp(x) <= libm::exp(x) * (1.0 + 0.05 * x * x + 1e-8), "{x}");
        }
        assert_eq!(exp(17.0), f64::INFINITY);
        assert_eq!(up(f64::NAN), f64::INFINITY);
    }
}
