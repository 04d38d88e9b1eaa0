//! A finished picture, its size in print, and its file formats.

use std::fmt::Display;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree};

use super::error::PlotError;
use super::geometry::{MILLIMETRES, PIXELS_PER_INCH, UNITS};
use super::{text, tikz};

/// The largest PNG side that is drawn.
const PIXELS_MAX: f64 = 30_000.0;

/// The class of formulas in texts.
pub const FORMULA_CLASS: &str = "bifdiag-math";

/// How an SVG shows formulas, with the letters themselves; programs that read no fonts out of pictures take others like them.
fn style() -> String {
    let family = text::FORMULAS;
    let font = STANDARD.encode(text::FORMULA_BYTES);
    format!(
        "<style>.{FORMULA_CLASS}{{font-family:'{family}','STIX Two Text','Times New Roman',serif;font-style:italic}}\n\
         @font-face{{font-family:'{family}';font-style:italic;src:url(data:font/otf;base64,{font})}}</style>\n"
    )
}

/// A vector picture; PNG and PDF are made from its SVG. Equal input gives equal bytes in every format.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// The picture as an SVG document.
    pub svg: String,
}

/// A picture in pixels.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pixels {
    /// Width and height.
    pub size: [u32; 2],
    /// Row by row, three bytes each.
    pub rgb: Vec<u8>,
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
pub fn escaped(text: impl Display) -> String {
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
        let height = self.svg.split_once(" height=\"").and_then(|(_, rest)| rest.split_once("mm\""));
        height.and_then(|(height, _)| height.parse().ok()).unwrap_or(0.0)
    }

    /// A document of SVG elements, with its size in pixels and its heading.
    #[must_use]
    pub fn new(elements: &str, size: [f64; 2], heading: &Heading) -> Self {
        let [width, height] = size.map(|side| (side * MILLIMETRES * 100.0).round() / 100.0);
        let [units_wide, units_high] = size.map(|side| (side * UNITS).round());
        let title = escaped(&heading.title);
        let metadata = match heading.metadata.as_str() {
            "" => String::new(),
            metadata => format!("<metadata>{}</metadata>\n", escaped(metadata)),
        };
        let style = if elements.contains(FORMULA_CLASS) { style() } else { String::new() };
        // Viewers without the font fall back to Verdana, whose widths DejaVu Sans shares.
        let svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}mm\" height=\"{height}mm\" \
             viewBox=\"0 0 {units_wide} {units_high}\" stroke-linejoin=\"round\" font-family=\"{}, Verdana, sans-serif\">\n\
             <title>{title}</title>\n{metadata}{style}{elements}</svg>\n",
            text::FAMILY,
        );
        Self { svg }
    }

    /// The picture as PNG with `dpi` dots per inch of print, which it says of itself.
    ///
    /// # Errors
    /// [`PlotError::Resolution`] where that gives no pixels or too many.
    pub fn to_png(&self, dpi: f64) -> Result<Vec<u8>, PlotError> {
        let Pixels { size, rgb } = self.to_pixels(dpi)?;
        png(size, None, &rgb, Some(dpi))
    }

    /// The picture in pixels, `dpi` of them in an inch of print.
    ///
    /// # Errors
    /// As those of [`Self::to_png`].
    pub fn to_pixels(&self, dpi: f64) -> Result<Pixels, PlotError> {
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
        let rgb = pixels.data().chunks_exact(4).flat_map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect();
        Ok(Pixels { size: [pixels.width(), pixels.height()], rgb })
    }

    /// The picture as a PDF of one page, text as text, scaled so that the smallest letters have 6 pt.
    ///
    /// # Errors
    /// [`PlotError::NoPdf`] in a build without the feature `pdf`, [`PlotError::Pdf`] where the writer fails.
    pub fn to_pdf(&self) -> Result<Vec<u8>, PlotError> {
        pdf(&self.tree()?)
    }

    /// The picture as TikZ that a LaTeX document can `\input`, text as text, as large as the PDF.
    ///
    /// # Errors
    /// [`PlotError::TikzImage`] for a picture that holds images.
    pub fn to_tikz(&self) -> Result<String, PlotError> {
        tikz::picture(&self.tree()?, self.title())
    }

    /// The same as a LaTeX document of its own.
    ///
    /// # Errors
    /// As those of [`Self::to_tikz`].
    pub fn to_latex(&self) -> Result<String, PlotError> {
        tikz::document(&self.tree()?, self.title())
    }

    fn title(&self) -> &str {
        let title = self.svg.split_once("<title>").and_then(|(_, rest)| rest.split_once("</title>"));
        title.map_or("", |(title, _)| title)
    }

    fn tree(&self) -> Result<Tree, PlotError> {
        #[expect(clippy::cast_possible_truncation, reason = "lengths of pictures need no more digits")]
        let dpi = PIXELS_PER_INCH as f32;
        let (fontdb, font_family) = (text::database(), text::FAMILY.to_owned());
        let options = Options { dpi, fontdb, font_family, ..Options::default() };
        Ok(Tree::from_str(&self.svg, &options)?)
    }
}

/// An image of `samples`, row by row: three bytes a pixel, or with `palette` (its colours, three bytes each, the first
/// transparent) one; with the dots per inch of print if known.
///
/// # Errors
/// [`PlotError`] when the bytes cannot be encoded.
pub fn png(
    [width, height]: [u32; 2],
    palette: Option<Vec<u8>>,
    samples: &[u8],
    dpi: Option<f64>,
) -> Result<Vec<u8>, PlotError> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width, height);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::High);
    if let Some(palette) = palette {
        encoder.set_color(png::ColorType::Indexed);
        encoder.set_filter(png::Filter::NoFilter);
        encoder.set_palette(palette);
        encoder.set_trns(vec![0]);
    } else {
        encoder.set_color(png::ColorType::Rgb);
    }
    if let Some(dpi) = dpi {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "30,000 dots at most")]
        let per_metre = (dpi / 0.0254).round() as u32;
        let dimensions = png::PixelDimensions { xppu: per_metre, yppu: per_metre, unit: png::Unit::Meter };
        encoder.set_pixel_dims(Some(dimensions));
    }
    let mut writer = encoder.write_header()?;
    writer.write_image_data(samples)?;
    writer.finish()?;
    Ok(bytes)
}

/// A PDF of one page, as large as in print.
#[cfg(feature = "pdf")]
fn pdf(tree: &Tree) -> Result<Vec<u8>, PlotError> {
    use krilla::geom::Size;
    use krilla::page::PageSettings;
    use krilla_svg::{SurfaceExt, SvgSettings};

    use super::geometry::POINTS;

    let [width, height] = [tree.size().width(), tree.size().height()].map(|side| side * POINTS);
    let no_page = || PlotError::Page { width, height };
    let page_settings = PageSettings::from_wh(width, height).ok_or_else(no_page)?;
    let page_size = Size::from_wh(width, height).ok_or_else(no_page)?;
    let mut document = krilla::Document::new();
    let mut page = document.start_page_with(page_settings);
    let mut surface = page.surface();
    surface.draw_svg(tree, page_size, SvgSettings::default()).ok_or_else(no_page)?;
    surface.finish();
    page.finish();
    document.finish().map_err(|error| PlotError::Pdf(Box::new(error)))
}

#[cfg(not(feature = "pdf"))]
fn pdf(_: &Tree) -> Result<Vec<u8>, PlotError> {
    Err(PlotError::NoPdf)
}
