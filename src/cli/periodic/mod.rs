//! `bifdiag periodic`: periodic orbits.

mod family;

use clap::{Args, Subcommand};

use super::failure::Failure;
use super::terminal::Timings;
use family::{FAMILY_EXAMPLES, FamilyArguments};

pub const PERIODIC_EXAMPLES: &str = "\
Examples:
  bifdiag periodic family --body paper --l 1.5
  bifdiag periodic family --body paper --from G2.1 --l 1.5 --json";

/// `bifdiag periodic`.
#[derive(Debug, Args)]
pub struct PeriodicArguments {
    #[command(subcommand)]
    pub command: PeriodicCommand,
}

/// What is asked of periodic orbits.
#[derive(Debug, Subcommand)]
pub enum PeriodicCommand {
    /// Follow the families of periodic orbits that begin at relative equilibria
    #[command(after_help = FAMILY_EXAMPLES)]
    Family(Box<FamilyArguments>),
}

pub fn run(arguments: &PeriodicArguments, timings: &Timings) -> Result<(), Failure> {
    match &arguments.command {
        PeriodicCommand::Family(arguments) => family::run(arguments, timings),
    }
}
