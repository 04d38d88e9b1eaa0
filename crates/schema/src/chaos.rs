//! Documents of `bifdiag chaos`: the chaotic share of energy surfaces.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{GivenBody, Head, PartDocument};

/// The chaotic share of a component of E, in Liouville measure.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ChaosShareDocument {
    /// The component of U over which it lies, such as `D2`.
    pub accessible_region: String,
    /// The component of E, such as `S3`.
    pub energy_surface: String,
    /// The share of the orbits that are known to be chaotic; the whole lies between this and `fraction` + `open`.
    pub fraction: f64,
    /// One standard deviation of `fraction`.
    pub error: f64,
    /// The share of the orbits without a verdict.
    pub open: f64,
    /// How many orbits were judged.
    pub orbits: u64,
    /// How often they crossed the section S = 0, as seen at the steps of the integrator.
    pub crossings: u64,
}

/// The answer of `chaos` at one point.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ChaosPointDocument {
    /// Where it comes from.
    #[serde(flatten)]
    pub head: Head,
    /// The body.
    #[serde(flatten)]
    pub body: GivenBody,
    /// Energy as given.
    pub h: String,
    /// Vertical angular momentum as given.
    pub l: String,
    /// The region of the point; absent where no atlas was made.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub region: Option<String>,
    /// Steps of the integrator after which an orbit stays open.
    pub steps: u64,
    /// One entry for each component of E, in the order of `classify`.
    pub components: Vec<ChaosShareDocument>,
    /// The part from which A and r were computed, when one was given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub part: Option<PartDocument>,
}
