//! Numbers exact and enclosed, and the roots of polynomials.

pub(crate) mod ball;
pub(crate) mod bounds;
pub(crate) mod fixed;
pub(crate) mod interval;
pub(crate) mod isolation;
pub(crate) mod jet;
pub(crate) mod number;
pub(crate) mod polynomial;
mod words;
