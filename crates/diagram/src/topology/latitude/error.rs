//! What the sweep refuses.
//!
//! A bound on the work of one answer.

use thiserror::Error;

/// What the sweep could not resolve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Obstacle {
    /// A pole lies on ∂U_hl within rounding: the point is on a pole line.
    Pole,
    /// ∂U_hl is singular within rounding, or nearly so at too many places for the allowed effort:
    /// the point is close to a critical curve.
    Singularity,
}

/// Why the sweep has no answer.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum SweepError {
    /// h or l is not a finite number.
    #[error("h = {h} and l = {l} must be finite")]
    NotFinite {
        /// h as given.
        h: f64,
        /// l as given.
        l: f64,
    },
    /// c is not in [−1, 1].
    #[error("the cosine c = {cosine} of a latitude must lie between -1 and 1")]
    NoLatitude {
        /// c as given.
        cosine: f64,
    },
    /// The arcs could not be separated near the latitude c.
    #[error("the boundary of U_hl cannot be resolved near c = {cosine} ({obstacle:?}, after {effort} evaluations)")]
    Undecided {
        /// ⟨γ,r̂⟩ where the sweep stopped.
        cosine: f64,
        /// What is there.
        obstacle: Obstacle,
        /// How many boxes were examined.
        effort: u32,
    },
    /// Two counts of the Euler characteristic disagree: a defect of this program.
    #[error("Euler characteristic {cells} by cells but {components} by components")]
    Inconsistent {
        /// Sum over slabs and circles.
        cells: i64,
        /// Sum of 2 − k over the components.
        components: i64,
    },
}

pub(super) fn check_finite(h: f64, l: f64) -> Result<(), SweepError> {
    if h.is_finite() && l.is_finite() { Ok(()) } else { Err(SweepError::NotFinite { h, l }) }
}

/// Boxes that may still be examined.
#[derive(Clone, Copy, Debug)]
pub(super) struct Effort {
    left: u32,
}

impl Effort {
    const LIMIT: u32 = 200_000;

    pub fn new() -> Self {
        Self { left: Self::LIMIT }
    }

    pub fn spend(&mut self) -> Option<()> {
        self.left = self.left.checked_sub(1)?;
        Some(())
    }

    pub fn spent(self) -> u32 {
        Self::LIMIT - self.left
    }
}
