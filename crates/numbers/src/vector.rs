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
    const SAFE: std::ops::Range<f64> = 1e-100..1e100;
    let largest = v.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
    let scale = if SAFE.contains(&largest) { 1.0 } else { largest };
    (largest > 0.0).then(|| normalised(v.map(|x| x / scale)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_have_length_one_whatever_the_length() {
        assert_eq!(direction([0.0; 3]), None);
        for scale in [f64::MIN_POSITIVE, 1.0, 0.25 / f64::MIN_POSITIVE] {
            let [x, y, z] = direction([3.0 * scale, 0.0, -4.0 * scale]).unwrap();
            assert!((x - 0.6).abs() <= f64::EPSILON && y == 0.0 && (z + 0.8).abs() <= f64::EPSILON, "{x} {z}");
        }
        assert_eq!(direction([0.6, 0.8, 0.0]), Some([0.6, 0.8, 0.0]));
        assert_eq!(cross([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]), [0.0, 0.0, 1.0]);
    }
}
