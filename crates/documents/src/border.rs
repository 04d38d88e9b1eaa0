//! Borders between classes as documents.

use bifdiag_schema::{
    BorderDocument, BorderEventDocument, BorderEventName, BorderValueDocument, CommandLine, FoundBorderDocument,
};
use bifdiag_survey::ParameterRange;
use bifdiag_survey::border::{BodySegment, Border, BorderEvent, BorderEventKind};

use crate::body::head;
use crate::scan::range;

/// A border on a segment along which some parameters vary.
#[must_use]
pub fn border(border: &Border, segment: &BodySegment, vary: &[ParameterRange], command: CommandLine) -> BorderDocument {
    let value = |range: &ParameterRange| {
        let at = |t: f64| segment.coordinate(range.parameter.place(), t).to_f64().value();
        BorderValueDocument {
            parameter: range.parameter,
            value: at(border.t),
            error: border.error * (at(1.0) - at(0.0)).abs(),
            enclosure: border.enclosure.map(at),
        }
    };
    BorderDocument {
        head: head(command.json()),
        vary: vary.iter().map(range).collect(),
        borders: vec![FoundBorderDocument {
            at: vary.iter().map(value).collect(),
            event: event(&border.event),
            classes: border.classes.each_ref().map(|class| class.name().to_string()),
            reached: border.reached,
        }],
        atlases: border.atlases,
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
