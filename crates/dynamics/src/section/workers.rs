//! Orbits shared among threads, monitored and cancelled from outside, and checkpoints from which they resume, bit for
//! bit.

use std::sync::atomic::{AtomicBool, AtomicU32, AtomicU64, Ordering};

use super::orbit::{OrbitEnd, OrbitReport, SweepOptions};
use super::torus::PpTorus;
use crate::field::{Integrals, State};

/// Watches a run from outside, and stops it.
#[derive(Debug, Default)]
pub struct Monitor {
    /// Cancellation: once it is set, every orbit ends as [`OrbitEnd::Interrupted`](super::OrbitEnd::Interrupted); orbits not yet begun are left out.
    pub stop: AtomicBool,
    /// Crossings so far, updated every few hundred steps.
    pub crossings: AtomicU64,
    /// Finished orbits.
    pub orbits: AtomicU64,
}

impl Monitor {
    /// Cancellation was requested.
    #[must_use]
    #[inline]
    pub fn is_stopped(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }
}

/// The numbers 0, 1, … of the orbits still to be begun, shared by the workers.
#[derive(Debug)]
pub struct Turns<'a> {
    /// Watches the work.
    pub monitor: &'a Monitor,
    next: AtomicU32,
}

impl<'a> Turns<'a> {
    pub fn new(monitor: &'a Monitor) -> Self {
        Self { monitor, next: AtomicU32::new(0) }
    }

    /// The next of these; None when all have had their turn, or the work was stopped.
    pub fn next<'b, T>(&self, all: &'b [T]) -> Option<(u32, &'b T)> {
        if self.monitor.is_stopped() {
            return None;
        }
        let number = self.next.fetch_add(1, Ordering::Relaxed);
        all.get(number as usize).map(|one| (number, one))
    }
}

/// One worker on each thread of the current pool; what they made, in no order.
#[cfg(feature = "parallel")]
pub fn run_workers<T: Send>(worker: impl Fn() -> Vec<T> + Sync) -> Vec<T> {
    rayon::broadcast(|_| worker()).into_iter().flatten().collect()
}

/// Without threads.
#[cfg(not(feature = "parallel"))]
pub fn run_workers<T: Send>(worker: impl Fn() -> Vec<T> + Sync) -> Vec<T> {
    worker()
}

/// What a lane of the Taylor integrator knows of its orbit: γ and l, what they leave out, and the time, likewise.
pub(crate) const LANE: usize = 14;
/// Numbers of a halted orbit.
pub(super) const NUMBERS: usize = LANE + 6;
/// Counts of a halted orbit.
pub(super) const COUNTS: usize = 5;

/// An orbit halted between two steps: everything needed to continue as if it had not been halted.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct OrbitCheckpoint {
    /// The lane; S; the deviations of H, ⟨γ,l⟩ and ⟨γ,γ⟩; the residual; the time at the last step's end.
    pub(super) numbers: [f64; NUMBERS],
    /// Crossings, steps, tangencies, flat steps in a row and the last of them.
    pub(super) counts: [u64; COUNTS],
}

impl OrbitCheckpoint {
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
    pub fn report(&self, torus: &PpTorus, options: &SweepOptions, end: OrbitEnd) -> OrbitReport {
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
pub struct OrbitTask {
    /// Its number.
    pub orbit: u32,
    /// Its state at time 0.
    pub start: State,
    /// The state from which it continues.
    pub halt: Option<OrbitCheckpoint>,
}
