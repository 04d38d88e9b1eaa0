//! A point of the plane on curves.

use dashu_ratio::RBig;

use crate::heights::{Heights, Level};
use crate::plane::Plane;

/// The point, and the heights over its x.
pub(crate) struct Vertex<'a> {
    pub plane: &'a Plane<'a>,
    pub heights: &'a Heights<'a>,
    pub h: &'a RBig,
    pub levels: &'a [Level],
}
