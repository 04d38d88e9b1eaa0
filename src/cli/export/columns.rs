//! Tables: columns of numbers, in memory or piece by piece.

use std::io;
use std::ops::Range;

use serde::Serialize;
use serde_json::Value;

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
    /// Words: the places of each row's in a list of words, as integers. Tables of text say the words.
    Words { words: Vec<Value>, places: Box<Self> },
    /// Measures, or the parts of vectors: a row for each list of parts.
    Float { parts: &'static [&'static str], values: Vec<f64> },
}

impl Values {
    /// Measures.
    pub fn floats(values: impl Iterator<Item = f64>) -> Self {
        Self::of_parts(&[""], values)
    }

    /// Vectors of ℝ³.
    pub fn vectors(values: impl Iterator<Item = [f64; 3]>) -> Self {
        Self::of_parts(&["1", "2", "3"], values.flatten())
    }

    /// Quaternions w + x i + y j + z k.
    pub fn quaternions(values: impl Iterator<Item = [f64; 4]>) -> Self {
        Self::of_parts(&["_w", "_x", "_y", "_z"], values.flatten())
    }

    /// Rows of as many numbers as there are parts. Zero has no sign.
    pub fn of_parts(parts: &'static [&'static str], values: impl Iterator<Item = f64>) -> Self {
        Self::Float { parts, values: values.map(|x| x + 0.0).collect() }
    }

    /// Words, as they are in JSON, and the place of each row's among them.
    ///
    /// # Errors
    /// When a word cannot be written as JSON.
    pub fn words(words: &impl Serialize, places: Self) -> Result<Self, serde_json::Error> {
        let words = match serde_json::to_value(words)? {
            Value::Array(words) => words,
            word => vec![word],
        };
        Ok(Self::Words { words, places: Box::new(places) })
    }

    /// What is added to the column's name for each number in a row.
    pub fn parts(&self) -> &'static [&'static str] {
        match self {
            Self::Int8(_) | Self::Int32(_) | Self::Words { .. } => &[""],
            Self::Float { parts, .. } => parts,
        }
    }

    /// Number of rows.
    pub fn len(&self) -> usize {
        match self {
            Self::Int8(values) => values.len(),
            Self::Int32(values) => values.len(),
            Self::Words { places, .. } => places.len(),
            Self::Float { parts, values } => values.len() / parts.len(),
        }
    }

    /// The column itself; of words their places.
    pub fn numbers(&self) -> &Self {
        match self {
            Self::Words { places, .. } => places.numbers(),
            _ => self,
        }
    }

    /// Bytes of a row.
    pub fn row_bytes(&self) -> usize {
        match self {
            Self::Words { places, .. } => places.row_bytes(),
            Self::Int8(_) => 1,
            Self::Int32(_) => 4,
            Self::Float { parts, .. } => 8 * parts.len(),
        }
    }

    /// The numbers in little-endian bytes.
    pub fn bytes(&self) -> Vec<u8> {
        let mut bytes = Vec::with_capacity(self.len() * self.row_bytes());
        match self {
            Self::Words { places, .. } => return places.bytes(),
            Self::Int8(values) => bytes.extend(values.iter().map(|x| x.cast_unsigned())),
            Self::Int32(values) => values.iter().for_each(|x| bytes.extend_from_slice(&x.to_le_bytes())),
            Self::Float { values, .. } => values.iter().for_each(|x| bytes.extend_from_slice(&x.to_le_bytes())),
        }
        bytes
    }

    /// Adds the numbers of [`bytes`](Self::bytes).
    pub fn extend_from_bytes(&mut self, bytes: &[u8]) {
        match self {
            Self::Words { places, .. } => places.extend_from_bytes(bytes),
            Self::Int8(values) => values.extend(bytes.iter().map(|x| x.cast_signed())),
            Self::Int32(values) => values.extend(bytes.as_chunks().0.iter().map(|x| i32::from_le_bytes(*x))),
            Self::Float { values, .. } => values.extend(bytes.as_chunks().0.iter().map(|x| f64::from_le_bytes(*x))),
        }
    }

    /// Adds some rows of a column of the same kind.
    pub fn extend_from(&mut self, other: &Self, rows: Range<usize>) {
        match (self, other) {
            (Self::Words { places, .. }, Self::Words { places: others, .. }) => places.extend_from(others, rows),
            (Self::Int8(values), Self::Int8(others)) => values.extend_from_slice(&others[rows]),
            (Self::Int32(values), Self::Int32(others)) => values.extend_from_slice(&others[rows]),
            (Self::Float { parts, values }, Self::Float { values: others, .. }) => {
                values.extend_from_slice(&others[parts.len() * rows.start..parts.len() * rows.end]);
            }
            _ => unreachable!("a column keeps its kind"),
        }
    }

    /// The same kind of numbers, none of them.
    fn without_rows(&self) -> Self {
        match self {
            Self::Words { words, places } => {
                Self::Words { words: words.clone(), places: Box::new(places.without_rows()) }
            }
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
            Self::Words { words, places } => match places.text(row, k).parse().ok().and_then(|at: usize| words.get(at))
            {
                Some(Value::String(word)) => word.clone(),
                word => word.unwrap_or(&Value::Null).to_string(),
            },
            // The shortest text that reads back as the same double; zero has no sign.
            Self::Float { parts, values } => format!("{:?}", values[row * parts.len() + k] + 0.0),
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
    /// Of names and values, and the document that says what they mean.
    ///
    /// # Errors
    /// When the document cannot be written as JSON.
    pub fn new(
        columns: impl IntoIterator<Item = (&'static str, Values)>,
        document: &impl Serialize,
    ) -> Result<Self, serde_json::Error> {
        let columns = columns.into_iter().map(|(name, values)| Column { name, values }).collect();
        Ok(Self { columns, meta: bifdiag_schema::json(document)? })
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.columns.first().map_or(0, |column| column.values.len())
    }
}

/// A table that may be too long for the memory.
pub trait Pieces {
    /// Its columns, without rows.
    fn columns(&self) -> Vec<Column>;

    /// Number of rows.
    fn rows(&self) -> usize;

    /// The parameters, as JSON on one line.
    fn meta(&self) -> &str;

    /// The little-endian bytes of a column, in their order.
    ///
    /// # Errors
    /// When the table cannot be read, and those of `take`.
    fn column(&mut self, number: usize, take: &mut dyn FnMut(&[u8]) -> io::Result<()>) -> io::Result<()>;

    /// The rows, some at a time, in their order.
    ///
    /// # Errors
    /// As [`column`](Self::column).
    fn pieces(&mut self, take: &mut dyn FnMut(&[Column]) -> io::Result<()>) -> io::Result<()>;
}

impl Pieces for &Columns {
    fn columns(&self) -> Vec<Column> {
        self.columns.iter().map(Column::without_rows).collect()
    }

    fn rows(&self) -> usize {
        Columns::rows(self)
    }

    fn meta(&self) -> &str {
        &self.meta
    }

    fn column(&mut self, number: usize, take: &mut dyn FnMut(&[u8]) -> io::Result<()>) -> io::Result<()> {
        take(&self.columns[number].values.bytes())
    }

    fn pieces(&mut self, take: &mut dyn FnMut(&[Column]) -> io::Result<()>) -> io::Result<()> {
        take(&self.columns)
    }
}
