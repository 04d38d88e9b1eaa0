//! Symmetric 3×3 matrices over the rationals, their eigenvalues and principal axes.
//!
//! Nothing is rounded before it is asked for: equal eigenvalues are found by a gcd of the characteristic polynomial with
//! its derivative, a component of a vector along an axis that vanishes by a gcd with rᵀ adj(μ − A) r, and what is
//! irrational is enclosed between rationals as closely as one likes.

mod axes;
mod eigenvalue;
mod matrix;

pub use axes::PrincipalAxes;
pub use eigenvalue::{Eigenvalue, Real};
pub use matrix::{Symmetric, dot};
