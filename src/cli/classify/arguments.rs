//! The options of `bifdiag classify`.

use std::path::PathBuf;

use bifdiag_body::Number;
use bifdiag_schema::Accuracy;
use clap::Args;

use crate::cli::batch::BatchArguments;
use crate::cli::input::values::Grid;
use crate::cli::input::{BodyArguments, accuracy, values};

pub const EXAMPLES: &str = "\
Examples:
  bifdiag classify --A 2,1.1,1 --r 0.94868,0,0.61623 --h 3.8 --l 3.25
  bifdiag classify --body kovalevskaya --h 1.84 --l=-1.84 --json
  bifdiag classify --body paper --grid -1:6:200,0:4:200 --out grid.npz
  bifdiag classify --batch points.jsonl > types.jsonl
  echo '{\"h\": 3.8, \"l\": \"13/4\"}' | bifdiag classify --body paper --batch -

Each line of a batch is {\"A\": [2, 1.1, 1], \"r\": [0.94868, 0, 0.61623], \"h\": 3.8, \"l\": 3.25}, numbers or strings; a \
line without A and r means the body of the command line, other keys are ignored. One line is written for each, in \
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
    /// The regions of all points of a grid: n energies and m momenta, both ends included; with --out FILE
    #[arg(long, value_name = "hmin:hmax:n,lmin:lmax:m", allow_hyphen_values = true, value_parser = values::grid)]
    #[arg(help_heading = "Grid")]
    pub grid: Option<Grid>,
    /// Where the grid goes: FILE.npz (arrays h, l, region, regions, meta) or FILE.png (a pixel for each point)
    #[arg(long, value_name = "FILE", help_heading = "Grid")]
    pub out: Option<PathBuf>,
    /// What the answer must be worth
    #[arg(long, value_parser = accuracy(), default_value = "exact", help_heading = "Work")]
    pub accuracy: Accuracy,
    /// Leave the ids of the regions out: no atlas is made (for batches over many bodies)
    #[arg(long, help_heading = "Work")]
    pub no_region: bool,
    /// Print the answer as JSON (a batch always is)
    #[arg(long, help_heading = "Output")]
    pub json: bool,
}
