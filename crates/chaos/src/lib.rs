//! The chaotic share of the components of an energy surface, in Liouville measure, at a point of the (h, l) plane and over it.

mod block;
mod cells;
mod liouville;
mod map;
mod point_shares;
mod share;

pub use block::CellShare;
pub use cells::Cells;
pub use liouville::{EnergySurface, SampleError};
pub use map::{MapError, map_tiles};
pub use point_shares::{PointError, PointShares, point_shares};
pub use share::{Share, ShareError, ShareOptions, shares};
