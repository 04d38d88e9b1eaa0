//! What can be wrong with the documents of a scan.

use bifdiag_diagram::class::ParseClassNameError;
use bifdiag_diagram::topology::ParseSurfaceError;
use bifdiag_numbers::ParseNumberError;
use bifdiag_survey::{DesignError, ParseComponentTypeError};
use thiserror::Error;

/// Why a document of a scan cannot be read.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum ReadScanError {
    /// A number of a body or of a range.
    #[error(transparent)]
    Number(#[from] ParseNumberError),
    /// Bodies that no scan covers.
    #[error(transparent)]
    Design(#[from] DesignError),
    /// A class.
    #[error(transparent)]
    Class(#[from] ParseClassNameError),
    /// A surface of a signature.
    #[error(transparent)]
    Surface(#[from] ParseSurfaceError),
    /// A type of component.
    #[error(transparent)]
    Component(#[from] ParseComponentTypeError),
    /// Counts that are not written like `S2:2 S2+T2:1`.
    #[error("`{0}` is not a name with its count, such as S2+T2:1")]
    Count(String),
    /// A row with only some of the numbers of a diagram.
    #[error("row {index} has no {column}, but other numbers of a diagram")]
    Missing {
        /// Number of the body.
        index: u64,
        /// What is missing.
        column: &'static str,
    },
}
