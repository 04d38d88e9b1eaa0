//! The command line: options, one module for each command, and what they share to print, write files and stop.
//!
//! Only this part of the crate prints, writes files or chooses an exit status.

mod arguments;
mod atlas;
mod batch;
mod bodies;
mod classify;
mod critical;
mod data;
mod failure;
mod figures;
mod files;
mod find;
mod integration;
mod interrupt;
mod log;
mod orbit;
mod output;
mod pages;
mod report;
mod scan;
mod schema;
mod section;
mod subject;
mod table;
mod timings;
mod values;
mod verify;

use std::ffi::OsString;

use documents::layout;

use arguments::{Command, Options};
use failure::Failure;
use timings::Timings;

/// Where the files go if nothing else is said.
const DEFAULT_DIRECTORY: &str = "bifdiag-out";

/// Runs a command line, its first argument the name of the program, and returns the exit status: 0 done, 2 wrong input,
/// 1 anything else. Prints to stdout and stderr, writes files, and answers SIGINT and SIGTERM.
pub fn run(arguments: impl IntoIterator<Item = OsString>) -> u8 {
    let options = match Options::from_arguments(arguments) {
        Ok(options) => options,
        Err(refusal) => return refusal.print(),
    };
    match start(&options).and_then(|()| work(&options)) {
        Ok(()) => 0,
        Err(failure) => failure.print(),
    }
}

/// Sets up logging, the answer to interrupts and the number of threads.
fn start(options: &Options) -> Result<(), Failure> {
    log::start(&options.common);
    interrupt::install()?;
    if let Some(threads) = options.common.threads {
        rayon::ThreadPoolBuilder::new().num_threads(threads.get()).build_global()?;
    }
    Ok(())
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
        Some(Command::Section(arguments)) => section::run(arguments, &timings, quiet),
        Some(Command::Orbit(arguments)) => orbit::run(arguments, &timings),
        Some(Command::Verify(arguments)) => verify::run(arguments, &timings),
        Some(Command::Bodies(arguments)) => bodies::run(arguments),
        Some(Command::Schema(arguments)) => schema::run(arguments),
        Some(Command::Completions(arguments)) => pages::completions(arguments),
        Some(Command::Man(arguments)) => pages::man(arguments),
        Some(Command::Find(arguments)) => find::run(arguments, quiet),
        Some(Command::Scan(arguments)) => scan::run(arguments, &timings, quiet),
        Some(Command::Figures(arguments)) => figures::run(arguments, &timings),
    };
    timings.total();
    done
}
