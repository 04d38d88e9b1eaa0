//! How far a long computation has come, on stderr: a bar on a terminal, else a line now and then.

use std::io::{self, IsTerminal};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};

use crate::cli::failure::say;

/// Between lines where no terminal is.
const BETWEEN_LINES: Duration = Duration::from_secs(30);

/// Shorter work is over before a bar could be read.
const BAR_AFTER: Duration = Duration::from_secs(1);

/// Bodies done out of so many.
pub struct Progress {
    started: Instant,
    told: Instant,
    bar: Option<ProgressBar>,
    quiet: bool,
    before: u64,
    done: u64,
    total: u64,
}

impl Progress {
    /// `done` bodies were there before.
    pub fn new(done: u64, total: u64, quiet: bool) -> Self {
        let now = Instant::now();
        Self { started: now, told: now, bar: None, quiet, before: done, done, total }
    }

    /// So many bodies more.
    pub fn add(&mut self, bodies: u64) {
        self.done += bodies;
        if self.quiet {
            return;
        }
        if io::stderr().is_terminal() {
            if self.bar.is_none() && self.started.elapsed() > BAR_AFTER {
                let template = "{bar:40} {percent}% {pos}/{len} bodies, {msg}";
                let style =
                    ProgressStyle::with_template(template).unwrap_or_else(|_unknown_key| ProgressStyle::default_bar());
                self.bar = Some(ProgressBar::new(self.total).with_style(style));
            }
            if let Some(bar) = &self.bar {
                bar.set_message(self.pace());
                bar.set_position(self.done);
            }
        } else if self.told.elapsed() > BETWEEN_LINES {
            self.told = Instant::now();
            say(&format!("{} of {} bodies, {}", self.done, self.total, self.pace()));
        }
    }

    /// Rate and remaining time.
    fn pace(&self) -> String {
        let rate = (self.done - self.before) as f64 / self.started.elapsed().as_secs_f64().max(1e-9);
        let left = (self.total - self.done) as f64 / rate.max(1e-9);
        format!("{rate:.0} a second, {} left", duration(left))
    }

    /// The bar goes.
    pub fn finish(&self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}

/// Seconds as `42 s`, `12 min`, `3.4 h`.
fn duration(seconds: f64) -> String {
    if seconds < 100.0 {
        format!("{seconds:.0} s")
    } else if seconds < 6000.0 {
        format!("{:.0} min", seconds / 60.0)
    } else {
        format!("{:.1} h", seconds / 3600.0)
    }
}
