//! Documents of states and spins: `bifdiag state`, `bifdiag critical-spin`, `bifdiag campbell`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{MarginDocument, PartDocument};

/// A rate of turning in two units.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SpinDocument {
    /// Turns in a minute.
    pub rpm: f64,
    /// Radians in a second.
    pub rad_per_s: f64,
}

/// A permanent axis near to the one that was asked about.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct NearestAxisDocument {
    /// A unit vector in the frame of the question, pointing up.
    pub axis: [f64; 3],
    /// The angle between the two, in degrees.
    pub angle_deg: f64,
    /// The one spin at which it is permanent; `null`: every spin, or (with `up` turned) none.
    pub spin: Option<SpinDocument>,
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

/// Spins at which rotation about an axis changes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct CriticalSpinDocument {
    /// Version of the schema.
    pub schema_version: String,
    /// Version of the program.
    pub version: String,
    /// The command that makes the document.
    pub command: String,
    /// A1, A2, A3.
    #[serde(rename = "A")]
    pub moments: [String; 3],
    /// r1, r2, r3.
    #[serde(rename = "r")]
    pub center: [String; 3],
    /// The axis of the question, a unit vector in the part's frame (without a part: in principal axes).
    pub axis: [f64; 3],
    /// Rotation about it is permanent at every spin.
    pub permanent: bool,
    /// The angle to the principal axis that is meant, in degrees; else the nearest permanent axis is told.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub nearest: Option<NearestAxisDocument>,
    /// The spectral type at rest or at the slowest spins, with `+axis` and with `-axis` up.
    pub slow: Option<[String; 2]>,
    /// By the end that is up, then by rising spin.
    pub changes: Vec<SpinChangeDocument>,
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

/// Changes of stability when the moments and the weight are known to a relative tolerance.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ToleranceDocument {
    /// The relative tolerance of each moment and of the weight, as given.
    pub relative: String,
    /// How many parts were tried: each input less, nominal and more. A sample, not a bound.
    pub sampled_parts: usize,
    /// All of them have the same changes in the same order; else `ranges` is empty.
    pub same_changes: bool,
    /// The changes over the parts that were tried.
    pub ranges: Vec<SpinRangeDocument>,
}

/// One change over the parts that were tried.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SpinRangeDocument {
    /// Which end of the axis is up.
    pub up: String,
    /// The spectral type below.
    pub from: String,
    /// The spectral type above.
    pub to: String,
    /// Least and largest spin in rpm.
    pub rpm: [f64; 2],
    /// The input that moves it most by itself.
    pub most: String,
    /// By how much of the spin.
    pub most_change: f64,
}

/// A relative equilibrium in numbers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SteadyDocument {
    /// The spectral type.
    pub stability: String,
    /// Not unstable in the linear terms.
    pub stable: bool,
    /// Frequencies of small oscillations seen from the turning body, in Hz.
    pub frequencies_hz: [f64; 2],
    /// The time in which a deviation grows by e, in s; `null` when none does.
    pub growth_time_s: Option<f64>,
    /// The change at the next smaller spin.
    pub below: Option<SpinChangeDocument>,
    /// The change at the next larger spin.
    pub above: Option<SpinChangeDocument>,
    /// Regions just below and just above in h; `null`: forbidden or not known.
    pub regions: [Option<String>; 2],
}

/// A state: where it lies in the (h, l) plane and what it is.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct StateDocument {
    /// Version of the schema.
    pub schema_version: String,
    /// Version of the program.
    pub version: String,
    /// The command that makes the document.
    pub command: String,
    /// A1, A2, A3.
    #[serde(rename = "A")]
    pub moments: [String; 3],
    /// r1, r2, r3.
    #[serde(rename = "r")]
    pub center: [String; 3],
    /// The angular velocity in the frame of the question, in rad/s.
    pub omega: [f64; 3],
    /// The direction upward in that frame.
    pub vertical: [f64; 3],
    /// Its magnitude.
    pub spin: SpinDocument,
    /// The energy, in the units of the body.
    pub h: f64,
    /// The vertical angular momentum, in the units of the body.
    pub l: f64,
    /// Steady rotation about a permanent axis; `null` for another motion.
    pub steady: Option<SteadyDocument>,
    /// The region of (h, l); `null` on a curve.
    pub region: Option<String>,
    /// The distance of (h, l) to the nearest curve; `null` for a steady rotation, which lies on one.
    pub margin: Option<MarginDocument>,
    /// The nearest permanent axis, where the motion is not steady.
    pub nearest: Option<NearestAxisDocument>,
    /// The part from which A and r were computed, when one was given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub part: Option<PartDocument>,
}
