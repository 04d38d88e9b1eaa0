//! Standard output.

use std::io::{self, ErrorKind, Write};

use thiserror::Error;

use super::interrupt::uninterrupted;
use crate::cli::failure::{CommandError, Exit};

/// Why standard output took no more.
#[derive(Debug, Error)]
pub enum OutputError {
    /// The reader has gone: no failure of ours.
    #[error("the reader of standard output has gone")]
    ClosedPipe,
    #[error("cannot write to standard output: it is closed")]
    Closed,
    #[error("cannot write to standard output: {0}")]
    Write(#[source] io::Error),
}

impl CommandError for OutputError {
    fn exit(&self) -> Exit {
        match self {
            Self::ClosedPipe => Exit::Done,
            Self::Closed | Self::Write(_) => Exit::Failed,
        }
    }
}

/// Writes bytes and flushes them; an interrupt waits until all are written.
pub fn print(bytes: impl AsRef<[u8]>) -> Result<(), OutputError> {
    let bytes = bytes.as_ref();
    if bifdiag_streams::stdout_was_closed() && !bytes.is_empty() {
        return Err(OutputError::Closed);
    }
    let _guard = uninterrupted();
    let mut stdout = io::stdout().lock();
    stdout.write_all(bytes).and_then(|()| stdout.flush()).map_err(|error| match error.kind() {
        ErrorKind::BrokenPipe => OutputError::ClosedPipe,
        _ => OutputError::Write(error),
    })
}
