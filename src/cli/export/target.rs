//! Where results go.

use std::io::{Cursor, Seek, Write};
use std::path::{Path, PathBuf};

use clap::ValueEnum;
use thiserror::Error;

use super::columns::Columns;
use super::error::ExportError;
use super::exporter::Exporter;
#[cfg(feature = "parquet")]
use super::parquet;
use super::pieces::Pieces;
use super::{csv, jsonl, npz};
use crate::cli::failure::{CommandError, Exit};

/// Where the files go if nothing else is said.
const DEFAULT_DIRECTORY: &str = "bifdiag-out";

/// `-` is no directory.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("--out -: a directory is needed; leave --out away and use --json to write the atlas to stdout")]
pub struct DirectoryInput;

impl CommandError for DirectoryInput {
    fn exit(&self) -> Exit {
        Exit::WrongInput
    }
}

/// The directory of `--out`, if files are wanted at all; without that option, the usual one if `wanted` is set.
pub fn directory(out: Option<&Path>, wanted: bool) -> Result<Option<PathBuf>, DirectoryInput> {
    match out {
        Some(directory) if directory == Path::new("-") => Err(DirectoryInput),
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

impl Exporter<Columns> for DataFormat {
    fn ending(&self) -> &'static str {
        match self {
            Self::Npz => "npz",
            #[cfg(feature = "parquet")]
            Self::Parquet => "parquet",
            Self::Csv => "csv",
            Self::Jsonl => "jsonl",
        }
    }

    fn bytes(&self, columns: &Columns) -> Result<Vec<u8>, ExportError> {
        let mut out = Cursor::new(Vec::new());
        self.write(&mut &*columns, &mut out)?;
        Ok(out.into_inner())
    }
}

impl DataFormat {
    /// Writes a table, however long.
    pub fn write(self, table: &mut impl Pieces, out: impl Write + Seek + Send) -> Result<(), ExportError> {
        match self {
            Self::Npz => npz::write(table, out),
            #[cfg(feature = "parquet")]
            Self::Parquet => parquet::write(table, out),
            Self::Csv => csv::write(table, out),
            Self::Jsonl => jsonl::write(table, out),
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

/// The name of a data file is of no use.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum UnknownFormat {
    #[error(
        "the extension tells the format: give FILE.npz, FILE.csv, FILE.jsonl or FILE.parquet, or - for CSV on stdout"
    )]
    Extension,
    #[error("this bifdiag was built without the feature `parquet`; give FILE.npz, FILE.csv or FILE.jsonl")]
    NoParquet,
}

impl DataTarget {
    /// Of the text of an option.
    pub fn parse(text: &str) -> Result<Self, UnknownFormat> {
        if text == "-" {
            return Ok(Self::Stdout);
        }
        let path = Path::new(text);
        let extension = path.extension().and_then(|extension| extension.to_str());
        let unknown = match extension {
            Some("parquet") => UnknownFormat::NoParquet,
            _ => UnknownFormat::Extension,
        };
        let mut formats = DataFormat::value_variants().iter();
        let format = formats.find(|format| Some(format.ending()) == extension).ok_or(unknown)?;
        Ok(Self::File { path: path.to_owned(), format: *format })
    }
}
