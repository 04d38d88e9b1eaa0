//! The options of `bifdiag critical`.

use super::momenta::Momenta;
use crate::cli::batch::BatchArguments;
use crate::cli::export::DataTarget;
use crate::cli::input::BodyArguments;
use clap::{Args, ValueEnum};

pub const EXAMPLES: &str = "\
Examples:
  bifdiag critical --A 2,1.1,1 --r 0.94868,0,0.61623 --l 3.25
  bifdiag critical --body katok:6 --l 7/3 --json
  bifdiag critical --A 2,1.1,1 --r 0.94868,0,0.61623 --l 3.25 --method newton
  bifdiag critical --body lagrange --l 0:4:401 --out lagrange.npz
  bifdiag critical --batch momenta.jsonl --threads 4 > equilibria.jsonl

Each line of a batch is {\"A\": [2, 1.1, 1], \"r\": [0.94868, 0, 0.61623], \"l\": 3.25}, numbers or strings; a line \
without A and r means the body of the command line, other keys are ignored. One line is written for each, in the \
same order; a wrong line gives {\"error\": …, \"line\": n}.";

/// How relative equilibria are found.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Method {
    /// All of them from the closed form, with bounds
    #[default]
    ClosedForm,
    /// Follow each curve from l = 0, its cusp or its pitchfork by Newton continuation: slower, a second way to the same
    /// list; eigenvalues and verdicts are those of the closed form
    Newton,
}

/// `bifdiag critical`.
#[derive(Debug, Args)]
pub struct CriticalArguments {
    #[command(flatten)]
    pub body: BodyArguments,
    /// Vertical angular momentum, or a range a:b:n of n momenta; its sign is that of omega
    #[arg(long = "l", value_name = "l|a:b:n", allow_hyphen_values = true, value_parser = Momenta::parse)]
    #[arg(help_heading = "Momentum")]
    pub momentum: Option<Momenta>,
    /// How they are found
    #[arg(long, value_enum, default_value_t, value_name = "METHOD", help_heading = "Momentum")]
    pub method: Method,
    #[command(flatten)]
    pub batch: BatchArguments,
    /// Print the answer as JSON (a batch always is)
    #[arg(long, help_heading = "Output")]
    pub json: bool,
    /// Write the table of a range to FILE (.npz, .parquet, .csv, .jsonl; default: CSV to stdout)
    #[arg(long, value_name = "FILE", value_parser = DataTarget::parse, help_heading = "Output")]
    pub out: Option<DataTarget>,
}
