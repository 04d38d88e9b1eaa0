//! The document of a proved atlas: drawn as the `f64` one, decided as proved, with its certificate.

use bifdiag_diagram::atlas::Atlas;
use bifdiag_exact::CertifiedAtlas;
use bifdiag_schema::{Accuracy, AtlasDocument};

use crate::atlas::{DocumentOptions, attach_part, command, document, name_command};
use crate::subject::Subject;

/// The document with its certificate, sealed by its checksum. `drawn` is [`CertifiedAtlas::to_atlas`].
///
/// # Errors
/// When the document cannot be written as JSON.
pub fn certified_atlas(
    proved: &CertifiedAtlas,
    drawn: &Atlas,
    options: &DocumentOptions,
) -> Result<AtlasDocument, serde_json::Error> {
    let options = DocumentOptions { accuracy: Accuracy::Exact, window: None, ..*options };
    let mut document = document(drawn, &options);
    for (event, enclosure) in document.events.iter_mut().zip(proved.enclosures()) {
        event.enclosure = Some(enclosure);
    }
    document.head.command = command(&Subject::from(drawn.body().clone()), &options, true);
    document.certificate = Some(proved.certificate());
    seal(&mut document)?;
    Ok(document)
}

/// The same with the part from which the body was computed, if there is one.
///
/// # Errors
/// As [`certified_atlas`].
pub fn certified_atlas_of(
    subject: &Subject,
    proved: &CertifiedAtlas,
    drawn: &Atlas,
    options: &DocumentOptions,
) -> Result<AtlasDocument, serde_json::Error> {
    let mut document = certified_atlas(proved, drawn, options)?;
    if subject.part.is_some() {
        attach_part(&mut document, subject);
        seal(&mut document)?;
    }
    Ok(document)
}

/// Leaves the drawing out of the document of an atlas, which pictures need while they are drawn.
///
/// # Errors
/// When the document cannot be written as JSON.
pub fn leave_out_drawing(document: &mut AtlasDocument, subject: &Subject) -> Result<(), serde_json::Error> {
    document.drawing = None;
    name_command(document, subject);
    seal(document)
}

/// Writes the checksum of a document into its certificate.
///
/// # Errors
/// When the document cannot be written as JSON.
pub fn seal(document: &mut AtlasDocument) -> Result<(), serde_json::Error> {
    let sum = bifdiag_schema::checksum(document)?;
    if let Some(certificate) = &mut document.certificate {
        certificate.checksum = sum;
    }
    Ok(())
}
