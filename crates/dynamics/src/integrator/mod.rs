//! The integrator of the Euler–Poisson equations: Taylor series of adaptive order and step, several orbits a SIMD register.
//!
//! For one orbit, [`Taylor`] gives each [`Step`] as a polynomial in x ∈ [0, 1]. Nothing here knows of sections.

pub(crate) mod product;
mod step;
pub mod taylor;
mod time;

pub use step::{Step, StepError};
pub use taylor::{DEFAULT_TOLERANCE, Taylor, ToleranceError, check_tolerance};
pub use time::Instant;
