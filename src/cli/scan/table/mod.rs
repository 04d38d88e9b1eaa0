//! Files with one row for each body: CSV, JSON Lines and, with the feature `parquet`, Parquet.

mod csv;
mod json_lines;
#[cfg(feature = "parquet")]
mod parquet;
mod sink;

use std::fs::File;
use std::io::{BufReader, Write};
use std::path::Path;

use clap::ValueEnum;
use sink::{RowSink, Rows};

pub use sink::TableError;

/// Formats of the rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// Apache Parquet, for pandas, Polars, DuckDB, Spark
    Parquet,
    /// Comma-separated values with a heading
    Csv,
    /// One JSON object a line
    Jsonl,
}

impl Format {
    /// The format that the ending of a file's name says.
    pub fn of(path: &Path) -> Option<Self> {
        match path.extension()?.to_str()?.to_ascii_lowercase().as_str() {
            "parquet" | "pq" => Some(Self::Parquet),
            "csv" => Some(Self::Csv),
            "jsonl" | "ndjson" => Some(Self::Jsonl),
            _ => None,
        }
    }

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Parquet => "parquet",
            Self::Csv => "csv",
            Self::Jsonl => "jsonl",
        }
    }

    /// True if this program can read and write it.
    pub fn is_available(self) -> bool {
        self != Self::Parquet || cfg!(feature = "parquet")
    }

    /// A writer of rows.
    pub fn sink<'a, W: Write + Send + 'a>(self, out: W) -> Result<Box<dyn RowSink + 'a>, TableError> {
        Ok(match self {
            Self::Csv => Box::new(csv::Sink::new(out)),
            Self::Jsonl => Box::new(json_lines::Sink::new(out)),
            #[cfg(feature = "parquet")]
            Self::Parquet => Box::new(parquet::Sink::new(out)?),
            #[cfg(not(feature = "parquet"))]
            Self::Parquet => return Err(TableError::NoParquet),
        })
    }

    /// The rows of a file.
    pub fn rows(self, path: &Path) -> Result<Rows, TableError> {
        let file = File::open(path)?;
        Ok(match self {
            Self::Csv => Box::new(csv::rows(BufReader::new(file))),
            Self::Jsonl => Box::new(json_lines::rows(BufReader::new(file))),
            #[cfg(feature = "parquet")]
            Self::Parquet => Box::new(parquet::rows(file)?),
            #[cfg(not(feature = "parquet"))]
            Self::Parquet => return Err(TableError::NoParquet),
        })
    }
}

#[cfg(test)]
mod tests {
    use bifdiag_schema::RowDocument;
    use bifdiag_survey::scan::ScanRow;

    use super::*;

    #[test]
    fn rows_come_back_from_every_format_as_they_went() {
        let directory = tempfile::tempdir().unwrap();
        let bodies = [
            [[2.0, 1.1, 1.0], [0.94868, 0.0, 0.61623]],
            [[2.0, -1.0, 1.0 / 3.0], [1e-300, 0.0, 6e150]],
            [[2.0, 1.5, 1.0], [0.0; 3]],
        ];
        let row = |(n, values)| bifdiag_documents::scan::row(&ScanRow::of(n, values, bifdiag_exact::Accuracy::Exact));
        let mut rows: Vec<RowDocument> = (0..).zip(bodies).map(row).collect();
        rows[1].error = Some("a \"text\", with commas;\nand a line".to_owned());
        for format in [Format::Csv, Format::Jsonl, Format::Parquet] {
            let path = directory.path().join(format.name());
            if !format.is_available() {
                assert!(format.sink(Vec::new()).is_err());
                continue;
            }
            let bytes = || {
                let mut out = Vec::new();
                let mut sink = format.sink(&mut out).unwrap();
                for row in &rows {
                    sink.write(row).unwrap();
                }
                sink.finish().unwrap();
                drop(sink);
                out
            };
            let first = bytes();
            assert_eq!(first, bytes(), "{format:?}");
            std::fs::write(&path, first).unwrap();
            let read: Vec<RowDocument> = format.rows(&path).unwrap().map(Result::unwrap).collect();
            assert_eq!(read, rows, "{format:?}");
        }
    }
}
