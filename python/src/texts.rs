//! Exact texts in, texts of documents out.

use bifdiag::Number;
use pyo3::prelude::*;

use crate::errors;

/// A number of an exact text.
pub fn number(text: &str) -> PyResult<Number> {
    text.parse().map_err(|error: bifdiag::numbers::ParseNumberError| errors::input(&error))
}

/// A document on one line.
pub fn json(document: &impl serde::Serialize) -> PyResult<String> {
    serde_json::to_string(document).map_err(|error| errors::range(&error))
}
