//! What documents begin with, and exact numbers in them.

use std::borrow::Cow;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Serialize};

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

/// An exact number as a text: the decimal or rational that was given, never its nearest double.
pub struct Number;

impl JsonSchema for Number {
    fn schema_name() -> Cow<'static, str> {
        "Number".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "description": "An exact number as it was given: a decimal (-1.1, 11e-1) or a rational (11/10).",
            "type": "string",
            "pattern": r"^[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?( */ *[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?)?$"
        })
    }
}
