//! A progress bar with rate while orbits are followed.

use std::fmt::Write;
use std::io::{self, IsTerminal};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use dynamics::section::Monitor;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};

/// Runs shorter than this are over before a bar could be read.
const SHOWN_AFTER: Duration = Duration::from_secs(1);
/// Time between two looks at the monitor.
const PERIOD: Duration = Duration::from_millis(100);

const TEMPLATE: &str = "{bar:40} {percent}% {human_pos} crossings, {rate}/s, {eta} left";

/// Does the work while a bar on stderr, if that is a terminal, shows what the monitor counts.
pub fn shown<T>(monitor: &Monitor, expected: u64, quiet: bool, work: impl FnOnce() -> T) -> T {
    if quiet || !io::stderr().is_terminal() {
        return work();
    }
    let bar = ProgressBar::with_draw_target(Some(expected), ProgressDrawTarget::hidden());
    if let Ok(style) = ProgressStyle::with_template(TEMPLATE) {
        bar.set_style(style.with_key("rate", rate));
    }
    let over = AtomicBool::new(false);
    let result = std::thread::scope(|scope| {
        let watcher = scope.spawn(|| {
            while !over.load(Ordering::Relaxed) {
                std::thread::park_timeout(PERIOD);
                if bar.is_hidden() && bar.elapsed() > SHOWN_AFTER {
                    bar.set_draw_target(ProgressDrawTarget::stderr());
                }
                bar.set_position(monitor.crossings.load(Ordering::Relaxed));
            }
        });
        let result = work();
        over.store(true, Ordering::Relaxed);
        watcher.thread().unpark();
        result
    });
    bar.finish_and_clear();
    result
}

/// Crossings a second.
fn rate(state: &ProgressState, out: &mut dyn Write) {
    let _never_fails = write!(out, "{:.0}", state.per_sec());
}
