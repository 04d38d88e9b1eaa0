//! The options of `bifdiag figures`.

use std::path::PathBuf;

use clap::Args;

use crate::cli::export::PictureArguments;

pub const EXAMPLES: &str = "\
Examples:
  bifdiag figures
  bifdiag figures --out my-figures --format svg,png";

/// `bifdiag figures`.
#[derive(Debug, Args)]
pub struct FiguresArguments {
    /// Write the figures to DIR
    #[arg(long, value_name = "DIR", default_value = "figures")]
    pub out: PathBuf,
    /// Draw the charts of measured errors and times too
    #[arg(long)]
    pub charts: bool,
    #[command(flatten)]
    pub picture: PictureArguments,
}
