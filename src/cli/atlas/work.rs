//! The atlas of a body and its document.

use bifdiag_diagram::atlas::Atlas;
use bifdiag_documents::{DocumentOptions, Subject, attach_part, certified_atlas_of};
use bifdiag_exact::CertifiedAtlas;
use bifdiag_schema::AtlasDocument;

use super::error::NoAtlas;
use super::settings::Settings;
use crate::cli::terminal::Timings;

pub fn atlas(settings: &Settings, timings: &Timings) -> Result<(Atlas, AtlasDocument), NoAtlas> {
    let Settings { subject, accuracy, window, .. } = settings;
    if settings.certificate {
        return proved(subject, timings);
    }
    let atlas = timings.stage("regions", || bifdiag_exact::atlas(&subject.body, *accuracy))?;
    let options = DocumentOptions { window: *window, accuracy: *accuracy, ..DocumentOptions::default() };
    let mut document = timings.stage("curves", || bifdiag_documents::atlas::document(&atlas, &options));
    attach_part(&mut document, subject);
    Ok((atlas, document))
}

fn proved(subject: &Subject, timings: &Timings) -> Result<(Atlas, AtlasDocument), NoAtlas> {
    let proof = timings.stage("proof", || CertifiedAtlas::new(&subject.body))?;
    let drawn = proof.to_atlas()?;
    let options = DocumentOptions::default();
    let document = timings.stage("certificate", || certified_atlas_of(subject, &proof, &drawn, &options))?;
    Ok((drawn, document))
}
