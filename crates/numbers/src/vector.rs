//! Vectors of ℝ³ in doubles.

/// ⟨u, v⟩ = (u₁v₁ + u₂v₂) + u₃v₃.
#[must_use]
#[inline]
pub fn dot(u: [f64; 3], v: [f64; 3]) -> f64 {
    u[0] * v[0] + u[1] * v[1] + u[2] * v[2]
}

/// u × v.
#[must_use]
#[inline]
pub fn cross(u: [f64; 3], v: [f64; 3]) -> [f64; 3] {
    [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
}

/// |v|, for a vector whose square neither overflows nor underflows.
#[must_use]
#[inline]
pub fn norm(v: [f64; 3]) -> f64 {
    dot(v, v).sqrt()
}

/// v/|v|, likewise; NaN for 0.
#[must_use]
#[inline]
pub fn normalised(v: [f64; 3]) -> [f64; 3] {
    let norm = norm(v);
    v.map(|x| x / norm)
}

/// v/|v| of a vector of any length; `None` for 0.
#[must_use]
pub fn direction(v: [f64; 3]) -> Option<[f64; 3]> {
    let largest = v.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
    (largest > 0.0).then(|| normalised(v.map(|x| x / largest)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_have_length_one_whatever_the_length() {
        assert_eq!(direction([0.0; 3]), None);
        for scale in [f64::MIN_POSITIVE, 1.0, 0.25 / f64::MIN_POSITIVE] {
            assert_eq!(direction([3.0 * scale, 0.0, -4.0 * scale]), Some([0.75 / 1.25, 0.0, -1.0 / 1.25]));
        }
        assert_eq!(cross([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]), [0.0, 0.0, 1.0]);
    }
}
