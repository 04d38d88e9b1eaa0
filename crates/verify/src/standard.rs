//! Cross-check of an atlas without certificate by the second topological method: no proof, since nothing tells that no
//! region is missing.

use super::{Refused, Report, words};
use schema::{AtlasDocument, ComponentDocument};
use top::body::Body;
use top::topology::latitude;

pub(super) fn verify(document: &AtlasDocument, body: &Body) -> Result<Report, Refused> {
    let frame = body.frame();
    let mut open = Vec::new();
    for region in &document.regions {
        let (h, l) = (region.sample.h / frame.energy_unit, region.sample.l / frame.momentum_unit);
        let Ok(found) = latitude::components(&frame, h, l) else {
            open.push(region.id.clone());
            continue;
        };
        if region.components.is_empty() {
            open.push(region.id.clone());
            continue;
        }
        let expected: Vec<ComponentDocument> = found.iter().map(crate::component).collect();
        if expected != region.components {
            let claimed = region.signature.clone().unwrap_or_default();
            return Err(Refused::Topology { region: region.id.clone(), claimed, found: words(&found) });
        }
    }
    if document.summary.regions != document.regions.len() {
        let (claimed, found) = (document.summary.regions, document.regions.len());
        return Err(Refused::Summary { what: "regions", claimed, found });
    }
    let regions = document.regions.len() - open.len();
    Ok(Report { proof: false, regions, open, events: document.events.len(), pairs: 0 })
}
