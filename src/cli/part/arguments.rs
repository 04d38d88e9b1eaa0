//! The options of `bifdiag body`.

use std::path::PathBuf;

use clap::Args;

use crate::cli::export::PictureArguments;
use crate::cli::input::PartArguments;

pub const BODY_EXAMPLES: &str = "\
Examples:
  bifdiag body --inertia-com 0.24,0.15,0.17,0,0,0 --com 0,0.02,0.15 --mass 2.5
  bifdiag body --inertia-com 240,150,170,8,0,-12 --products tensor \\
      --com 0,20,150 --mass 2.5 --units kg,mm,s
  bifdiag body --inertia-com 0.24,0.15,0.17,0,0,0 --com 0,0.02,0.15 --mass 2.5 \\
      --pivot 0.01,0,0 --out part";

/// `bifdiag body`.
#[derive(Debug, Args)]
pub struct PartBodyArguments {
    #[command(flatten)]
    pub part: PartArguments,
    /// Draw the part into DIR/part.svg
    #[arg(long, value_name = "DIR", help_heading = "Output")]
    pub out: Option<PathBuf>,
    #[command(flatten)]
    pub picture: PictureArguments,
    /// Print the part as JSON
    #[arg(long, help_heading = "Output")]
    pub json: bool,
}
