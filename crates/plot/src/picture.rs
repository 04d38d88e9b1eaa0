//! A finished picture and its file formats.

use krilla::geom::Size;
use krilla::page::PageSettings;
use krilla_svg::{SurfaceExt, SvgSettings};
use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree};

use super::canvas::UNITS;
use super::{PlotError, font};

/// Pixels of an SVG in an inch (CSS).
const PIXELS_PER_INCH: f64 = 96.0;

/// Points of a PDF in a pixel.
const POINTS_PER_PIXEL: f32 = 0.75;

/// The largest PNG side that is drawn.
const PIXELS_MAX: f64 = 30_000.0;

/// A vector picture; PNG and PDF are made from its SVG. Equal input gives equal bytes in every format.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// The picture as an SVG document.
    pub svg: String,
}

impl Picture {
    /// Puts the size in pixels, a title and the font's stand-ins on the elements of a canvas.
    pub(super) fn from_canvas(elements: &str, size: [f64; 2], title: &str) -> Self {
        let [width, height] = size;
        let [units_wide, units_high] = size.map(|side| (side * UNITS).round());
        let title = title.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
        // Viewers without the font fall back to Verdana, whose widths DejaVu Sans shares.
        let elements = elements.replace(
            &format!("font-family=\"{}\"", font::FAMILY),
            &format!("font-family=\"{}, Verdana, sans-serif\"", font::FAMILY),
        );
        let svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"0 0 {units_wide} {units_high}\" stroke-linejoin=\"round\">\n<title>{title}</title>\n{elements}</svg>\n"
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
        let [width, height] = [tree.size().width(), tree.size().height()].map(|side| (f64::from(side) * scale).round());
        if !(width >= 1.0 && height >= 1.0 && width <= PIXELS_MAX && height <= PIXELS_MAX) {
            return Err(PlotError::Resolution { dpi });
        }
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 1 and 30,000")]
        let mut pixels = Pixmap::new(width as u32, height as u32).ok_or(PlotError::Resolution { dpi })?;
        #[expect(clippy::cast_possible_truncation, reason = "a scale needs no more digits")]
        let transform = Transform::from_scale(scale as f32, scale as f32);
        resvg::render(&tree, transform, &mut pixels.as_mut());
        encoded(&pixels).map_err(|error| PlotError::Png(Box::new(error)))
    }

    /// The picture as a PDF of one page, text as text.
    ///
    /// # Errors
    /// [`PlotError::Pdf`] where the writer fails.
    pub fn to_pdf(&self) -> Result<Vec<u8>, PlotError> {
        let tree = self.tree()?;
        let [width, height] = [tree.size().width(), tree.size().height()].map(|side| side * POINTS_PER_PIXEL);
        let no_page = || PlotError::Page { width, height };
        let page_settings = PageSettings::from_wh(width, height).ok_or_else(no_page)?;
        let page_size = Size::from_wh(width, height).ok_or_else(no_page)?;
        let mut document = krilla::Document::new();
        let mut page = document.start_page_with(page_settings);
        let mut surface = page.surface();
        surface.draw_svg(&tree, page_size, SvgSettings::default()).ok_or_else(no_page)?;
        surface.finish();
        page.finish();
        Ok(document.finish()?)
    }

    fn tree(&self) -> Result<Tree, PlotError> {
        let options = Options { fontdb: font::database(), font_family: font::FAMILY.to_owned(), ..Options::default() };
        Ok(Tree::from_str(&self.svg, &options)?)
    }
}

/// The pixels as PNG. A page is opaque, so that there is no alpha to be stored.
fn encoded(pixels: &Pixmap) -> Result<Vec<u8>, png::EncodingError> {
    let colors: Vec<u8> = pixels.data().chunks_exact(4).flat_map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect();
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, pixels.width(), pixels.height());
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::High);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&colors)?;
    writer.finish()?;
    Ok(bytes)
}
