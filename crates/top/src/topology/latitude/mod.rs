//! Topology of U_hl by a sweep over circles of latitude: no Morse theory, no critical points (Proposition 9.4 of
//! docs/mathematics.md).
//!
//! With r̂ as polar axis and c = ⟨γ,r̂⟩, J is on each circle of latitude a trigonometric polynomial of degree 2, so
//! the circle meets U_hl in at most two arcs, or wholly, or not at all. The sphere is cut along finitely many
//! circles whose arcs are certified; each slab between two of them is tiled by bricks in each of which interval
//! arithmetic proves that G = 2J(h + ⟨γ,r⟩) − l² has no zero, or is monotone along the latitudes, or is monotone
//! along the meridians. Then the way in which the slab connects the arcs is known, and union-find does the rest.
//! Slabs are thinned until this succeeds, which it does unless ∂U_hl is singular or passes through a pole: only
//! near those curves of the bifurcation diagram the answer is [`SweepError::Undecided`]. Special bodies need no
//! special treatment. Inputs count as known to one unit in the last place; an answer is proved for all of that range.

mod angle;
mod arcs;
mod circle;
mod level;
mod slab;
mod sweep;
mod union;

pub use arcs::{Arc, Arcs, Latitudes};

use thiserror::Error;

use super::component::{Component, Poles};
use crate::body::Frame;
use level::Level;

/// What the sweep could not resolve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Obstacle {
    /// A pole lies on ∂U_hl within rounding: the point is on a pole line.
    Pole,
    /// ∂U_hl is singular within rounding, or nearly so at so many places that the effort allowed was not enough:
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
    /// The arcs could not be told apart near the latitude c.
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

/// Boxes that may still be examined.
#[derive(Clone, Copy, Debug)]
struct Effort {
    left: u32,
}

impl Effort {
    const LIMIT: u32 = 200_000;

    fn new() -> Self {
        Self { left: Self::LIMIT }
    }

    fn spend(&mut self) -> Option<()> {
        self.left = self.left.checked_sub(1)?;
        Some(())
    }

    fn spent(self) -> u32 {
        Self::LIMIT - self.left
    }
}

/// The connected components of U_hl = {γ ∈ S² : U_l(γ) ≤ h} in canonical order; none when U_hl is empty.
///
/// h and l are in the frame's units (l' and h' of [`Frame`]). For r = 0 there are no poles: `poles` is `None`.
///
/// # Errors
/// [`SweepError::NotFinite`]; [`SweepError::Undecided`] near the curves of the bifurcation diagram. An answer that
/// is given is right for every body, h and l within one unit in the last place of the given numbers.
pub fn components(frame: &Frame, h: f64, l: f64) -> Result<Vec<Component>, SweepError> {
    check_finite(h, l)?;
    if l == 0.0 {
        return without_momentum(frame, h);
    }
    sweep::components(&Level::new(frame, h, l), frame.is_euler())
}

fn check_finite(h: f64, l: f64) -> Result<(), SweepError> {
    if h.is_finite() && l.is_finite() { Ok(()) } else { Err(SweepError::NotFinite { h, l }) }
}

/// l = 0: U = −⟨γ,r⟩ and U_hl is empty, a disc about r̂, or the sphere.
fn without_momentum(frame: &Frame, h: f64) -> Result<Vec<Component>, SweepError> {
    let tolerance = 4.0 * f64::EPSILON * frame.r_norm;
    for pole in [1.0, -1.0] {
        if (h + pole * frame.r_norm).abs() <= tolerance {
            return Err(SweepError::Undecided { cosine: pole, obstacle: Obstacle::Pole, effort: 0 });
        }
    }
    let plus = h > -frame.r_norm;
    let minus = h > frame.r_norm;
    if !plus {
        return Ok(Vec::new());
    }
    let poles = (!frame.is_euler()).then_some(Poles { plus, minus });
    Ok(vec![Component { boundary_circles: u32::from(!minus), poles }])
}
