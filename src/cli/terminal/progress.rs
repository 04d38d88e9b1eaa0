//! How far a long computation has come, and how long its stages took, on stderr.

use std::fmt;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Mutex, PoisonError};
use std::thread::Thread;
use std::time::{Duration, Instant};

use bifdiag_exact::statistics;
use indicatif::{HumanCount, HumanDuration, ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};

use super::stderr::{is_terminal, say};

/// Shorter work is over before a bar could be read.
const BAR_AFTER: Duration = Duration::from_secs(1);

/// Between two lines where no terminal is.
const BETWEEN_LINES: Duration = Duration::from_secs(30);

/// Interval between two readings of a counter.
const PERIOD: Duration = Duration::from_millis(100);

/// The state of work of known or unknown length: a bar on a terminal, else a line now and then.
pub struct Progress {
    /// `None` where no progress is shown.
    bar: Option<ProgressBar>,
    /// What is counted; empty where the message says it.
    things: String,
    /// When the last line was written.
    last_line: Mutex<Instant>,
}

impl Progress {
    /// Of `total` things; `done` of them were there before.
    pub fn new(done: u64, total: u64, things: &str, quiet: bool) -> Self {
        let template = format!("{{bar:40}} {{percent}}% {{human_pos}} {things}{{pace}}{{msg}}");
        Self::styled(Some(total), &template, things, quiet).starting_at(done)
    }

    /// Of `total` bytes, or of an unknown number; a message says what they are.
    pub fn of_bytes(total: Option<u64>, quiet: bool) -> Self {
        // The length of a pipe is unknown: lines are written as it is read.
        let quiet = quiet || !is_terminal();
        let template = if total.is_some() { "{bar:40} {percent}% {msg}, {eta} left" } else { "{spinner} {msg}" };
        Self::styled(total, template, "bytes", quiet)
    }

    /// Of work whose end is not known; `things` are counted.
    pub fn open(things: &str, quiet: bool) -> Self {
        Self::styled(None, &format!("{{spinner}} {{human_pos}} {things}{{pace}}"), things, quiet)
    }

    /// Of work that goes through several stages: a message says how far it has come.
    pub fn of_stages(quiet: bool) -> Self {
        Self::styled(None, "{spinner} {msg}", "", quiet)
    }

    fn styled(total: Option<u64>, template: &str, things: &str, quiet: bool) -> Self {
        let bar = (!quiet).then(|| {
            let style =
                ProgressStyle::with_template(template).unwrap_or_else(|_unknown_key| ProgressStyle::default_bar());
            ProgressBar::with_draw_target(total, ProgressDrawTarget::hidden()).with_style(style.with_key("pace", pace))
        });
        Self { bar, things: things.to_owned(), last_line: Mutex::new(Instant::now()) }
    }

    fn starting_at(self, done: u64) -> Self {
        if let Some(bar) = &self.bar {
            bar.set_position(done);
            bar.reset_eta();
        }
        self
    }

    /// So much more is done.
    pub fn add(&self, more: u64) {
        if let Some(bar) = &self.bar {
            self.show(bar, bar.position() + more);
        }
    }

    /// So much is done.
    pub fn set(&self, position: u64) {
        if let Some(bar) = &self.bar {
            // Orbits may be followed further than was foreseen.
            self.show(bar, position.min(bar.length().unwrap_or(position)));
        }
    }

    /// The text beside the bar.
    pub fn message(&self, message: impl fmt::Display) {
        if let Some(bar) = &self.bar {
            bar.set_message(message.to_string());
        }
    }

