//! Documents of states: `bifdiag state`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{
    FrictionDocument, GivenBody, Head, MarginDocument, Multiplicity, NonlinearDocument, PartDocument,
    SpinChangeDocument, SpinDocument, Stability, Verdict,
};

/// A steady rotation in numbers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SteadyDocument {
    /// Its axis, a unit vector in the frame of the question, pointing up.
    pub axis: [f64; 3],
    /// The angle between it and the vertical of the question, in degrees; 0 where they are taken to be the same.
    pub angle_deg: f64,
    /// Its energy, in the units of the body.
    pub h: f64,
    /// Its vertical angular momentum.
    pub l: f64,
    /// The spectral type.
    pub stability: Stability,
    /// `circle` or `sphere`: it is one of a circle or sphere of steady rotations at this spin, and `stable` refers to
    /// the whole set; absent for a single rotation.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub one_of: Option<Multiplicity>,
    /// What is known of its stability, as in `critical`.
    pub stable: Verdict,
    /// The verdict on its stability, with its reason.
    pub nonlinear: NonlinearDocument,
    /// What friction leaves of it.
    pub friction: FrictionDocument,
    /// Frequencies of small oscillations seen from the rotating body, in Hz, by size; 0 for a real pair of eigenvalues
    /// and
    /// for a pair of zeros, the same twice for a complex quadruple.
    pub frequencies_hz: [f64; 2],
    /// The time in which a deviation grows by a factor of e, in s; `null` when none does, and beyond doubles.
    pub growth_time_s: Option<f64>,
    /// The change at exactly this spin (of regions only: within rounding).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub at: Option<SpinChangeDocument>,
    /// The change at the next smaller spin; `null` also for an axis that is permanent at its own spin only.
    pub below: Option<SpinChangeDocument>,
    /// The change at the next larger spin.
    pub above: Option<SpinChangeDocument>,
    /// Regions just below and just above in h; `null`: forbidden, or not known (then `note` says so).
    pub regions: [Option<String>; 2],
    /// What is not known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub note: Option<String>,
}

/// A state: where it lies in the (h, l) plane, and whether it is a steady rotation.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct StateDocument {
    /// Where it comes from.
    #[serde(flatten)]
    pub head: Head,
    /// The body.
    #[serde(flatten)]
    pub body: GivenBody,
    /// The angular velocity in the frame of the question, in rad/s.
    pub omega: [f64; 3],
    /// The upward direction in that frame.
    pub vertical: [f64; 3],
    /// The magnitude of the angular velocity.
    pub spin: SpinDocument,
    /// The energy, in the units of the body.
    pub h: f64,
    /// The vertical angular momentum, about the upward vertical (elsewhere l is about γ, which points down; the diagram is the
    /// same for l and −l), in the units of the body.
    pub l: f64,
    /// The steady rotation that the state is; `null` for another motion.
    pub steady: Option<SteadyDocument>,
    /// The region of (h, l); `null` on a curve, within rounding of one, and where it is not known (then `note` says so).
    pub region: Option<String>,
    /// The distance of (h, l) to the nearest curve; `null` for a steady rotation, which lies on one.
    pub margin: Option<MarginDocument>,
    /// The steady rotation at this spin whose axis is nearest to the vertical, where the motion is not steady.
    pub nearest: Option<SteadyDocument>,
    /// What is not known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub note: Option<String>,
    /// The part from which A and r were computed, when one was given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub part: Option<PartDocument>,
}
