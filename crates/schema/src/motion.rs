//! `orbit`: the body's motion in space.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{DriftDocument, FurtherIntegralDocument, GivenBody, Head, IntegratorDocument, PartDocument};

/// The motion at one time; vectors are in the body's (principal) axes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct MotionSampleDocument {
    /// Time since the start.
    pub time: f64,
    /// The vertical.
    pub gamma: [f64; 3],
    /// Angular momentum.
    pub l: [f64; 3],
    /// Angular velocity.
    pub omega: [f64; 3],
    /// Euler's angle ϑ ∈ [0, π] between γ and the third axis.
    pub theta: f64,
    /// Euler's angle ψ ∈ (−π, π].
    pub psi: f64,
    /// Euler's angle φ, continuous in time while γ is not at ±e₃.
    pub phi: f64,
    /// The attitude as a unit quaternion [w, x, y, z], continuous in time: it takes vectors from the body to space.
    pub attitude: [f64; 4],
}

/// How well it went.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct MotionSummaryDocument {
    /// Samples that were computed.
    pub samples: usize,
    /// Steps of the integrator.
    pub steps: u64,
    /// The largest deviations of the first integrals from their values at the start, over the samples.
    pub drift: DriftDocument,
    /// The largest |Rᵀe_z − γ|: the attitude's vertical against the integrated one.
    pub vertical_error: f64,
    /// The largest angle between the attitude and that of the angles (ϑ, ψ, φ), which are found independently.
    pub attitude_difference: f64,
    /// Pieces of the motion with γ at ±e₃ within rounding; beyond them φ and ψ are one possible continuation.
    pub at_pole: u64,
}

/// The answer of `orbit`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct MotionDocument {
    /// Where it comes from.
    #[serde(flatten)]
    pub head: Head,
    /// The body.
    #[serde(flatten)]
    pub body: GivenBody,
    /// Energy at the start.
    pub h: f64,
    /// Vertical angular momentum ⟨γ,l⟩ at the start.
    pub l: f64,
    /// The start, at time 0.
    pub start: MotionSampleDocument,
    /// How γ and l were integrated.
    pub integrator: IntegratorDocument,
    /// False when samples are missing: the run was interrupted, or the integrator failed.
    pub complete: bool,
    /// How well it went.
    pub summary: MotionSummaryDocument,
    /// The further integrals of an integrable body along the motion.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub integrals: Vec<FurtherIntegralDocument>,
    /// The motion, by rising time; absent where the samples are written as data.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub samples: Option<Vec<MotionSampleDocument>>,
    /// Remarks on the result, in words.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub notes: Vec<String>,
    /// The part from which A and r were computed, when one was given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub part: Option<PartDocument>,
}

/// Two decimals that are rounded outward: the exact value lies between them.
pub type Ends = [String; 2];

/// Enclosures of the motion, a row for each time; vectors are in the body's (principal) axes.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct EnclosuresDocument {
    /// The vertical γ.
    pub gamma: Vec<[Ends; 3]>,
    /// Angular velocity.
    pub omega: Vec<[Ends; 3]>,
    /// The rotation matrix that takes vectors from the body to space, by rows; γ is its last row.
    pub rotation: Vec<[Ends; 9]>,
    /// The same rotation as a unit quaternion [w, x, y, z], continuous in time.
    pub quaternion: Vec<[Ends; 4]>,
}

/// The start of a proved motion: exactly these numbers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ExactStartDocument {
    /// The vertical, up to its length.
    pub gamma: [String; 3],
    /// Angular velocity.
    pub omega: [String; 3],
    /// Euler's angle φ.
    pub phi: String,
}

/// The answer of `orbit --proved`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ProvedMotionDocument {
    /// Where it comes from.
    #[serde(flatten)]
    pub head: Head,
    /// The body.
    #[serde(flatten)]
    pub body: GivenBody,
    /// The start, at time 0.
    pub start: ExactStartDocument,
    /// The times of the enclosures.
    pub times: Vec<f64>,
    /// The motion at these times; absent where it is written as data.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub enclosures: Option<EnclosuresDocument>,
    /// From time 0 to here no enclosure is wider than `bound`.
    pub proved_to: f64,
    /// The same for the past.
    pub proved_from: f64,
    /// The requested bound on the widest enclosure.
    pub bound: f64,
    /// The widest enclosure, rounded up.
    pub widest: f64,
    /// Bits of the arithmetic.
    pub bits: usize,
    /// Steps of the integrator.
    pub steps: u64,
    /// False when times are missing.
    pub complete: bool,
    /// Remarks on the result, in words.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub notes: Vec<String>,
    /// The part from which A and r were computed, when one was given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub part: Option<PartDocument>,
}
