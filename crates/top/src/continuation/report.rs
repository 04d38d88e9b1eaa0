//! What a track brings back.

use thiserror::Error;

use crate::body::Axis;
use crate::stability::RelativeEquilibrium;

/// What is special about a vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum VertexKind {
    /// Nothing.
    Regular,
    /// l and h turn here: dl = dh = 0 along the branch.
    Cusp,
    /// A symmetric pair meets its parent here.
    Pitchfork,
}

/// A vertex of the polyline.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vertex {
    /// Vertical angular momentum.
    pub l: f64,
    /// Energy.
    pub h: f64,
    /// The relative equilibrium.
    pub equilibrium: RelativeEquilibrium,
    /// Morse index of U_l; `None` where the Hessian is singular within rounding.
    pub index: Option<u8>,
    /// Cusp, pitchfork or neither.
    pub kind: VertexKind,
}

/// Why a track stopped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StopReason {
    /// l reached `l_max`.
    MaximumReached,
    /// l reached `l_min` > 0.
    MinimumReached,
    /// l reached 0: the body hangs or stands, γ = ±r̂ or an axis.
    Rest,
    /// A cusp, and the options say to stop there.
    Cusp,
    /// A pitchfork, and the options say to stop there; or a pair has met its parent.
    Pitchfork,
    /// h rose above `h_max`.
    LeftWindow,
    /// The step that Newton's method or the chord tolerance asked for is below rounding.
    StepUnderflow,
    /// `max_steps` were taken.
    StepLimit,
}

/// A pitchfork met on the way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pitchfork {
    /// Its vertex in the report.
    pub vertex: usize,
    /// The axis i with r_i = 0 = B_i: the pair leaves with ±γ_i.
    pub axis: Axis,
}

/// What a track has cost.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Effort {
    /// Steps accepted.
    pub steps: usize,
    /// Steps rejected.
    pub rejected: usize,
    /// Newton iterations.
    pub newton_iterations: usize,
    /// Points corrected: steps, and evaluations that locate cusps, pitchforks and ends.
    pub corrections: usize,
}

impl Effort {
    pub(super) fn plus(self, other: Self) -> Self {
        Self {
            steps: self.steps + other.steps,
            rejected: self.rejected + other.rejected,
            newton_iterations: self.newton_iterations + other.newton_iterations,
            corrections: self.corrections + other.corrections,
        }
    }
}

/// A tracked branch, or the part of it up to where the track stopped.
#[derive(Clone, Debug, PartialEq)]
pub struct TrackReport {
    /// The polyline, from the start on.
    pub vertices: Vec<Vertex>,
    /// Pitchforks met, in order.
    pub pitchforks: Vec<Pitchfork>,
    /// Why the track stopped.
    pub stop: StopReason,
    /// What it has cost.
    pub effort: Effort,
}

/// Why a track could not start.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum TrackError {
    /// The start does not lead to a relative equilibrium nearby.
    #[error("no relative equilibrium near γ = ({:?}), Ω = {omega}", .gamma)]
    StartNotOnBranch {
        /// γ as given.
        gamma: [f64; 3],
        /// Ω as given.
        omega: f64,
    },
    /// The start lies outside the range of l.
    #[error("the start at l = {l} lies outside [{l_min}, {l_max}]")]
    StartOutsideRange {
        /// l of the start.
        l: f64,
        /// `l_min`.
        l_min: f64,
        /// `l_max`.
        l_max: f64,
    },
    /// An option is not positive, or not a number.
    #[error("{option} = {value}, but it must be positive")]
    OptionNotPositive {
        /// Name of the option.
        option: &'static str,
        /// Its value.
        value: f64,
    },
}
