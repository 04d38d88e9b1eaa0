//! JSON Lines.

use std::io::{BufRead, Write};

use bifdiag_schema::RowDocument;

use super::sink::{RowSink, TableError};

/// Writes one object a line.
pub struct Sink<W: Write> {
    out: W,
}

impl<W: Write> Sink<W> {
    pub fn new(out: W) -> Self {
        Self { out }
    }
}

impl<W: Write> RowSink for Sink<W> {
    fn write(&mut self, row: &RowDocument) -> Result<(), TableError> {
        let mut line = serde_json::to_vec(row).map_err(TableError::JsonWrite)?;
        line.push(b'\n');
        Ok(self.out.write_all(&line)?)
    }

    fn finish(&mut self) -> Result<(), TableError> {
        Ok(self.out.flush()?)
    }
}

/// The rows of a file.
pub fn rows(file: impl BufRead) -> impl Iterator<Item = Result<RowDocument, TableError>> {
    file.lines()
        .zip(1..)
        .map(|(line, number)| serde_json::from_str(&line?).map_err(|source| TableError::Json { line: number, source }))
}
