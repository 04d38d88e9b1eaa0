//! What a figure is.

use std::error::Error;

use bifdiag_plot::{Picture, Theme};

/// The figures are made for a light page.
pub const THEME: Theme = Theme::Light;

/// A figure: the name of its file and how it is drawn.
pub struct Figure {
    pub stem: &'static str,
    pub draw: Box<dyn Fn() -> Result<Picture, Box<dyn Error>>>,
}
