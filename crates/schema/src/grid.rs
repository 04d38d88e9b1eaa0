//! `classify --grid`: what the arrays mean.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{Accuracy, GivenBody, Head, Number};

/// Values of a grid, both ends included; of one value the first end.
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
    /// Where it comes from.
    #[serde(flatten)]
    pub head: Head,
    /// The body.
    #[serde(flatten)]
    pub body: GivenBody,
    /// The requested level of accuracy.
    pub accuracy: Accuracy,
    /// Energies: the columns.
    pub h: GridAxisDocument,
    /// Momenta: the rows.
    pub l: GridAxisDocument,
    /// What negative entries of `region` mean.
    pub codes: BTreeMap<String, String>,
}
