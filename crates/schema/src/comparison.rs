//! `compare`: what the diagram of one body has and that of another lacks.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{BorderEventDocument, ComponentDocument, EventKind, GivenBody, Head, Stability, StabilityChangeKind};

/// One of two bodies that are compared.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ComparedBodyDocument {
    /// The body as `command` names it.
    pub name: String,
    /// The body.
    #[serde(flatten)]
    pub body: GivenBody,
    /// Its class; null where that is not decided.
    pub class: Option<String>,
    /// Number of its regions.
    pub regions: usize,
    /// Number of its events.
    pub events: usize,
    /// The largest number of relative equilibria at one l; a critical circle or sphere counts once.
    pub critical_points_max: usize,
}

/// The regions with the same U, E and P.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ComparedRegionsDocument {
    /// The components of U_hl.
    pub components: Vec<ComponentDocument>,
    /// The sections' names joined by `+`; null when r = 0.
    pub signature: Option<String>,
    /// Ids of the regions of each body that have them.
    pub regions: [Vec<String>; 2],
}

/// The events of one kind on the same branches.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct ComparedEventDocument {
    /// What happens.
    pub kind: EventKind,
    /// The branches that meet, in words, in axes by rising moments.
    pub branches: Vec<String>,
    /// How many each body has.
    pub counts: [usize; 2],
}

/// The changes of the linear type of one kind on one branch.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct ComparedStabilityDocument {
    /// What happens.
    pub kind: StabilityChangeKind,
    /// The branch in words, in axes by rising moments.
    pub branch: String,
    /// The type before: at smaller l or, at a cusp or pitchfork, on the first of the two curves.
    pub from: Stability,
    /// The type after.
    pub to: Stability,
    /// How many each body has.
    pub counts: [usize; 2],
}

/// A border that the straight path between two bodies crosses.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct CrossedBorderDocument {
    /// Where on the path: 0 is the first body, 1 the second.
    pub at: f64,
    /// Estimate of the error of `at`.
    pub error: f64,
    /// What happens there. Places are in the units of the path.
    #[serde(flatten)]
    pub event: BorderEventDocument,
    /// The classes before and behind.
    pub classes: [String; 2],
}

/// The path between two bodies: straight in A and r, both in standard form, A1 ≤ A2 ≤ A3 with sum 2 and r_i ≥ 0 with
/// largest component 1.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct PathDocument {
    /// The two ends, in these axes and units. Where moments are equal the axes are those in which r is nearest to that of the
    /// other body.
    pub ends: [GivenBody; 2],
    /// For each end: r is turned by 90° about an axis of symmetry, or reflected there, or that of a ball has the direction of the other's r, which changes no diagram.
    pub turned: [bool; 2],
    /// The borders that were found, in their order. Bisection may miss a class that the path enters and leaves again.
    pub borders: Vec<CrossedBorderDocument>,
    /// True when these borders lead from the class of the first body to that of the second.
    pub complete: bool,
}

/// The answer of `compare`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ComparisonDocument {
    /// Where it comes from.
    #[serde(flatten)]
    pub head: Head,
    /// The two bodies.
    pub bodies: [ComparedBodyDocument; 2],
    /// True when both have one class; null where a class is not decided.
    pub same_class: Option<bool>,
    /// All kinds of regions of both.
    pub regions: Vec<ComparedRegionsDocument>,
    /// All kinds of events of both.
    pub events: Vec<ComparedEventDocument>,
    /// All kinds of changes of stability of both.
    pub stability_changes: Vec<ComparedStabilityDocument>,
    /// The straight path between them.
    pub path: PathDocument,
}
