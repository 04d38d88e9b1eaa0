//! Motion in time: the Euler–Poisson equations, their integrator, Poincaré sections, chaos, attitude.

pub mod field;
pub mod integrator;
pub mod motion;
pub mod poincare;
pub mod section;
