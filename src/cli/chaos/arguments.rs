//! The options of `bifdiag chaos`.

use bifdiag_chaos::ShareOptions;
use bifdiag_dynamics::section::chaos::DecisionOptions;
use clap::Args;

use crate::cli::input::{BodyArguments, PointArguments, values};

pub const CHAOS_EXAMPLES: &str = "\
Examples:
  bifdiag chaos --body paper --h 5.3 --l 3.25
  bifdiag chaos --A 2,1.1,1 --r 0.6,0,0.8 --h 3.8 --l 1 --error 0.1 --json

The share of each component of E that is chaotic, in Liouville measure: orbits start at random, as the invariant measure of \
the energy surface has it, and each is followed until it is known to be regular or chaotic.";

/// `bifdiag chaos`.
#[derive(Debug, Args)]
pub struct ChaosArguments {
    #[command(flatten)]
    pub body: BodyArguments,
    #[command(flatten)]
    pub point: PointArguments,
    /// Standard deviation that is wanted of each share
    #[arg(long, value_name = "E", default_value_t = 0.03, value_parser = values::share_error, help_heading = "Orbits")]
    pub error: f64,
    /// Steps of the integrator after which an orbit stays open
    #[arg(long, value_name = "N", default_value_t = 20_480, value_parser = clap::value_parser!(u32).range(160..=1 << 24))]
    #[arg(help_heading = "Orbits", hide_short_help = true)]
    pub steps: u32,
    /// Another choice of the orbits, equally spread
    #[arg(long, value_name = "K", default_value_t = 0, value_parser = values::seed, help_heading = "Orbits", hide_short_help = true)]
    pub seed: u64,
    /// Print the answer as JSON
    #[arg(long, help_heading = "Output")]
    pub json: bool,
}

impl ChaosArguments {
    /// How shares are measured.
    pub fn options(&self) -> ShareOptions {
        let orbits = DecisionOptions { steps: self.steps as usize, ..DecisionOptions::default() };
        ShareOptions { error: self.error, seed: self.seed, orbits }
    }
}
