//! The schematic figures of the paper.

use plot::{Scheme, draw_scheme};

use super::figure::Figure;
use crate::cli::export::ExportError;

/// Name of the file and what is drawn.
const SCHEMES: [(&str, Scheme); 3] = [
    ("scheme-sheets", Scheme::Sheets),
    ("scheme-both-sheets-needed", Scheme::BothSheetsNeeded),
    ("scheme-cylinder", Scheme::Cylinder),
];

pub fn figures() -> impl Iterator<Item = Figure> {
    SCHEMES.into_iter().map(|(stem, scheme)| Figure {
        stem,
        draw: Box::new(move |_, theme| Ok(draw_scheme(scheme, theme).map_err(ExportError::from)?)),
    })
}
