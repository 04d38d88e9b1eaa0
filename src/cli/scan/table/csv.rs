//! CSV.

use std::io::{Read, Write};

use bifdiag_schema::RowDocument;

use super::sink::{RowSink, TableError};

/// Writes rows below a heading.
pub struct Sink<W: Write> {
    writer: csv::Writer<W>,
}

impl<W: Write> Sink<W> {
    pub fn new(out: W) -> Self {
        Self { writer: csv::Writer::from_writer(out) }
    }
}

impl<W: Write> RowSink for Sink<W> {
    fn write(&mut self, row: &RowDocument) -> Result<(), TableError> {
        Ok(self.writer.serialize(row)?)
    }

    fn finish(&mut self) -> Result<(), TableError> {
        Ok(self.writer.flush()?)
    }
}

/// The rows of a file.
pub fn rows(file: impl Read) -> impl Iterator<Item = Result<RowDocument, TableError>> {
    csv::Reader::from_reader(file).into_deserialize().map(|row| Ok(row?))
}
