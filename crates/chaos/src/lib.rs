//! The chaotic share of the components of an energy surface, in Liouville measure, at a point of the (h, l) plane and over it.

mod liouville;
mod map;
mod point;
mod share;

pub use liouville::{EnergySurface, SampleError};
pub use map::{CellShare, Cells, MapError, map_tiles};
pub use point::{PointError, PointShares, point_shares};
pub use share::{Share, ShareError, ShareOptions, shares};
