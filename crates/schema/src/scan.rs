//! Scans: which bodies, what is noted about each, and what they have in common.

use std::collections::BTreeMap;
use std::fmt;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{Accuracy, Head, Number};

/// One coordinate of (A, r).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema)]
#[schemars(rename = "ParameterName")]
pub enum BodyParameter {
    /// A1.
    A1,
    /// A2.
    A2,
    /// A3.
    A3,
    /// r1.
    #[serde(rename = "r1")]
    R1,
    /// r2.
    #[serde(rename = "r2")]
    R2,
    /// r3.
    #[serde(rename = "r3")]
    R3,
}

impl BodyParameter {
    /// All six, in the order of (A1, A2, A3, r1, r2, r3).
    pub const ALL: [Self; 6] = [Self::A1, Self::A2, Self::A3, Self::R1, Self::R2, Self::R3];

    /// As it is written.
    #[must_use]
    pub fn name(self) -> &'static str {
        ["A1", "A2", "A3", "r1", "r2", "r3"][self.place()]
    }

    /// Its place in (A1, A2, A3, r1, r2, r3).
    #[must_use]
    pub fn place(self) -> usize {
        self as usize
    }
}

impl fmt::Display for BodyParameter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// The values that one parameter takes.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct RangeDocument {
    /// Which.
    pub parameter: BodyParameter,
    /// Lower end.
    pub from: String,
    /// Upper end.
    pub to: String,
    /// Number of values in equal steps, both ends included; without it, the range is sampled, or halved by `scan border`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub steps: Option<u32>,
}

/// The bodies among which a scan chooses.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "family", rename_all = "lowercase")]
pub enum FamilyDocument {
    /// Every body that exists, up to its symmetries and units: A_i = 1 − m_i, where the second moments of mass m are
    /// uniform on the simplex m1 + m2 + m3 = 1, and r̂ uniform on the positive octant of the sphere, |r| = 1. Four
    /// parameters.
    General,
    /// As `general`, but with A itself uniform on the simplex A1 + A2 + A3 = 1, whether or not a body has these moments.
    Positive,
    /// A = (1, A2, A3), r = (1, 0, 0): the centre of mass on a principal axis. Two parameters.
    Katok,
    /// One body with some of its parameters varied.
    Body {
        /// A1, A2, A3 where not varied.
        #[serde(rename = "A")]
        #[schemars(with = "[Number; 3]")]
        moments: [String; 3],
        /// r1, r2, r3 where not varied.
        #[serde(rename = "r")]
        #[schemars(with = "[Number; 3]")]
        center: [String; 3],
    },
    /// Bodies that were given one by one; `samples` is their number.
    Listed {
        /// SHA-256 of A1, A2, A3, r1, r2, r3 of each body, as doubles of eight bytes, the lowest byte first.
        sha256: String,
    },
}

/// A numbered list of bodies.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct DesignDocument {
    /// The bodies.
    #[serde(rename = "bodies")]
    pub family: FamilyDocument,
    /// What varies; on a grid the last one varies fastest.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub vary: Vec<RangeDocument>,
    /// Number of points of the low-discrepancy sequence, or of the bodies of a list; absent for a grid.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub samples: Option<u64>,
    /// Seed of the sequence.
    #[serde(default)]
    pub seed: u64,
}

/// Which scan a file with rows belongs to: the first line of `FILE.partial`.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct ScanIdentityDocument {
    /// Version of the program.
    pub program: String,
    /// What the answers are worth.
    pub accuracy: Accuracy,
    /// Which bodies the scan covers.
    pub design: DesignDocument,
    /// The numbers of the bodies: from this one on, up to but without that one.
    pub range: [u64; 2],
}

/// How far a body was understood.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum RowStatus {
    /// It has a class.
    Classified,
    /// Its diagram is open at this accuracy, or not proved within the limits; the numbers of the row are what was
    /// found.
    Undecided,
    /// The atlas cannot be computed, or fails a check; `error` says why.
    Failed,
}

