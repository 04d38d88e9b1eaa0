//! A body as a tensor: not reduced, not rounded.
//!
//! Everything about relative equilibria depends on D(μ) = det(μ − A), N(μ) = rᵀ adj(μ − A) r and J_r = rᵀAr/|r|², which
//! are rational in the entries of a tilted tensor. Symmetry is a gcd (D with D′, N with D), J_r and |r|² are exact. The
//! principal form, in which the rest of the program computes, is exact where it is rational; else its numbers are
//! decimals that keep every symmetry exactly and everything else to [`Tensor::DIGITS`] digits.

use dashu_ratio::RBig;
use thiserror::Error;

use super::error::BodyError;
use bifdiag_numbers::ParseNumberError;
use bifdiag_numbers::symmetric::{Symmetric, dot};

/// The tensor of inertia about the fixed point and r = m g c, in the same axes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Tensor {
    matrix: Symmetric,
    center: [RBig; 3],
}

/// Why a tensor makes no body.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum TensorError {
    /// A leading minor of the tensor is zero or negative.
    #[error(
        "the inertia tensor about the fixed point is not positive definite (its leading {order}x{order} minor is \
         {minor}); no body turns about a fixed point with such a tensor"
    )]
    NotPositiveDefinite {
        /// 1, 2 or 3.
        order: usize,
        /// The minor, rounded.
        minor: String,
    },
    /// A moment or a component of r in principal axes left the range of magnitudes.
    #[error("in principal axes {name}{axis} leaves the supported range: {source}")]
    OutOfRange {
        /// `A` or `r`.
        name: &'static str,
        /// 1, 2 or 3.
        axis: usize,
        /// What is wrong with it.
        source: ParseNumberError,
    },
    /// No body.
    #[error(transparent)]
    Body(#[from] BodyError),
}

impl Tensor {
    /// Digits that a rounded principal form keeps: of each moment, of each difference of two moments and of each
    /// component of r. That is finer than 400 bits (120 digits), the last rung of the proofs for a rounded body, so that
    /// what is decided there is farther off than the rounding.
    pub const DIGITS: usize = 130;

    /// A tensor about the fixed point with r = m g c.
    ///
    /// # Errors
    /// [`TensorError::NotPositiveDefinite`], decided exactly.
    pub fn new(matrix: Symmetric, center: [RBig; 3]) -> Result<Self, TensorError> {
        let minors = matrix.leading_minors();
        match minors.iter().position(|minor| *minor <= RBig::ZERO) {
            None => Ok(Self { matrix, center }),
            Some(at) => {
                let minor = format!("{:e}", minors[at].to_f64().value());
                Err(TensorError::NotPositiveDefinite { order: at + 1, minor })
            }
        }
    }

    /// The matrix.
    #[must_use]
    pub fn matrix(&self) -> &Symmetric {
        &self.matrix
    }

    /// r.
    #[must_use]
    pub fn center(&self) -> &[RBig; 3] {
        &self.center
    }

    /// |r|².
    #[must_use]
    pub fn center_squared(&self) -> RBig {
        dot(&self.center, &self.center)
    }

    /// rᵀAr = |r|² J_r.
    #[must_use]
    pub fn weighted_moment(&self) -> RBig {
        dot(&self.center, &self.matrix.times(&self.center))
    }

    /// Whether the body is unphysical, and whether it is a plate. Some distribution of mass has the tensor and r if and only if
    /// the second moments ∫ x xᵀ dm = (tr A / 2) E − A are positive semidefinite and r lies in their range: a plate where
    /// they are singular. As A is positive, their rank is 2 at least, and the adjugate projects onto their kernel.
    #[must_use]
    pub(super) fn existence(&self) -> [bool; 2] {
        let second = self.matrix.subtracted_from(&(self.matrix.trace() / RBig::from(2)));
        let is_flat = second.determinant().is_zero();
        let in_range = || second.adjugate().times(&self.center).iter().all(RBig::is_zero);
        let exists = second.is_positive_semidefinite() && (!is_flat || in_range());
        [!exists, exists && is_flat]
    }
}
