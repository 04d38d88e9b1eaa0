//! Documents as JSON.

use serde::Serialize;

use super::error::ExportError;
use super::exporter::Exporter;
use crate::cli::terminal::print;

/// JSON for people and programs: what fits a line stands on one line.
pub struct Json;

impl<D: Serialize> Exporter<D> for Json {
    fn ending(&self) -> &'static str {
        "json"
    }

    fn bytes(&self, document: &D) -> Result<Vec<u8>, ExportError> {
        Ok(bifdiag_documents::layout::text(document)?.into_bytes())
    }
}

/// Prints a document as JSON or, unless `json` is set, as a text for people.
pub fn answer(json: bool, document: &impl Serialize, text: impl FnOnce() -> String) -> Result<(), ExportError> {
    let bytes = if json { Json.bytes(document)? } else { text().into_bytes() };
    Ok(print(bytes)?)
}
