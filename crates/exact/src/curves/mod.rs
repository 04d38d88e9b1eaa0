//! Every critical curve and pole line, cut at cusps and pitchforks, from exactly isolated roots.

mod build;
mod curve;
mod generic;
mod list;
mod place;
mod special;
#[cfg(test)]
mod tests;

pub(crate) use curve::{Bound, Curve, Segment, Shape};
pub(crate) use list::Curves;

pub(crate) use place::{NotIsolated, Place, ROOT_BITS, order, passive_place, roots_in_interval};
