//! The fonts of every picture, one of texts and one of formulas, built into the binary, so that text comes out the same where no
//! fonts are installed; widths of texts in them, and lines.

use std::sync::{Arc, OnceLock};

use plotters::style::IntoFont;
#[cfg(not(target_arch = "wasm32"))]
use plotters::style::{FontStyle, register_font};
use resvg::usvg::fontdb::Database;

use super::error::PlotError;
use super::formula::{Part, parts, stacked};

/// Family name of the font of texts.
pub const FAMILY: &str = "DejaVu Sans";
/// Family name of the font of formulas.
pub const FORMULAS: &str = "Bifdiag Math";

const BYTES: &[u8] = include_bytes!("../fonts/DejaVuSans.ttf");
/// The font of formulas, small enough to be embedded in a picture.
pub const FORMULA_BYTES: &[u8] = include_bytes!("../fonts/Math.otf");

/// From ascent to descent, in font sizes, of both: this is the size by which plotters measures text.
const EXTENT: f64 = 1.164_32;

/// A browser draws with its own fonts: there, pictures are only laid out.
#[cfg(target_arch = "wasm32")]
pub fn register() -> Result<(), PlotError> {
    Err(PlotError::Font)
}

/// Makes the fonts known to plotters; safe to call again.
#[cfg(not(target_arch = "wasm32"))]
pub fn register() -> Result<(), PlotError> {
    static REGISTERED: OnceLock<bool> = OnceLock::new();
    let fonts = [(FAMILY, BYTES), (FORMULAS, FORMULA_BYTES)];
    let register = || fonts.into_iter().all(|(name, bytes)| register_font(name, FontStyle::Normal, bytes).is_ok());
    let registered = *REGISTERED.get_or_init(register);
    if registered { Ok(()) } else { Err(PlotError::Font) }
}

/// A font database that holds the built-in fonts and nothing of the machine.
pub fn database() -> Arc<Database> {
    static DATABASE: OnceLock<Arc<Database>> = OnceLock::new();
    Arc::clone(DATABASE.get_or_init(|| {
        let mut database = Database::new();
        database.load_font_data(BYTES.to_vec());
        database.load_font_data(FORMULA_BYTES.to_vec());
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
    let width = |Part { text, is_formula }: &Part| match stacked(text) {
        _ if !is_formula => width_in(FAMILY, text, size),
        Some([base, _, index]) => width_in(FORMULAS, base, size) + width_in(FORMULAS, index, size),
        None => width_in(FORMULAS, text, size),
    };
    parts(text).iter().map(width).sum()
}

/// Width of a text in one font.
pub fn width_in(family: &str, text: &str, size: f64) -> f64 {
    // Measured at a hundredfold size, since plotters rounds to whole pixels.
    let font = (family, size * EXTENT * 100.0).into_font();
    font.box_size(text).map_or(0.0, |(width, _)| f64::from(width) / 100.0)
}

/// Width of the widest of some texts.
pub fn widest<'a>(texts: impl IntoIterator<Item = &'a String>, size: f64) -> f64 {
    texts.into_iter().map(|text| text_width(text, size)).fold(0.0, f64::max)
}

/// The font size of a title: smaller than usual where it would be wider than `width`, but not below the smallest letters.
#[must_use]
pub fn title_size(title: &str, usual: f64, width: f64) -> f64 {
    const SMALLEST: f64 = 11.0;
    let own = text_width(title, usual);
    if own <= width { usual } else { (usual * width / own).max(SMALLEST) }
}

/// A text in lines of at most `width` pixels, broken between words.
#[must_use]
pub fn lines(text: &str, size: f64, width: f64) -> Vec<String> {
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
