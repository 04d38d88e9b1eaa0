//! Work that holds no lock of the interpreter, stops at Ctrl-C and uses no more threads than it may.

use std::panic::resume_unwind;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::Duration;

use pyo3::prelude::*;

use crate::errors;

/// How often the interpreter is asked whether somebody pressed Ctrl-C.
const PATIENCE: Duration = Duration::from_millis(50);

/// Runs work on `threads` threads (0: as many as there are cores). It is to look at `stop`, and to end when that is set: its
/// result is then dropped, and the exception of the signal goes on.
pub fn run<T: Send>(
    python: Python<'_>,
    threads: usize,
    stop: &AtomicBool,
    work: impl FnOnce() -> T + Send,
) -> PyResult<T> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().map_err(|error| errors::range(&error))?;
    let over = AtomicBool::new(false);
    let waiting = thread::current();
    thread::scope(|scope| {
        let worker = scope.spawn(|| {
            let _at_the_end = Over(&over, waiting);
            pool.install(work)
        });
        let mut interrupt = Ok(());
        while !over.load(Ordering::Acquire) {
            python.detach(|| thread::park_timeout(PATIENCE));
            if interrupt.is_ok() {
                interrupt = python.check_signals();
                stop.store(interrupt.is_err(), Ordering::Relaxed);
            }
        }
        let result = worker.join().unwrap_or_else(|panic| resume_unwind(panic));
        interrupt.map(|()| result)
    })
}

/// Tells the waiting thread that the work is over, even if it panicked.
struct Over<'a>(&'a AtomicBool, thread::Thread);

impl Drop for Over<'_> {
    fn drop(&mut self) {
        self.0.store(true, Ordering::Release);
        self.1.unpark();
    }
}
