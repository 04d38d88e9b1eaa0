//! Documents of steady axes over the spin: `bifdiag critical --spin`, `bifdiag critical-spin`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{
    AxisEnd, Failing, FrictionDocument, GivenBody, Head, Multiplicity, NonlinearDocument, NonlinearVerdict,
    PartDocument, Reason, RelativeEquilibriumDocument, SpinType, Stability, StabilityChangeKind, ToleranceDocument,
    Verdict,
};

/// A rate of turning in two units.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SpinDocument {
    /// Turns in a minute.
    pub rpm: f64,
    /// Radians in a second.
    pub rad_per_s: f64,
}

/// An axis about which the body turns steadily at one spin.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SteadyAxisDocument {
    /// The axis, a unit vector in the frame of the question, pointing up.
    pub axis: [f64; 3],
    /// Vertical angular momentum, in the units of the body.
    pub l: f64,
    /// At this spin it meets another steady axis, or several; at slightly slower spins they do not exist.
    pub fold: bool,
    /// The relative equilibrium, as `critical` lists it at this l.
    #[serde(flatten)]
    pub equilibrium: RelativeEquilibriumDocument,
}

/// The answer of `critical --spin`: every axis about which the body turns steadily at one spin.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SteadyAxesDocument {
    /// Where it comes from.
    #[serde(flatten)]
    pub head: Head,
    /// The body.
    #[serde(flatten)]
    pub body: GivenBody,
    /// The spin.
    pub spin: SpinDocument,
    /// By rising h, then γ lexicographically.
    pub axes: Vec<SteadyAxisDocument>,
    /// Bound on the error of every `h`.
    pub error_bound: f64,
    /// False when it could not be decided whether further axes exist.
    pub complete: bool,
    /// The part from which A and r were computed, when one was given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub part: Option<PartDocument>,
}

/// How a family of steady axes begins.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum SteadyStart {
    /// At rest, where the body hangs or stands.
    Rest,
    /// Together with another family, or several; just below this spin they do not exist.
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

/// An isolated spin at which a hypothesis of Arnold's theorem fails, between spins to which the theorem applies.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct IsolatedSpinDocument {
    /// The spin.
    pub spin: SpinDocument,
    /// Which hypothesis fails.
    pub kind: Failing,
    /// The verdict on rotation at this spin.
    pub verdict: NonlinearVerdict,
    /// Its reason.
    pub why: Reason,
}

/// A range of spins in which a family has one linear type and one Morse index, to the start of the next one or to infinity.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SteadyStretchDocument {
    /// Where it begins; `null`: at rest.
    pub from: Option<SteadyPlaceDocument>,
    /// Which eigenvalues meet there; `null` where the family itself begins. `zero` also at the cusp of a circle, where only the
    /// index changes, and of a permanent axis where a pair only touches 0.
    pub change: Option<StabilityChangeKind>,
    /// Linear type of the flow reduced by l.
    pub stability: Stability,
    /// What is known of its stability, except at the isolated spins.
    pub stable: Verdict,
    /// The isolated spins inside at which the usual conditions of Arnold's theorem fail; `null` where not all of them were found.
    pub isolated: Option<Vec<IsolatedSpinDocument>>,
}

/// Steady axes that continue each other over the spin, from one spin to infinity; others may leave them at forks.
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

/// An axis near the given one: one of Staude's cone, or one that is permanent at every spin.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct NearestAxisDocument {
    /// A unit vector in the frame of the question, at an acute or right angle to the axis of the question.
    pub axis: [f64; 3],
    /// The angle between the two, in degrees.
    pub angle_deg: f64,
    /// The one spin at which it is permanent, 0 where the body only rests; `null`: every spin, or none for a principal axis
    /// off the centre of mass.
    pub spin: Option<SpinDocument>,
    /// Which of its ends is up then.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub up: Option<AxisEnd>,
}

