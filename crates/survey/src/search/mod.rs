//! The search for a body and a point that show a wanted thing: theorems first, then known points, then global sampling
//! with local optimisation.
//!
//! Each body gets a [`Score`]: how visible the wanted thing is, or how near the body comes to it. Bodies are drawn by
//! number from four strata in turn ([`sample`]), the best ones are improved with the simplex method of Nelder and Mead
//! (`argmin`, with the feature `search`), and the winner becomes a [`Witness`] only after both topological methods have
//! confirmed it. Nothing found says nothing about existence; an [`Exclusion`] does.

mod answer;
#[cfg(feature = "search")]
mod chart;
mod exclusion;
#[cfg(feature = "search")]
mod find;
#[cfg(feature = "search")]
mod improve;
mod known;
mod sample;
mod score;
mod target;
mod witness;

pub use answer::{Answer, Nearest, Search, SearchOptions};
pub use exclusion::Exclusion;
#[cfg(feature = "search")]
pub use find::{find, search};
#[cfg(feature = "search")]
pub use improve::improve;
pub use known::{KnownPoint, known_witness};
pub use sample::sample;
pub use score::{Domain, Score, Seen, look};
pub use target::{ParseTargetError, Target};
pub use witness::{Method, Witness, WitnessError};
