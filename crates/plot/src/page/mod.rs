//! What every picture is drawn on and with: a page in pixels, its canvas, colours, text, axes and legends.

mod axes;
mod canvas;
mod error;
mod font;
mod geometry;
mod image;
mod ink;
mod legend;
mod notation;
mod path;
pub(crate) mod pattern;
mod pdf;
mod perception;
mod picture;
mod rows;
mod space;
mod stripes;
mod table;
mod tex;
mod theme;
mod ticks;
mod tikz;
mod width;

pub(crate) use axes::{Axis, TICK_SIZE, draw_axes};
pub(crate) use canvas::{Anchor, Canvas, render};
pub use error::PlotError;
pub(crate) use font::{text_width, title_size};
pub(crate) use geometry::{
    Point, Rect, between, clip_polygon, clip_polyline, distance, is_proper, meets, to_pixels, to_units,
};
pub(crate) use image::png;
pub(crate) use ink::{FAINT_INK, INK, Ink, PAPER, POLE, rgb, rgbs};
pub(crate) use legend::Legend;
pub use notation::section_type;
pub(crate) use notation::{body_line, number, short, short_number, short_time, superscript};
pub(crate) use path::Path;
pub(crate) use pattern::Pattern;
#[cfg(test)]
pub(crate) use perception::{contrast, sight};
pub(crate) use picture::Heading;
pub use picture::Picture;
pub(crate) use rows::{Rows, lines};
pub(crate) use space::Taken;
pub(crate) use stripes::Stripes;
pub(crate) use table::Table;
pub use theme::Theme;
pub(crate) use ticks::{Ticks, ticks};
pub(crate) use width::HEIGHT;
pub use width::Width;
