//! The command line's documents.

use bifdiag::schema::AtlasDocument;
use bifdiag::{Accuracy, Atlas, Solver, documents};

use crate::body::{Refused, body, number};

/// A document as the command line prints it.
pub fn text(document: &impl serde::Serialize) -> Result<String, Refused> {
    documents::layout::text(document).map_err(|error| Refused::Json(error.to_string()))
}

/// `bifdiag --json`.
pub fn atlas(of: &str) -> Result<String, Refused> {
    let atlas = bifdiag::atlas(&body(of)?, Accuracy::Exact)?;
    let mut document = documents::atlas::document(&atlas, &documents::DocumentOptions::default());
    documents::atlas::attach_verdict_changes(&mut document, &atlas);
    text(&document)
}

/// `bifdiag --accuracy fast --json` of an atlas that is there, without outlines and widths of regions, which the page does not draw.
pub fn sketch(atlas: &Atlas) -> AtlasDocument {
    let accuracy = Accuracy::Fast;
    let options = documents::DocumentOptions { accuracy, drawing: documents::Drawn::Curves, ..Default::default() };
    documents::atlas::document(atlas, &options)
}

/// `bifdiag classify --json`.
pub fn classify(of: &str, h: &str, l: &str) -> Result<String, Refused> {
    let (body, h, l) = (body(of)?, number("h", h)?, number("l", l)?);
    let subject = documents::Subject::from(body.clone());
    let prepared = Solver::new(body, Accuracy::Exact);
    let found = prepared.classify(&h, &l)?;
    text(&documents::classification(&subject, &h, &l, &found, Accuracy::Exact, Some(&prepared)))
}

/// `bifdiag critical --json`.
pub fn critical(of: &str, l: &str) -> Result<String, Refused> {
    let (body, l) = (body(of)?, number("l", l)?);
    let found = bifdiag::critical(&body, &l)?;
    text(&documents::critical(&body.into(), &l, &found))
}
