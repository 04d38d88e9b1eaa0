//! Relative equilibria in closed form: every critical curve of a body and both pole lines (docs/mathematics.md,
//! sections 3 to 6).
//!
//! Works in x = l²/2, in which U_l(γ) = x/J(γ) − ⟨γ, r⟩ is linear for each γ.

mod abscissa;
mod arc;
mod asymptote;
mod at_momentum;
mod critical_set;
mod curve;
mod cusps;
mod generic;
mod generic_curves;
mod id;
mod index;
mod name;
mod point;
mod special_curves;
mod symmetric;

pub use abscissa::{MomentumError, X_ROUNDINGS, abscissa};
pub use arc::{Arc, Segment, Shape};
pub use asymptote::Asymptote;
pub use at_momentum::{EquilibriaAt, RelativeEquilibrium};
pub use critical_set::{CriticalSet, Cusp, CuspCluster, EquilibriaError, Pitchfork};
pub use curve::{Branch, Curve, End, Orbit, Pole};
pub use cusps::MuInterval;
pub use generic::{GenericState, Mu};
pub use id::{ClusterId, CurveId, CuspId, IntervalId, PitchforkId};
pub use name::{BranchName, CurveName, ParseCurveNameError, branch_words};
pub use point::{Gap, Point};
pub use symmetric::{SymmetricFamily, SymmetricState};
