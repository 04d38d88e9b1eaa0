//! Columns of numbers.

use serde::Serialize;

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
    /// Number of rows.
    pub fn len(&self) -> usize {
        match self {
            Self::Int8(values) => values.len(),
            Self::Int32(values) => values.len(),
            Self::Float(values) => values.len(),
            Self::Vector(values) => values.len(),
            Self::Quaternion(values) => values.len(),
        }
    }

    /// Numbers in a row; 1 for scalars.
    pub fn width(&self) -> usize {
        match self {
            Self::Int8(_) | Self::Int32(_) | Self::Float(_) => 1,
            Self::Vector(_) => 3,
            Self::Quaternion(_) => 4,
        }
    }

    /// The text of entry `k` of a row.
    pub fn text(&self, row: usize, k: usize) -> String {
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
pub struct Columns {
    pub columns: Vec<Column>,
    /// The parameters, as JSON on one line.
    pub meta: String,
}

impl Columns {
    /// Of names and values, and the document that tells what they mean.
    ///
    /// # Errors
    /// When the document cannot be written as JSON.
    pub fn new(
        columns: impl IntoIterator<Item = (&'static str, Values)>,
        document: &impl Serialize,
    ) -> Result<Self, serde_json::Error> {
        let columns = columns.into_iter().map(|(name, values)| Column { name, values }).collect();
        Ok(Self { columns, meta: serde_json::to_string(document)? })
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.columns.first().map_or(0, |column| column.values.len())
    }
}
