//! What every picture is drawn on and with: a page in pixels, its canvas, colours, text, axes, labels, legends and tables.

mod areas;
mod axes;
mod canvas;
mod caption;
mod chart;
mod color;
mod error;
mod formula;
mod geometry;
mod legend;
mod notation;
mod path;
mod perception;
mod picture;
mod places;
mod table;
mod text;
mod tikz;
mod union;

pub(crate) use areas::{Areas, NOTHING, Sums, pixel};
pub(crate) use axes::{Axis, TICK_SIZE, Ticks, draw_axes, ticks};
pub(crate) use canvas::hex;
pub use canvas::{Anchor, Canvas, render};
pub use caption::{Caption, Figure};
pub(crate) use chart::{CHART_TEXT, Chart};
pub(crate) use color::PAPER;
pub use color::{FAINT_INK, INK, Ink, POLE, POLE_MINUS, Theme, rgb, rgbs};
pub use error::PlotError;
pub(crate) use formula::letter;
pub(crate) use geometry::{HEIGHT, between, clip_polygon, clip_polyline, distance, is_proper, meets, to_units};
pub use geometry::{Point, Rect, Width};
pub use legend::Rows;
pub(crate) use legend::{Legend, Symbol};
pub use notation::{body_line, section_type, superscript, value_text};
pub(crate) use notation::{number, short, short_number, short_time};
pub(crate) use path::{Dash, Path};
#[cfg(test)]
pub(crate) use perception::{contrast, sight};
pub(crate) use picture::png;
pub use picture::{Heading, Picture, Pixels};
pub(crate) use places::{Labelled, Taken, all_over, round_point};
pub(crate) use table::Table;
pub use text::text_width;
pub(crate) use text::{lines, title_size, widest};
pub(crate) use union::{outlines, union};
