//! What connects a result with a format.

use super::error::ExportError;

/// A format of files that knows how to write results of type `R`.
pub trait Exporter<R: ?Sized> {
    /// What the names of its files end with.
    fn ending(&self) -> &'static str;

    /// The bytes of a file with this result.
    ///
    /// # Errors
    /// When the format cannot hold the result.
    fn bytes(&self, result: &R) -> Result<Vec<u8>, ExportError>;
}
