//! The abscissa x = l²/2 of an angular momentum, in the frame's units.

use bifdiag_body::Frame;
use thiserror::Error;

/// An angular momentum at which `f64` cannot compute.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error("l = {l:e} is too {} for this body in f64; |l| between {smallest:e} and {largest:e}, or 0, is possible", if *.l < *.smallest { "small" } else { "large" })]
pub struct MomentumError {
    /// |l| as asked for.
    pub l: f64,
    /// Smallest |l| > 0.
    pub smallest: f64,
    /// Largest |l|.
    pub largest: f64,
}

/// Roundings of x = l²/2 relative to its exact value: l itself, the square.
pub const X_ROUNDINGS: f64 = 4.0;

/// x = l²/2 in the frame's units.
///
/// # Errors
/// [`MomentumError`] when squares and cubes of x would leave the range of `f64`.
#[inline]
pub fn abscissa(frame: &Frame, l: f64) -> Result<f64, MomentumError> {
    const LIMIT: f64 = 1e45;
    let scaled = l.abs() / frame.momentum_unit;
    if scaled == 0.0 || (1.0 / LIMIT..=LIMIT).contains(&scaled) {
        Ok(0.5 * scaled * scaled)
    } else {
        let unit = frame.momentum_unit;
        Err(MomentumError { l: l.abs(), smallest: unit / LIMIT, largest: unit * LIMIT })
    }
}
