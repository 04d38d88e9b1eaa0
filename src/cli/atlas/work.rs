//! The atlas of a body and its document.

use documents::{DocumentOptions, Subject, attach_part, certified_atlas};
use plot::CurveSource;
use proof::{CertifiedAtlas, atlas_of};
use schema::{AtlasDocument, RelativeEquilibriumDocument};
use top::atlas::Atlas;
use top::body::Number;
use top::critical::critical;

use super::error::NoAtlas;
use super::settings::Settings;
use crate::cli::terminal::Timings;

pub fn atlas(settings: &Settings, timings: &Timings) -> Result<(Atlas, AtlasDocument), NoAtlas> {
    let Settings { subject, accuracy, window, polygons, .. } = settings;
    if settings.certificate {
        return proved(subject, *polygons, timings);
    }
    let atlas = timings.stage("regions", || atlas_of(&subject.body, (*accuracy).into()))?;
    let options =
        DocumentOptions { window: *window, accuracy: *accuracy, polygons: *polygons, ..DocumentOptions::default() };
    let mut document = timings.stage("curves", || documents::atlas::document(&atlas, &options));
    attach_part(&mut document, subject);
    Ok((atlas, document))
}

fn proved(subject: &Subject, polygons: bool, timings: &Timings) -> Result<(Atlas, AtlasDocument), NoAtlas> {
    let proof = timings.stage("proof", || CertifiedAtlas::new(&subject.body))?;
    let drawn = proof.drawn()?;
    let options = DocumentOptions { polygons, ..DocumentOptions::default() };
    let mut document = timings.stage("certificate", || certified_atlas(&proof, &drawn, &options))?;
    if subject.part.is_some() {
        attach_part(&mut document, subject);
        documents::seal(&mut document)?;
    }
    Ok((drawn, document))
}

/// Polylines as fine as a magnification needs.
pub struct Curves<'a>(pub &'a Atlas);

impl CurveSource for Curves<'_> {
    fn polyline(&self, curve: &str, l: [f64; 2], tolerance: f64) -> Option<Vec<[f64; 2]>> {
        self.0.polyline(curve.parse().ok()?, l, tolerance)
    }

    fn equilibria(&self, l: f64) -> Vec<RelativeEquilibriumDocument> {
        let found = Number::from_f64(l).ok().and_then(|l| critical(self.0.body(), &l).ok());
        found.map_or_else(Vec::new, |found| documents::equilibria(&found))
    }
}
