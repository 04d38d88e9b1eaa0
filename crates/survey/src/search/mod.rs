//! The search for a body and a point that show a wanted thing: global sampling, then local optimisation.
//!
//! Each body gets a [`Score`]: how visible the wanted thing is, or how near the body comes to it. Bodies are drawn by
//! number from four strata in turn ([`sample`]), the best ones are improved with the simplex method of Nelder and Mead
//! (`argmin`), and the winner becomes a [`Witness`] only after both topological methods have confirmed it. Nothing found
//! says nothing about existence.

mod chart;
mod improve;
mod sample;
mod score;
mod target;
mod witness;

pub use improve::improve;
pub use sample::sample;
pub use score::{Domain, Score, Seen, look};
pub use target::{ParseTargetError, Target};
pub use witness::{Witness, WitnessError, witness};
