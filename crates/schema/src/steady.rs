//! Documents of all steady axes over the spin: `bifdiag critical-spin` without an axis.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{GivenBody, Head, PartDocument, SpinChangeDocument, SpinDocument, SpinType, SteadyFamilyDocument};

/// An axis about which the body turns steadily at every spin.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct PermanentAxisDocument {
    /// A unit vector in the frame of the question.
    pub axis: [f64; 3],
    /// The spectral type at rest or at the slowest spins, with `+axis` and with `-axis` up.
    pub slow: [SpinType; 2],
    /// Changes of stability and of the regions beside it, by the end that is up, then by rising spin.
    pub changes: Vec<SpinChangeDocument>,
}

/// How many steady axes there are from one spin on, to the next one of the list.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct AxisCountDocument {
    /// `null`: from rest; without weight every axis is one of rest, which is not counted.
    pub from: Option<SpinDocument>,
    /// Axes by the end that is up, those of circles apart.
    pub axes: u32,
    /// Circles of axes; of a ball without weight the sphere of all axes.
    pub circles: u32,
}

/// The answer of `critical-spin` without an axis: every steady axis at every spin.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SteadySpinsDocument {
    /// Where it comes from.
    #[serde(flatten)]
    pub head: Head,
    /// The body.
    #[serde(flatten)]
    pub body: GivenBody,
    /// The axes that are permanent at every spin; a circle of them is represented by one.
    pub permanent: Vec<PermanentAxisDocument>,
    /// All families of steady axes, permanent ones included.
    pub families: Vec<SteadyFamilyDocument>,
    /// The number of steady axes by rising spin.
    pub counts: Vec<AxisCountDocument>,
    /// What is not known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub note: Option<String>,
    /// The part from which A and r were computed, when one was given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub part: Option<PartDocument>,
}
