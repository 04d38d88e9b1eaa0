//! The integrator of the Euler–Poisson equations: Taylor series of adaptive order and step, several orbits a SIMD register.
//!
//! For one orbit, [`Taylor`] gives each [`TaylorStep`] as a polynomial in x ∈ [0, 1]. Nothing here knows of sections.

pub(crate) mod product;
mod step;
pub mod taylor;

pub use step::{Instant, StepError, TaylorStep};
pub use taylor::{DEFAULT_TOLERANCE, Taylor, ToleranceError, Transport, check_tolerance, transport};
