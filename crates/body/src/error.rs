//! Why numbers are not a body.

use bifdiag_numbers::ParseNumberError;
use thiserror::Error;

/// Why three moments and a centre of mass are not a body.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum BodyError {
    /// A moment of inertia is zero or negative.
    #[error("A{axis} = {value} is not positive; a moment of inertia must be greater than zero")]
    MomentNotPositive {
        /// 1, 2 or 3.
        axis: usize,
        /// The moment as given.
        value: String,
    },
    /// Not three moments.
    #[error("A needs three moments of inertia, {count} given")]
    MomentCount {
        /// How many were given.
        count: usize,
    },
    /// Not three coordinates.
    #[error("r needs three coordinates, {count} given")]
    CenterCount {
        /// How many were given.
        count: usize,
    },
    /// A component is not a number.
    #[error("{name}{axis}: {source}")]
    Component {
        /// `A` or `r`.
        name: &'static str,
        /// 1, 2 or 3.
        axis: usize,
        /// What is wrong with it.
        source: ParseNumberError,
    },
}
