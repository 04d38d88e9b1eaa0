//! `data/classes.json`: the classes of bodies and the borders between them.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{GivenBody, Head};

/// A body by its moments and its centre of mass.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ClassWitnessDocument {
    /// The body.
    #[serde(flatten)]
    pub body: GivenBody,
}

/// A class beside another one.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ClassNeighbourDocument {
    /// The class beyond the border.
    pub class: String,
    /// What happens on the border.
    pub event: String,
    /// True when a body that exists was met on the border.
    pub physical: bool,
}

/// A class of bodies.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ClassDocument {
    /// Its name.
    pub name: String,
    /// The canonical form of its diagram, whose SHA-256 begins with the name. Absent in the `others` of a list: the
    /// witness has it.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub text: String,
    /// What is special about its bodies: the moments that are equal, where r lies (axes by rising moments). Absent for a
    /// class of generic bodies.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stratum: Option<String>,
    /// Number of regions of the diagram.
    pub regions: usize,
    /// Types of the components that the regions show, such as `k2n1`.
    pub types: Vec<String>,
    /// True when there are bodies that exist of this class.
    pub physical: bool,
    /// A body of it far from other classes, one that exists if there is any.
    pub witness: ClassWitnessDocument,
    /// How far the witness is from the nearest body of another class that was found, or from the nearest special body (two
    /// equal moments, a component of r that is 0): √(|ΔA|² + ∠²), for A with the sum 2 and the angle between the two r. 0 where that was not sought, as for all of `others`.
    pub distance: f64,
    /// Its share of all physical bodies; if none of them has it, of all bodies with A > 0. Second moments of mass (or A
    /// itself) are uniform on a simplex, r̂ on the sphere. With a stratum: its share of the bodies of that stratum.
    pub measure: f64,
    /// Standard error of `measure`; if none or all of the sampled bodies have the class, the share of one body.
    pub measure_error: f64,
    /// The classes beside it, by name and event; empty for all of `others`.
    pub neighbours: Vec<ClassNeighbourDocument>,
}

/// The classes of bodies.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ClassesDocument {
    /// Version of this document.
    pub schema_version: String,
    /// The classes, by rising names.
    pub classes: Vec<ClassDocument>,
    /// Classes that are not counted among them, by rising names: those of special bodies, each with its stratum, and those
    /// that are known only of bodies that do not exist.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub others: Vec<ClassDocument>,
}

/// A border of the class of a body.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ClassBorderDocument {
    /// The class beyond it.
    pub class: String,
    /// What happens on it, in axes by rising moments, numbered as in the body on both sides.
    pub event: String,
    /// How far the nearest body on it is that was found: √(|ΔA|² + ∠²), for A with the sum 2 and the angle between the
    /// two r; 0 where it is no farther than 1e-13.
    pub distance: f64,
    /// That body, in the axes of A1 ≤ A2 ≤ A3 with the sum 2, and r of length 1; where moments are equal, the axes of these
    /// are chosen so that r has fewest components, and may be turned from those of the distance.
    #[serde(rename = "A")]
    pub moments: [f64; 3],
    /// r1, r2, r3.
    #[serde(rename = "r")]
    pub center: [f64; 3],
}

/// A class of generic bodies beside a special one.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ClassBesideDocument {
    /// Its name.
    pub class: String,
    /// The share of random bodies within a distance of 1e-6 that have this class.
    pub share: f64,
}

/// The answer of `classes --at`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct StandingDocument {
    /// Where it comes from.
    #[serde(flatten)]
    pub head: Head,
    /// The class of the body; `null` when it is not decided.
    pub name: Option<String>,
    /// True when the class is one of those that come with the program.
    pub known: bool,
    /// What is special about the body (axes by rising moments), decided exactly; absent for a generic one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stratum: Option<String>,
    /// For a special body: the classes of generic bodies beside it, the most frequent first. Rare ones may be missing.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub generic: Vec<ClassBesideDocument>,
    /// The borders of the class around the body, by rising distance; none for a body without a class, nor for one within 1e-8 of a more
    /// special one.
    pub borders: Vec<ClassBorderDocument>,
}
