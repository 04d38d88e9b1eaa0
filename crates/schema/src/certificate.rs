//! The certificate of a certified atlas: what a second program needs to check it without searching again.
//!
//! All numbers are strings that denote rationals exactly. They refer to the body in the certificate's units: moments
//! divided by `units.moment`, r divided by `units.energy`, x = l²/2, so that l² is in units of their product.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Units of the numbers of a certificate: powers of four.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct CertificateUnits {
    /// Unit of A.
    pub moment: String,
    /// Unit of r and h.
    pub energy: String,
}

/// A range of places on a family of relative equilibria.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct PlaceDocument {
    /// Number of an eigenspace of A, by rising moment, from 0.
    pub base: usize,
    /// `+`: μ = a + y; `-`: μ = a − y; `over`: v = s² = P̂ + y over an eigenspace that carries no r.
    pub side: String,
    /// y lies between these.
    pub y: [String; 2],
}

/// An isolated cusp: the only root of the cusp polynomial in its range.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct CertifiedCusp {
    /// Where it is.
    pub place: PlaceDocument,
    /// Ids of the two curves.
    pub curves: [String; 2],
}

/// An isolated meeting of a critical curve with a pole line.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct CertifiedMeeting {
    /// `+` or `-`.
    pub pole: String,
    /// Where it is on the critical curve.
    pub place: PlaceDocument,
    /// The critical curve; both, if the meeting is exactly at a cusp or pitchfork.
    pub curves: Vec<String>,
    /// The curves touch and do not cross.
    pub touch: bool,
}

/// Where two curves are compared.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct CertifiedNode {
    /// x; absent at the beginning or end of the common range.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub x: Option<String>,
    /// The places of both curves over x; absent at x → ∞ and at an end that both share.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub places: Option<[PlaceDocument; 2]>,
}

/// A range of x on which the order of two curves is constant, or changes once.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct CertifiedStretch {
    /// Lower end.
    pub from: CertifiedNode,
    /// Upper end.
    pub to: CertifiedNode,
    /// Sign of h of the first curve minus h of the second at the lower end.
    pub sign: i8,
    /// The box in x of the one crossing, if there is one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub crossing: Option<[CertifiedNode; 2]>,
}

/// The order of two critical curves over all their common range.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct CertifiedPair {
    /// Ids.
    pub curves: [String; 2],
    /// By rising x, without gaps.
    pub stretches: Vec<CertifiedStretch>,
}

/// A point where curves meet.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct CertifiedEvent {
    /// What it is: `cusp:N`, `pitchfork:N`, `meeting:N` (numbers from 0 in the lists of the certificate) or
    /// `crossing`. Several: they are proved to be one point.
    pub sources: Vec<String>,
    /// Ids of the curves that meet.
    pub curves: Vec<String>,
    /// Enclosure of x.
    pub x: [String; 2],
    /// Enclosure of h.
    pub h: [String; 2],
}

/// A curve over the abscissa of a slab.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct CertifiedHeight {
    /// Id of the curve.
    pub curve: String,
    /// Its place over x; absent on a straight line.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub place: Option<PlaceDocument>,
    /// Id of the region above.
    pub region: String,
}

/// A strip between events: the order of the curves over one abscissa.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct CertifiedSlab {
    /// The abscissa.
    pub x: String,
    /// Curves by rising h.
    pub curves: Vec<CertifiedHeight>,
}

/// A point at which the topology of a region is proved.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct CertifiedSample {
    /// Id of the region.
    pub region: String,
    /// Number of the slab whose abscissa is taken, from 0.
    pub slab: usize,
    /// Energy.
    pub h: String,
}

/// A certificate.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct CertificateDocument {
    /// Units of all its numbers.
    pub units: CertificateUnits,
    /// Bits of the arithmetic that the proof needed at most.
    pub bits: usize,
    /// Cusps of the generic family, then those over eigenspaces without r.
    pub cusps: Vec<CertifiedCusp>,
    /// The place where the slope of the generic family turns, if r lies on no principal plane.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub inflection: Option<PlaceDocument>,
    /// Meetings with pole lines.
    pub meetings: Vec<CertifiedMeeting>,
    /// Orders of pairs of critical curves. Pairs with the global minimum, and of straight lines, need none.
    pub pairs: Vec<CertifiedPair>,
    /// Events by rising x.
    pub events: Vec<CertifiedEvent>,
    /// Numbers of the events between each two slabs.
    pub transitions: Vec<Vec<usize>>,
    /// Slabs by rising x: one more than transitions.
    pub slabs: Vec<CertifiedSlab>,
    /// A sample of each region.
    pub samples: Vec<CertifiedSample>,
    /// SHA-256 of the atlas as compact JSON with this string empty.
    pub checksum: String,
}
