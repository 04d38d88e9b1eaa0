//! The search for a body and a point that show a wanted thing: theorems first, then known points, then global sampling
//! with local optimisation.
//!
//! Each body gets a [`Score`]: how visible the wanted thing is, or how near the body comes to it. Bodies are drawn by
//! number from four strata cyclically ([`sample`]), the best ones are improved with the simplex method of Nelder and
//! Mead (`argmin`, with the feature `search`), and the winner becomes a [`Witness`] only after both topological methods
//! have confirmed it. Nothing found says nothing about existence; an [`Exclusion`] does.

mod exclusion;
#[cfg(feature = "search")]
mod find;
#[cfg(feature = "search")]
mod improve;
mod score;
mod target;
mod witness;

pub use exclusion::Exclusion;
#[cfg(feature = "search")]
pub use find::{find, search};
#[cfg(feature = "search")]
pub use improve::improve;
pub use score::{Score, ScoredPoint, SearchDomain, look, sample};
pub use target::{ParseTargetError, Target};
pub use witness::{KnownPoint, METHODS, Witness, WitnessError, known_witness};

use bifdiag_exact::Accuracy;

/// How bodies are sought.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SearchOptions {
    /// Which bodies are tried.
    pub domain: SearchDomain,
    /// The most bodies that are drawn.
    pub samples: u64,
    /// Draw all of them, although something was found before.
    pub all: bool,
    /// Seed of the sequence of bodies.
    pub seed: u64,
    /// What the answer must be worth.
    pub accuracy: Accuracy,
}

impl Default for SearchOptions {
    fn default() -> Self {
        Self { domain: SearchDomain::default(), samples: 20_000, all: false, seed: 0, accuracy: Accuracy::Exact }
    }
}

/// What a search came to.
#[derive(Clone, Debug, PartialEq)]
pub enum SearchAnswer {
    /// A body and a point that show what was sought.
    Found(Box<Witness>),
    /// None of the bodies that were drawn; this says nothing about others.
    NotFound {
        /// The body that came nearest, if a distance is known.
        nearest: Option<NearestBody>,
    },
    /// No body shows it.
    Excluded(Exclusion),
    /// The search was stopped.
    Stopped,
}

/// How near a body came.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearestBody {
    /// A and r.
    pub values: [[f64; 3]; 2],
    /// h and l where it came nearest.
    pub at: Option<[f64; 2]>,
    /// What is missing, measured by the objective of the search; 0 where it seemed to show it and was not confirmed.
    pub missing: f64,
}

/// The answer of a search, with its evidence.
#[derive(Clone, Debug, PartialEq)]
pub struct SearchResult {
    /// The answer.
    pub answer: SearchAnswer,
    /// Bodies that were drawn while sampling.
    pub drawn: u64,
    /// Of these, bodies that were tried: those in the domain that are decided.
    pub tried: u64,
    /// Of these, bodies that seemed to show it.
    pub showing: u64,
    /// Bodies that seemed to show it best and were not confirmed.
    pub refused: Vec<([[f64; 3]; 2], WitnessError)>,
}

impl SearchResult {
    /// Without any search.
    #[cfg(feature = "search")]
    pub(super) fn at_once(answer: SearchAnswer) -> Self {
        Self { answer, drawn: 0, tried: 0, showing: 0, refused: Vec::new() }
    }
}
