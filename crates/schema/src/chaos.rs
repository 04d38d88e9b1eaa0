//! Documents of `bifdiag chaos`: the chaotic share of energy surfaces.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{GivenBody, Head, PartDocument, WindowDocument};

/// The chaotic share of a component of E, in Liouville measure.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ChaosShareDocument {
    /// The component of U over which it lies, such as `D2`.
    pub accessible_region: String,
    /// The component of E, such as `S3`.
    pub energy_surface: String,
    /// The share of the orbits known to be chaotic; apart from the sampling error, the true share lies between this and
    /// `fraction` + `open`.
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
    /// Steps of the integrator after which an orbit is left open.
    pub steps: u64,
    /// One entry for each component of E, in the order of `classify`.
    pub components: Vec<ChaosShareDocument>,
    /// The part from which A and r were computed, when one was given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub part: Option<PartDocument>,
}

/// A row of a map: one component of E in one region, in one cell.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ChaosCellDocument {
    /// The cell, counted from 0 along h and along l.
    pub cell: [u64; 2],
    /// Energy at its centre.
    pub h: f64,
    /// Vertical angular momentum at its centre.
    pub l: f64,
    /// The region.
    pub region: String,
    /// The component of E, counted from 0 in the order of `classify`.
    pub component: u32,
    /// The fraction of the block that belongs to the region, estimated from 16 points.
    pub part: f64,
    /// Cells along a side of the block that was measured as one: its orbits are those of all its cells.
    pub block: u32,
    /// The share of the orbits that are known to be chaotic; `null` without orbits.
    pub fraction: Option<f64>,
    /// One standard deviation of `fraction`, including by how much the quarters of the block differ beyond chance.
    pub error: Option<f64>,
    /// The share of the orbits without a verdict.
    pub open: f64,
    /// How many orbits were judged; 0 where the component is too thin to be met.
    pub orbits: u64,
    /// How often they crossed the section S = 0, as seen at the steps of the integrator.
    pub crossings: u64,
}

/// A map of the chaotic share over a window, or a shard of it; without its rows, the `meta` of its tables.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ChaosMapDocument {
    /// Where it comes from.
    #[serde(flatten)]
    pub head: Head,
    /// The body.
    #[serde(flatten)]
    pub body: GivenBody,
    /// What the map shows.
    pub window: WindowDocument,
    /// How many cells, along h and along l.
    pub cells: [u64; 2],
    /// The requested standard deviation.
    pub error: f64,
    /// Steps of the integrator after which an orbit is left open.
    pub steps: u64,
    /// The choice of the orbits.
    pub seed: u64,
    /// The range of 8 × 8 tiles that it contains, from the first one up to but excluding the second.
    pub tiles: [u64; 2],
    /// Its rows, by tiles, then by cells.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub rows: Vec<ChaosCellDocument>,
    /// The part from which A and r were computed, when one was given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub part: Option<PartDocument>,
}
