//! Vectors of ℝ³ as plain arrays.

/// ⟨u, v⟩.
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

/// u + v.
#[must_use]
#[inline]
pub fn add(u: [f64; 3], v: [f64; 3]) -> [f64; 3] {
    [u[0] + v[0], u[1] + v[1], u[2] + v[2]]
}

/// u − v.
#[must_use]
#[inline]
pub fn sub(u: [f64; 3], v: [f64; 3]) -> [f64; 3] {
    [u[0] - v[0], u[1] - v[1], u[2] - v[2]]
}

/// c u.
#[must_use]
#[inline]
pub fn scale(c: f64, u: [f64; 3]) -> [f64; 3] {
    [c * u[0], c * u[1], c * u[2]]
}

/// |u|, for magnitudes whose squares neither overflow nor underflow.
#[must_use]
#[inline]
pub fn norm(u: [f64; 3]) -> f64 {
    dot(u, u).sqrt()
}
