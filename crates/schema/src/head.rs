//! What documents begin with.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::Number;

/// Where a document comes from: the first fields of each.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Head {
    /// Version of the documents.
    pub schema_version: String,
    /// Version of the program that made it.
    pub version: String,
    /// The canonical command that prints the document, made from body and settings.
    pub command: String,
}

/// A body by the texts of its numbers.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct GivenBody {
    /// A1, A2, A3 as given.
    #[serde(rename = "A")]
    #[schemars(with = "[Number; 3]")]
    pub moments: [String; 3],
    /// r1, r2, r3 as given.
    #[serde(rename = "r")]
    #[schemars(with = "[Number; 3]")]
    pub center: [String; 3],
}