/// One body of a scan.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct RowDocument {
    /// Number of the body in the scan, from 0.
    pub index: u64,
    /// A1.
    #[serde(rename = "A1")]
    pub a1: f64,
    /// A2.
    #[serde(rename = "A2")]
    pub a2: f64,
    /// A3.
    #[serde(rename = "A3")]
    pub a3: f64,
    /// r1.
    pub r1: f64,
    /// r2.
    pub r2: f64,
    /// r3.
    pub r3: f64,
    /// How far the body was understood.
    pub status: RowStatus,
    /// Name of the class of its diagram.
    pub class: Option<String>,
    /// Number of regions.
    pub regions: Option<u32>,
    /// Number of cusps.
    pub cusps: Option<u32>,
    /// Number of pitchforks.
    pub pitchforks: Option<u32>,
    /// Number of crossings.
    pub crossings: Option<u32>,
    /// The largest number of relative equilibria at one l; a circle counts once.
    pub critical_points: Option<u32>,
    /// How many regions have each signature (for r = 0, each type of U): `S2:2 S2+T2:1`.
    pub signatures: Option<String>,
    /// How many regions show a component with k boundary circles and n poles: `k0n2:1 k1n1:4`.
    pub types: Option<String>,
    /// For the most visible region (of those bounded above): the distance in h of its sample from the boundary, divided
    /// by |r|.
    pub largest_margin: Option<f64>,
    /// Signature of that region.
    pub largest_region: Option<String>,
    /// As `largest_margin`, of the region that is hardest to see.
    pub smallest_margin: Option<f64>,
    /// Signature of that region.
    pub smallest_region: Option<String>,
    /// No mass distribution has these moments and this centre of mass. This and what follows, up to `euler`, is false of
    /// numbers that are those of no body, such as A1 = 0.
    pub unphysical: bool,
    /// A_i + A_j = A_k and r_k = 0.
    pub plate: bool,
    /// Equal moments.
    pub symmetric: bool,
    /// Some r_i = 0.
    pub plane: bool,
    /// r is a principal direction.
    pub axis: bool,
    /// r = 0.
    pub euler: bool,
    /// Points of curves that were computed to find the crossings.
    pub work: Option<u32>,
    /// Why the body has no class.
    pub error: Option<String>,
}

/// A body that shows something, with its number in the scan.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct BodyRecordDocument {
    /// Its number.
    pub index: u64,
    /// A1, A2, A3.
    #[serde(rename = "A")]
    pub moments: [f64; 3],
    /// r1, r2, r3.
    #[serde(rename = "r")]
    pub center: [f64; 3],
}

/// A class and how often it was met.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ClassRecordDocument {
    /// Its name.
    pub class: String,
    /// Number of bodies.
    pub bodies: u64,
    /// Number of its regions.
    pub regions: u32,
    /// Number of its cusps, pitchforks and crossings.
    pub events: [u32; 3],
    /// The first body of the class.
    pub first: BodyRecordDocument,
    /// Its canonical form, line by line.
    pub text: Vec<String>,
}

/// Something that bodies show: how many do, and the first of them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct RecordDocument {
    /// Number of bodies.
    pub bodies: u64,
    /// The first body.
    pub first: BodyRecordDocument,
}

/// The summary of a scan.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ScanSummaryDocument {
    /// Where it comes from.
    #[serde(flatten)]
    pub head: Head,
    /// The program and its version, as in the rows that a stopped scan leaves.
    pub program: String,
    /// What the answers are worth.
    #[serde(default)]
    pub accuracy: Accuracy,
    /// Which bodies the scan covers.
    pub design: DesignDocument,
    /// The numbers of the bodies: from this one on, up to but without that one.
    pub range: [u64; 2],
    /// Number of bodies.
    pub rows: u64,
    /// Bodies with a class.
    pub classified: u64,
    /// Bodies whose class is open at this accuracy.
    pub undecided: u64,
    /// Bodies without an atlas.
    pub failed: u64,
    /// Points of curves that were computed in all.
    pub work: u64,
    /// Format of the file with the rows.
    pub format: String,
    /// SHA-256 of that file.
    pub sha256: String,
    /// For each number of relative equilibria at one l, at most: the bodies.
    pub critical_points: BTreeMap<u32, RecordDocument>,
    /// For each number of regions: the bodies.
    pub regions: BTreeMap<u32, RecordDocument>,
    /// For each type of component (boundary circles and poles): the bodies that show it.
    pub types: BTreeMap<String, RecordDocument>,
    /// For each signature (for r = 0, each type of U): the bodies that show it.
    pub signatures: BTreeMap<String, RecordDocument>,
    /// Every class, the most frequent first.
    pub classes: Vec<ClassRecordDocument>,
}
