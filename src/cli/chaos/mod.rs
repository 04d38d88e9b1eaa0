//! `bifdiag chaos`: the chaotic share of the energy surface, at one point and over a window.

mod arguments;
mod draw;
mod map;
mod merge;
mod output;
mod share;

pub use arguments::{CHAOS_EXAMPLES, ChaosArguments};

use super::failure::Failure;
use super::terminal::Timings;
use arguments::ChaosCommand;

pub fn run(arguments: &ChaosArguments, timings: &Timings, quiet: bool) -> Result<(), Failure> {
    let share = &arguments.share;
    match &arguments.command {
        Some(ChaosCommand::Map(arguments)) => draw::run(arguments, timings),
        Some(ChaosCommand::Merge(arguments)) => merge::run(arguments),
        None if share.out.is_some() || share.window.is_some() => map::run(share, quiet),
        None => share::run(share, timings),
    }
}
