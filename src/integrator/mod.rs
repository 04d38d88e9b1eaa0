//! Integrators of the Euler–Poisson equations.
//!
//! - [`taylor`]: the default. Taylor series of adaptive order and step, several orbits a SIMD register.
//!
//! Nothing here knows of sections: an integrator gives states and, within each step, a polynomial.

pub mod taylor;
mod time;

pub use time::Instant;
