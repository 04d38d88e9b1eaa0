//! The options of `bifdiag chaos`.

use std::path::PathBuf;

use bifdiag_chaos::ShareOptions;
use bifdiag_dynamics::section::chaos::DecisionOptions;
use bifdiag_schema::WindowDocument;
use bifdiag_survey::scan::Shard;
use clap::{Args, Subcommand};

use crate::cli::export::{PictureArguments, WidthArgument};
use crate::cli::failure::Failure;
use crate::cli::input::{BodyArguments, PointArguments, values};

pub const CHAOS_EXAMPLES: &str = "\
Examples:
  bifdiag chaos --body paper --h 5.3 --l 3.25
  bifdiag chaos --A 2,1.1,1 --r 0.6,0,0.8 --h 3.8 --l 1 --error 0.1 --json
  bifdiag chaos --body paper --window 5:6,1:2 --cells 4x4 --out chaos.json
  bifdiag chaos --body paper --cells 16x8 --error 0.2 --shard 1/2 --out p-1.json
  bifdiag chaos merge p-*.json --out chaos.npz
  bifdiag chaos map chaos.json --out pictures

The chaotic share of each component of E, in Liouville measure: orbits start at random points, distributed by the \
invariant measure of the energy surface, and each is followed until it is known to be regular or chaotic. An \
interrupted map resumes where it stopped when the same command is run again, and its file is byte for byte that of an \
uninterrupted run.";

const DRAW_EXAMPLES: &str = "\
Examples:
  bifdiag chaos map chaos.json --out pictures
  bifdiag chaos map chaos.json --width 86mm --theme print --out pictures";

const MERGE_EXAMPLES: &str = "\
Examples:
  bifdiag chaos merge part-1.json part-2.json --out chaos.npz";

/// `bifdiag chaos`.
#[derive(Debug, Args)]
#[command(args_conflicts_with_subcommands = true, subcommand_negates_reqs = true)]
pub struct ChaosArguments {
    #[command(subcommand)]
    pub command: Option<ChaosCommand>,
    #[command(flatten)]
    pub share: ShareArguments,
}

/// What else can be done with maps.
#[derive(Debug, Subcommand)]
pub enum ChaosCommand {
    /// Draw a map, overlaid with the curves and the regions
    #[command(after_help = DRAW_EXAMPLES)]
    Map(DrawArguments),
    /// Join the shards of a map
    #[command(after_help = MERGE_EXAMPLES)]
    Merge(MergeArguments),
}

/// A point or a map.
#[derive(Debug, Args)]
pub struct ShareArguments {
    #[command(flatten)]
    pub body: BodyArguments,
    #[command(flatten)]
    pub point: PointArguments,
    /// Map this part of the plane instead of measuring one point (default: that of the diagram)
    #[arg(long, value_name = "hmin:hmax,lmin:lmax", allow_hyphen_values = true, value_parser = values::window)]
    #[arg(help_heading = "Map")]
    pub window: Option<WindowDocument>,
    /// Number of cells along h and along l
    #[arg(long, value_name = "NxM", default_value = "200x200", value_parser = cells, help_heading = "Map")]
    pub cells: [u64; 2],
    /// Compute only part i of n of the map
    #[arg(long, value_name = "i/n", help_heading = "Map", hide_short_help = true)]
    pub shard: Option<Shard>,
    /// Start over even if FILE.partial holds an unfinished map
    #[arg(long, help_heading = "Map", hide_short_help = true)]
    pub restart: bool,
    /// Standard deviation wanted for each share
    #[arg(long, value_name = "E", default_value_t = 0.03, value_parser = values::share_error, help_heading = "Orbits")]
    pub error: f64,
    /// Leave an orbit open after N steps of the integrator
    #[arg(long, value_name = "N", default_value_t = 20_480, value_parser = clap::value_parser!(u32).range(160..=1 << 24))]
    #[arg(help_heading = "Orbits", hide_short_help = true)]
    pub steps: u32,
    /// Seed for the choice of the orbits; all choices are equally spread
    #[arg(long, value_name = "K", default_value_t = 0, value_parser = values::seed, help_heading = "Orbits", hide_short_help = true)]
    pub seed: u64,
    /// Write the map to FILE (.npz, .parquet, .csv, .jsonl: tables; .json: a document)
    #[arg(long, value_name = "FILE", help_heading = "Output")]
    pub out: Option<PathBuf>,
    /// Print the answer of one point as JSON
    #[arg(long, conflicts_with = "out", help_heading = "Output")]
    pub json: bool,
}

/// `bifdiag chaos map`.
#[derive(Debug, Args)]
pub struct DrawArguments {
    /// A map (.json)
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Write chaos.svg, or the other formats, to DIR
    #[arg(long, value_name = "DIR", default_value = "bifdiag-out", help_heading = "Output")]
    pub out: PathBuf,
    #[command(flatten)]
    pub width: WidthArgument,
    #[command(flatten)]
    pub picture: PictureArguments,
}

/// `bifdiag chaos merge`.
#[derive(Debug, Args)]
pub struct MergeArguments {
    /// The shards (.json), in any order
    #[arg(value_name = "SHARD")]
    pub shards: Vec<PathBuf>,
    /// Write the map to FILE (.npz, .parquet, .csv, .jsonl, .json)
    #[arg(long, value_name = "FILE", help_heading = "Output")]
    pub out: Option<PathBuf>,
}

impl ShareArguments {
    /// How shares are measured.
    pub fn options(&self) -> ShareOptions {
        let orbits = DecisionOptions { steps: self.steps as usize, ..DecisionOptions::default() };
        ShareOptions { error: self.error, seed: self.seed, orbits }
    }
}

/// Numbers of cells such as 200x200.
fn cells(text: &str) -> Result<[u64; 2], Failure> {
    /// The most cells of a map.
    const MOST: u64 = 100_000_000;
    let count = |text: &str| text.parse::<u64>().ok().filter(|count| *count > 0);
    let counts = text.split_once('x').and_then(|(n, m)| Some([count(n)?, count(m)?]));
    counts
        .filter(|[n, m]| n.checked_mul(*m).is_some_and(|all| all <= MOST))
        .ok_or_else(|| Failure::input("cells are written NxM, such as 200x200, at most 100000000 of them"))
}
