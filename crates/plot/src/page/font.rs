//! The one font of every picture, built into the binary: text comes out the same where no fonts are installed.

use std::sync::{Arc, OnceLock};

use plotters::style::{FontStyle, IntoFont, register_font};
use resvg::usvg::fontdb::Database;

use super::error::PlotError;

/// Family name of the built-in font.
pub(crate) const FAMILY: &str = "DejaVu Sans";

const BYTES: &[u8] = include_bytes!("../../fonts/DejaVuSans.ttf");

/// plotters writes a font size of `size / 1.24` into the SVG.
pub(crate) const PLOTTERS_SCALE: f64 = 1.24;

/// plotters measures text at `size` pixels from ascent to descent, which is this many times wider than the SVG's text.
const MEASURE_EXCESS: f64 = 1.065;

/// Makes the font known to plotters; safe to call again.
pub(crate) fn register() -> Result<(), PlotError> {
    static REGISTERED: OnceLock<bool> = OnceLock::new();
    let registered = *REGISTERED.get_or_init(|| register_font(FAMILY, FontStyle::Normal, BYTES).is_ok());
    if registered { Ok(()) } else { Err(PlotError::Font) }
}

/// A font database that holds the built-in font and nothing of the machine.
pub(crate) fn database() -> Arc<Database> {
    static DATABASE: OnceLock<Arc<Database>> = OnceLock::new();
    Arc::clone(DATABASE.get_or_init(|| {
        let mut database = Database::new();
        database.load_font_data(BYTES.to_vec());
        database.set_sans_serif_family(FAMILY);
        Arc::new(database)
    }))
}

/// Width of `text` in pixels at font size `size`.
#[must_use]
pub fn text_width(text: &str, size: f64) -> f64 {
    if register().is_err() {
        return 0.0;
    }
    // Measured at a hundredfold size, since plotters rounds to whole pixels.
    let font = (FAMILY, size * PLOTTERS_SCALE * 100.0).into_font();
    font.box_size(text).map_or(0.0, |(width, _)| f64::from(width) / (100.0 * MEASURE_EXCESS))
}

/// The font size of a title: smaller than usual where it would be wider than `width`, but not below the smallest letters.
pub(crate) fn title_size(title: &str, usual: f64, width: f64) -> f64 {
    const SMALLEST: f64 = 11.0;
    let own = text_width(title, usual);
    if own <= width { usual } else { (usual * width / own).max(SMALLEST) }
}
