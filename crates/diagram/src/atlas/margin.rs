//! How far a point is from the nearest curve.

use bifdiag_equilibria::curves::CurveName;

/// Distance in h to the nearest curve, and how much of it can be trusted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Margin {
    /// |h − h_c| to the nearest critical curve or pole line at this l.
    pub h: f64,
    /// That curve; `None` when no curve was computed.
    pub nearest: Option<CurveName>,
    /// Bound on the error of `h`.
    pub error_bound: f64,
}
