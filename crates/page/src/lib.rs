//! What every picture is drawn on and with: a page in pixels, its canvas, colours, text, axes, labels, legends and tables.
//! It knows nothing of what it shows; SVG, PNG, TikZ and, with the feature `pdf`, PDF come out.

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
pub mod sight;
mod table;
mod text;
mod tikz;
mod union;

pub use areas::{Areas, NOTHING, Sums, pixel};
pub use axes::{Axis, TICK_SIZE, Ticks, draw_axes, ticks};
pub use canvas::{Anchor, Canvas, hex, render};
pub use caption::{Caption, Figure, color_name};
pub use chart::{CHART_TEXT, Chart};
pub use color::{FAINT_INK, INK, Ink, PAPER, POLE, POLE_MINUS, Theme, rgb, rgbs};
pub use error::PlotError;
pub use formula::letter;
pub use geometry::{
    HEIGHT, Point, Rect, Width, between, clip_polygon, clip_polyline, distance, is_proper, meets, to_units,
};
pub use legend::{Legend, Rows, Symbol};
pub use notation::{body_line, number, section_type, short, short_number, short_time, superscript, value_text};
pub use path::{Dash, Path};
pub use perception::contrast;
pub use picture::{Heading, Picture, Pixels, png};
pub use places::{Labelled, Taken, all_over, round_point};
pub use table::Table;
pub use text::{lines, text_width, title_size, widest};
pub use union::{outlines, union};
