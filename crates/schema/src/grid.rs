//! `classify --grid`: what the arrays mean.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{Accuracy, Number};

/// Values of a grid, both ends included.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct GridAxisDocument {
    /// The first.
    #[schemars(with = "Number")]
    pub from: String,
    /// The last.
    #[schemars(with = "Number")]
    pub to: String,
    /// Their number.
    pub count: usize,
}

/// The `meta` of a grid.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct GridDocument {
    /// Version of this document.
    pub schema_version: String,
    /// Version of the program that made it.
    pub version: String,
    /// The command that makes it: canonical, from body and settings.
    pub command: String,
    /// A1, A2, A3 as given.
    #[serde(rename = "A")]
    #[schemars(with = "[Number; 3]")]
    pub moments: [String; 3],
    /// r1, r2, r3 as given.
    #[serde(rename = "r")]
    #[schemars(with = "[Number; 3]")]
    pub center: [String; 3],
    /// The level of accuracy that was asked for.
    pub accuracy: Accuracy,
    /// Energies: the columns.
    pub h: GridAxisDocument,
    /// Momenta: the rows.
    pub l: GridAxisDocument,
    /// What negative entries of `region` mean.
    pub codes: BTreeMap<String, String>,
}
