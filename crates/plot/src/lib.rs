//! Pictures of finished results: the bifurcation diagram of an atlas and Poincaré sections, as SVG, PNG and PDF.
//!
//! What is drawn of an atlas comes from [`schema`] alone; nothing is computed here that an atlas does not say already.
//! The pieces, in the order in which the data flows: a `scene` resolves the ids of the document, `trace` gives each
//! curve as a polyline fit for one window, a `grid` is the coarse picture of one panel from which sizes and label
//! places are read, `window` and `insets` choose the panels, `layout` puts them on the page, `labels` places the text,
//! `diagram` draws it all on a `canvas`, and the result is a [`Picture`]. Sections have their own folder, and share the
//! canvas, the font and the colours of text.

mod axes;
mod canvas;
mod chart;
mod diagram;
mod font;
mod geometry;
mod grid;
mod insets;
mod labels;
mod layout;
mod legend;
mod map;
mod notation;
mod notes;
mod palette;
mod panel;
mod picture;
mod scene;
mod schematic;
mod section;
mod stroke;
mod ticks;
mod trace;
mod window;

pub use chart::{Chart, ChartAxis, ChartPanel, Scale, Series, draw_chart};
pub use diagram::draw;
pub use map::{Map, MapAxis, MapBodies, MapEntry, MapLine, MapNote, draw_map};
pub use picture::Picture;
pub use schematic::{Scheme, draw_scheme};
pub use section::{OrbitValues, Projection, SectionOptions, SectionScene, draw_section, draw_section_rows};
pub use trace::CurveSource;

use schema::WindowDocument;

/// How a diagram is drawn.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DiagramOptions {
    /// The part of the (h, l) plane of the main panel; `None`: chosen so that every event and every unbounded region
    /// is inside.
    pub window: Option<WindowDocument>,
}

/// Why a picture could not be made.
#[derive(Debug, thiserror::Error)]
pub enum PlotError {
    /// The document names a curve that it does not contain.
    #[error("region {region} lies along curve {curve}, which the atlas does not contain")]
    UnknownCurve {
        /// Id of the region.
        region: String,
        /// Id of the missing curve.
        curve: String,
    },
    /// A curve has neither a polyline nor a source of one.
    #[error("curve {curve} has no polyline to draw")]
    NoPolyline {
        /// Id of the curve.
        curve: String,
    },
    /// The window is empty or not finite.
    #[error("the window h {h:?}, l {l:?} is empty or not finite: both need a lower end below the upper end")]
    EmptyWindow {
        /// Energies.
        h: [f64; 2],
        /// Vertical angular momenta.
        l: [f64; 2],
    },
    /// The built-in font could not be read.
    #[error("the built-in font could not be read")]
    Font,
    /// The drawing library failed.
    #[error("the picture could not be drawn")]
    Backend(#[from] plotters::drawing::DrawingAreaErrorKind<std::io::Error>),
    /// The SVG could not be read back for conversion.
    #[error("the SVG could not be read for conversion")]
    Svg(#[from] resvg::usvg::Error),
    /// The resolution gives a picture of no pixels, or of more than can be held.
    #[error("a resolution of {dpi} dpi gives no usable picture size")]
    Resolution {
        /// Dots per inch.
        dpi: f64,
    },
    /// There is nothing to draw, or more than a page can hold.
    #[error("a picture needs between 1 and {most} sections, not {given}")]
    Scenes {
        /// How many there are.
        given: usize,
        /// The most.
        most: usize,
    },
    /// There is not one value for each orbit.
    #[error("{values} values of {label} for {orbits} orbits: one for each orbit is needed")]
    Values {
        /// What the values are.
        label: String,
        /// Values given.
        values: usize,
        /// Orbits of the scene.
        orbits: usize,
    },
    /// The PNG could not be encoded.
    #[error("the PNG could not be encoded")]
    Png(#[source] Box<dyn std::error::Error + Send + Sync>),
    /// The picture's size is none that a PDF page can have.
    #[error("a page of {width} × {height} points cannot be made")]
    Page {
        /// Width in points.
        width: f32,
        /// Height in points.
        height: f32,
    },
    /// The PDF could not be written.
    #[error("the PDF could not be written")]
    Pdf(#[from] krilla::error::KrillaError),
}
