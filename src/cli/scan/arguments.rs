//! The options of `bifdiag scan` and its commands.

use std::path::PathBuf;

use bifdiag_schema::{Accuracy, BodyParameter};
use bifdiag_survey::scan::Shard;
use bifdiag_survey::{BodyFamily, ParameterRange, parameter};
use clap::{Args, Subcommand};

use super::table::Format;
use crate::cli::export::{DataTarget, PictureArguments, WidthArgument};
use crate::cli::input::values::{self, Named, named};
use crate::cli::input::{PlainBodyArguments, accuracy};
use crate::pictures::Shown;

pub const SCAN_EXAMPLES: &str = "\
Examples:
  bifdiag scan --family general --samples 200 --out general.parquet
  bifdiag scan --family katok --vary A2=0.3:1.7:15,A3=0.3:1.7:15 --out katok.csv
  bifdiag scan --body paper --vary r2=0:0.5:9,r3=0:0.5:9 --out paper.jsonl
  bifdiag scan --family general --samples 200 --shard 3/16 --out shard-3.parquet
  bifdiag scan --family katok --samples 5 --format csv --out -
  bifdiag scan merge shard-*.parquet --out general.parquet
  bifdiag scan map katok.csv --x A2 --y A3 --out maps
  bifdiag scan border --body katok:2 --vary A3=0.7:0.8
  bifdiag scan events --body kovalevskaya --vary A2=1:2.2

One row per body: A, r, the class of its diagram, the numbers of regions, events and relative equilibria, the types \
found. FILE.summary.json summarizes all rows. An interrupted scan resumes where it stopped when the same command is \
run again, and its files are byte for byte those of an uninterrupted run.";

const MERGE_EXAMPLES: &str = "\
Examples:
  bifdiag scan merge shard-1.parquet shard-2.parquet --out all.parquet
  bifdiag scan merge shard-*.csv --out all.csv

A shard consists of a file with rows and its FILE.summary.json. The result is byte for byte that of the scan in one \
piece.";

const MAP_EXAMPLES: &str = "\
Examples:
  bifdiag scan map katok.parquet --x A2 --y A3
  bifdiag scan map general.csv --x A1 --y r3 --format svg,png --out maps";

const BORDER_EXAMPLES: &str = "\
Examples:
  bifdiag scan border --body katok:2 --vary A3=0.7:0.8
  bifdiag scan border --body paper --vary r2=0.01:0.4 --json";

const EVENTS_EXAMPLES: &str = "\
Examples:
  bifdiag scan events --body kovalevskaya --vary A2=1:2.2
  bifdiag scan events --body paper --vary r2=0:0.4:60 --l 0:6 --data events.csv

Each event (cusp, pitchfork, crossing) is followed from border to border; --data FILE lists its positions.";

/// `bifdiag scan`.
#[derive(Debug, Args)]
#[command(args_conflicts_with_subcommands = true, subcommand_negates_reqs = true)]
pub struct ScanArguments {
    #[command(subcommand)]
    pub command: Option<ScanCommand>,
    #[command(flatten)]
    pub sample: SampleArguments,
}

/// What else can be done with scans.
#[derive(Debug, Subcommand)]
pub enum ScanCommand {
    /// Join the shards of a scan
    #[command(after_help = MERGE_EXAMPLES)]
    Merge(MergeArguments),
    /// Draw the class of each body over two parameters
    #[command(after_help = MAP_EXAMPLES)]
    Map(MapArguments),
    /// Find where the class changes between two bodies, and what happens there
    #[command(after_help = BORDER_EXAMPLES)]
    Border(Box<BorderArguments>),
    /// Follow all events of the diagram while one parameter of the body varies
    #[command(after_help = EVENTS_EXAMPLES)]
    Events(Box<EventsArguments>),
}

/// Families of bodies.
static FAMILIES: [Named<BodyFamily>; 3] = [
    (
        "general",
        "Every body that exists: A_i = 1 - m_i, the second moments m uniform on a simplex, r/|r| uniform on an octant",
        BodyFamily::General,
    ),
    (
        "positive",
        "As general, but A uniform on a simplex, whether or not bodies with these moments exist",
        BodyFamily::Positive,
    ),
    ("katok", "A = (1, A2, A3), r = (1, 0, 0)", BodyFamily::Katok),
];

