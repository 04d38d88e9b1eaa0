//! Every critical curve and pole line, cut at cusps and pitchforks, from exactly isolated roots.

mod curve;
mod generic;
mod place;
mod special;
#[cfg(test)]
mod tests;

pub(crate) use curve::{Bound, Curve, Curves, Segment, Shape};
pub(crate) use place::{IsolationError, Place, ROOT_BITS, order, passive_place, roots_in_interval};
