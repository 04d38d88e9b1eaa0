//! Relative equilibria in closed form: every critical curve of a body and both pole lines (docs/mathematics.md,
//! sections 3 to 6).
//!
//! Works in x = l²/2, in which U_l(γ) = x/J(γ) − ⟨γ, r⟩ is linear for each γ.

mod arc;
mod critical_set;
mod curve;
mod curve_point;
mod cusps;
mod families;
mod generic_curves;
mod index;
mod name;
mod special_curves;

pub use arc::{Arc, Asymptote, Segment, Shape};
pub use critical_set::{CriticalSet, Cusp, CuspCluster, EquilibriaError, Pitchfork};
pub use curve::{Branch, ClusterId, Curve, CurveId, CuspId, End, IntervalId, Orbit, PitchforkId, Pole};
pub use curve_point::{Gap, MomentumError, Point, X_ROUNDINGS, abscissa};
pub use cusps::{CuspPair, MuInterval, cusp_at_pitchfork, cusp_pairs};
pub use families::{GenericState, Mu, SymmetricFamily, SymmetricState};
pub use name::{BranchName, CurveName, ParseCurveNameError, branch_words};
