//! What a figure is.

use plot::{Picture, Theme};

use crate::cli::failure::Failure;
use crate::cli::terminal::Timings;

/// How a figure is drawn.
type Draw = dyn Fn(&Timings, Theme) -> Result<Picture, Failure>;

/// A figure: the name of its files and how it is drawn.
pub struct Figure {
    pub stem: &'static str,
    pub draw: Box<Draw>,
}
