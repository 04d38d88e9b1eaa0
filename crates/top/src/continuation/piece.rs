//! One curve piece of an atlas: between two events, l monotone.

use super::options::{AtEvent, Direction, Start, TrackOptions};
use super::report::{Effort, StopReason, TrackError, Vertex, VertexKind};
use super::tracker::track;
use crate::body::Frame;
use crate::stability::Hessian;
use numbers::Sign;

/// How a piece ends on one side, and at which l.
///
/// Cusps and pitchforks are located by the tracker itself; the l that is given here only says which one is meant, and
/// the piece is complete if both agree to [`AGREEMENT`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PieceEnd {
    /// At a cusp.
    Cusp(f64),
    /// At a pitchfork.
    Pitchfork(f64),
    /// At this l: 0, or where a curve that goes on to infinity is cut.
    Momentum(f64),
}

/// Relative difference in l between the event that was meant and the one that was found, beyond which they are not
/// the same.
pub const AGREEMENT: f64 = 1e-9;

/// A curve piece by rising l.
#[derive(Clone, Debug, PartialEq)]
pub struct PieceTrack {
    /// The polyline, both ends included.
    pub vertices: Vec<Vertex>,
    /// Morse index of U_l, the same along the piece; for a circle of relative equilibria the index across it.
    /// `None` if rounding hides it at every vertex.
    pub index: Option<u8>,
    /// Why the track stopped at the lower and at the upper end.
    pub stops: [StopReason; 2],
    /// True when both ends are what was asked for. An incomplete piece is drawn as far as it goes.
    pub complete: bool,
    /// What it has cost.
    pub effort: Effort,
}

impl PieceTrack {
    /// The polyline as points [h, l].
    #[must_use]
    pub fn polyline(&self) -> Vec<[f64; 2]> {
        self.vertices.iter().map(|vertex| [vertex.h, vertex.l]).collect()
    }
}

/// Whether the track that stopped for this reason at `vertex` has come to `end`.
fn is_end(stop: StopReason, vertex: &Vertex, end: PieceEnd) -> bool {
    let agrees = |l: f64| (vertex.l - l).abs() <= AGREEMENT * l;
    match end {
        PieceEnd::Cusp(l) => stop == StopReason::Cusp && agrees(l),
        PieceEnd::Pitchfork(l) => stop == StopReason::Pitchfork && agrees(l),
        PieceEnd::Momentum(_) => {
            matches!(stop, StopReason::Rest | StopReason::MinimumReached | StopReason::MaximumReached)
        }
    }
}

/// Tracks the piece through `start`, a point inside it, to both of its ends.
///
/// `options.l_min` and `l_max` are replaced by the piece's own ends, and the track stops at any event. An end other than
/// the one that was asked for leaves `complete` false and the reason in `stops`.
///
/// # Errors
/// Those of [`track`].
pub fn track_piece(
    frame: &Frame,
    start: &Start,
    ends: [PieceEnd; 2],
    options: &TrackOptions,
) -> Result<PieceTrack, TrackError> {
    // A little beyond an event, so that it lies inside; a track that misses it ends there.
    let limit = |end, beyond| match end {
        PieceEnd::Momentum(l) => l,
        PieceEnd::Cusp(l) | PieceEnd::Pitchfork(l) => l * beyond,
    };
    let options = TrackOptions {
        l_min: limit(ends[0], 0.999),
        l_max: limit(ends[1], 1.001),
        at_cusp: AtEvent::Stop,
        at_pitchfork: AtEvent::Stop,
        ..*options
    };
    let falling = track(frame, start, Direction::Falling, &options)?;
    let rising = track(frame, start, Direction::Rising, &options)?;
    let stops = [falling.stop, rising.stop];
    let mut vertices: Vec<Vertex> = falling.vertices.iter().rev().copied().collect();
    vertices.extend(&rising.vertices[1..]);
    let outermost = [&vertices[0], &vertices[vertices.len() - 1]];
    let complete = (0..2).all(|side| is_end(stops[side], outermost[side], ends[side]));
    Ok(PieceTrack {
        index: index_of(frame, &vertices),
        complete,
        stops,
        effort: falling.effort.plus(rising.effort),
        vertices,
    })
}

/// The index of the first vertex that has one; where the Hessian is singular all along (a circle of relative
/// equilibria) the sign of its other eigenvalue, which is its trace.
fn index_of(frame: &Frame, vertices: &[Vertex]) -> Option<u8> {
    vertices.iter().find_map(|vertex| vertex.index).or_else(|| {
        let regular = |vertex: &&Vertex| vertex.kind == VertexKind::Regular && vertex.equilibrium.omega > 0.0;
        let trace = Hessian::new(frame, &vertices.iter().find(regular)?.equilibrium).trace;
        trace.strict().map(|sign| u8::from(sign == Sign::Negative))
    })
}
