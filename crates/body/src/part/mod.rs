//! Real parts as engineers have them: a tensor of inertia with its reference point and its sign convention, a centre of
//! mass, a mass, units; knows nothing of diagrams.
//!
//! All arithmetic is rational: a thin rod twenty metres from the pivot stays a rod.

#[cfg(feature = "files")]
pub mod file;
#[cfg(feature = "files")]
pub mod link;
mod mass;
mod measured;
#[cfg(feature = "files")]
pub mod mesh;
mod quantity;
mod units;

pub use mass::{Existence, Inequality, MassError, MassProperties, Part, Products, tensor_of};
pub use measured::{INPUTS, Measured, MeasuredPart};
pub use quantity::{Dimension, Quantity, QuantityError, Unit};
pub use units::{Spin, SpinError, SpinUnit, Units, UnitsError};
