//! Standard output.

use std::io::{self, ErrorKind, Write};

use thiserror::Error;

use super::interrupt::uninterrupted;

/// Why standard output took no more.
#[derive(Debug, Error)]
pub enum OutputError {
    /// The reader has gone: no failure of ours.
    #[error("the reader of standard output has gone")]
    ClosedPipe,
    #[error("cannot write to standard output: {0}")]
    Write(#[source] io::Error),
}

/// Writes bytes and flushes them; an interrupt waits until all are written.
pub fn print(bytes: &[u8]) -> Result<(), OutputError> {
    let _guard = uninterrupted();
    let mut stdout = io::stdout().lock();
    stdout.write_all(bytes).and_then(|()| stdout.flush()).map_err(|error| match error.kind() {
        ErrorKind::BrokenPipe => OutputError::ClosedPipe,
        _ => OutputError::Write(error),
    })
}
