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
    length(v)
}

/// A bound for the Frobenius norm of a matrix.
#[must_use]
#[inline]
pub fn frobenius<const N: usize>(matrix: &[[f64; N]; N]) -> f64 {
    length(matrix.as_flattened())
}

/// Squares below this may have lost digits, or all of them.
const SMALL: f64 = 1e-280;

#[inline]
fn length(v: &[f64]) -> f64 {
    let square = v.iter().map(|x| x * x).sum::<f64>();
    if square < SMALL {
        // Not by squares.
        return up(v.iter().map(|x| x.abs()).sum());
    }
    up(square.sqrt())
}

/// A bound for the largest absolute value of the eigenvalues of a symmetric matrix M: ‖M⁸‖ to the power 1/8, in the
/// Frobenius norm, which is at most N to the power 1/16 too large.
#[must_use]
pub fn spectral<const N: usize>(matrix: &[[f64; N]; N]) -> f64 {
    let mut bound = 1.0;
    let mut power = *matrix;
    // ‖M‖ = s, ‖M²/s²‖ = s′, …: the bound is s √(s′ √…). Each square of a matrix of norm 1 has a norm of at least 1/N.
    let mut sizes = [0.0; 4];
    for size in &mut sizes {
        *size = frobenius(&power);
        if *size == 0.0 || !size.is_finite() {
            return *size;
        }
        let unit = power.map(|row| row.map(|x| x / *size));
        for i in 0..N {
            for j in 0..N {
                power[i][j] = (0..N).map(|m| unit[i][m] * unit[m][j]).sum();
            }
        }
    }
    for size in sizes.iter().rev() {
        bound = size * f64::sqrt(bound);
    }
    up(bound)
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
    /// Also where squares vanish.
    #[test]
    fn lengths_of_tiny_vectors_are_bounded() {
        for size in [1e-250, 1e-170, 1e-150, 1e-130, 1e-3] {
            let bound = norm(&[3.0 * size, 4.0 * size]);
            assert!(bound >= 5.0 * size && bound <= 7.0 * size * (1.0 + 1e-9), "{size} {bound}");
            assert!(frobenius(&[[3.0 * size, 0.0], [0.0, 4.0 * size]]) >= 5.0 * size);
        }
    }

    #[test]
    fn the_spectral_bound_is_above_the_largest_eigenvalue_and_close() {
        // Eigenvalues 3 and -1, 5, and 4 and -6.
        for (matrix, largest) in
            [([[1.0, 2.0], [2.0, 1.0]], 3.0), ([[5.0, 0.0], [0.0, 5.0]], 5.0), ([[-1.0, 5.0], [5.0, -1.0]], 6.0)]
        {
            let bound = spectral(&matrix);
            assert!(bound >= largest && bound < 1.1 * largest, "{bound} {largest}");
        }
        assert!(spectral(&[[0.0; 3]; 3]) < 1e-200);
    }
}
