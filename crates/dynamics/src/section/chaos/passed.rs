//! A step that an orbit has gone.

use crate::integrator::taylor::MOMENTS;

/// What one step of an orbit and its tangent vector is like.
pub(super) struct Passed {
    /// Time at its end.
    pub time: f64,
    /// Its length.
    pub length: f64,
    /// |δ|² there.
    pub length_squared: f64,
    /// δ is then scaled by 2^−power.
    pub power: i32,
    /// Of γ: ∫ (ξ − 1/2)ʲ γ dt over it, ξ from 0 to 1.
    pub moments: [[f64; 3]; MOMENTS],
}

impl Passed {
    /// The time in its middle.
    pub fn middle(&self) -> f64 {
        self.time - 0.5 * self.length
    }
}
