//! The document of an atlas: names, stability, its drawing, and everything in the body's own units.

mod curves;
mod drawing;
mod events;
mod options;
mod regions;
mod stability;

use std::collections::BTreeMap;

use bifdiag_diagram::atlas::{Atlas, Window};
use bifdiag_schema::{
    Accuracy, AtlasDocument, BodyDocument, EventDocument, RegionDocument, SummaryDocument, WindowDocument,
};

use crate::body::{given, head};
use crate::classification::accuracy_option;
use crate::integrals::integrable;
use crate::subject::Subject;

use stability::Stability;

pub use options::{DocumentOptions, Drawn};
pub(crate) use stability::verdict_changes;

/// The atlas as a document. Curves, events and regions come from the closed form.
#[must_use]
pub fn document(atlas: &Atlas, options: &DocumentOptions) -> AtlasDocument {
    let window = options.window.map(|WindowDocument { h, l }| Window { h, l });
    let mut undecided = events::undecided(atlas);
    let stability = Stability::new(atlas);
    let curves = curves::documents(atlas, options, &stability, &mut undecided);
    let (regions, clipped) = regions::documents(atlas, window.as_ref(), &mut undecided);
    let drawing = drawing::document(atlas, options, &regions);
    let mut signatures = BTreeMap::new();
    for region in &regions {
        *signatures.entry(region.shown()).or_insert(0) += 1;
    }
    let events = events::documents(atlas, window.as_ref());
    let summary = SummaryDocument {
        regions: regions.len(),
        events: events.len(),
        signatures,
        critical_points_max: atlas.critical_points_max(),
        complete: undecided.is_empty() && !clipped && options.window.is_none(),
        undecided,
    };
    let body = atlas.body();
    AtlasDocument {
        head: head(command(&Subject::from(body.clone()), options, false)),
        accuracy: options.accuracy,
        body: BodyDocument {
            given: given(body),
            flags: body.flags(),
            degenerate: body.flags().degenerate(),
            integrable: integrable(body),
            part: None,
        },
        window: options.window,
        curves,
        events,
        stability_changes: stability.changes(window.as_ref()),
        verdict_changes: None,
        regions,
        summary,
        drawing,
        certificate: None,
    }
}

/// The regions as the whole document has them: sooner than the document, whose curves are traced.
#[must_use]
pub fn regions(atlas: &Atlas) -> Vec<RegionDocument> {
    regions::documents(atlas, None, &mut Vec::new()).0
}

/// The events as the whole document has them.
#[must_use]
pub fn events(atlas: &Atlas) -> Vec<EventDocument> {
    events::documents(atlas, None)
}

/// The command of a document that has all else.
pub(crate) fn name_command(document: &mut AtlasDocument, subject: &Subject) {
    let drawing = if document.drawing.is_some() { Drawn::Everything } else { Drawn::Nothing };
    let options =
        DocumentOptions { window: document.window, accuracy: document.accuracy, drawing, ..Default::default() };
    document.head.command = command(subject, &options, document.certificate.is_some());
}

/// Writes into the document of an atlas the part from which its body was computed.
pub fn attach_part(document: &mut AtlasDocument, subject: &Subject) {
    if let Some(part) = &subject.part {
        name_command(document, subject);
        document.body.part = Some(part.clone());
    }
}

/// Adds to an exact document the points of its window where a hypothesis of Arnold's theorem fails; takes several times as long as
/// the rest.
pub fn attach_verdict_changes(document: &mut AtlasDocument, atlas: &Atlas) {
    if document.accuracy != Accuracy::Exact {
        return;
    }
    document.verdict_changes = verdict_changes(atlas);
    if let (Some(WindowDocument { h, l }), Some(changes)) = (document.window, &mut document.verdict_changes) {
        changes.retain(|change| h[0] <= change.h && change.h <= h[1] && l[0] <= change.l && change.l <= l[1]);
    }
}

/// The command that makes the document.
pub(crate) fn command(subject: &Subject, options: &DocumentOptions, certificate: bool) -> String {
    let window = options.window.map(|WindowDocument { h, l }| format!("{}:{},{}:{}", h[0], h[1], l[0], l[1]));
    let line = subject.command("atlas").option_if("window", window);
    line.option_if("accuracy", accuracy_option(options.accuracy))
        .flag("certificate", certificate)
        .flag("no-drawing", options.drawing == Drawn::Nothing)
        .json()
}
