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
    /// Measures, or the parts of vectors: a row for each list of parts.
    Float { parts: &'static [&'static str], values: Vec<f64> },
}

impl Values {
    /// Measures.
    pub fn floats(values: impl Iterator<Item = f64>) -> Self {
        Self::Float { parts: &[""], values: values.collect() }
    }

    /// Vectors of ℝ³.
    pub fn vectors(values: impl Iterator<Item = [f64; 3]>) -> Self {
        Self::Float { parts: &["1", "2", "3"], values: values.flatten().collect() }
    }

    /// Quaternions w + x i + y j + z k.
    pub fn quaternions(values: impl Iterator<Item = [f64; 4]>) -> Self {
        Self::Float { parts: &["_w", "_x", "_y", "_z"], values: values.flatten().collect() }
    }

    /// What is added to the column's name for each number in a row.
    pub fn parts(&self) -> &'static [&'static str] {
        match self {
            Self::Int8(_) | Self::Int32(_) => &[""],
            Self::Float { parts, .. } => parts,
        }
    }

    /// Number of rows.
    pub fn len(&self) -> usize {
        match self {
            Self::Int8(values) => values.len(),
            Self::Int32(values) => values.len(),
            Self::Float { parts, values } => values.len() / parts.len(),
        }
    }

    /// Bytes of a row.
    pub fn row_bytes(&self) -> usize {
        match self {
            Self::Int8(_) => 1,
            Self::Int32(_) => 4,
            Self::Float { parts, .. } => 8 * parts.len(),
        }
    }

    /// The numbers in little-endian bytes.
    pub fn bytes(&self) -> Vec<u8> {
        let mut bytes = Vec::with_capacity(self.len() * self.row_bytes());
        match self {
            Self::Int8(values) => bytes.extend(values.iter().map(|x| x.cast_unsigned())),
            Self::Int32(values) => values.iter().for_each(|x| bytes.extend_from_slice(&x.to_le_bytes())),
            Self::Float { values, .. } => values.iter().for_each(|x| bytes.extend_from_slice(&x.to_le_bytes())),
        }
        bytes
    }

    /// Adds the numbers of [`bytes`](Self::bytes).
    pub fn extend_from_bytes(&mut self, bytes: &[u8]) {
        match self {
            Self::Int8(values) => values.extend(bytes.iter().map(|x| x.cast_signed())),
            Self::Int32(values) => values.extend(bytes.as_chunks().0.iter().map(|x| i32::from_le_bytes(*x))),
            Self::Float { values, .. } => values.extend(bytes.as_chunks().0.iter().map(|x| f64::from_le_bytes(*x))),
        }
    }

    /// The same kind of numbers, none of them.
    fn without_rows(&self) -> Self {
        match self {
            Self::Int8(_) => Self::Int8(Vec::new()),
            Self::Int32(_) => Self::Int32(Vec::new()),
            Self::Float { parts, .. } => Self::Float { parts, values: Vec::new() },
        }
    }

    /// The text of entry `k` of a row.
    pub fn text(&self, row: usize, k: usize) -> String {
        match self {
            Self::Int8(values) => values[row].to_string(),
            Self::Int32(values) => values[row].to_string(),
            // The shortest text that reads back as the same double.
            Self::Float { parts, values } => format!("{:?}", values[row * parts.len() + k]),
        }
    }
}

impl Column {
    /// Its name and kind.
    pub fn without_rows(&self) -> Self {
        Self { name: self.name, values: self.values.without_rows() }
    }
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
