//! The options of `bifdiag sphere`.

use std::path::PathBuf;

use bifdiag_body::Number;
use clap::Args;

use crate::cli::export::{PictureArguments, WidthArgument};
use crate::cli::input::BodyArguments;
use crate::cli::input::values::{self, Vector};

pub const EXAMPLES: &str = "\
Examples:
  bifdiag sphere --body paper --h 4.45 --l 3.25
  bifdiag sphere --body paper --region R4 --format svg,png
  bifdiag sphere --A 2,2,1 --r 1,0,0 --h 3.4 --l 2.87 --view 0,0,1 --out annulus

The picture shows the Poisson sphere, on which γ is the direction of gravity in the body's axes, from two opposite sides. \
U is tinted: a component with k boundary circles and n of the poles ±r̂ has a section of genus k + n − 1 above it.";

/// `bifdiag sphere`.
#[derive(Debug, Args)]
pub struct SphereArguments {
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
    /// The sample of this region of the body's atlas, instead of --h and --l
    #[arg(long, value_name = "ID", conflicts_with_all = ["energy", "momentum"], help_heading = "Point")]
    pub region: Option<String>,
    /// From where the first view is taken, in the body's axes (default: from beside r, a little above)
    #[arg(long, value_name = "x,y,z", allow_hyphen_values = true, value_parser = values::direction)]
    #[arg(help_heading = "Output")]
    pub view: Option<Vector>,
    /// Write the picture to DIR
    #[arg(long, value_name = "DIR", help_heading = "Output")]
    pub out: Option<PathBuf>,
    #[command(flatten)]
    pub picture: PictureArguments,
    #[command(flatten)]
    pub width: WidthArgument,
}
