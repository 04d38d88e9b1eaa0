//! `bodies`: the named bodies; and the line that stands for a wrong line of a batch.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::Number;

/// A named body.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct PresetDocument {
    /// Its name, as for `--body`.
    pub name: String,
    /// A1, A2, A3.
    #[serde(rename = "A")]
    #[schemars(with = "[Number; 3]")]
    pub moments: [String; 3],
    /// r1, r2, r3.
    #[serde(rename = "r")]
    #[schemars(with = "[Number; 3]")]
    pub center: [String; 3],
    /// What it is.
    pub note: String,
}

/// The answer of `bodies`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct BodiesDocument {
    /// Version of this document.
    pub schema_version: String,
    /// Version of the program that made it.
    pub version: String,
    /// The command that makes it: canonical, from body and settings.
    pub command: String,
    /// Every named body.
    pub bodies: Vec<PresetDocument>,
}

/// The answer to a line of a batch that is wrong.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct BatchErrorDocument {
    /// What is wrong, and what would be right.
    pub error: String,
    /// Number of the line, from 1.
    pub line: usize,
}
