//! `classify`: the type of U, E and P at one point (h, l).

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{Accuracy, GivenBody, Head, Number, PartDocument};

/// One connected component of U_hl with the components of E_hl and P_hl above it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct ComponentDocument {
    /// k: the component of U_hl is the sphere without k discs.
    pub boundary_circles: u32,
    /// The poles inside: `+` for r̂ and `-` for −r̂; null when r = 0.
    pub poles: Option<Vec<String>>,
    /// Its name: `S2` (the sphere), `D2` (a disc), `S2-2D2` (an annulus), … `S2-kD2`.
    pub accessible_region: String,
    /// The component of E_hl above it: `RP3`, `S3`, `S1xS2`, `(S1xS2)#(S1xS2)`, `#3(S1xS2)` … `#(k-1)(S1xS2)`.
    pub energy_surface: String,
    /// The component of P_hl above it, by genus: `S2`, `T2`, `M2`, `M3`, …; null when r = 0.
    pub section: Option<String>,
    /// Genus of `section`: k + n − 1 with n poles inside; null when r = 0.
    pub genus: Option<u32>,
}

/// Distance in h to the nearest curve. With `fast`, curves that begin or end within rounding (1e-14) of l count on both
/// sides; with `exact`, those at l itself.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct MarginDocument {
    /// `|h − h_c|` to the nearest critical curve or pole line at this l.
    pub h: f64,
    /// Id of that curve; `l=0` at rest without weight, where no curve of the atlas is nearest.
    pub nearest: String,
    /// Bound on the error of `h`.
    pub error_bound: f64,
}

/// What is known of a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Status {
    /// Inside a region; `components` holds the answer.
    Regular,
    /// Below the lowest critical value: U_hl is empty.
    Forbidden,
    /// Exactly on a curve (proved); `candidates` holds every region that meets there, with `fast` those beside curves
    /// within the error bound too.
    Critical,
    /// Closer to a curve than the error bound (only with `fast`); `candidates` holds every possible region.
    Undecided,
}

/// A region that meets at a critical or undecided point; without an atlas, a class.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct CandidateDocument {
    /// Id of the region; null for the forbidden region, and without an atlas.
    pub region: Option<String>,
    /// `regular`, or `forbidden` for the region below the lowest critical value.
    pub status: Status,
    /// The components of U_hl there; none in the forbidden region.
    pub components: Vec<ComponentDocument>,
}

/// The answer of `classify`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ClassificationDocument {
    /// Where it comes from.
    #[serde(flatten)]
    pub head: Head,
    /// The body.
    #[serde(flatten)]
    pub body: GivenBody,
    /// Energy as given.
    #[schemars(with = "Number")]
    pub h: String,
    /// Vertical angular momentum as given.
    #[schemars(with = "Number")]
    pub l: String,
    /// What is known of the point.
    pub status: Status,
    /// The requested level of accuracy.
    pub accuracy: Accuracy,
    /// Id of the region in the body's atlas; null unless regular, with `--no-region`, and where no atlas gives it (`note` says
    /// so).
    pub region: Option<String>,
    /// Distance to the nearest curve.
    pub margin: MarginDocument,
    /// The components of U_hl (none when forbidden); null when critical or undecided.
    pub components: Option<Vec<ComponentDocument>>,
    /// The sections' names joined by `+`; null when r = 0, when forbidden, and when no single class is known.
    pub signature: Option<String>,
    /// Each region that meets at a critical or undecided point, once; without an atlas, each class.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub candidates: Vec<CandidateDocument>,
    /// What of a point is not known or not defined, and why.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub note: Option<String>,
    /// The part from which A and r were computed, when one was given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub part: Option<PartDocument>,
}
