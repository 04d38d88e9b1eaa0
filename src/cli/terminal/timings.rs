//! How long each stage took, on stderr.

use std::time::Instant;

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
        Self { wanted, started: Instant::now() }
    }

    /// Does the work of a stage and tells how long it took.
    pub fn stage<T>(&self, name: &str, work: impl FnOnce() -> T) -> T {
        let started = Instant::now();
        let result = work();
        self.tell(name, started);
        result
    }

    /// Tells the time since the start.
    pub fn total(&self) {
        self.tell("total", self.started);
    }

    fn tell(&self, name: &str, since: Instant) {
        if self.wanted {
            say(&format!("timing: {name:<10} {:>12.3} ms", since.elapsed().as_secs_f64() * 1e3));
        }
    }
}
