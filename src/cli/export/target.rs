//! Where results go.

use std::io::{Cursor, Seek, Write};
use std::path::{Path, PathBuf};

use clap::ValueEnum;
use serde::Serialize;

use super::columns::{Columns, Pieces};
#[cfg(feature = "parquet")]
use super::parquet;
use super::{npz, text};
use crate::cli::failure::Failure;
use crate::cli::terminal::print;

/// Where the files go if nothing else is said.
const DEFAULT_DIRECTORY: &str = "bifdiag-out";

/// The directory of `--out`, if files are wanted at all; without that option, the usual one if `wanted` is set.
pub fn directory(out: Option<&Path>, wanted: bool) -> Result<Option<PathBuf>, Failure> {
    match out {
        Some(directory) if directory == Path::new("-") => {
            Err(Failure::input("--out -: a directory is needed, such as --out pictures"))
        }
        Some(directory) => Ok(Some(directory.to_owned())),
        None => Ok(wanted.then(|| PathBuf::from(DEFAULT_DIRECTORY))),
    }
}

/// Formats of data files.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum DataFormat {
    /// NumPy's archive of arrays
    Npz,
    /// Apache Parquet
    #[cfg(feature = "parquet")]
    Parquet,
    /// Comma-separated values
    Csv,
    /// One JSON object a line
    Jsonl,
}

impl DataFormat {
    /// What the names of its files end with.
    pub fn ending(self) -> &'static str {
        match self {
            Self::Npz => "npz",
            #[cfg(feature = "parquet")]
            Self::Parquet => "parquet",
            Self::Csv => "csv",
            Self::Jsonl => "jsonl",
        }
    }

    /// A table in this format.
    pub fn bytes(self, columns: &Columns) -> Result<Vec<u8>, Failure> {
        let mut out = Cursor::new(Vec::new());
        self.write(&mut &*columns, &mut out)?;
        Ok(out.into_inner())
    }

    /// Writes a table, however long.
    pub fn write(self, table: &mut impl Pieces, out: impl Write + Seek + Send) -> Result<(), Failure> {
        match self {
            Self::Npz => npz::write(table, out),
            #[cfg(feature = "parquet")]
            Self::Parquet => parquet::write(table, out),
            Self::Csv => text::csv(table, out),
            Self::Jsonl => text::json_lines(table, out),
        }
    }
}

/// Where data go.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum DataTarget {
    /// CSV on stdout.
    Stdout,
    /// A file, in the format of its extension.
    File { path: PathBuf, format: DataFormat },
}

impl DataTarget {
    /// Parses the option.
    pub fn parse(text: &str) -> Result<Self, Failure> {
        if text == "-" {
            return Ok(Self::Stdout);
        }
        let path = Path::new(text);
        let extension = path.extension().and_then(|extension| extension.to_str());
        let unknown = match extension {
            Some("parquet") => {
                "this bifdiag was built without the feature `parquet`; give FILE.npz, FILE.csv or FILE.jsonl"
            }
            _ => {
                "the extension selects the format: give FILE.npz, FILE.csv, FILE.jsonl or FILE.parquet, or - for CSV \
                on stdout"
            }
        };
        let mut formats = DataFormat::value_variants().iter();
        let format =
            formats.find(|format| Some(format.ending()) == extension).ok_or_else(|| Failure::input(unknown))?;
        Ok(Self::File { path: path.to_owned(), format: *format })
    }
}

/// Prints a document as JSON or, unless `json` is set, as a text for people.
pub fn answer(json: bool, document: &impl Serialize, text: impl FnOnce() -> String) -> Result<(), Failure> {
    print(if json { bifdiag_documents::layout::text(document)? } else { text() })
}
