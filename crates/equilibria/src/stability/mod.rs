//! Stability of relative equilibria under the Euler–Poisson flow at fixed l (docs/mathematics.md, section 13).
//!
//! At a relative equilibrium (γ, ω = Ωγ, l = AΩγ) the linearised flow on the six-dimensional (γ, l) space has two zero
//! eigenvalues (the Casimirs ⟨γ,γ⟩ and ⟨γ,l⟩); the other four are the roots of λ⁴ + bλ² + c with b and c in closed form
//! ([`Reduced`]). An equilibrium that f64 found is enclosed ([`Place`]), and so are the changes of type along the curves
//! ([`LinearTypes`]); where intervals leave something open integer polynomials decide ([`StabilityProfile`]). The eigenvalues of the
//! whole 6×6 matrix are the second way (`whole_spectrum`, with the feature `spectrum`).

mod along;
mod changes;
mod collisions;
mod constants;
mod enclosed;
mod equilibrium;
pub mod exact;
mod hessian;
mod kind;
mod reduced;
#[cfg(feature = "spectrum")]
mod spectrum;
mod state;

pub use along::LinearTypes;
pub use changes::{ChangeKind, StabilityChange, StabilityProfile};
pub use constants::Constants;
pub use enclosed::Place;
pub use equilibrium::RelativeEquilibrium;
pub use hessian::Hessian;
pub use kind::{LinearType, Setting, Signs, Verdict};
pub use reduced::{Eigenvalues, Reduced};
#[cfg(feature = "spectrum")]
pub use spectrum::{SpectrumError, whole_matrix, whole_spectrum};
pub use state::State;

/// A stretch of a curve with one spectral type.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StabilitySpan {
    /// From this l …
    pub l_from: f64,
    /// … to this l; `None`: to infinity.
    pub l_to: Option<f64>,
    /// The type there.
    pub stability: LinearType,
}
