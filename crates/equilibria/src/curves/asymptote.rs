//! Limits of arcs as l → ∞ (Proposition 6.2 of docs/mathematics.md).

use super::arc::{Arc, Shape};
use bifdiag_body::{Axis, Frame};

/// As x → ∞, h = x/J∞ − ρ∞ + O(1/x).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Asymptote {
    /// J∞ is the moment of this axis of the frame; `None`: J_r, of a pole line off the axes.
    pub axis: Option<Axis>,
    /// ρ∞ = lim ⟨γ, r⟩.
    pub rho: f64,
}

impl Asymptote {
    /// J∞ of `other` less J∞ of `self`, from exact differences rounded once.
    #[must_use]
    pub fn moment_gap(&self, frame: &Frame, other: &Self) -> f64 {
        match (self.axis, other.axis) {
            (Some(i), Some(j)) => frame.diff[j][i],
            (None, Some(j)) => frame.offset[j],
            (Some(i), None) => -frame.offset[i],
            (None, None) => 0.0,
        }
    }
}

impl Arc {
    /// The limit of the curve's last arc. (An arc with a finite end has none: then the answer is that of the axis next
    /// to which it ends.)
    #[must_use]
    pub fn asymptote(&self, frame: &Frame) -> Asymptote {
        match &self.shape {
            Shape::Straight { gamma, .. } => {
                // A component may round to 1 while the others are not zero.
                let axis =
                    Axis::ALL.into_iter().find(|&k| Axis::ALL.into_iter().all(|j| (gamma[j] != 0.0) == (j == k)));
                Asymptote { axis, rho: (0..3).map(|k| gamma[k] * frame.r[k]).sum() }
            }
            Shape::Generic(segments) => {
                let last = segments[segments.len() - 1];
                Asymptote { axis: Some(last.base), rho: last.sign * frame.r[last.base] }
            }
            Shape::Symmetric { family, .. } => Asymptote { axis: Some(family.axis), rho: 0.0 },
        }
    }
}
