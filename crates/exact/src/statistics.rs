//! How many questions each precision decided. Nothing is counted until [`count_from_here`] is called.

use std::collections::BTreeMap;
use std::fmt;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};

/// What was asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Question {
    /// The regions of a whole plane.
    Atlas,
    /// The type of one point.
    Point,
    /// The sign of h against one height over l.
    Sign,
    /// The order of two curves along all their common range.
    Pair,
    /// The order of all curves over one l.
    Order,
}

/// What decided it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Precision {
    /// `f64` with proved bounds.
    Double,
    /// Intervals of this many bits.
    Bits(usize),
    /// Equality, or its absence, in exact rational arithmetic: by squares or by a gcd of polynomials.
    Algebra,
    /// It went on to questions that are counted themselves.
    Further,
    /// Nothing did.
    Open,
}

impl fmt::Display for Question {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Atlas => "atlas",
            Self::Point => "point",
            Self::Sign => "sign of h against a height",
            Self::Pair => "order of two curves",
            Self::Order => "order of all curves over an l",
        })
    }
}

impl fmt::Display for Precision {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Double => f.write_str("f64"),
            Self::Bits(bits) => write!(f, "{bits} bits"),
            Self::Algebra => f.write_str("algebra"),
            Self::Further => f.write_str("further"),
            Self::Open => f.write_str("open"),
        }
    }
}

static COUNTS: AtomicBool = AtomicBool::new(false);
static DECIDED: Mutex<BTreeMap<(Question, Precision), u64>> = Mutex::new(BTreeMap::new());

/// Begins to count, in all threads.
pub fn count_from_here() {
    COUNTS.store(true, Ordering::Relaxed);
}

/// How many questions of each kind each precision decided.
#[must_use]
pub fn tally() -> Vec<(Question, Precision, u64)> {
    let decided = DECIDED.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
    decided.iter().map(|(&(question, precision), &count)| (question, precision, count)).collect()
}

/// Counts a question and what decided it.
pub(crate) fn count(question: Question, precision: Precision) {
    if COUNTS.load(Ordering::Relaxed) {
        let mut all = DECIDED.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        *all.entry((question, precision)).or_default() += 1;
    }
}
