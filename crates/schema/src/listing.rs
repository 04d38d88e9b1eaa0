//! `bodies`: the named bodies; `explain`: the terms; and the answer to an invalid line of a batch.

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

/// A row of the glossary.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct ExplainedTermDocument {
    /// The terms that the row explains.
    pub terms: Vec<String>,
    /// What they mean.
    pub meaning: String,
    /// Other names of them.
    pub also_called: Vec<String>,
    /// The section of the glossary with this row.
    pub section: String,
}

/// The answer of `explain`.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct ExplanationDocument {
    /// Where it comes from.
    #[serde(flatten)]
    pub head: Head,
    /// The requested word; empty for the whole glossary.
    pub word: String,
    /// The rows of the glossary that explain it.
    pub entries: Vec<ExplainedTermDocument>,
}

/// The answer to an invalid line of a batch.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct BatchErrorDocument {
    /// What is wrong, and what would be right.
    pub error: String,
    /// Number of the line, from 1.
    pub line: usize,
}
