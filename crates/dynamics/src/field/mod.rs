//! The Euler–Poisson equations in the body's own principal coordinates: γ̇ = γ×ω, l̇ = l×ω − γ×r, ω = A⁻¹l.
//!
//! Vectors of ℝ³ are plain arrays, with the operations of `nalgebra`.

mod further;
mod heavy_top;
mod units;

pub use bifdiag_numbers::vector::{cross, dot, norm};
pub use further::{further_integral, further_scale, keeps_further_integral};
pub use heavy_top::{HeavyTop, Integrals, State};
pub use units::{Dimension, TopUnits};

use nalgebra::Vector3;

/// u + v.
#[must_use]
#[inline]
pub fn add(u: [f64; 3], v: [f64; 3]) -> [f64; 3] {
    (Vector3::from(u) + Vector3::from(v)).into()
}

/// u − v.
#[must_use]
#[inline]
pub fn sub(u: [f64; 3], v: [f64; 3]) -> [f64; 3] {
    (Vector3::from(u) - Vector3::from(v)).into()
}

/// c u.
#[must_use]
#[inline]
pub fn scale(c: f64, u: [f64; 3]) -> [f64; 3] {
    (c * Vector3::from(u)).into()
}

/// u/|u| for any u ≠ 0.
#[must_use]
pub fn unit(u: [f64; 3]) -> [f64; 3] {
    let largest = u.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
    // By a power of two, so that nothing is rounded.
    let exponent = if largest > 0.0 { -libm::ilogb(largest) } else { 0 };
    let scaled = u.map(|x| libm::scalbn(x, exponent));
    scale(1.0 / norm(scaled), scaled)
}
