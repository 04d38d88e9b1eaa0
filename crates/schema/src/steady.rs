//! Documents of all steady axes over the spin: `bifdiag critical-spin` without an axis.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{
    GivenBody, Head, Multiplicity, PartDocument, SpinChangeDocument, SpinDocument, Stability, StabilityChangeKind,
    Verdict,
};

/// How a family of steady axes begins.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum SteadyStart {
    /// At rest, where the body hangs or stands.
    Rest,
    /// Together with another family: slower, there is neither.
    Fold,
    /// On another family, from which a pair or a circle of axes leaves.
    Fork,
}

/// A steady rotation of a family.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SteadyPlaceDocument {
    /// The spin.
    pub spin: SpinDocument,
    /// Bound on the error of the spin, in rad/s.
    pub error_bound: f64,
    /// The axis, a unit vector in the frame of the question, pointing up; of a pair or circle one of them.
    pub axis: [f64; 3],
    /// l there.
    pub l: f64,
    /// h there.
    pub h: f64,
}

/// A range of spins in which a family has one linear type, to the start of the next one or to infinity.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SteadyStretchDocument {
    /// Where it begins; `null`: at rest.
    pub from: Option<SteadyPlaceDocument>,
    /// Which eigenvalues meet there; `null` where the family itself begins.
    pub change: Option<StabilityChangeKind>,
    /// Linear type of the flow reduced by l.
    pub stability: Stability,
    /// What is known of its stability.
    pub stable: Verdict,
}

/// Steady axes that move with the spin without meeting others, from one spin to infinity.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SteadyFamilyDocument {
    /// Id of the branch of relative equilibria on which it lies; two families that begin in a fold share one.
    pub branch: String,
    /// The branch in words.
    pub branch_name: String,
    /// How it begins.
    pub start: SteadyStart,
    /// How many axes it has at each spin; 2 is a symmetric pair.
    pub axes: Multiplicity,
    /// The axis is the same at every spin.
    pub permanent: bool,
    /// The axis at rest, pointing up, in the frame of the question; `null` for a family that begins later.
    pub slow_axis: Option<[f64; 3]>,
    /// The axis in the limit of fast spins; of a pair or circle one of them.
    pub fast_axis: [f64; 3],
    /// By rising spin.
    pub stretches: Vec<SteadyStretchDocument>,
}

/// An axis about which the body turns steadily at every spin.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct PermanentAxisDocument {
    /// A unit vector in the frame of the question.
    pub axis: [f64; 3],
    /// The spectral type at rest or at the slowest spins, with `+axis` and with `-axis` up.
    pub slow: [String; 2],
    /// Changes of stability and of the regions beside it, by the end that is up, then by rising spin.
    pub changes: Vec<SpinChangeDocument>,
}

/// How many steady axes there are from one spin on, to the next one of the list.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct AxisCountDocument {
    /// `null`: from rest.
    pub from: Option<SpinDocument>,
    /// Axes by the end that is up, those of circles apart.
    pub axes: u32,
    /// Circles of axes.
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
    /// The axes that are permanent at every spin; of a circle of them one.
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