    fn show(&self, bar: &ProgressBar, position: u64) {
        bar.set_position(position);
        if is_terminal() {
            if bar.is_hidden() && bar.elapsed() > BAR_AFTER {
                bar.set_draw_target(ProgressDrawTarget::stderr());
            }
            return;
        }
        let mut last_line = self.last_line.lock().unwrap_or_else(PoisonError::into_inner);
        if last_line.elapsed() > BETWEEN_LINES {
            *last_line = Instant::now();
            if self.things.is_empty() {
                return say(&bar.message());
            }
            let of = bar.length().map_or_else(String::new, |total| format!(" of {total}"));
            let pace = match (bar.per_sec(), bar.length()) {
                (0.0, _) => String::new(),
                (rate, None) => format!(", {rate:.0} per second"),
                (rate, Some(_)) => format!(", {rate:.0} per second, {} left", HumanDuration(bar.eta())),
            };
            say(&format!("{position}{of} {}{pace}{}", self.things, bar.message()));
        }
    }

    /// The bar goes.
    pub fn finish(&self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }

    /// Does the work while the bar shows what the work counts.
    pub fn watching<T>(&self, counter: &AtomicU64, work: impl FnOnce() -> T) -> T {
        let result = self.looking(|| self.set(counter.load(Ordering::Relaxed)), work);
        self.finish();
        result
    }

    /// Does a part of the work, which counts smaller things meanwhile: their number is shown beside the bar.
    pub fn beside<T>(&self, counter: &AtomicU64, things: &str, work: impl FnOnce() -> T) -> T {
        let look = || {
            let count = HumanCount(counter.load(Ordering::Relaxed));
            self.message(format_args!("; {count} {things}"));
            self.add(0);
        };
        self.looking(look, work)
    }

    /// Does the work while a message says how far it has come, once that is known.
    pub fn telling<T>(&self, stage: impl Fn() -> Option<String> + Sync, work: impl FnOnce() -> T) -> T {
        let look = || {
            if let Some(message) = stage() {
                self.message(message);
                self.add(0);
            }
        };
        let result = self.looking(look, work);
        self.finish();
        result
    }

    /// Does the work, calling the observer from time to time.
    fn looking<T>(&self, look: impl Fn() + Sync, work: impl FnOnce() -> T) -> T {
        if self.bar.is_none() {
            return work();
        }
        let over = AtomicBool::new(false);
        std::thread::scope(|scope| {
            let watcher = scope.spawn(|| {
                while !over.load(Ordering::Relaxed) {
                    std::thread::park_timeout(PERIOD);
                    look();
                }
            });
            let _over = AtEnd { over: &over, watcher: watcher.thread() };
            work()
        })
    }
}

/// Stops the watcher when the work is over, also when it panics.
struct AtEnd<'a> {
    over: &'a AtomicBool,
    watcher: &'a Thread,
}

impl Drop for AtEnd<'_> {
    fn drop(&mut self) {
        self.over.store(true, Ordering::Relaxed);
        self.watcher.unpark();
    }
}

/// How many a second, and how long it will take, once that is known.
fn pace(state: &ProgressState, out: &mut dyn fmt::Write) {
    let rate = state.per_sec();
    let left = || format!(", {:#} left", HumanDuration(state.eta()));
    let _never_fails = match (rate > 0.0, state.len()) {
        (false, _) => Ok(()),
        (true, None) => write!(out, ", {rate:.0}/s"),
        (true, Some(_)) => write!(out, ", {rate:.0}/s{}", left()),
    };
}

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

    /// Does the work of a stage and reports how long it took.
    pub fn stage<T>(&self, name: &str, work: impl FnOnce() -> T) -> T {
        let started = Instant::now();
        let result = work();
        self.report(name, started);
        result
    }

    /// Reports the time since the start, and how many questions were decided by which numbers.
    pub fn total(&self) {
        self.report("total", self.started);
        for (question, precision, count) in statistics::tally() {
            say(&format!("work: {:<28} {:<8} {count:>12}", question.to_string(), precision.to_string()));
        }
    }

    fn report(&self, name: &str, since: Instant) {
        if self.wanted {
            say(&format!("timing: {name:<10} {:>12.3} ms", since.elapsed().as_secs_f64() * 1e3));
        }
    }
}