/// The scan itself.
#[derive(Debug, Args)]
pub struct SampleArguments {
    #[command(flatten)]
    pub body: PlainBodyArguments,
    /// Family of bodies; without it, vary the body of --A and --r by --vary
    #[arg(long, value_parser = named(&FAMILIES), help_heading = "Bodies")]
    pub family: Option<BodyFamily>,
    /// Read the bodies from a CSV table with the columns A1, A2, A3, r1, r2, r3
    #[arg(long, value_name = "FILE", help_heading = "Bodies", conflicts_with_all = ["family", "vary", "samples", "seed"])]
    pub bodies: Option<PathBuf>,
    /// A parameter (A1, A2, A3, r1, r2, r3) and its range; with N: a grid of N values
    #[arg(long, value_name = "A2=FROM:TO[:N]", value_delimiter = ',', help_heading = "Bodies")]
    pub vary: Vec<ParameterRange>,
    /// Take N bodies of a low-discrepancy sequence
    #[arg(long, value_name = "N", help_heading = "Bodies", value_parser = clap::value_parser!(u64).range(1..1 << 53))]
    pub samples: Option<u64>,
    /// Seed of the sequence
    #[arg(long, value_name = "N", default_value_t = 0, help_heading = "Bodies", hide_short_help = true)]
    pub seed: u64,
    /// Scan only part i of n of the bodies
    #[arg(long, value_name = "i/n", help_heading = "Work", hide_short_help = true)]
    pub shard: Option<Shard>,
    /// Required accuracy of the answers
    #[arg(long, value_parser = accuracy(), default_value = "exact", help_heading = "Work", hide_short_help = true)]
    pub accuracy: Accuracy,
    /// Start over even if FILE.partial holds an unfinished scan
    #[arg(long, help_heading = "Work", hide_short_help = true)]
    pub restart: bool,
    /// Do not replace FILE if another scan has finished it, or if it is not a scan
    #[arg(long, help_heading = "Output", hide_short_help = true)]
    pub keep: bool,
    /// Write the rows to FILE (.parquet, .csv, .jsonl; -: stdout) and the summary to FILE.summary.json
    #[arg(long, value_name = "FILE", help_heading = "Output")]
    pub out: Option<PathBuf>,
    /// Format of the rows (default: by the extension of FILE; JSON Lines on stdout)
    #[arg(long, value_enum, help_heading = "Output")]
    pub format: Option<Format>,
    /// Print the summary as JSON
    #[arg(long, help_heading = "Output")]
    pub json: bool,
}

/// `bifdiag scan merge`.
#[derive(Debug, Args)]
pub struct MergeArguments {
    /// The files of the shards, in any order
    #[arg(value_name = "SHARD")]
    pub shards: Vec<PathBuf>,
    /// Write the rows to FILE (.parquet, .csv, .jsonl) and the summary to FILE.summary.json
    #[arg(long, value_name = "FILE", help_heading = "Output")]
    pub out: Option<PathBuf>,
    /// Print the summary as JSON
    #[arg(long, help_heading = "Output")]
    pub json: bool,
}

/// `bifdiag scan map`.
#[derive(Debug, Args)]
pub struct MapArguments {
    /// The rows of a scan
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Parameter of the horizontal axis
    #[arg(long, value_name = "PARAMETER", value_parser = parameter, help_heading = "Map")]
    pub x: BodyParameter,
    /// Parameter of the vertical axis
    #[arg(long, value_name = "PARAMETER", value_parser = parameter, help_heading = "Map")]
    pub y: BodyParameter,
    /// What the colours show
    #[arg(long, value_enum, default_value = "class", help_heading = "Map")]
    pub show: Shown,
    /// Write map.svg, or the other formats, to DIR
    #[arg(long, value_name = "DIR", default_value = "bifdiag-out", help_heading = "Output")]
    pub out: PathBuf,
    #[command(flatten)]
    pub picture: PictureArguments,
    #[command(flatten)]
    pub width: WidthArgument,
}

/// `bifdiag scan border`.
#[derive(Debug, Args)]
pub struct BorderArguments {
    #[command(flatten)]
    pub body: PlainBodyArguments,
    /// A parameter and two values between which the class changes; several vary together
    #[arg(long, value_name = "A2=FROM:TO", value_delimiter = ',', help_heading = "Border")]
    pub vary: Vec<ParameterRange>,
    /// Required accuracy of the answers
    #[arg(long, value_parser = accuracy(), default_value = "exact", help_heading = "Work")]
    pub accuracy: Accuracy,
    /// Print the answer as JSON
    #[arg(long, help_heading = "Output")]
    pub json: bool,
}

/// `bifdiag scan events`.
#[derive(Debug, Args)]
pub struct EventsArguments {
    #[command(flatten)]
    pub body: PlainBodyArguments,
    /// The parameter that varies and its range; N is the number of bodies (default: 240)
    #[arg(long, value_name = "A2=FROM:TO[:N]", help_heading = "Path")]
    pub vary: ParameterRange,
    /// Range of momenta in the picture (default: nearly all events)
    #[arg(long = "l", value_name = "FROM:TO", value_parser = values::momenta, help_heading = "Output")]
    pub momenta: Option<[f64; 2]>,
    /// Write the positions of the events to FILE.csv, FILE.npz, FILE.jsonl or FILE.parquet (-: CSV to stdout)
    #[arg(long, value_name = "FILE", value_parser = DataTarget::parse, help_heading = "Output")]
    pub data: Option<DataTarget>,
    /// Write the picture to DIR (default: bifdiag-out; with --json or --data -: nowhere)
    #[arg(long, value_name = "DIR", help_heading = "Output")]
    pub out: Option<PathBuf>,
    #[command(flatten)]
    pub picture: PictureArguments,
    #[command(flatten)]
    pub width: WidthArgument,
    /// Draw nothing
    #[arg(long, help_heading = "Output")]
    pub no_plot: bool,
    /// Print the answer as JSON
    #[arg(long, help_heading = "Output")]
    pub json: bool,
}
