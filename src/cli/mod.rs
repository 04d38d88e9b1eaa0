//! The command line. From the top: [`run`] reads the options (`arguments`) and calls a command; a command reads
//! its arguments (`input`), works, and writes its results (`export`); below are the terminal (`terminal`) and the one type of
//! failure (`failure`).
//!
//! Only this part of the package prints, writes files or chooses an exit status.

mod arguments;
mod atlas;
mod batch;
mod chaos;
mod classes;
mod classify;
mod compare;
mod critical;
mod explain;
mod explore;
mod export;
mod failure;
mod find;
mod input;
mod listings;
mod orbit;
mod part;
mod periodic;
mod scan;
mod section;
mod show;
mod sphere;
mod spin;
mod terminal;
mod verify;

use std::ffi::OsString;
use std::io::{self, IsTerminal};
use std::num::NonZeroUsize;

pub use explore::serve;

use arguments::{Command, Options, Refusal};
use failure::{Exit, Failure, failed};
use terminal::{Timings, interrupt, is_terminal, log, print, say, say_styled};

/// Stack of the threads of `--threads`, on which whole commands run: as large as a process's own.
const STACK: usize = 8 << 20;

/// Runs a command line, its first argument the name of the program, and returns the exit status: 0 done, 2 wrong input,
/// 1 anything else. Prints to stdout and stderr, writes files, and ends the process at SIGINT and SIGTERM, from the first
/// call on. Several command lines may be run one after the other.
pub fn run(arguments: impl IntoIterator<Item = OsString>) -> u8 {
    let done = match Options::from_arguments(arguments) {
        Ok(options) => start(&options),
        Err(Refusal::Clap(error)) => answer_of_clap(&error),
        Err(Refusal::Failure(failure)) => Err(failure),
    };
    let exit = done.unwrap_or_else(|failure| report(&failure));
    exit as u8
}

/// Reports a failure on stderr. A reader that closed the pipe wants no more, and no message.
fn report(failure: &Failure) -> Exit {
    let exit = failure.exit();
    if exit != Exit::Done {
        say(&format!("error: {failure}"));
    }
    exit
}

/// Help goes to stdout, errors to stderr.
fn answer_of_clap(error: &clap::Error) -> Result<Exit, Failure> {
    let text = |terminal: bool| {
        let text = error.render();
        if terminal { text.ansi().to_string() } else { text.to_string() }
    };
    if error.use_stderr() {
        say_styled(text(is_terminal()).trim_end());
        return Ok(Exit::WrongInput);
    }
    print(text(io::stdout().is_terminal()))?;
    Ok(Exit::Done)
}

/// Sets up logging, the answer to interrupts and the threads, and works.
fn start(options: &Options) -> Result<Exit, Failure> {
    log(options.common.quiet, options.common.verbose);
    interrupt::install().map_err(failed("the answer to interrupts could not be set up"))?;
    let done = on_threads(options.common.threads, || work(options));
    done.map_err(failed("the threads could not be started"))??;
    Ok(Exit::Done)
}

/// Works on this number of threads, or on as many as there are cores.
fn on_threads<T: Send>(
    threads: Option<NonZeroUsize>,
    work: impl FnOnce() -> T + Send,
) -> Result<T, rayon::ThreadPoolBuildError> {
    match threads {
        Some(threads) => {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads.get()).stack_size(STACK).build()?;
            Ok(pool.install(work))
        }
        None => Ok(work()),
    }
}

/// Runs the command that was asked for.
fn work(options: &Options) -> Result<(), Failure> {
    let timings = Timings::new(options.common.timings);
    let quiet = options.common.quiet;
    let done = match &options.command {
        None => atlas::run(&options.atlas, &timings),
        Some(Command::Atlas(arguments)) => atlas::run(arguments, &timings),
        Some(Command::Classify(arguments)) => classify::run(arguments, &timings, quiet),
        Some(Command::Critical(arguments)) => critical::run(arguments, &timings, quiet),
        Some(Command::Show(arguments)) => show::run(arguments),
        Some(Command::Explain(arguments)) => explain::run(arguments, &Options::abouts()),
        Some(Command::Section(arguments)) => section::run(arguments, &timings, quiet),
        Some(Command::Chaos(arguments)) => chaos::run(arguments, &timings, quiet),
        Some(Command::Sphere(arguments)) => sphere::run(arguments, &timings),
        Some(Command::Orbit(arguments)) => orbit::run(arguments, &timings, quiet),
        Some(Command::Periodic(arguments)) => periodic::run(arguments, &timings, quiet),
        Some(Command::Explore(arguments)) => explore::run(arguments),
        Some(Command::Verify(arguments)) => verify::run(arguments, &timings),
        Some(Command::Body(arguments)) => part::run(arguments, &timings),
        Some(Command::State(arguments)) => spin::state(arguments, &timings),
        Some(Command::CriticalSpin(arguments)) => spin::critical_spin(arguments, &timings),
        Some(Command::Campbell(arguments)) => spin::campbell(arguments, &timings),
        Some(Command::SpinDown(arguments)) => spin::spin_down(arguments, &timings),
        Some(Command::Bodies(arguments)) => listings::bodies(arguments),
        Some(Command::Schema(arguments)) => listings::schema(arguments),
        Some(Command::Completions(arguments)) => listings::completions(arguments, Options::command()),
        Some(Command::Man(arguments)) => listings::man(arguments, Options::command()),
        Some(Command::Compare(arguments)) => compare::run(arguments, &timings),
        Some(Command::Classes(arguments)) => classes::run(arguments),
        Some(Command::Class(arguments)) => classes::class(arguments, &timings),
        Some(Command::Find(arguments)) => find::run(arguments, quiet),
        Some(Command::Scan(arguments)) => scan::run(arguments, &timings, quiet),
    };
    timings.total();
    done
}
