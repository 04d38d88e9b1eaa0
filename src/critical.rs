//! Relative equilibria.

use crate::body::{Body, Number};
use crate::document::{CriticalDocument, SCHEMA_VERSION};

/// Why there is no answer.
#[derive(Debug, thiserror::Error)]
#[error("no answer")]
pub enum CriticalError {}

/// All relative equilibria at one l.
///
/// # Errors
/// [`CriticalError`].
pub fn critical(body: &Body, l: &Number) -> Result<CriticalDocument, CriticalError> {
    Ok(CriticalDocument {
        schema_version: SCHEMA_VERSION.to_owned(),
        moments: body.moments().clone(),
        center: body.center().clone(),
        l: l.clone(),
        critical: Vec::new(),
        error_bound: 1.0,
        complete: false,
        note: None,
        inertia: None,
    })
}
