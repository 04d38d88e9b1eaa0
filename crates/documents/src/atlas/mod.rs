//! The document of an atlas: names, polylines, stability, and everything in the body's own units.

mod curves;
mod events;
mod regions;
mod undecided;

use std::collections::BTreeMap;

use schema::{Accuracy, AtlasDocument, BodyDocument, SCHEMA_VERSION, SummaryDocument, WindowDocument};
use top::atlas::{Atlas, Window};

use crate::body::{flags, texts};

/// What the document holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DocumentOptions {
    /// The part of the plane asked for; `None`: all of it.
    pub window: Option<WindowDocument>,
    /// Largest distance between a curve and its polyline, relative to the ranges of h and l of the events.
    pub chord_tolerance: f64,
    /// Whether curves carry polylines and stability at all.
    pub polylines: bool,
    /// The level of accuracy.
    pub accuracy: Accuracy,
}

impl Default for DocumentOptions {
    fn default() -> Self {
        Self { window: None, chord_tolerance: 1e-3, polylines: true, accuracy: Accuracy::Standard }
    }
}

/// The atlas as a document. Curves are traced by Newton continuation; events and regions come from the closed form.
#[must_use]
pub fn document(atlas: &Atlas, options: &DocumentOptions) -> AtlasDocument {
    let window = options.window.map(|WindowDocument { h, l }| Window { h, l });
    let mut undecided = undecided::documents(atlas);
    let curves = curves::documents(atlas, options, &mut undecided);
    let (regions, clipped) = regions::documents(atlas, window.as_ref(), &mut undecided);
    let mut signatures = BTreeMap::new();
    for region in &regions {
        let accessible = || {
            let names: Vec<&str> = region.components.iter().map(|c| c.accessible_region.as_str()).collect();
            names.join("+")
        };
        *signatures.entry(region.signature.clone().unwrap_or_else(accessible)).or_insert(0) += 1;
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
        schema_version: SCHEMA_VERSION.to_owned(),
        accuracy: options.accuracy,
        body: BodyDocument {
            moments: texts(body.moments()),
            center: texts(body.center()),
            flags: flags(body),
            degenerate: body.flags().degenerate(),
            inertia: None,
        },
        window: options.window,
        curves,
        events,
        regions,
        summary,
        certificate: None,
    }
}
