//! What only pictures need: polylines, outlines of regions, windows and widths. No answer depends on it.

mod outline;
mod polyline;
mod view;
mod width;

pub use outline::Outline;
pub use polyline::{PolylineOptions, Tail};
pub use view::{SamplePoint, View, Window};
