//! The options of `bifdiag classify`.

use clap::Args;
use top::body::Number;

use crate::cli::batch::BatchArguments;
use crate::cli::input::{AccuracyArgument, BodyArguments, values};

pub const EXAMPLES: &str = "\
Examples:
  bifdiag classify --A 2,1.1,1 --r 0.94868,0,0.61623 --h 3.8 --l 3.25
  bifdiag classify --body kovalevskaya --h 1.84 --l=-1.84 --json
  bifdiag classify --batch points.jsonl > types.jsonl
  echo '{\"h\": 3.8, \"l\": \"13/4\"}' | bifdiag classify --body paper --batch -

Each line of a batch is {\"A\": [2, 1.1, 1], \"r\": [0.94868, 0, 0.61623], \"h\": 3.8, \"l\": 3.25}, numbers or strings; a
line without A and r means the body of the command line, other keys are ignored. One line is written for each, in
the same order; a wrong line gives {\"error\": …, \"line\": n}.";

/// `bifdiag classify`.
#[derive(Debug, Args)]
pub struct ClassifyArguments {
    #[command(flatten)]
    pub body: BodyArguments,
    /// Energy
    #[arg(long = "h", value_name = "h", allow_hyphen_values = true, value_parser = values::number)]
    #[arg(help_heading = "Point")]
    pub energy: Option<Number>,
    /// Vertical angular momentum; its sign does not matter
    #[arg(long = "l", value_name = "l", allow_hyphen_values = true, value_parser = values::number)]
    #[arg(help_heading = "Point")]
    pub momentum: Option<Number>,
    #[command(flatten)]
    pub batch: BatchArguments,
    /// What the answer must be worth
    #[arg(long, value_enum, default_value = "standard", help_heading = "Work")]
    pub accuracy: AccuracyArgument,
    /// Print the answer as JSON (a batch always is)
    #[arg(long, help_heading = "Output")]
    pub json: bool,
}
