//! Tables that come piece by piece, however long they are.

use std::io;

use super::columns::{Column, Columns};

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
