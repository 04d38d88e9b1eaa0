//! The options of a batch.

use std::path::{Path, PathBuf};

use clap::Args;

use super::error::BatchInput;

/// Many points at once.
#[derive(Debug, Args)]
#[command(next_help_heading = "Batch")]
pub struct BatchArguments {
    /// Read one JSON object a line from FILE (-: stdin) and write one line for each
    #[arg(long, value_name = "FILE")]
    pub batch: Option<PathBuf>,
    /// Exit with status 2 if a line of the batch is wrong
    #[arg(long)]
    pub strict: bool,
}

impl BatchArguments {
    /// The file of the batch, if one is asked for and none of the options that its lines replace is given.
    pub fn path(&self, replaced: &[(&'static str, bool)]) -> Result<Option<&Path>, BatchInput> {
        let Some(path) = &self.batch else {
            return if self.strict { Err(BatchInput::StrictWithoutBatch) } else { Ok(None) };
        };
        match replaced.iter().find(|(_, given)| *given) {
            Some((option, _)) => Err(BatchInput::PointWithBatch { option }),
            None => Ok(Some(path)),
        }
    }
}
