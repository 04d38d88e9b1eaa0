//! The one font of every picture, built into the binary, so that text comes out the same where no fonts are installed; widths
//! of texts in it, and lines.

use std::sync::{Arc, OnceLock};

use plotters::style::{FontStyle, IntoFont, register_font};
use resvg::usvg::fontdb::Database;

use super::error::PlotError;

/// Family name of the built-in font.
pub(crate) const FAMILY: &str = "DejaVu Sans";

const BYTES: &[u8] = include_bytes!("../../fonts/DejaVuSans.ttf");

/// From ascent to descent, in font sizes: this is the size by which plotters measures text.
const EXTENT: f64 = 1.164_32;

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
    let font = (FAMILY, size * EXTENT * 100.0).into_font();
    font.box_size(text).map_or(0.0, |(width, _)| f64::from(width) / 100.0)
}

/// Width of the widest of some texts.
pub(crate) fn widest<'a>(texts: impl IntoIterator<Item = &'a String>, size: f64) -> f64 {
    texts.into_iter().map(|text| text_width(text, size)).fold(0.0, f64::max)
}

/// The font size of a title: smaller than usual where it would be wider than `width`, but not below the smallest letters.
pub(crate) fn title_size(title: &str, usual: f64, width: f64) -> f64 {
    const SMALLEST: f64 = 11.0;
    let own = text_width(title, usual);
    if own <= width { usual } else { (usual * width / own).max(SMALLEST) }
}

/// A text in lines of at most `width` pixels, broken between words.
pub(crate) fn lines(text: &str, size: f64, width: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split(' ') {
        match lines.last_mut() {
            Some(line) if text_width(&format!("{line} {word}"), size) <= width => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}
