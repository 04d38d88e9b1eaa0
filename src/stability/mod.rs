//! Spectral stability of relative equilibria under the linearised Euler–Poisson flow.
//!
//! At a relative equilibrium (γ, ω = Ωγ, l = AΩγ) the linearised flow on the six-dimensional (γ, l) space has two zero
//! eigenvalues (the Casimirs ⟨γ,γ⟩ and ⟨γ,l⟩); the other four are the roots of λ⁴ + bλ² + c with b and c in closed form
//! ([`Linearisation`]). The eigenvalues of the whole 6×6 matrix are the second path ([`whole_spectrum`]).

mod equilibrium;
mod linearisation;
mod spectrum;

pub use equilibrium::RelativeEquilibrium;
pub use linearisation::Linearisation;
pub use spectrum::{SpectrumError, whole_matrix, whole_spectrum};

use crate::body::Frame;
use crate::document::Stability;

/// Spectral stability of the relative equilibrium γ at angular velocity Ω ≥ 0, in the frame.
#[must_use]
pub fn stability_of(frame: &Frame, gamma: [f64; 3], omega: f64) -> Stability {
    Linearisation::new(frame, &RelativeEquilibrium::new(frame, gamma, omega)).stability()
}
