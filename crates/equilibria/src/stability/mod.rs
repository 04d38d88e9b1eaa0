//! Stability of relative equilibria under the Euler–Poisson flow at fixed l (docs/mathematics.md, section 13).
//!
//! At a relative equilibrium (γ, ω = Ωγ, l = AΩγ) the linearised flow on the six-dimensional (γ, l) space has two zero
//! eigenvalues (the Casimirs ⟨γ,γ⟩ and ⟨γ,l⟩); the other four are the roots of λ⁴ + bλ² + c with b and c in closed form
//! ([`Reduced`]). An equilibrium that f64 found is enclosed ([`Place`]), and so are the changes of type along the curves
//! ([`LinearTypes`]); where intervals leave something open integer polynomials decide ([`exact`]). The eigenvalues of the
//! whole 6×6 matrix are the second way, in the tests.

mod along;
mod changes;
mod collisions;
pub mod exact;
mod linear_type;
mod reduced;
mod state;

pub use along::LinearTypes;
pub use bifdiag_schema::StabilityChangeKind;
pub use changes::{StabilityChange, StabilitySpan};
pub use linear_type::{LinearType, Signs};
pub use reduced::{Eigenvalues, RESONANCES, Reduced};
pub use state::{Constants, Place, State};
