//! Where to start, how to go on, when to stop.

use crate::body::{Axis, Frame};
use crate::stability::RelativeEquilibrium;

/// Which way to leave the start. At a cusp both ways fall or both rise, and either may be taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// Towards larger l.
    Rising,
    /// Towards smaller l.
    Falling,
}

/// What to do at a cusp or pitchfork. It becomes a vertex in either case.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AtEvent {
    /// Go on along the same branch.
    Pass,
    /// End there.
    Stop,
}

/// A point of a branch, and which branch if two meet there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Start {
    pub(super) equilibrium: RelativeEquilibrium,
    pub(super) pair_axis: Option<Axis>,
}

impl Start {
    /// A start on the branch through `equilibrium`: the pair over μ = A_i if r_i = 0 and γ_i ≠ 0, else the branch with
    /// γ_i = 0 wherever r_i = 0.
    #[must_use]
    pub fn on(frame: &Frame, equilibrium: RelativeEquilibrium) -> Self {
        let pair_axis = Axis::ALL.into_iter().find(|&i| frame.r[i] == 0.0 && equilibrium.gamma[i] != 0.0);
        Self { equilibrium, pair_axis }
    }

    /// A start at a pitchfork (γ_i = 0 and B_i = 0 for `axis` i) on the pair that leaves it; of the two mirror images
    /// the one with γ_i > 0 is tracked.
    #[must_use]
    pub fn leaving_pitchfork(equilibrium: RelativeEquilibrium, axis: Axis) -> Self {
        Self { equilibrium, pair_axis: Some(axis) }
    }
}

/// Options of [`track`](super::track). Lengths are in the units of the frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TrackOptions {
    /// Stop at this l (≥ 0).
    pub l_min: f64,
    /// Stop at this l.
    pub l_max: f64,
    /// Stop at the first vertex with larger h.
    pub h_max: f64,
    /// Largest distance between the curve and its polyline in the plane (h/`h_scale`, l/`l_scale`).
    pub chord_tolerance: f64,
    /// Height of the picture.
    pub h_scale: f64,
    /// Width of the picture.
    pub l_scale: f64,
    /// Largest step in the measure of the tracker (relative changes of Ω and of the gaps, change of γ).
    pub max_step: f64,
    /// Give up after so many steps, accepted or not.
    pub max_steps: usize,
    /// What to do at a cusp.
    pub at_cusp: AtEvent,
    /// What to do at a pitchfork.
    pub at_pitchfork: AtEvent,
}

impl Default for TrackOptions {
    fn default() -> Self {
        Self {
            l_min: 0.0,
            l_max: f64::INFINITY,
            h_max: f64::INFINITY,
            chord_tolerance: 1e-3,
            h_scale: 1.0,
            l_scale: 1.0,
            max_step: 0.5,
            max_steps: 100_000,
            at_cusp: AtEvent::Pass,
            at_pitchfork: AtEvent::Pass,
        }
    }
}
