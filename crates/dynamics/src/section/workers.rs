//! Orbits shared among threads, and the way to watch and to stop them from outside.

use std::sync::atomic::{AtomicBool, AtomicU32, AtomicU64, Ordering};

/// Watches a run from outside, and stops it.
#[derive(Debug, Default)]
pub struct Monitor {
    /// Set it, and every orbit ends as [`End::Interrupted`](super::End::Interrupted); orbits not yet begun are left out.
    pub stop: AtomicBool,
    /// Crossings so far, brought up to date every few hundred steps.
    pub crossings: AtomicU64,
    /// Finished orbits.
    pub orbits: AtomicU64,
}

impl Monitor {
    /// Was the work told to stop?
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
