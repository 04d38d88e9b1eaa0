//! The atlas of a body and its document.

use documents::{DocumentOptions, certified_atlas};
use plot::CurveSource;
use proof::CertifiedAtlas;
use schema::{Accuracy, AtlasDocument};
use top::atlas::Atlas;

use super::error::NoAtlas;
use super::settings::Settings;
use crate::cli::input::Subject;
use crate::cli::terminal::Timings;

/// How much farther than usual a draft's polylines may lie from their curves.
const DRAFT_COARSENING: f64 = 8.0;

pub fn atlas(settings: &Settings, timings: &Timings) -> Result<(Atlas, AtlasDocument), NoAtlas> {
    let Settings { subject, accuracy, window, .. } = settings;
    if *accuracy == Accuracy::Certified {
        return proved(subject, timings);
    }
    let atlas = timings.stage("regions", || Atlas::new(&subject.body))?;
    let mut options = DocumentOptions { window: *window, accuracy: *accuracy, ..DocumentOptions::default() };
    if *accuracy == Accuracy::Draft {
        options.chord_tolerance *= DRAFT_COARSENING;
    }
    let mut document = timings.stage("curves", || documents::atlas::document(&atlas, &options));
    attach_part(&mut document, subject);
    Ok((atlas, document))
}

fn proved(subject: &Subject, timings: &Timings) -> Result<(Atlas, AtlasDocument), NoAtlas> {
    let proof = timings.stage("proof", || CertifiedAtlas::new(&subject.body))?;
    let drawn = proof.drawn()?;
    let mut document = timings.stage("certificate", || certified_atlas(&proof, &drawn, &DocumentOptions::default()))?;
    if subject.inertia.is_some() {
        attach_part(&mut document, subject);
        documents::seal(&mut document)?;
    }
    Ok((drawn, document))
}

/// The part that was given; what it can be is decided on its own tensor, not on rounded moments.
fn attach_part(document: &mut AtlasDocument, subject: &Subject) {
    if let Some(inertia) = &subject.inertia {
        document.body.flags.unphysical = inertia.unphysical;
        document.body.flags.plate = inertia.plate;
        document.body.inertia = Some(inertia.clone());
    }
}

/// Polylines as fine as a magnification needs.
pub struct Curves<'a>(pub &'a Atlas);

impl CurveSource for Curves<'_> {
    fn polyline(&self, curve: &str, l: [f64; 2], tolerance: f64) -> Option<Vec<[f64; 2]>> {
        self.0.polyline(curve.parse().ok()?, l, tolerance)
    }
}
