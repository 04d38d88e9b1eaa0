//! The sequence from which designs are drawn.

pub use crate::numerics::sequence::{DIMENSIONS_MAX, point};
