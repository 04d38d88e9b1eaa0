//! The plane straightened: l to the right, h upwards, the lowest curve level. Each stretch between neighbouring event momenta
//! has a share of the width and each region one of the height, so that nearly all of them can be labelled inside. At every l
//! the map rises with h, so that regions keep their neighbours; between two curves it is linear, above the highest it
//! extends to infinity.

mod axes;
mod columns;
mod fit;
mod plane;
mod shares;
mod strata;

pub use super::labels::Boxes as LabelBoxes;
pub(super) use axes::{Tick, half_width};
pub use columns::StraightColumn;
pub(super) use fit::straighten;
pub(super) use plane::Straight;
pub use shares::Shares as StraightShares;
