//! Real parts as engineers have them: a tensor of inertia with its reference point and its sign convention, a centre of
//! mass, a mass, units; knows nothing of diagrams.
//!
//! All arithmetic is rational: a thin rod twenty metres from the pivot stays a rod.

mod existence;
#[cfg(feature = "files")]
pub mod file;
#[cfg(feature = "files")]
pub mod link;
mod mass;
mod measured;
#[cfg(feature = "files")]
pub mod mesh;
mod products;
mod spin;
mod units;

pub use existence::{Existence, Inequality};
pub use mass::{MassError, MassProperties, Part};
pub use measured::{INPUT_NAMES, INPUTS, Measured, MeasuredPart};
pub use products::{Products, tensor_of};
pub use spin::{Spin, SpinError, SpinUnit};
pub use units::{Units, UnitsError};
