//! A finished picture and its file formats.

use std::fmt::Display;

use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree};

use super::error::PlotError;
use super::geometry::UNITS;
use super::width::POINTS;
use super::{font, image, pdf, tikz};

/// Pixels of an SVG in an inch (CSS).
const PIXELS_PER_INCH: f64 = 96.0;

/// The largest PNG side that is drawn.
const PIXELS_MAX: f64 = 30_000.0;

/// A vector picture; PNG and PDF are made from its SVG. Equal input gives equal bytes in every format.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// The picture as an SVG document.
    pub svg: String,
}

/// What an SVG says of itself.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Heading {
    /// In a line, numbers rounded.
    pub title: String,
    /// Whatever else, with all digits; may be empty.
    pub metadata: String,
}

/// A text as XML writes it.
pub(crate) fn escaped(text: impl Display) -> String {
    text.to_string().replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

impl From<&str> for Heading {
    fn from(title: &str) -> Self {
        Self { title: title.to_owned(), metadata: String::new() }
    }
}

impl Picture {
    /// Whether this build makes PDF, which needs the feature `pdf`.
    pub const MAKES_PDF: bool = cfg!(feature = "pdf");

    /// The greatest height in print, in millimetres: what a page or a column leaves beside a caption.
    pub const HIGHEST: f64 = 230.0;

    /// The height in print, with letters of at least 6 pt, in millimetres.
    #[must_use]
    pub fn millimetres_high(&self) -> f64 {
        let height = self.svg.split_once(" height=\"").and_then(|(_, rest)| rest.split_once('"'));
        let pixels: f64 = height.and_then(|(height, _)| height.parse().ok()).unwrap_or(0.0);
        pixels * f64::from(POINTS) / 72.0 * 25.4
    }

    /// Puts the size in pixels, the heading and the font's stand-ins on the elements of a canvas.
    pub(crate) fn from_canvas(elements: &str, size: [f64; 2], heading: &Heading) -> Self {
        let [width, height] = size;
        let [units_wide, units_high] = size.map(|side| (side * UNITS).round());
        let title = escaped(&heading.title);
        let metadata = match heading.metadata.as_str() {
            "" => String::new(),
            metadata => format!("<metadata>{}</metadata>\n", escaped(metadata)),
        };
        // Viewers without the font fall back to Verdana, whose widths DejaVu Sans shares.
        let elements = elements.replace(
            &format!("font-family=\"{}\"", font::FAMILY),
            &format!("font-family=\"{}, Verdana, sans-serif\"", font::FAMILY),
        );
        let svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"0 0 {units_wide} {units_high}\" stroke-linejoin=\"round\">\n<title>{title}</title>\n{metadata}{elements}</svg>\n"
        );
        Self { svg }
    }

    /// The picture as PNG with `dpi` dots per inch (96: one dot per SVG pixel).
    ///
    /// # Errors
    /// [`PlotError::Resolution`] where that gives no pixels or too many.
    pub fn to_png(&self, dpi: f64) -> Result<Vec<u8>, PlotError> {
        let tree = self.tree()?;
        let scale = dpi / PIXELS_PER_INCH;
        // Only whole pixels: the page does not cover a part of one, which would show as a line.
        let [width, height] =
            [tree.size().width(), tree.size().height()].map(|side| (f64::from(side) * scale + 1e-6).floor());
        if !(width >= 1.0 && height >= 1.0 && width <= PIXELS_MAX && height <= PIXELS_MAX) {
            return Err(PlotError::Resolution { dpi });
        }
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 1 and 30,000")]
        let mut pixels = Pixmap::new(width as u32, height as u32).ok_or(PlotError::Resolution { dpi })?;
        #[expect(clippy::cast_possible_truncation, reason = "a scale needs no more digits")]
        let transform = Transform::from_scale(scale as f32, scale as f32);
        resvg::render(&tree, transform, &mut pixels.as_mut());
        // A page is opaque, so that there is no alpha to be stored.
        let colors: Vec<u8> = pixels.data().chunks_exact(4).flat_map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect();
        image::png([pixels.width(), pixels.height()], None, &colors)
    }

    /// The picture as a PDF of one page, text as text, so large that the smallest letters have 6 pt.
    ///
    /// # Errors
    /// [`PlotError::NoPdf`] in a build without the feature `pdf`, [`PlotError::Pdf`] where the writer fails.
    pub fn to_pdf(&self) -> Result<Vec<u8>, PlotError> {
        pdf::page(&self.tree()?)
    }

    /// The picture as a LaTeX document of one TikZ picture, text as text, as large as the PDF.
    ///
    /// # Errors
    /// [`PlotError::TikzImage`] for a picture that holds images.
    pub fn to_tikz(&self) -> Result<String, PlotError> {
        let title = self.svg.split_once("<title>").and_then(|(_, rest)| rest.split_once("</title>"));
        tikz::document(&self.tree()?, title.map_or("", |(title, _)| title))
    }

    fn tree(&self) -> Result<Tree, PlotError> {
        let options = Options { fontdb: font::database(), font_family: font::FAMILY.to_owned(), ..Options::default() };
        Ok(Tree::from_str(&self.svg, &options)?)
    }
}
