//! `critical`: all relative equilibria at one l.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::InertiaDocument;

/// Spectral stability of a relative equilibrium under the linearised Euler–Poisson flow at fixed l.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Stability {
    /// Two imaginary pairs.
    Elliptic,
    /// One real and one imaginary pair.
    SaddleCentre,
    /// Two real pairs.
    Saddle,
    /// A complex quadruple.
    Complex,
    /// An eigenvalue zero or a double pair, within rounding.
    Degenerate,
}

/// How many critical points an entry stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Multiplicity {
    /// One critical point; 2 is a degenerate root (at a cusp).
    Points(u32),
    /// A circle of critical points (Lagrange's top); `gamma` is one of them.
    Circle,
    /// All of S² is critical (r = 0 and three equal moments).
    Sphere,
}

impl Serialize for Multiplicity {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Points(count) => serializer.serialize_u32(*count),
            Self::Circle => serializer.serialize_str("circle"),
            Self::Sphere => serializer.serialize_str("sphere"),
        }
    }
}

impl<'de> Deserialize<'de> for Multiplicity {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        #[derive(Deserialize)]
        #[serde(untagged)]
        enum Raw {
            Count(u32),
            Name(String),
        }
        match Raw::deserialize(deserializer)? {
            Raw::Count(count) => Ok(Self::Points(count)),
            Raw::Name(name) if name == "circle" => Ok(Self::Circle),
            Raw::Name(name) if name == "sphere" => Ok(Self::Sphere),
            Raw::Name(name) => {
                Err(serde::de::Error::custom(format!("multiplicity `{name}` is neither a count, circle nor sphere")))
            }
        }
    }
}

impl JsonSchema for Multiplicity {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Multiplicity".into()
    }

    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        schemars::json_schema!({
            "description": "1, 2 (a degenerate root), or a critical circle or sphere.",
            "oneOf": [{"type": "integer", "minimum": 1}, {"enum": ["circle", "sphere"]}]
        })
    }
}

/// A relative equilibrium: the body turns about the vertical γ with constant angular velocity ω γ.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct RelativeEquilibriumDocument {
    /// Energy h = U_l(γ).
    pub h: f64,
    /// The vertical in body coordinates.
    pub gamma: [f64; 3],
    /// Angular velocity l / J(γ), with the sign of l.
    pub omega: f64,
    /// Morse index of U_l: 0 minimum, 1 saddle, 2 maximum.
    pub index: u8,
    /// How many critical points this entry stands for.
    pub multiplicity: Multiplicity,
    /// Spectral stability.
    pub stability: Stability,
    /// Id of the curve on which it lies.
    pub branch: String,
}

/// The answer of `critical`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct CriticalDocument {
    /// Version of this document.
    pub schema_version: String,
    /// A1, A2, A3 as given.
    #[serde(rename = "A")]
    pub moments: [String; 3],
    /// r1, r2, r3 as given.
    #[serde(rename = "r")]
    pub center: [String; 3],
    /// Vertical angular momentum as given.
    pub l: String,
    /// Relative equilibria sorted by h, then γ lexicographically.
    pub critical: Vec<RelativeEquilibriumDocument>,
    /// Bound on the error of every `h`.
    pub error_bound: f64,
    /// False when f64 cannot decide whether further critical points exist (l within rounding of a cusp).
    pub complete: bool,
    /// What could not be decided, in words.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub note: Option<String>,
    /// The part from which A and r were computed, when a full inertia tensor was given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub inertia: Option<InertiaDocument>,
}
