//! Regular or chaotic: two witnesses that know nothing of each other must agree, three times in a row.

use std::convert::Infallible;
use std::fmt;

use super::evidence::{AGREE, Evidence, LINEAR, first_decision, verdict};
use super::verdict::{Open, Verdict};

/// A verdict with what it rests on.
#[derive(Clone, Debug, PartialEq)]
pub struct Judgement {
    /// What it is.
    pub verdict: Verdict,
    /// The three looks that decided it; where it is open, the last three. Empty if the orbit was too short or not measured.
    pub evidence: Vec<Evidence>,
    /// Where it was decided: the last look's time since the start, and the number of the last crossing until then; None where it
    /// is open.
    pub decided: Option<(f64, u32)>,
}

impl Judgement {
    /// None, and why.
    #[must_use]
    pub fn open(why: Open) -> Self {
        Self { verdict: Verdict::Open(why), evidence: Vec::new(), decided: None }
    }

    /// Judges an orbit by the looks at it, in their order. `crossings` are those of the orbit, `crossing_at` is the number of the last one until
    /// a time.
    ///
    /// The first three successive looks that decide do so for good: an orbit that is followed further has the same verdict.
    #[must_use]
    pub fn new(seen: &[Evidence], crossings: usize, crossing_at: impl FnOnce(f64) -> u32) -> Self {
        match Self::try_new(seen, crossings, |time| Ok::<u32, Infallible>(crossing_at(time))) {
            Ok(judgement) => judgement,
            Err(never) => match never {},
        }
    }

    /// Likewise, where the number of a crossing may not be found.
    ///
    /// # Errors
    /// That of `crossing_at`.
    pub fn try_new<E>(
        seen: &[Evidence],
        crossings: usize,
        crossing_at: impl FnOnce(f64) -> Result<u32, E>,
    ) -> Result<Self, E> {
        if let Some((verdict, looks)) = first_decision(seen) {
            let time = looks[AGREE - 1].time;
            return Ok(Self { verdict, evidence: looks.to_vec(), decided: Some((time, crossing_at(time)?)) });
        }
        Ok(match seen.last_chunk::<AGREE>() {
            Some(looks) => Self { verdict: verdict(looks), evidence: looks.to_vec(), decided: None },
            None => Self::open(Open::TooShort { crossings }),
        })
    }
}

impl fmt::Display for Judgement {
    /// Why the verdict is what it is.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [linear, late] = LINEAR;
        match (self.verdict, self.evidence.last()) {
            (Verdict::Regular, Some(Evidence { growth: [a, b], apart, .. })) => write!(
                f,
                "a tangent vector grows no faster than linearly (ln|δ| by {a:.2} and {b:.2} in two windows of time; linear is \
                 {linear:.2} and {late:.2}) and the averages over them agree (to {apart:.1e} of the spread)"
            ),
            (Verdict::Chaotic, Some(Evidence { growth: [a, b], apart, log, .. })) => write!(
                f,
                "a tangent vector grows exponentially (ln|δ| by {a:.1} and {b:.1} in two windows of time, by {log:.1} in all) \
                 and the averages over them do not agree ({apart:.1e} of the spread)"
            ),
            (Verdict::Open(why), _) => why.fmt(f),
            (_, None) => Ok(()),
        }
    }
}
