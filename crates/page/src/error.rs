//! What can go wrong.

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
    /// The atlas has no drawing.
    #[error("the atlas has no drawing, and no window was given")]
    NoDrawing,
    /// The document does not say which curves lie above each other, or covers only a part of the plane; or doubles do not tell
    /// the curves apart.
    #[error(
        "the straightened plane needs all regions of the whole plane, with curves that doubles tell apart: --view plane \
         draws what there is"
    )]
    NotStraight,
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
    Backend(#[from] plotters::drawing::DrawingAreaErrorKind<std::convert::Infallible>),
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
    Png(#[from] png::EncodingError),
    /// PDF is asked of a build without the feature `pdf`.
    #[error(
        "PDF needs the feature `pdf`, which released programs and wheels have: build with \
         `cargo install --path . --features pdf`, or use svg, png or tikz"
    )]
    NoPdf,
    /// TikZ was requested for a picture whose points are so many that they are drawn as an image.
    #[error("TikZ holds no images, as which many points are drawn: use svg, png or pdf, or fewer crossings")]
    TikzImage,
    /// A PDF page cannot have the picture's size.
    #[error("a page of {width} × {height} points cannot be made")]
    Page {
        /// Width in points.
        width: f32,
        /// Height in points.
        height: f32,
    },
    /// The PDF could not be written.
    #[error("the PDF could not be written")]
    Pdf(#[source] Box<dyn std::error::Error + Send + Sync>),
}
