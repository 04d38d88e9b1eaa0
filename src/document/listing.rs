//! `bodies`: the named bodies; and the line that stands for a wrong line of a batch.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::SCHEMA_VERSION;
use crate::body::{Number, Preset};

/// A named body.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct PresetDocument {
    /// Its name, as for `--body`.
    pub name: String,
    /// A1, A2, A3.
    #[serde(rename = "A")]
    pub moments: [Number; 3],
    /// r1, r2, r3.
    #[serde(rename = "r")]
    pub center: [Number; 3],
    /// What it is.
    pub note: String,
}

/// The answer of `bodies`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct BodiesDocument {
    /// Version of this document.
    pub schema_version: String,
    /// Every named body.
    pub bodies: Vec<PresetDocument>,
}

impl BodiesDocument {
    /// All presets.
    #[must_use]
    pub fn all() -> Self {
        let describe = |preset: &Preset| {
            let body = preset.body();
            PresetDocument {
                name: preset.name().to_owned(),
                moments: body.moments().clone(),
                center: body.center().clone(),
                note: preset.note().to_owned(),
            }
        };
        Self { schema_version: SCHEMA_VERSION.to_owned(), bodies: Preset::all().iter().map(describe).collect() }
    }
}

/// The answer to a line of a batch that is wrong.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct BatchErrorDocument {
    /// What is wrong, and what would be right.
    pub error: String,
    /// Number of the line, from 1.
    pub line: usize,
}
