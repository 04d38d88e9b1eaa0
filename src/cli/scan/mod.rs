//! `bifdiag scan`: many bodies, their shards, maps, the borders between their classes, and their events along a way.

mod arguments;
mod border;
mod events;
mod journal;
mod map;
mod merge;
mod output;
#[cfg(feature = "parquet")]
mod parquet;
mod sample;
mod table;

pub use arguments::{SCAN_EXAMPLES, ScanArguments, ScanCommand};

use super::failure::Failure;
use super::terminal::Timings;

pub fn run(arguments: &ScanArguments, timings: &Timings, quiet: bool) -> Result<(), Failure> {
    match &arguments.command {
        None => sample::run(&arguments.sample, quiet),
        Some(ScanCommand::Merge(arguments)) => merge::run(arguments),
        Some(ScanCommand::Map(arguments)) => map::run(arguments, timings),
        Some(ScanCommand::Border(arguments)) => border::run(arguments),
        Some(ScanCommand::Events(arguments)) => events::run(arguments, timings),
    }
}
