//! Files with one row for each body: CSV, JSON Lines and, with the feature `parquet`, Parquet.

use std::fs::File;
use std::io::{BufRead, BufReader, Write};
use std::path::Path;

use bifdiag_schema::RowDocument;
use clap::ValueEnum;

#[cfg(feature = "parquet")]
use super::parquet;
use crate::cli::failure::{Failure, failed};

/// Formats of the rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// Apache Parquet, for pandas, Polars, DuckDB, Spark
    Parquet,
    /// Comma-separated values with a header
    Csv,
    /// One JSON object per line
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
    pub fn sink<W: Write + Send>(self, out: W) -> Result<Sink<W>, Failure> {
        Ok(match self {
            Self::Csv => Sink::Csv(csv::Writer::from_writer(out)),
            Self::Jsonl => Sink::Jsonl(out),
            #[cfg(feature = "parquet")]
            Self::Parquet => Sink::Parquet(parquet::Groups::new(out)?),
            #[cfg(not(feature = "parquet"))]
            Self::Parquet => return Err(no_parquet()),
        })
    }

    /// The rows of a file.
    pub fn rows(self, path: &Path) -> Result<Rows, Failure> {
        let file = File::open(path).map_err(Failure::input)?;
        Ok(match self {
            Self::Csv => {
                let rows = csv::Reader::from_reader(BufReader::new(file)).into_deserialize();
                let row = |row: Result<RowDocument, csv::Error>| {
                    row.map_err(|error| {
                        Failure::input(format!("this is not a CSV file of a scan: {error}")).because(error)
                    })
                };
                Box::new(rows.map(row))
            }
            Self::Jsonl => Box::new(BufReader::new(file).lines().zip(1_u64..).map(|(line, number)| {
                let line = line.map_err(Failure::input)?;
                serde_json::from_str(&line)
                    .map_err(|error| Failure::input(format!("line {number} is not a row of a scan: {error}")))
            })),
            #[cfg(feature = "parquet")]
            Self::Parquet => Box::new(parquet::rows(file)?),
            #[cfg(not(feature = "parquet"))]
            Self::Parquet => return Err(no_parquet()),
        })
    }
}

/// The rows of a file, one by one.
pub type Rows = Box<dyn Iterator<Item = Result<RowDocument, Failure>>>;

/// Takes the rows one by one.
pub enum Sink<W: Write + Send> {
    Csv(csv::Writer<W>),
    Jsonl(W),
    #[cfg(feature = "parquet")]
    Parquet(parquet::Groups<W>),
}

impl<W: Write + Send> Sink<W> {
    /// Adds a row.
    pub fn write(&mut self, row: &RowDocument) -> Result<(), Failure> {
        match self {
            Self::Csv(writer) => Ok(writer.serialize(row)?),
            Self::Jsonl(out) => {
                let mut line = bifdiag_schema::json(row)?.into_bytes();
                line.push(b'\n');
                out.write_all(&line).map_err(failed("a row could not be written"))
            }
            #[cfg(feature = "parquet")]
            Self::Parquet(groups) => groups.write(row),
        }
    }

    /// Writes what is still held back, and gives the writer below.
    pub fn finish(self) -> Result<W, Failure> {
        match self {
            Self::Csv(writer) => writer
                .into_inner()
                .map_err(|error| Failure::work("the rows could not be written").because(error.into_error())),
            Self::Jsonl(out) => Ok(out),
            #[cfg(feature = "parquet")]
            Self::Parquet(groups) => groups.finish(),
        }
    }
}

#[cfg(not(feature = "parquet"))]
fn no_parquet() -> Failure {
    Failure::input(
        "this bifdiag was built without the feature `parquet`; use .csv or .jsonl, or build it with --features parquet",
    )
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
                let mut sink = format.sink(Vec::new()).unwrap();
                for row in &rows {
                    sink.write(row).unwrap();
                }
                sink.finish().unwrap()
            };
            let first = bytes();
            assert_eq!(first, bytes(), "{format:?}");
            std::fs::write(&path, first).unwrap();
            let read: Vec<RowDocument> = format.rows(&path).unwrap().map(Result::unwrap).collect();
            assert_eq!(read, rows, "{format:?}");
        }
    }
}
