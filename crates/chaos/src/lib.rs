//! The chaotic share of the components of an energy surface, in Liouville measure.

mod liouville;
mod share;

pub use liouville::{EnergySurface, SampleError};
pub use share::{Share, ShareError, ShareOptions, shares};
