//! Spectral stability of relative equilibria under the linearised Euler–Poisson flow.
//!
//! At a relative equilibrium (γ, ω = Ωγ, l = AΩγ) the linearised flow on the six-dimensional (γ, l) space has two zero
//! eigenvalues (the Casimirs ⟨γ,γ⟩ and ⟨γ,l⟩); the other four are the roots of λ⁴ + bλ² + c with b and c in closed form
//! ([`Linearisation`]). The eigenvalues of the whole 6×6 matrix are the second path (`whole_spectrum`, with the feature `spectrum`).

mod equilibrium;
mod linearisation;
#[cfg(feature = "spectrum")]
mod spectrum;

pub use equilibrium::RelativeEquilibrium;
pub use linearisation::Linearisation;
#[cfg(feature = "spectrum")]
pub use spectrum::{SpectrumError, whole_matrix, whole_spectrum};

use crate::body::Frame;

/// Spectral type of a relative equilibrium under the linearised Euler–Poisson flow at fixed l.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Stability {
    /// Two imaginary pairs.
    Elliptic,
    /// One real and one imaginary pair.
    SaddleCentre,
    /// Two real pairs.
    Saddle,
    /// A complex quadruple.
    Complex,
    /// An eigenvalue zero or a double pair, within rounding.
    Degenerate,
}

/// A stretch of a curve with one spectral type.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StabilitySpan {
    /// From this l …
    pub l_from: f64,
    /// … to this l; `None`: to infinity.
    pub l_to: Option<f64>,
    /// The type there.
    pub stability: Stability,
}

/// Spectral stability of the relative equilibrium γ at angular velocity Ω ≥ 0, in the frame.
#[must_use]
pub fn stability_of(frame: &Frame, gamma: [f64; 3], omega: f64) -> Stability {
    Linearisation::new(frame, &RelativeEquilibrium::new(frame, gamma, omega)).stability()
}
