//! The classes of all regions that meet at a point on curves (Proposition 8.6 of docs/algorithms.md).
//!
//! Over the point's own x these are the cells just below and above it. Over x ∓ δ they are those between the curves that
//! pass through the point: `strip` bounds δ so that no other curve comes near, `fan` proves that the curves through the
//! point do not meet on the way, and where it cannot, δ is made smaller.

mod candidates;
mod fan;
mod strip;

pub(crate) use candidates::{Cell, candidates, cells, room};
pub(crate) use fan::Vertex;
pub(crate) use strip::reach;
