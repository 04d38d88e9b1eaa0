//! Newton continuation of relative equilibria.
//!
//! A predictor–corrector tracker follows the curves of solutions of
//!
//! B_j γ_j = r_j (j = 1, 2, 3), |γ|² = 1, with the gaps B_j = λ − sA_j and s = Ω²,
//!
//! which is sAγ + r = λγ, the condition for a relative equilibrium. It knows nothing of the closed form in μ: that form
//! gives start points and the comparison in tests.
//!
//! Unknowns are γ, Ω and the smallest gap b = B_i; the others are b + s(A_i − A_j), exact to three roundings. Distance
//! along a curve is measured by dγ, dΩ/Ω and dB_j/B_j. In that measure
//! - folds in l (cusps of the (h, l) curve, where dl = dh = 0) are ordinary points,
//! - so is the end l = 0 at γ = ±r̂, where everything is smooth in Ω,
//! - l → ∞ is as many steps away as ln l,
//! - the sharp turn near a pitchfork unfolded by a small r_j is a smooth stretch of length ln r_j.
//!
//! No step can land on another branch unseen: as B_j γ_j = r_j, the signs of γ cannot change along a branch, and two
//! branches of one body differ in a sign. Steps that skip a part of their own branch are caught by the angle between
//! tangents and by Newton's contraction. A branch cannot close up: each runs between pitchforks, l = 0 and l = ∞.

mod branch;
mod chord;
mod corrector;
mod events;
mod location;
mod options;
mod piece;
mod report;
mod tracker;

pub use options::{AtEvent, Direction, Start, TrackOptions};
pub use piece::{AGREEMENT, PieceEnd, PieceTrack, track_piece};
pub use report::{Effort, Pitchfork, StopReason, TrackError, TrackReport, Vertex, VertexKind};
pub use tracker::track;
