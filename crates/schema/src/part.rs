//! The block `part` of a document whose body was given as a real part.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{Head, IntegrableDocument};

/// Principal moments and axes about a point.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct PrincipalDocument {
    /// The principal moments, in the part's units.
    pub moments: [f64; 3],
    /// Row k is principal axis k in the part's frame.
    pub axes: [[f64; 3]; 3],
}

/// The answer of `body`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct PartAnswerDocument {
    /// Where it comes from.
    #[serde(flatten)]
    pub head: Head,
    /// The part.
    #[serde(flatten)]
    pub part: PartDocument,
    /// The integrable cases to which the part belongs.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub integrable: Vec<IntegrableDocument>,
}

/// A part as it was read.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct PartDocument {
    /// The tensor about the fixed point, its entries exact (off the diagonal Ixy = −∫ x y dm).
    pub inertia: [[String; 3]; 3],
    /// The centre of mass from the fixed point, exact.
    pub com: [String; 3],
    /// The mass, exact.
    pub mass: String,
    /// The acceleration of gravity in m/s².
    pub g: String,
    /// Units of mass, length and time, of the block and of h, l, A and r in the document; `g` is in m/s², spins in rpm and rad/s.
    pub units: String,
    /// About the fixed point: the axes in which A, r and γ of the document are.
    pub principal: PrincipalDocument,
    /// About the centre of mass: what CAD prints.
    pub principal_com: PrincipalDocument,
    /// Principal moments about the fixed point.
    #[serde(rename = "A")]
    pub moments: [String; 3],
    /// m g times the centre of mass, in the principal axes.
    #[serde(rename = "r")]
    pub center: [String; 3],
    /// True when A and r are exact; else they are rounded to at least 130 digits, so that equal moments, zeros and coincidences
    /// of thresholds remain.
    pub exact: bool,
    /// Some mass distribution has these mass properties.
    pub physical: bool,
}

impl PartDocument {
    /// The unit of every time of the document.
    #[must_use]
    pub fn time_unit(&self) -> &str {
        self.units.rsplit(',').next().unwrap_or_default().trim()
    }
}
