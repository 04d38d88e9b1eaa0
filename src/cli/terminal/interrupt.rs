//! Ctrl-C, SIGTERM and SIGHUP end a command within a second, and nothing half-written stays behind.

use std::fs;
use std::mem;
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, MutexGuard, Once, PoisonError, TryLockError};
use std::time::{Duration, Instant};

use super::stderr::say;

/// How long an interrupt waits for a write or for work to end. A reader that never takes what is written must not keep
/// the process alive.
const PATIENCE: Duration = Duration::from_millis(700);
/// Polling interval.
const PAUSE: Duration = Duration::from_millis(5);

/// Held while something is written: a set of files, or whole lines of output.
static WRITING: Mutex<()> = Mutex::new(());

/// Files and directories that go if an interrupt ends the process before their set is whole.
static UNFINISHED: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// Whether anything was ever written.
static WRITTEN: AtomicBool = AtomicBool::new(false);

/// The work under way, if results of it can be kept.
static WORK: Mutex<Work> = Mutex::new(Work::Nothing);

/// Work whose partial results can be kept.
enum Work {
    /// Nothing that could be kept.
    Nothing,
    /// Under way; this stops it.
    Running(Box<dyn Fn() + Send>),
    /// Asked to stop.
    Stopped,
}

fn lock<T>(mutex: &'static Mutex<T>) -> MutexGuard<'static, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Until the guard is dropped, an interrupt waits.
pub fn uninterrupted() -> MutexGuard<'static, ()> {
    let guard = lock(&WRITING);
    WRITTEN.store(true, Ordering::Relaxed);
    guard
}

/// The list of what is not whole yet; the process does not end by an interrupt while it is held.
pub fn unfinished() -> MutexGuard<'static, Vec<PathBuf>> {
    lock(&UNFINISHED)
}

/// Work that an interrupt stops: while it runs, the first interrupt does not end the process.
#[derive(Debug)]
pub struct Stoppable(());

/// From now on the first interrupt calls `stop` and leaves it to the caller to keep what is finished and to end; a second
/// one ends the process. So does the first one if the guard is not dropped soon.
pub fn stoppable(stop: impl Fn() + Send + 'static) -> Stoppable {
    *lock(&WORK) = Work::Running(Box::new(stop));
    Stoppable(())
}

#[expect(clippy::unused_self, reason = "only work that is running can be over")]
impl Stoppable {
    /// Ends the work: from now on an interrupt ends the process. False if one came before; then nothing changes, and the
    /// process ends soon unless the guard is dropped.
    pub fn over(&self) -> bool {
        let mut work = lock(&WORK);
        let stopped = matches!(*work, Work::Stopped);
        if !stopped {
            *work = Work::Nothing;
        }
        !stopped
    }
}

impl Drop for Stoppable {
    fn drop(&mut self) {
        *lock(&WORK) = Work::Nothing;
    }
}

/// Answers interrupts from now on, in this process once and for all. Files that may not grow further (`ulimit -f`) give
/// errors instead of ending the process.
pub fn install() -> Result<(), ctrlc::Error> {
    static INSTALLED: Once = Once::new();
    let mut installed = Ok(());
    INSTALLED.call_once(|| {
        #[cfg(unix)]
        {
            static TOO_LARGE: std::sync::atomic::AtomicBool = std::sync::atomic::AtomicBool::new(false);
            // Where it is refused, the signal ends the process as before.
            let _refused = signal_hook::flag::register(signal_hook::consts::SIGXFSZ, &TOO_LARGE);
        }
        installed = ctrlc::set_handler(interrupted);
    });
    installed
}

fn interrupted() {
    let since = Instant::now();
    let mut work = lock(&WORK);
    match mem::replace(&mut *work, Work::Stopped) {
        Work::Running(stop) => {
            stop();
            std::thread::spawn(move || end_unless_over(since));
        }
        nothing => {
            *work = nothing;
            drop(work);
            end(since);
        }
    }
}

/// The work has been asked to stop: it must not take longer than a write may.
fn end_unless_over(since: Instant) {
    while since.elapsed() < PATIENCE {
        std::thread::sleep(PAUSE);
        if !matches!(*lock(&WORK), Work::Stopped) {
            return;
        }
    }
    end(since);
}

/// Ends the process with status 1, once what is being written is whole, or some time after the interrupt without it.
fn end(since: Instant) -> ! {
    // The guard is kept to the end, so that nothing new is begun.
    let guard = loop {
        match WRITING.try_lock() {
            Err(TryLockError::WouldBlock) if since.elapsed() < PATIENCE => std::thread::sleep(PAUSE),
            guard => break guard,
        }
    };
    for path in unfinished().iter() {
        // One of the two is right, unless it has gone or is in use.
        let _not_there = fs::remove_file(path).or_else(|_no_file| fs::remove_dir(path));
    }
    if !matches!(guard, Err(TryLockError::WouldBlock)) {
        let written = WRITTEN.load(Ordering::Relaxed);
        say(if written {
            "interrupted; the files already written are complete"
        } else {
            "interrupted; nothing was \
        written"
        });
    }
    std::process::exit(1);
}