/// A spin at which stability or regions change.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SpinChangeDocument {
    /// Which end of the axis is up.
    pub up: AxisEnd,
    /// The spin.
    pub spin: SpinDocument,
    /// l there.
    pub l: f64,
    /// h there.
    pub h: f64,
    /// `stability`, `region`, or `stability-and-region`.
    pub kind: String,
    /// The spectral type below.
    pub from: SpinType,
    /// The spectral type above.
    pub to: SpinType,
    /// What the curves do there: `fork`, `crossing`, `cusp`; `null` where only the stability changes.
    pub event: Option<String>,
    /// Bound on the error of the spin, in rad/s.
    pub error_bound: f64,
}

/// The spin at which rotation about an axis of Staude's cone is steady.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SteadySpinDocument {
    /// Which end of the axis is up.
    pub up: AxisEnd,
    /// The spin.
    pub spin: SpinDocument,
    /// l there.
    pub l: f64,
    /// h there.
    pub h: f64,
    /// The spectral type; `null` where it was not found.
    pub stability: Option<Stability>,
    /// What is known of its stability, as in `critical`; `null` also where `stability` is.
    pub stable: Option<Verdict>,
    /// The verdict on its stability, with its reason.
    pub nonlinear: Option<NonlinearDocument>,
    /// What friction leaves of it.
    pub friction: Option<FrictionDocument>,
}

/// Spins of a permanent axis between two changes of the type, with the verdict on rotation there.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SpinStretchDocument {
    /// Which end of the axis is up.
    pub up: AxisEnd,
    /// The change below; `null`: rest.
    pub from: Option<SpinDocument>,
    /// The change above; `null`: any larger spin.
    pub to: Option<SpinDocument>,
    /// The spectral type.
    pub stability: SpinType,
    /// The verdict, except at the isolated spins.
    pub nonlinear: NonlinearDocument,
    /// The isolated spins inside at which the usual conditions of Arnold's theorem fail; `null` where not all of them were found.
    pub isolated: Option<Vec<IsolatedSpinDocument>>,
    /// What friction leaves of it.
    pub friction: FrictionDocument,
}

/// Spins at which rotation about an axis changes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct CriticalSpinDocument {
    /// Where it comes from.
    #[serde(flatten)]
    pub head: Head,
    /// The body.
    #[serde(flatten)]
    pub body: GivenBody,
    /// The axis of the question, a unit vector in the part's frame (without a part: in principal axes).
    pub axis: [f64; 3],
    /// Rotation about it, or about the axis `nearest` within 0.5° of it, is permanent at every spin.
    pub permanent: bool,
    /// The permanent axis used if `permanent` is true and the given axis is not exactly permanent; otherwise the
    /// nearest axis of Staude's cone, with two equal moments outside of their plane; without weight, and with three, the
    /// nearest one that is permanent at every spin.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub nearest: Option<NearestAxisDocument>,
    /// The spin at which rotation about the given axis itself is steady, at an angle of 10⁻⁶ at most; empty if there is
    /// no such spin; absent where the given axis is permanent at every spin, and where this was not found.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub steady: Option<Vec<SteadySpinDocument>>,
    /// For an axis that is not permanent: the families of steady axes that are nearest to it at fast spins, with `+axis` and with `-axis` up.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub families: Vec<SteadyFamilyDocument>,
    /// The spectral type at rest or at the slowest spins, with `+axis` and with `-axis` up; of `families` at their start.
    pub slow: Option<[SpinType; 2]>,
    /// By the end that is up, then by rising spin.
    pub changes: Vec<SpinChangeDocument>,
    /// The spins between the changes of the type, but those between which no double lies, by the end that is up, then by rising spin.
    pub stretches: Vec<SpinStretchDocument>,
    /// What the tolerance does to the changes of stability.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tolerance: Option<ToleranceDocument>,
    /// What is not known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub note: Option<String>,
    /// The part from which A and r were computed, when one was given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub part: Option<PartDocument>,
}
