//! Borders between classes as documents.

use bifdiag_schema::{
    BorderDocument, BorderEventDocument, BorderEventName, BorderValueDocument, CommandLine, EventTrackDocument,
    EventTracksDocument, FoundBorderDocument,
};
use bifdiag_survey::ParameterRange;
use bifdiag_survey::border::{BodySegment, Border, BorderEvent, BorderEventKind};
use bifdiag_survey::events::{EventTrack, EventTracks, Stretch};

use crate::body::head;
use crate::scan::range;

/// A border on a segment along which some parameters vary.
#[must_use]
pub fn border(border: &Border, segment: &BodySegment, vary: &[ParameterRange], command: CommandLine) -> BorderDocument {
    BorderDocument {
        head: head(command.json()),
        vary: vary.iter().map(range).collect(),
        borders: vec![found(border, segment, vary)],
        atlases: border.atlases,
    }
}

fn found(border: &Border, segment: &BodySegment, vary: &[ParameterRange]) -> FoundBorderDocument {
    let value = |range: &ParameterRange| {
        let at = |t: f64| segment.value(range.parameter.place(), t);
        let value = at(border.t);
        // The value itself is rounded, unless it is exact.
        let rounding = if border.error == 0.0 { 0.0 } else { f64::EPSILON * value.abs() };
        BorderValueDocument {
            parameter: range.parameter,
            value,
            error: border.error * (at(1.0) - at(0.0)).abs() + rounding,
            enclosure: border.enclosure.map(at),
        }
    };
    FoundBorderDocument {
        at: vary.iter().map(value).collect(),
        event: event(&border.event),
        classes: border.classes.each_ref().map(|class| class.name().to_string()),
        reached: border.reached,
    }
}

/// The events along a segment on which one parameter varies.
#[must_use]
pub fn event_tracks(
    tracks: &EventTracks,
    segment: &BodySegment,
    vary: &ParameterRange,
    command: CommandLine,
) -> EventTracksDocument {
    let count = |number: usize| u32::try_from(number).unwrap_or(u32::MAX);
    let value = |t: f64| segment.value(vary.parameter.place(), t);
    let track = |track: &EventTrack| EventTrackDocument {
        event: track.label.to_string(),
        between: track.between.map(|border| border.map(count)),
        at: track.points.iter().map(|point| value(point.t)).collect(),
        h: track.points.iter().map(|point| point.h).collect(),
        l: track.points.iter().map(|point| point.l).collect(),
    };
    let class = |stretch: &Stretch| stretch.class.as_ref().map(ToString::to_string);
    EventTracksDocument {
        head: head(command.json()),
        vary: range(vary),
        bodies: count(tracks.bodies),
        passed: count(tracks.passed),
        classes: tracks.stretches.iter().map(class).collect(),
        borders: tracks.borders.iter().map(|border| found(border, segment, std::slice::from_ref(vary))).collect(),
        events: tracks.tracks.iter().map(track).collect(),
    }
}

pub(crate) fn event(event: &BorderEvent) -> BorderEventDocument {
    BorderEventDocument {
        kind: name(&event.kind),
        text: event.kind.to_string(),
        curves: event.curves.iter().map(ToString::to_string).collect(),
        h: event.place.map(|place| place.h),
        l: event.place.map(|place| place.l),
        error_bound: event.place.map(|place| place.error),
        vanish: event.vanish.iter().map(ToString::to_string).collect(),
        appear: event.appear.iter().map(ToString::to_string).collect(),
    }
}

fn name(kind: &BorderEventKind) -> BorderEventName {
    match kind {
        BorderEventKind::Swallowtail { .. } => BorderEventName::Swallowtail,
        BorderEventKind::TriplePoint { .. } => BorderEventName::TriplePoint,
        BorderEventKind::CuspOnCurve { .. } => BorderEventName::CuspOnCurve,
        BorderEventKind::PitchforkOnCurve { .. } => BorderEventName::PitchforkOnCurve,
        BorderEventKind::CuspAtPitchfork { .. } | BorderEventKind::CuspNearPitchfork { .. } => {
            BorderEventName::CuspAtPitchfork
        }
        BorderEventKind::PitchforkAtInfinity { .. } => BorderEventName::PitchforkAtInfinity,
        BorderEventKind::SymmetryBroken { .. } => BorderEventName::SymmetryBroken,
        BorderEventKind::MomentsEqual { .. } => BorderEventName::MomentsEqual,
        BorderEventKind::WeightVanishes => BorderEventName::WeightVanishes,
        BorderEventKind::PoleLinesAtInfinity { .. } => BorderEventName::PoleLinesAtInfinity,
        BorderEventKind::CrossingAtTheEdge { .. } => BorderEventName::CrossingAtTheEdge,
        BorderEventKind::Several | BorderEventKind::Unexplained => BorderEventName::Other,
    }
}
