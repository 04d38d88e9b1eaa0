//! How regular an orbit is: a finite-time Lyapunov exponent and a rotation number, each with its convergence, and a
//! verdict.

mod average;
mod curve;
mod direction;
mod evidence;
mod growth;
mod judgement;
mod ladder;
mod lyapunov;
mod measure;
mod passed;
mod plane;
mod rotation;
mod stretching;
mod verdict;
mod window;

pub use evidence::Evidence;
pub use growth::{Course, Growth, Lyapunov};
pub use judgement::Judgement;
pub use lyapunov::{ChaosOptions, growths, lyapunov_exponents};
pub use measure::{ChaosMeasure, chaos_measures, verdicts};
pub use rotation::{Rotation, RotationAngle, RotationUndefined, rotation_number};
pub use verdict::{Open, UNIT, Verdict};
