//! Topology of U_hl by a sweep over circles of latitude: no Morse theory, no critical points (Proposition 9.4 of
//! docs/algorithms.md).
//!
//! With r̂ as polar axis and c = ⟨γ,r̂⟩, J is on each circle of latitude a trigonometric polynomial of degree 2, so
//! the circle meets U_hl in at most two arcs, or wholly, or not at all. The sphere is cut along finitely many
//! circles whose arcs are certified; each slab between two of them is tiled by bricks in which interval
//! arithmetic proves that G = 2J(h + ⟨γ,r⟩) − l² has no zero, or is monotone along the latitudes, or is monotone
//! along the meridians. Then the way in which the slab connects the arcs is known, and union-find does the rest.
//! Slabs are thinned until this succeeds, which it does unless ∂U_hl is singular or passes through a pole: only
//! near those curves of the bifurcation diagram the answer is [`SweepError::Undecided`]. Special bodies need no
//! special treatment. Inputs count as known to one unit in the last place; an answer is proved for all of that range.

mod angle;
mod arcs;
mod circle;
mod error;
mod level;
mod slab;
mod sweep;

pub use arcs::{Arc, Arcs, Latitudes};
pub use error::{Obstacle, SweepError};

use super::component::{Component, Poles};
use bifdiag_body::Frame;
use error::check_finite;
use level::Level;

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
