//! Integrable cases, and their further integrals along motions.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A case in which there is a further first integral, or an invariant relation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum IntegrableCaseName {
    /// r = 0.
    Euler,
    /// Two equal moments and r ≠ 0 on the third axis, or three equal moments and r ≠ 0.
    Lagrange,
    /// A = (2, 2, 1) up to scale with r in the plane of the equal moments.
    Kovalevskaya,
    /// A = (4, 4, 1) up to scale with r in the plane of the equal moments; integrable where l = 0.
    GoryachevChaplygin,
    /// The plane ⟨L,r⟩ = 0 cuts the ellipsoid ⟨L,A⁻¹L⟩ = const in a circle, and motions stay in it.
    HessAppelrot,
}

/// An integrable case to which a body belongs, decided exactly.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct IntegrableDocument {
    /// Which.
    pub case: IntegrableCaseName,
    /// The further integral in ω, γ, A, r and L = Aω, in the axes of the body.
    pub integral: String,
    /// For which motions it is constant, such as `always` or `where l = 0`.
    pub holds: String,
}

/// A further integral along motions.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct FurtherIntegralDocument {
    /// Of which case.
    #[serde(flatten)]
    pub of: IntegrableDocument,
    /// True if the case keeps it along these motions, within rounding of their starts; on a steady rotation it is constant
    /// in any case.
    pub kept: bool,
    /// Its value at the start; of several motions the largest in magnitude.
    pub at_start: f64,
    /// Of several motions, the number of the orbit with this value.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub orbit: Option<u32>,
    /// Its largest deviation from the value at the start, over the samples or crossings.
    pub drift: f64,
}
