//! How long each stage took, and what decided the questions there were, on stderr.

use std::time::Instant;

use bifdiag_exact::statistics;

use super::stderr::say;

/// A clock that speaks only when asked to.
#[derive(Debug)]
pub struct Timings {
    wanted: bool,
    started: Instant,
}

impl Timings {
    /// Starts the clock.
    pub fn new(wanted: bool) -> Self {
        if wanted {
            statistics::count_from_here();
        }
        Self { wanted, started: Instant::now() }
    }

    /// Does the work of a stage and tells how long it took.
    pub fn stage<T>(&self, name: &str, work: impl FnOnce() -> T) -> T {
        let started = Instant::now();
        let result = work();
        self.tell(name, started);
        result
    }

    /// Tells the time since the start, and how many questions were decided by which numbers.
    pub fn total(&self) {
        self.tell("total", self.started);
        for (question, precision, count) in statistics::tally() {
            say(&format!("work: {:<28} {:<8} {count:>12}", question.to_string(), precision.to_string()));
        }
    }

    fn tell(&self, name: &str, since: Instant) {
        if self.wanted {
            say(&format!("timing: {name:<10} {:>12.3} ms", since.elapsed().as_secs_f64() * 1e3));
        }
    }
}
