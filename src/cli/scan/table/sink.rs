//! Where rows go and what can go wrong on the way.

use std::io;

use bifdiag_schema::RowDocument;
use thiserror::Error;

/// Why rows cannot be read or written.
#[derive(Debug, Error)]
pub enum TableError {
    #[error("{0}")]
    Io(#[from] io::Error),
    #[error("line {line} is no row of a scan: {source}")]
    Json { line: u64, source: serde_json::Error },
    #[error("a row cannot be written as JSON: {0}")]
    JsonWrite(serde_json::Error),
    #[error("this is no CSV file of a scan: {0}")]
    Csv(#[from] ::csv::Error),
    #[cfg(feature = "parquet")]
    #[error("this is no Parquet file of a scan: {0}")]
    Parquet(#[from] ::parquet::errors::ParquetError),
    #[cfg(feature = "parquet")]
    #[error("row {row} of the Parquet file is no row of a scan: {source}")]
    ParquetRow { row: u64, source: serde_json::Error },
    #[cfg(feature = "parquet")]
    #[error("column {column} of the Parquet file cannot be written")]
    Column { column: String },
    #[cfg(not(feature = "parquet"))]
    #[error(
        "this bifdiag was built without the feature `parquet`; use .csv or .jsonl, or build it with --features parquet"
    )]
    NoParquet,
}

/// Takes the rows one by one.
pub trait RowSink {
    /// Adds a row.
    fn write(&mut self, row: &RowDocument) -> Result<(), TableError>;
    /// Writes what is still held back. Nothing may follow.
    fn finish(&mut self) -> Result<(), TableError>;
}

/// The rows of a file, one by one.
pub type Rows = Box<dyn Iterator<Item = Result<RowDocument, TableError>>>;
