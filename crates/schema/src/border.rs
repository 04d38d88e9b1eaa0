//! `scan border`: where the class changes between two bodies.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{BodyParameter, Head, RangeDocument};

/// Kinds of borders, in general of codimension one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum BorderEventName {
    /// Two cusps of one branch, and with them a crossing, are born or vanish.
    Swallowtail,
    /// Three curves meet in one point.
    TriplePoint,
    /// A cusp passes through another curve.
    CuspOnCurve,
    /// A pitchfork passes through another curve, or two pitchforks or crossings on one curve change places.
    PitchforkOnCurve,
    /// A cusp reaches the pitchfork of its branch.
    CuspAtPitchfork,
    /// A pitchfork leaves to infinity on one curve and comes back on another: two moments of inertia pass each other.
    PitchforkAtInfinity,
    /// A component of r is 0 at the border alone, and with it the body has a symmetry: beside it some of its pitchforks open
    /// into cusps.
    SymmetryBroken,
    /// Moments of inertia are equal at the border.
    MomentsEqual,
    /// r is 0 at the border.
    WeightVanishes,
    /// J_r passes the middle moment of inertia: crossings of the pole lines go to infinity and come back.
    PoleLinesAtInfinity,
    /// A crossing comes from, or goes to, l = 0 or infinity.
    CrossingAtTheEdge,
    /// Several of these at once, or something else; see the lists.
    Other,
}

/// What happens at a border.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct BorderEventDocument {
    /// Which kind.
    pub kind: BorderEventName,
    /// In words.
    pub text: String,
    /// The curves that take part, by their names on the side that has more of them.
    pub curves: Vec<String>,
    /// Energy of the place where it happens, if it is a place.
    pub h: Option<f64>,
    /// Vertical angular momentum there.
    pub l: Option<f64>,
    /// Estimate of the error of both.
    pub error_bound: Option<f64>,
    /// Events that only the body with the first of `classes` has, by the names of their branches: where the border is the
    /// body's own, as with equal moments, one event may have two names.
    pub vanish: Vec<String>,
    /// Events that only the body with the second has, likewise.
    pub appear: Vec<String>,
}

/// The value of a parameter at a border.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct BorderValueDocument {
    /// The parameter.
    pub parameter: BodyParameter,
    /// Where the class changes.
    pub value: f64,
    /// Estimate of the error of `value`; 0 where the border is at just this value.
    pub error: f64,
    /// Values at which the body has the first and the second of `classes`; the bodies between are undecided or were not
    /// examined, and other borders may lie beyond them.
    pub enclosure: [f64; 2],
}

/// A border between two classes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct FoundBorderDocument {
    /// Where the class changes: a value of each parameter that varies.
    pub at: Vec<BorderValueDocument>,
    /// What happens there.
    #[serde(flatten)]
    pub event: BorderEventDocument,
    /// The classes at the two ends of the enclosure.
    pub classes: [String; 2],
    /// True when every error is at most 1e-10.
    pub reached: bool,
}

/// The answer of `scan border`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct BorderDocument {
    /// Where it comes from.
    #[serde(flatten)]
    pub head: Head,
    /// The ranges that were searched.
    pub vary: Vec<RangeDocument>,
    /// The border that was found; between the two ends of `vary` there may be others.
    pub borders: Vec<FoundBorderDocument>,
    /// Bodies that were examined.
    pub atlases: u32,
}

/// An event along a way through the bodies.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct EventTrackDocument {
    /// What meets.
    pub event: String,
    /// The places in `borders` between which it lives, from 0; null where that is an end of the range.
    pub between: [Option<u32>; 2],
    /// The values of the parameter at which it was computed.
    pub at: Vec<f64>,
    /// Its energy at each of them.
    pub h: Vec<f64>,
    /// Its vertical angular momentum.
    pub l: Vec<f64>,
}

/// The answer of `scan events`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct EventTracksDocument {
    /// Where it comes from.
    #[serde(flatten)]
    pub head: Head,
    /// The parameter and its range.
    pub vary: RangeDocument,
    /// Bodies in equal steps, as many as were asked for.
    pub bodies: u32,
    /// Those that were left out: special bodies, those on a border, undecided ones, and those of another class than their
    /// stretch; neighbouring bodies were examined instead.
    pub passed: u32,
    /// The class before the first border, between any two, and behind the last; null where it is not known.
    pub classes: Vec<Option<String>>,
    /// Where the class changes, in order, and the special bodies between bodies of one class.
    pub borders: Vec<FoundBorderDocument>,
    /// The events.
    pub events: Vec<EventTrackDocument>,
}
