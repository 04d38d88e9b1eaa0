//! The options of `bifdiag atlas`.

use std::path::PathBuf;

use bifdiag_schema::{Accuracy, WindowDocument};
use clap::Args;

use crate::cli::export::{PictureArguments, WidthArgument};
use crate::cli::input::{BodyArguments, accuracy, values};

pub const EXAMPLES: &str = "\
Examples:
  bifdiag atlas --A 2,1.1,1 --r 0.94868,0,0.61623
  bifdiag atlas --body katok:7 --window 0:4,0:3 --format png --out katok7
  bifdiag atlas --A 2,11/10,1 --r=-1,0,1/2 --json > atlas.json
  bifdiag atlas --inertia 0.30,0.21,0.17,0.01,0,-0.02 --products tensor \\
      --com 0,0.02,0.15 --mass 2.5 --g 9.80665 --no-plot";

/// `bifdiag atlas`.
#[derive(Debug, Args)]
pub struct AtlasArguments {
    #[command(flatten)]
    pub body: BodyArguments,
    /// Only this part of the plane
    #[arg(long, value_name = "hmin:hmax,lmin:lmax", allow_hyphen_values = true, value_parser = values::window)]
    #[arg(help_heading = "Work")]
    pub window: Option<WindowDocument>,
    /// What the answer must be worth
    #[arg(long, value_parser = accuracy(), default_value = "exact", help_heading = "Work")]
    pub accuracy: Accuracy,
    /// Prove every step and write down what `bifdiag verify` needs to check it
    #[arg(long, help_heading = "Work")]
    pub certificate: bool,
    /// Write atlas.json and the diagram to DIR (default: bifdiag-out; with --json: nowhere)
    #[arg(long, value_name = "DIR", help_heading = "Output")]
    pub out: Option<PathBuf>,
    #[command(flatten)]
    pub picture: PictureArguments,
    #[command(flatten)]
    pub width: WidthArgument,
    /// Draw nothing
    #[arg(long, help_heading = "Output")]
    pub no_plot: bool,
    /// Leave polylines, polygons, widths and views out of atlas.json
    #[arg(long, help_heading = "Output")]
    pub no_drawing: bool,
    #[arg(long, hide = true)]
    pub no_polygons: bool,
    /// Print the atlas as JSON
    #[arg(long, help_heading = "Output")]
    pub json: bool,
}
