//! Orbits that are halted between two steps and go on later, bit for bit.

use super::orbit::{End, OrbitReport, SweepOptions};
use super::torus::PpTorus;
use crate::field::{Integrals, State};

/// What a lane of the Taylor integrator knows of its orbit: γ and l, what they leave out, and the time, likewise.
pub(crate) const LANE: usize = 14;
/// Numbers of a halted orbit.
pub(super) const NUMBERS: usize = LANE + 6;
/// Counts of a halted orbit.
pub(super) const COUNTS: usize = 5;

/// An orbit halted between two steps: all that it needs to go on as if it had not been.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Halt {
    /// The lane; S; the deviations of H, ⟨γ,l⟩ and ⟨γ,γ⟩; the residual; the time at the last step's end.
    pub(super) numbers: [f64; NUMBERS],
    /// Crossings, steps, tangencies, flat steps in a row and the last of them.
    pub(super) counts: [u64; COUNTS],
}

impl Halt {
    /// Words in which it can be kept.
    pub const WORDS: usize = NUMBERS + COUNTS;

    /// Itself as bits.
    #[must_use]
    pub fn words(&self) -> [u64; Self::WORDS] {
        std::array::from_fn(|k| if k < NUMBERS { self.numbers[k].to_bits() } else { self.counts[k - NUMBERS] })
    }

    /// From [`words`](Self::words).
    #[must_use]
    pub fn from_words(words: [u64; Self::WORDS]) -> Self {
        Self {
            numbers: std::array::from_fn(|k| f64::from_bits(words[k])),
            counts: std::array::from_fn(|k| words[NUMBERS + k]),
        }
    }

    /// What its orbit was like until here, if it ended for this reason.
    #[must_use]
    pub fn report(&self, torus: &PpTorus, options: &SweepOptions, end: End) -> OrbitReport {
        let [.., energy, vertical_momentum, gamma_squared, residual, time] = self.numbers;
        let [crossings, steps, tangencies, ..] = self.counts;
        // Both counts were made as u32.
        let narrow = |count: u64| u32::try_from(count).unwrap_or(u32::MAX);
        let report = OrbitReport {
            end,
            crossings: narrow(crossings),
            steps,
            time,
            tangencies: narrow(tangencies),
            drift: Integrals { energy, vertical_momentum, gamma_squared },
            residual,
        };
        report.restored(torus.top().units(), options.condition)
    }

    pub(super) fn lane(&self) -> [f64; LANE] {
        std::array::from_fn(|k| self.numbers[k])
    }

    pub(super) fn value(&self) -> f64 {
        self.numbers[LANE]
    }
}

/// An orbit, from its start or from where it was halted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Task {
    /// Its number.
    pub orbit: u32,
    /// Its state at time 0.
    pub start: State,
    /// Where it goes on.
    pub halt: Option<Halt>,
}
