//! Polynomials with integer coefficients and exact isolation of their real roots.
//!
//! No crate of pure Rust isolates roots of integer polynomials with certainty; the tests compare with python-flint.

mod division;
mod integer;
mod isolation;
pub mod rational;
mod root;

pub use integer::Polynomial;
pub use root::Root;
