//! How regular an orbit is: a finite-time Lyapunov exponent and a rotation number, each with its convergence, and a
//! verdict.

mod averages;
mod course;
mod curve;
mod decision;
mod growth;
mod ladder;
mod lyapunov;
mod measure;
mod rotation;
mod verdict;

pub use course::Decision;
pub use decision::{DecisionOptions, decisions};
pub use growth::{Growth, Lyapunov, TangentCourse};
pub use lyapunov::{ChaosOptions, growths, lyapunov_exponents};
pub use measure::{ChaosMeasure, chaos_measures, verdicts};
pub use rotation::{RotationAngle, RotationNumber, RotationUndefined, rotation_number};
pub use verdict::{Evidence, Judgement, OpenReason, OrbitVerdict, UNIT};
