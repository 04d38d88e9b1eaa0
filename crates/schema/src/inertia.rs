//! The block `inertia` of a document whose body was given as a real part.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Units of a document whose body was given in SI.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct UnitsDocument {
    /// Of A.
    #[serde(rename = "A")]
    pub moments: String,
    /// Of r = m g Rᵀ c.
    #[serde(rename = "r")]
    pub center: String,
    /// Of h.
    pub h: String,
    /// Of l.
    pub l: String,
    /// Of ω.
    pub omega: String,
}

/// A part as it was given, and the rotation to the principal axes in which A, r and γ of the document are.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct InertiaDocument {
    /// Matrix entries I_xx, I_yy, I_zz, I_xy, I_xz, I_yz about the fixed point (I_xy = −∫ x y dm), in kg m², as given.
    pub tensor: [String; 6],
    /// Centre of mass from the fixed point, in m, as given.
    pub com: [String; 3],
    /// Mass in kg, as given.
    pub mass: String,
    /// Acceleration of gravity in m/s², as given.
    pub g: String,
    /// R, by rows: column k is principal axis k in the axes of the input, v_input = R v_principal.
    pub rotation: [[f64; 3]; 3],
    /// True when A and r are exact (a diagonal tensor); else they are rounded to f64.
    pub exact: bool,
    /// The largest entry of |I − R A Rᵀ|, in kg m².
    pub residual: f64,
    /// The principal moments violate the triangle inequality (decided on the tensor as given).
    pub unphysical: bool,
    /// The principal moments satisfy it with equality.
    pub plate: bool,
    /// The tensor can be one about the fixed point (parallel axes).
    pub parallel_axes: bool,
    /// Units of the document's numbers.
    pub units: UnitsDocument,
}
