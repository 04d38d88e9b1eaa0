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
mod picture;
mod rows;
mod ticks;

pub(crate) use axes::{Axis, TICK_SIZE, draw_axes};
pub(crate) use canvas::{Anchor, Canvas, Page, render};
pub use error::PlotError;
pub(crate) use font::text_width;
pub(crate) use geometry::{Point, Rect, clip_polygon, clip_polyline, distance, is_proper, to_units};
pub(crate) use image::png;
pub(crate) use ink::{FAINT_INK, INK, Ink, PAPER, POLE, rgb, rgbs};
pub(crate) use legend::Legend;
pub(crate) use notation::{body, number, short, subscript, superscript};
pub(crate) use path::{Path, hex, stroke};
pub(crate) use pattern::Pattern;
pub use picture::Picture;
pub(crate) use rows::Rows;
pub(crate) use ticks::ticks;
