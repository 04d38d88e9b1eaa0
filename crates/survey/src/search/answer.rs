//! What a search is asked, and what it answers.

use super::exclusion::Exclusion;
use super::score::Domain;
use super::witness::{Witness, WitnessError};
use bifdiag_exact::Accuracy;

/// How bodies are sought.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SearchOptions {
    /// Which bodies are looked at.
    pub domain: Domain,
    /// The most bodies that are drawn.
    pub samples: u64,
    /// Draw all of them, although something was found before.
    pub all: bool,
    /// Where the sequence of bodies starts.
    pub seed: u64,
    /// What the answer must be worth.
    pub accuracy: Accuracy,
}

impl Default for SearchOptions {
    fn default() -> Self {
        Self { domain: Domain::default(), samples: 20_000, all: false, seed: 0, accuracy: Accuracy::Exact }
    }
}

/// What a search came to.
#[derive(Clone, Debug, PartialEq)]
pub enum Answer {
    /// A body and a point that show what was sought.
    Found(Box<Witness>),
    /// None of the bodies that were drawn; this says nothing about others.
    NotFound {
        /// The body that came nearest, if a distance is known.
        nearest: Option<Nearest>,
    },
    /// No body shows it.
    Excluded(Exclusion),
    /// The search was stopped.
    Stopped,
}

/// How near a body came.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nearest {
    /// A and r.
    pub values: [[f64; 3]; 2],
    /// h and l where it came nearest.
    pub at: Option<[f64; 2]>,
    /// What is missing, as in [`Score::Near`](super::Score::Near); 0 where it seemed to show it and was not confirmed.
    pub missing: f64,
}

/// The answer of a search, and what it is worth.
#[derive(Clone, Debug, PartialEq)]
pub struct Search {
    /// The answer.
    pub answer: Answer,
    /// Bodies that were drawn while sampling.
    pub drawn: u64,
    /// Of these, bodies that were looked at: those of the domain that are decided.
    pub tried: u64,
    /// Of these, bodies that seemed to show it.
    pub showing: u64,
    /// Bodies that seemed to show it best and were not confirmed.
    pub refused: Vec<([[f64; 3]; 2], WitnessError)>,
}

impl Search {
    /// Without any search.
    #[cfg(feature = "search")]
    pub(super) fn at_once(answer: Answer) -> Self {
        Self { answer, drawn: 0, tried: 0, showing: 0, refused: Vec::new() }
    }
}
