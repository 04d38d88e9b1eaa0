//! Stand-in for the document of an atlas.

use super::Atlas;
use crate::document::{Accuracy, AtlasDocument, BodyDocument, SCHEMA_VERSION, SummaryDocument, WindowDocument};

/// What the document holds.
#[derive(Clone, Debug, Default)]
pub struct DocumentOptions {
    /// The part of the plane asked for.
    pub window: Option<WindowDocument>,
    /// Chord tolerance.
    pub chord_tolerance: f64,
    /// The level of accuracy.
    pub accuracy: Accuracy,
}

impl Atlas {
    /// Its document.
    #[must_use]
    pub fn document(&self, options: &DocumentOptions) -> AtlasDocument {
        let flags = self.body().flags();
        AtlasDocument {
            schema_version: SCHEMA_VERSION.to_owned(),
            accuracy: options.accuracy,
            body: BodyDocument {
                moments: self.body().moments().clone(),
                center: self.body().center().clone(),
                flags,
                degenerate: flags.degenerate(),
                inertia: None,
            },
            window: options.window,
            curves: Vec::new(),
            events: Vec::new(),
            regions: Vec::new(),
            summary: SummaryDocument {
                regions: 0,
                events: 0,
                signatures: std::collections::BTreeMap::new(),
                critical_points_max: 0,
                undecided: Vec::new(),
                complete: false,
            },
        }
    }
}
