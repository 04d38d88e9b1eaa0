//! How regular an orbit is: a finite-time Lyapunov exponent and a rotation number, each with its convergence, and a
//! verdict.

mod average;
mod curve;
mod direction;
mod growth;
mod lyapunov;
mod measure;
mod plane;
mod rotation;
mod stretching;
mod verdict;

pub use growth::{Course, Growth, Lyapunov, Sample};
pub use lyapunov::{ChaosOptions, growths, lyapunov_exponents};
pub use measure::{ChaosMeasure, chaos_measures};
pub use rotation::{Rotation, RotationAngle, RotationUndefined, rotation_number};
pub use verdict::{Evidence, Judgement, Open, Verdict, judge};
