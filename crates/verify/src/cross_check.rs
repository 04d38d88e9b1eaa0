//! Cross-check of an atlas without certificate by a second method: no proof, since nothing tells that no region is
//! missing.

use schema::{Accuracy, AtlasDocument, BodyDocument, ComponentDocument};

use super::body::Body;
use super::topology::compare;
use super::{Refused, Report};

/// Compares the topology of every region with what a second method finds at its sample: `components` takes the body, h
/// and l, and gives the components in canonical order, or nothing where it has no answer.
///
/// # Errors
/// The first thing that is wrong; [`Refused::Certificate`] for a certified atlas, which is checked by
/// [`verify`](super::verify).
pub fn cross_check(
    document: &AtlasDocument,
    mut components: impl FnMut(&BodyDocument, f64, f64) -> Option<Vec<ComponentDocument>>,
) -> Result<Report, Refused> {
    if document.certificate.is_some() || document.accuracy == Accuracy::Certified {
        let (accuracy, present) = (document.accuracy, document.certificate.is_some());
        return Err(Refused::Certificate { accuracy, present });
    }
    Body::read(&document.body)?;
    let mut open = Vec::new();
    for region in &document.regions {
        let found = components(&document.body, region.sample.h, region.sample.l);
        match found.filter(|_| !region.components.is_empty()) {
            Some(found) => compare(region, &found)?,
            None => open.push(region.id.clone()),
        }
    }
    let (claimed, found) = (document.summary.regions, document.regions.len());
    if claimed != found {
        return Err(Refused::Summary { what: "regions", claimed, found });
    }
    Ok(Report { proof: false, regions: found - open.len(), open, events: document.events.len(), pairs: 0 })
}
