//! Ctrl-C, SIGTERM and SIGHUP: obeyed between writes, never inside of one.

use std::sync::{Mutex, MutexGuard, PoisonError, TryLockError};
use std::time::Duration;

use super::failure::say;

/// Held while something is written: a set of files, or whole lines of output.
static WRITING: Mutex<()> = Mutex::new(());

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
