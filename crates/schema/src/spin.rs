//! Documents of states and spins: `bifdiag state`, `bifdiag critical-spin`, `bifdiag campbell`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{
    Failing, FrictionDocument, GivenBody, Head, MarginDocument, Multiplicity, NonlinearDocument, NonlinearVerdict,
    PartDocument, Reason, RelativeEquilibriumDocument, Stability, StabilityChangeKind, Verdict,
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
    /// At this spin it meets another steady axis: slower bodies have neither.
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

/// A spin at which alone a hypothesis of Arnold's theorem fails, between spins to which it applies.
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

/// A range of spins in which a family has one linear type, to the start of the next one or to infinity.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SteadyStretchDocument {
    /// Where it begins; `null`: at rest.
    pub from: Option<SteadyPlaceDocument>,
    /// Which eigenvalues meet there; `null` where the family itself begins.
    pub change: Option<StabilityChangeKind>,
    /// Linear type of the flow reduced by l.
    pub stability: Stability,
    /// What is known of its stability, but at the isolated spins.
    pub stable: Verdict,
    /// The isolated spins inside at which Arnold's theorem does not apply; `null` where not all of them were found.
    pub isolated: Option<Vec<IsolatedSpinDocument>>,
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

/// A permanent axis near to the one that was asked about.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct NearestAxisDocument {
    /// A unit vector in the frame of the question, at an acute angle to the axis of the question.
    pub axis: [f64; 3],
    /// The angle between the two, in degrees.
    pub angle_deg: f64,
    /// The one spin at which it is permanent; `null`: every spin, or none.
    pub spin: Option<SpinDocument>,
    /// Which of its ends is up then: `+axis` or `-axis`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub up: Option<String>,
}

/// A spin at which stability or regions change.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SpinChangeDocument {
    /// Which end of the axis is up: `+axis` or `-axis`.
    pub up: String,
    /// The spin.
    pub spin: SpinDocument,
    /// l there.
    pub l: f64,
    /// h there.
    pub h: f64,
    /// `stability`, `region`, or `stability-and-region`.
    pub kind: String,
    /// The spectral type below.
    pub from: String,
    /// The spectral type above.
    pub to: String,
    /// What the curves do there: `fork`, `crossing`, `cusp`; `null` where only the stability changes.
    pub event: Option<String>,
    /// Bound on the error of the spin, in rad/s.
    pub error_bound: f64,
}

/// The spin at which rotation about an axis of Staude's cone is steady.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SteadySpinDocument {
    /// Which end of the axis is up: `+axis` or `-axis`.
    pub up: String,
    /// The spin.
    pub spin: SpinDocument,
    /// l there.
    pub l: f64,
    /// h there.
    pub h: f64,
    /// The spectral type; `null` where it was not found.
    pub stability: Option<String>,
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
    /// Which end of the axis is up: `+axis` or `-axis`.
    pub up: String,
    /// The change below; `null`: rest.
    pub from: Option<SpinDocument>,
    /// The change above; `null`: any larger spin.
    pub to: Option<SpinDocument>,
    /// The spectral type.
    pub stability: String,
    /// The verdict, but at the isolated spins.
    pub nonlinear: NonlinearDocument,
    /// The isolated spins inside at which Arnold's theorem does not apply; `null` where not all of them were found.
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
    /// Rotation about it is permanent at every spin.
    pub permanent: bool,
    /// The permanent axis that is taken where `permanent` is true and the given one is not it to the last digit; else the
    /// nearest permanent axis.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub nearest: Option<NearestAxisDocument>,
    /// The spin at which rotation about the given axis itself is steady, at an angle of 10⁻⁶ at most; empty if there is none;
    /// absent where the given axis is permanent at every spin.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub steady: Option<Vec<SteadySpinDocument>>,
    /// Of an axis that is not permanent: the families of steady axes that tend to the principal axis nearest to it at fast
    /// spins, with `+axis` and with `-axis` up.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub families: Vec<SteadyFamilyDocument>,
    /// The spectral type at rest or at the slowest spins, with `+axis` and with `-axis` up; of `families` at their start.
    pub slow: Option<[String; 2]>,
    /// By the end that is up, then by rising spin.
    pub changes: Vec<SpinChangeDocument>,
    /// The spins between the changes of the type, by the end that is up, then by rising spin.
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

