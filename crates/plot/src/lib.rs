//! Pictures of finished results: the bifurcation diagram of an atlas and Poincaré sections, as SVG, PNG and PDF.
//!
//! What is drawn of an atlas comes from [`crate::document`] alone; nothing is computed here that an atlas does not say already.
//! The pieces, in the order in which the data flows: a `scene` resolves the ids of the document, `trace` gives each
//! curve as a polyline fit for one window, a `grid` is the coarse picture of one panel from which sizes and label
//! places are read, `window` and `insets` choose the panels, `layout` puts them on the page, `labels` places the text,
//! `diagram` draws it all on a `canvas`, and the result is a [`Picture`]. Sections have their own folder, and share the
//! canvas, the font and the colours of text.

mod axes;
mod canvas;
mod chart;
mod closeup;
mod diagram;
mod error;
mod font;
mod geometry;
mod grid;
mod image;
mod ink;
mod insets;
mod labels;
mod layout;
mod legend;
mod map;
mod markers;
mod notation;
mod notes;
mod paint;
mod palette;
mod panel;
mod pattern;
mod pdf;
mod picture;
mod placement;
mod ranges;
mod rows;
mod scene;
mod schematic;
mod section;
mod space;
mod stroke;
mod ticks;
mod trace;
mod view;
mod window;

pub use chart::{Chart, ChartAxis, ChartPanel, Scale, Series, draw_chart};
pub use diagram::{DiagramOptions, draw};
pub use error::PlotError;
pub use map::{Map, MapAxis, MapBodies, MapEntry, MapLine, MapNote, draw_map};
pub use picture::Picture;
pub use scene::CurveSource;
pub use schematic::{Scheme, draw_scheme};
pub use section::{OrbitValues, Projection, SectionOptions, SectionScene, draw_section, draw_section_rows};
