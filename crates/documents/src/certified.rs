//! The document of a proved atlas: drawn as the `f64` one, decided as proved, with its certificate.

use bifdiag_diagram::arrangement::RegionId;
use bifdiag_diagram::atlas::Atlas;
use bifdiag_exact::CertifiedAtlas;
use bifdiag_numbers::Number;
use bifdiag_schema::{Accuracy, AtlasDocument, PointProofDocument, Status};

use crate::atlas::{DocumentOptions, attach_part, command, document, name_command, verdict_changes};
use crate::body::head;
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
    document.verdict_changes = verdict_changes(drawn);
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

/// Where a regular or forbidden point lies, with its proof: `atlas` is the document of `proved`, with its certificate and without
/// drawing. `None` where the curves over l are not those of a slab: at l = 0, and too close to an event.
#[must_use]
pub fn proved_point(
    subject: &Subject,
    [h, l]: [&Number; 2],
    region: Option<RegionId>,
    proved: &CertifiedAtlas,
    atlas: AtlasDocument,
) -> Option<PointProofDocument> {
    let (slab, level) = proved.level(l)?;
    let region = region.map(|id| id.to_string());
    let found = atlas.regions.iter().find(|listed| Some(&listed.id) == region.as_ref());
    let command = subject.command("classify").option("h", h.text()).option("l", l.text()).flag("certificate", true);
    Some(PointProofDocument {
        head: head(command.json()),
        h: h.text().to_owned(),
        l: l.text().to_owned(),
        status: if region.is_some() { Status::Regular } else { Status::Forbidden },
        components: found.map_or_else(Vec::new, |region| region.components.clone()),
        region,
        slab,
        level,
        atlas,
    })
}
