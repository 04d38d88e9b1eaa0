//! Integrators of the Euler–Poisson equations.
//!
//! - [`taylor`]: the default. Taylor series of adaptive order and step, several orbits a SIMD register.
//! - [`Dop853`]: Dormand and Prince's method of order 8 with adaptive step.
//! - [`RungeKutta4`]: the classical method of order 4 with a fixed step.
//! - [`Splitting`]: a composition of exact flows of order 4 with a fixed step; ⟨γ,γ⟩ and ⟨γ,l⟩ to rounding.
//!
//! All of them are [`Stepper`]s and give, for each [`Step`], the motion as a polynomial in x ∈ [0, 1].
//! Nothing here knows of sections.

mod dop853;
mod method;
pub(crate) mod product;
mod runge_kutta;
mod splitting;
mod step;
pub mod taylor;
mod time;

pub use dop853::Dop853;
pub use method::{Method, MethodError};
pub use runge_kutta::RungeKutta4;
pub use splitting::Splitting;
pub use step::{Step, StepError, Stepper};
pub use taylor::Taylor;
pub use time::Instant;
