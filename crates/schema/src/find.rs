//! `find`: a body and a point that show a wanted thing.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{ComponentDocument, GivenBody, Head, MarginDocument, Number};

/// A body and a point that show what was sought.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct WitnessDocument {
    /// What it shows: `k3n1`, `M4`, a signature, a number of isolated relative equilibria.
    #[serde(rename = "type")]
    pub kind: String,
    /// The body.
    #[serde(flatten)]
    pub body: GivenBody,
    /// Energy.
    #[schemars(with = "Number")]
    pub h: String,
    /// Vertical angular momentum.
    #[schemars(with = "Number")]
    pub l: String,
    /// The components of U_hl.
    pub components: Vec<ComponentDocument>,
    /// Distance in h to the nearest curve.
    pub margin: MarginDocument,
    /// Isolated relative equilibria at this l, where their number was sought.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub critical_points: Option<usize>,
}

/// How near the best body came.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct NearestDocument {
    /// A1, A2, A3.
    #[serde(rename = "A")]
    pub moments: [f64; 3],
    /// r1, r2, r3.
    #[serde(rename = "r")]
    pub center: [f64; 3],
    /// Energy.
    pub h: Option<f64>,
    /// Vertical angular momentum.
    pub l: Option<f64>,
    /// What is missing: the distance in h by which a pole would have to enter or leave, divided by |r|; or the number of
    /// isolated relative equilibria.
    pub missing: f64,
}

/// The answer of `find`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct FindDocument {
    /// Where it comes from.
    #[serde(flatten)]
    pub head: Head,
    /// True when there is a witness.
    pub found: bool,
    /// False when a theorem says that no body with r ≠ 0 shows it; absent otherwise.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub exists: Option<bool>,
    /// The theorem.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub why: Option<String>,
    /// What was sought.
    pub sought: String,
    /// The witness.
    #[serde(flatten)]
    pub witness: Option<WitnessDocument>,
    /// The methods that confirm its components.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub verified_by: Vec<String>,
    /// Bodies that were drawn while sampling.
    pub drawn: u64,
    /// Of these, bodies that were tried: those inside the limits that are decided.
    pub tried: u64,
    /// Of these, bodies that show it as f64 sees it; the witness alone is confirmed.
    pub showing: u64,
    /// Where nothing was found: the body that came nearest.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub nearest: Option<NearestDocument>,
}
