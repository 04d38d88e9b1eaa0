//! One curve piece of an atlas: between two events, l monotone.

use super::options::{AtEvent, Direction, Start, TrackOptions};
use super::report::{Effort, StabilityStretch, StopReason, TrackError, TrackReport, Vertex};
use super::tracker::track;
use crate::body::Frame;
use crate::document::{Stability, StabilitySpan};

/// How a piece ends on one side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PieceEnd {
    /// At a cusp, which the tracker finds itself.
    Cusp,
    /// At a pitchfork, which the tracker finds itself.
    Pitchfork,
    /// At this l: 0, or where a curve that goes on to infinity is cut.
    Momentum(f64),
}

/// A curve piece by rising l.
#[derive(Clone, Debug, PartialEq)]
pub struct PieceTrack {
    /// The polyline, both ends included.
    pub vertices: Vec<Vertex>,
    /// Stability by rising l.
    pub stability: Vec<StabilitySpan>,
    /// Morse index of U_l, the same along the piece; for a circle of relative equilibria the index across it.
    /// `None` if rounding hides it at every vertex.
    pub index: Option<u8>,
    /// Why the track stopped at the lower and at the upper end.
    pub stops: [StopReason; 2],
    /// True when both ends are what was asked for.
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

fn is_end(stop: StopReason, end: PieceEnd) -> bool {
    match end {
        PieceEnd::Cusp => stop == StopReason::Cusp,
        PieceEnd::Pitchfork => stop == StopReason::Pitchfork,
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
    let limit = |end, otherwise| if let PieceEnd::Momentum(l) = end { l } else { otherwise };
    let options = TrackOptions {
        l_min: limit(ends[0], 0.0),
        l_max: limit(ends[1], f64::INFINITY),
        at_cusp: AtEvent::Stop,
        at_pitchfork: AtEvent::Stop,
        ..*options
    };
    let falling = track(frame, start, Direction::Falling, &options)?;
    let rising = track(frame, start, Direction::Rising, &options)?;
    let stops = [falling.stop, rising.stop];
    let mut vertices: Vec<Vertex> = falling.vertices.iter().rev().copied().collect();
    vertices.extend(&rising.vertices[1..]);
    Ok(PieceTrack {
        index: index_of(&vertices),
        stability: joined(&falling, &rising),
        complete: is_end(stops[0], ends[0]) && is_end(stops[1], ends[1]),
        stops,
        effort: falling.effort.plus(rising.effort),
        vertices,
    })
}

fn index_of(vertices: &[Vertex]) -> Option<u8> {
    vertices.iter().find_map(|vertex| vertex.index)
}

/// The stretches of both halves by rising l, joined where the stability at the start is the same.
fn joined(falling: &TrackReport, rising: &TrackReport) -> Vec<StabilitySpan> {
    let reversed = |stretch: &StabilityStretch| StabilityStretch {
        l_from: stretch.l_to,
        l_to: stretch.l_from,
        stability: stretch.stability,
    };
    let mut spans: Vec<StabilitySpan> = Vec::new();
    for stretch in falling.stability.iter().rev().map(reversed).chain(rising.stability.iter().copied()) {
        match spans.last_mut() {
            Some(span) if span.stability == stretch.stability => span.l_to = Some(stretch.l_to),
            _ => spans.push(StabilitySpan {
                l_from: stretch.l_from,
                l_to: Some(stretch.l_to),
                stability: stretch.stability,
            }),
        }
    }
    let lonely_degenerate =
        |span: &StabilitySpan| span.stability == Stability::Degenerate && span.l_to == Some(span.l_from);
    spans.retain(|span| !lonely_degenerate(span));
    spans
}
