//! Maps: what each body of a grid or a sample shows, over two parameters, with a legend.

mod colors;
mod draw;
mod legend;
mod marks;
mod model;
mod spots;

pub use draw::draw_map;
pub use model::{Map, MapAxis, MapBodies, MapEntry, MapLine, MapNote};
