//! `bifdiag periodic`: periodic orbits.

mod family;
mod list;
mod list_output;
mod manifolds;
mod manifolds_output;
mod short;

use clap::{Args, Subcommand};

use super::failure::Failure;
use super::terminal::Timings;
use family::{FAMILY_EXAMPLES, FamilyArguments};
use list::{LIST_EXAMPLES, ListArguments};
use manifolds::{MANIFOLDS_EXAMPLES, ManifoldsArguments};
use short::ShortArguments;

pub const PERIODIC_EXAMPLES: &str = "\
Examples:
  bifdiag periodic --body paper --h 2.6 --l 3.25
  bifdiag periodic --body paper --h 2.6 --l 3.25 --crossings 4 --json
  bifdiag periodic family --body paper --from G2.1 --l 1.5
  bifdiag periodic list --body paper --l 1.5 --stable --period 2:5

Every periodic orbit of γ and ω at (h, l) with at most N crossings of the section P. Orbits are found in cells that cover P, each \
with an index, and proved one by one with Krawczyk's operator on the enclosed return map.";

/// `bifdiag periodic`.
#[derive(Debug, Args)]
#[command(args_conflicts_with_subcommands = true, subcommand_negates_reqs = true)]
pub struct PeriodicArguments {
    #[command(subcommand)]
    pub command: Option<PeriodicCommand>,
    #[command(flatten)]
    pub short: ShortArguments,
}

/// The subcommands.
#[derive(Debug, Subcommand)]
pub enum PeriodicCommand {
    /// Follow the families of periodic orbits that begin at relative equilibria
    #[command(after_help = FAMILY_EXAMPLES)]
    Family(Box<FamilyArguments>),
    /// List the orbits of all families of a body
    #[command(after_help = LIST_EXAMPLES)]
    List(Box<ListArguments>),
    /// Follow the stable and unstable manifolds of periodic orbits or equilibria in the section
    #[command(after_help = MANIFOLDS_EXAMPLES)]
    Manifolds(Box<ManifoldsArguments>),
}

pub fn run(arguments: &PeriodicArguments, timings: &Timings, quiet: bool) -> Result<(), Failure> {
    match &arguments.command {
        None => short::run(&arguments.short, timings, quiet),
        Some(PeriodicCommand::Family(arguments)) => family::run(arguments, timings, quiet),
        Some(PeriodicCommand::List(arguments)) => list::run(arguments, quiet),
        Some(PeriodicCommand::Manifolds(arguments)) => manifolds::run(arguments, timings, quiet),
    }
}
