//! Exact numbers, intervals, polynomials and their roots, low-discrepancy sequences; knows nothing of rigid bodies.

pub mod bernstein;
pub mod decimal;
pub mod directed;
pub mod enclosure;
mod fixed_float;
pub mod form;
pub mod interval;
mod number;
pub mod polynomial;
pub mod power;
pub mod root;
pub mod sequence;
mod sign;
pub mod symmetric;
pub mod table;
pub mod vector;
pub mod wide;

pub use number::{Number, ParseNumberError};
pub use sign::Sign;

/// Unit roundoff of `f64`: half the distance from 1 to the next double.
pub const UNIT_ROUNDOFF: f64 = f64::EPSILON / 2.0;
