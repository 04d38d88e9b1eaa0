//! Ctrl-C, SIGTERM and SIGHUP: obeyed between writes, never inside of one.

use std::mem;
use std::sync::{Mutex, MutexGuard, PoisonError, TryLockError};
use std::time::Duration;

use super::failure::say;

/// Held while something is written: a set of files, or whole lines of output.
static WRITING: Mutex<()> = Mutex::new(());

/// What stops the work under way so that its results can be kept.
static WORK: Mutex<Work> = Mutex::new(Work::None);

/// Work that can be stopped.
enum Work {
    /// Nothing that could be kept.
    None,
    /// Under way.
    Running(Box<dyn Fn() + Send>),
    /// Told to stop.
    Stopped,
}

/// Work that an interrupt stops; while this lives, the first interrupt does not end the process.
#[derive(Debug)]
pub struct Stoppable(());

/// From now on the first interrupt calls `stop` and leaves it to the caller to keep what is finished and to end; a second
/// one ends the process as usual.
pub fn stoppable(stop: impl Fn() + Send + 'static) -> Stoppable {
    *WORK.lock().unwrap_or_else(PoisonError::into_inner) = Work::Running(Box::new(stop));
    Stoppable(())
}

impl Drop for Stoppable {
    fn drop(&mut self) {
        *WORK.lock().unwrap_or_else(PoisonError::into_inner) = Work::None;
    }
}

/// Stops the work if there is some that was not yet told to.
fn stop_work() -> bool {
    let mut work = WORK.lock().unwrap_or_else(PoisonError::into_inner);
    if let Work::Running(stop) = mem::replace(&mut *work, Work::None) {
        stop();
        *work = Work::Stopped;
        return true;
    }
    false
}

/// How long an interrupt waits for a write to end: 500 times 10 ms. A reader that never takes what is written must
/// not keep the process alive.
const PATIENCE: u32 = 500;
const PAUSE: Duration = Duration::from_millis(10);

/// Until the guard is dropped, an interrupt waits.
pub fn uninterrupted() -> MutexGuard<'static, ()> {
    WRITING.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Ends the process with status 1 at an interrupt. Since files exist under temporary names only while
/// [`uninterrupted`] is held, nothing half-written stays behind.
pub fn install() -> Result<(), ctrlc::Error> {
    ctrlc::set_handler(|| {
        if stop_work() {
            return;
        }
        for _ in 0..PATIENCE {
            match WRITING.try_lock() {
                Err(TryLockError::WouldBlock) => std::thread::sleep(PAUSE),
                // The guard is kept to the end, so that nothing new is begun.
                _guard => {
                    say("interrupted; what was written is whole");
                    std::process::exit(1);
                }
            }
        }
        std::process::exit(1);
    })
}
