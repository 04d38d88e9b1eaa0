//! What tolerances do to the spins at which rotation about an axis changes.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{AxisEnd, SpinType};

/// Changes of stability when the moments and the weight, or the numbers of a part, are known to within tolerances.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ToleranceDocument {
    /// The relative tolerances of the moment about the axis, of the two others and of the weight times its distance; with
    /// `moving` the same four times, that of every moment and of every component of r; absent where each number has its own.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub relative: Option<[String; 4]>,
    /// The numbers of the part that have an uncertainty; empty with `relative`.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub inputs: Vec<MeasuredDocument>,
    /// The ranges are those of the steady rotation that moves with the spin and is nearest to the given axis at
    /// fast spins, since no rotation about the given axis is permanent.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub moving: bool,
    /// Outside the ranges each part has at every spin a steady rotation nearer than this, in degrees, to the permanent axis
    /// that is judged or, with `moving`, to that of the nominal part at the same spin; absent where that axis is found
    /// permanent for all of them: along x, y or z, or where the numbers with a ± only scale the weight.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tilt_deg: Option<f64>,
    /// How many parts were tried for `classes`, and with `relative`, but for `moving`, for `between`.
    pub sampled_parts: usize,
    /// The classes of the diagrams of these parts, the most frequent first.
    pub classes: Vec<SampledClassDocument>,
    /// Ranges of spins outside of which the spectral type of no part within the tolerances changes (its regions and
    /// frequencies may), by the end that is up, then by rising spin: bounds by interval arithmetic, not samples. Between two
    /// of them all parts are of one type.
    pub ranges: Vec<SpinRangeDocument>,
}

/// A number of a part with an uncertainty.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct MeasuredDocument {
    /// Ixx, …, com x, …, mass, g, products as entries of the tensor; `pivot x` where that alone is uncertain, and
    /// `com x - pivot x` where com is and the pivot is uncertain or not the origin.
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
    /// How many of the sampled parts have this class.
    pub parts: usize,
}

/// Spins at which a change may lie.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SpinRangeDocument {
    /// Which end of the axis is up.
    pub up: AxisEnd,
    /// The spectral type of all parts below, `elliptic` and `elliptic (local minimum)` also for double pairs; `null` where the range
    /// begins at rest.
    pub from: Option<SpinType>,
    /// The spectral type of all parts above; `null` where the range has no end.
    pub to: Option<SpinType>,
    /// Bounds in rpm; an infinite end is `null`.
    pub rpm: [Option<f64>; 2],
    /// Types other than these that some of the sampled parts have inside; empty where not sought: with ± on single numbers,
    /// and with `moving`.
    pub between: Vec<SpinType>,
    /// The single input that moves the change most: with `relative` that of the nominal part (the last of several), when it
    /// alone is at either end of its tolerance, else by bounds; `null` if there is none.
    pub most: Option<String>,
    /// How far it moves it, in rpm; `null` where the change vanishes with it, or its bounds have no end.
    pub most_rpm: Option<f64>,
}