/// Changes of stability when the moments and the weight are known to relative tolerances.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ToleranceDocument {
    /// The relative tolerances of the moment about the axis, of the two others and of the weight times its distance; absent
    /// where each number has its own.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub relative: Option<[String; 4]>,
    /// The numbers of the part that are known to within so much; empty with `relative`.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub inputs: Vec<MeasuredDocument>,
    /// The ranges are those of the steady rotation that moves with the spin and tends to the principal axis nearest to the
    /// given one at fast spins, since no rotation about the given axis is permanent.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub moving: bool,
    /// Outside the ranges each part has at every spin a steady rotation nearer than this, in degrees, to the axis or, with
    /// `moving`, to that of the nominal part at the same spin; absent where the axis itself is permanent for all of them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tilt_deg: Option<f64>,
    /// How many parts were tried for `classes`, and with `relative` for `between` and `most`.
    pub sampled_parts: usize,
    /// The classes of the diagrams of these parts, the most frequent first.
    pub classes: Vec<SampledClassDocument>,
    /// Ranges of spins outside of which the spectral type of no part within the tolerances changes (its regions and
    /// frequencies may), by the end that is up, then by rising spin: bounds by interval arithmetic, not samples. Between two
    /// of them all parts are of one type.
    pub ranges: Vec<SpinRangeDocument>,
}

/// A number of a part that is known to within so much.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct MeasuredDocument {
    /// Ixx, …, com x, …, mass: as entries of the tensor, and from the fixed point.
    pub name: String,
    /// The nominal value, exact.
    pub value: String,
    /// The largest deviation, exact.
    pub within: String,
}

/// A class of diagrams among sampled parts.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct SampledClassDocument {
    /// Its name; `null` for parts whose class is left open.
    pub class: Option<String>,
    /// How many of the sampled parts have it.
    pub parts: usize,
}

/// Spins at which a change may lie.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SpinRangeDocument {
    /// Which end of the axis is up.
    pub up: String,
    /// The spectral type of all parts below; `null` where the range begins at rest.
    pub from: Option<String>,
    /// The spectral type of all parts above; `null` where the range has no end.
    pub to: Option<String>,
    /// Bounds in rpm; an infinite end is `null`.
    pub rpm: [Option<f64>; 2],
    /// Types other than these that some of the sampled parts have inside.
    pub between: Vec<String>,
    /// The input that moves the change most by itself: with `relative` that of the nominal part, from samples, else by bounds;
    /// `null` where there is none.
    pub most: Option<String>,
    /// How far it moves it, in rpm.
    pub most_rpm: Option<f64>,
}

/// A steady rotation in numbers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SteadyDocument {
    /// Its axis, a unit vector in the frame of the question, pointing up.
    pub axis: [f64; 3],
    /// The angle between it and the vertical of the question, in degrees; 0 where they are meant to be one.
    pub angle_deg: f64,
    /// Its energy, in the units of the body.
    pub h: f64,
    /// Its vertical angular momentum.
    pub l: f64,
    /// The spectral type.
    pub stability: String,
    /// `circle` or `sphere`: it is one of so many steady rotations at this spin, and `stable` is that of all as a whole;
    /// absent for one alone.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub one_of: Option<Multiplicity>,
    /// What is known of its stability, as in `critical`.
    pub stable: Verdict,
    /// The verdict on its stability, with its reason.
    pub nonlinear: NonlinearDocument,
    /// What friction leaves of it.
    pub friction: FrictionDocument,
    /// Frequencies of small oscillations seen from the turning body, in Hz, by size; 0 for a real pair of eigenvalues and
    /// for a pair of zeros, the same twice for a complex quadruple.
    pub frequencies_hz: [f64; 2],
    /// The time in which a deviation grows by e, in s; `null` when none does.
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

/// A state: where it lies in the (h, l) plane and what it is.
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
    /// The direction upward in that frame.
    pub vertical: [f64; 3],
    /// Its magnitude.
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
