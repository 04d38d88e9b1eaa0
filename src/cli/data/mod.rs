//! Columns of numbers, and the formats in which they are written.

mod csv;
mod jsonl;
mod npz;

use std::path::{Path, PathBuf};

use clap::ValueEnum;
use thiserror::Error;

/// A named column of a table; all columns of a table have as many rows.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    pub name: &'static str,
    pub values: Values,
}

/// The numbers of a column.
#[derive(Clone, Debug, PartialEq)]
pub enum Values {
    /// Signs.
    Int8(Vec<i8>),
    /// Counts and numbers of things.
    Int32(Vec<i32>),
    /// Measures.
    Float(Vec<f64>),
    /// Vectors of ℝ³.
    Vector(Vec<[f64; 3]>),
    /// Quaternions.
    Quaternion(Vec<[f64; 4]>),
}

impl Values {
    fn len(&self) -> usize {
        match self {
            Self::Int8(values) => values.len(),
            Self::Int32(values) => values.len(),
            Self::Float(values) => values.len(),
            Self::Vector(values) => values.len(),
            Self::Quaternion(values) => values.len(),
        }
    }

    /// Numbers in a row; 1 for scalars.
    fn width(&self) -> usize {
        match self {
            Self::Int8(_) | Self::Int32(_) | Self::Float(_) => 1,
            Self::Vector(_) => 3,
            Self::Quaternion(_) => 4,
        }
    }

    /// The text of entry `k` of a row.
    fn text(&self, row: usize, k: usize) -> String {
        match self {
            Self::Int8(values) => values[row].to_string(),
            Self::Int32(values) => values[row].to_string(),
            Self::Float(values) => float(values[row]),
            Self::Vector(values) => float(values[row][k]),
            Self::Quaternion(values) => float(values[row][k]),
        }
    }
}

/// The shortest text that reads back as the same double.
fn float(x: f64) -> String {
    format!("{x:?}")
}

/// Columns with what they mean.
#[derive(Clone, Debug, PartialEq)]
pub struct DataTable {
    pub columns: Vec<Column>,
    /// The parameters, as JSON on one line.
    pub meta: String,
}

impl DataTable {
    fn rows(&self) -> usize {
        self.columns.first().map_or(0, |column| column.values.len())
    }

    /// The bytes of a file.
    pub fn bytes(&self, format: DataFormat) -> Result<Vec<u8>, zip::result::ZipError> {
        Ok(match format {
            DataFormat::Csv => csv::text(self).into_bytes(),
            DataFormat::Jsonl => jsonl::text(self).into_bytes(),
            DataFormat::Npz => npz::archive(self)?,
        })
    }
}

/// Formats of data files.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum DataFormat {
    /// NumPy's archive of arrays
    Npz,
    /// Comma-separated values
    Csv,
    /// One JSON object a line
    Jsonl,
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
#[error("the extension tells the format: give FILE.npz, FILE.csv or FILE.jsonl, or - for CSV on stdout")]
pub struct UnknownFormat;

impl DataTarget {
    /// Of the text of an option.
    pub fn parse(text: &str) -> Result<Self, UnknownFormat> {
        if text == "-" {
            return Ok(Self::Stdout);
        }
        let path = Path::new(text);
        let extension = path.extension().and_then(|extension| extension.to_str()).ok_or(UnknownFormat)?;
        let format = match extension {
            "npz" => DataFormat::Npz,
            "csv" => DataFormat::Csv,
            "jsonl" => DataFormat::Jsonl,
            _ => return Err(UnknownFormat),
        };
        Ok(Self::File { path: path.to_owned(), format })
    }
}
