//! How regular an orbit is: a finite-time Lyapunov exponent and a rotation number, each with its convergence.

mod average;
mod curve;
mod direction;
mod lyapunov;
mod measure;
mod plane;
mod rotation;

pub use lyapunov::{ChaosOptions, Lyapunov, lyapunov_exponents};
pub use measure::{ChaosMeasure, chaos_measures};
pub use rotation::{Rotation, RotationAngle, RotationUndefined, rotation_number};
