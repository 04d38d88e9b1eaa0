//! `bifdiag chaos`: the chaotic share of the energy surface at one point.

mod arguments;
mod point;

pub use arguments::{CHAOS_EXAMPLES, ChaosArguments};

use super::failure::Failure;
use super::terminal::Timings;

pub fn run(arguments: &ChaosArguments, timings: &Timings) -> Result<(), Failure> {
    point::run(arguments, timings)
}
