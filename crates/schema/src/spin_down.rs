//! The document of `bifdiag spin-down`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{GivenBody, Head, PartDocument};

/// What happens to a rotation that slows down.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum SlowdownEvent {
    /// Another curve crosses its own: the neighbouring regions change.
    Crossing,
    /// At a pitchfork its curve continues as another one that is a minimum.
    Turn,
    /// Its curve ends at a pitchfork beyond which nothing near is a minimum: the body falls.
    Pitchfork,
    /// Its curve ends at a cusp: the body falls.
    Cusp,
    /// It is not a minimum: with friction the body falls at once.
    Start,
    /// The body comes to rest, hanging if it has weight.
    Rest,
}

/// A stretch of the path, between two events.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SlowdownDocument {
    /// Id of the curve along which the rotation goes.
    pub curve: String,
    /// l at its beginning and end, falling.
    pub l: [f64; 2],
    /// h there.
    pub h: [f64; 2],
    /// The angular velocity there, in rad per unit of time.
    pub omega: [f64; 2],
    /// The regions just below and just above in h; `null`: forbidden.
    pub regions: [Option<String>; 2],
    /// What ends it.
    pub event: SlowdownEvent,
    /// Ids of the curves at which the body can be afterwards: after a fall the minima at that l of less energy to which
    /// it may fall: those in the component of U_l ≤ h in which the fall begins, or all where that is not decided.
    pub onto: Vec<String>,
}

/// The answer of `spin-down`: how a steady rotation ends when friction at the pivot or in the air slowly takes its l,
/// in the limit where that is much slower than the damping of all that is not steady.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SpinDownDocument {
    /// Where it comes from.
    #[serde(flatten)]
    pub head: Head,
    /// The body.
    #[serde(flatten)]
    pub body: GivenBody,
    /// By falling l; it ends at rest, or at a fall after which several minima are left.
    pub path: Vec<SlowdownDocument>,
    /// The part from which A and r were computed, when one was given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub part: Option<PartDocument>,
}
