//! `bodies`: the named bodies; and the line that stands for a wrong line of a batch.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{GivenBody, Head};

/// A named body.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct PresetDocument {
    /// Its name, as for `--body`.
    pub name: String,
    /// The body.
    #[serde(flatten)]
    pub body: GivenBody,
    /// What it is.
    pub note: String,
}

/// The answer of `bodies`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct BodiesDocument {
    /// Where it comes from.
    #[serde(flatten)]
    pub head: Head,
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
