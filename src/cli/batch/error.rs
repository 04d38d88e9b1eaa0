//! What can be wrong about a point or a batch of points.

use std::io;
use std::path::PathBuf;

use thiserror::Error;

use crate::cli::failure::{CommandError, Exit};

#[derive(Debug, Error)]
pub enum BatchInput {
    #[error("{missing} is missing; give {example}, or --batch FILE for many points")]
    NoPoint { missing: &'static str, example: &'static str },
    #[error("{option} cannot be used with --batch: the lines of the batch say it; leave out {option} or --batch")]
    PointWithBatch { option: &'static str },
    #[error("--strict needs --batch: it says what a wrong line of a batch means; add --batch FILE or leave it out")]
    StrictWithoutBatch,
    #[error("--batch {path}: {source}; give a file that can be read, or - for stdin", path = path.display())]
    File { path: PathBuf, source: io::Error },
    #[error("--strict: {bad} of {lines} lines of the batch are wrong; see the lines with \"error\"")]
    BadLines { bad: usize, lines: usize },
}

impl CommandError for BatchInput {
    fn exit(&self) -> Exit {
        Exit::WrongInput
    }
}

/// Right questions had no answer.
#[derive(Debug, Error)]
#[error("{unanswered} of {lines} lines of the batch have no answer; see the lines with \"error\"")]
pub struct Unanswered {
    pub unanswered: usize,
    pub lines: usize,
}

impl CommandError for Unanswered {}

/// The batch could be read no further.
#[derive(Debug, Error)]
#[error("--batch {path}: reading stopped", path = path.display())]
pub struct BatchRead {
    pub path: PathBuf,
    pub source: io::Error,
}

impl CommandError for BatchRead {}
