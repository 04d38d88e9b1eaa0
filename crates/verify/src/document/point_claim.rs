//! A point (h, l), and the region in which it lies.

use bifdiag_schema::{ComponentDocument, PointProofDocument, Status};
use dashu_ratio::RBig;

use super::totals;
use crate::Refused;
use crate::numbers::number;
use crate::order::events::Events;
use crate::order::orders::Orders;
use crate::order::slabs;

/// Checks what is said of a point, given that its atlas is true.
pub(crate) fn check(point: &PointProofDocument, orders: &Orders, events: &Events) -> Result<(), Refused> {
    let refuse = |field| Err(Refused::Field { field });
    let (atlas, head) = (&point.atlas, &point.head);
    let certificate = atlas.certificate.as_ref().ok_or(Refused::NoCertificate)?;
    if [&head.schema_version, &head.version] != [&atlas.head.schema_version, &atlas.head.version] {
        return refuse("schema_version or version");
    }
    if head.command != totals::point_command(point) {
        return refuse("command");
    }
    let (moment, energy) = (number::unit(&certificate.units.moment)?, number::unit(&certificate.units.energy)?);
    let (h, l) = (number::given(&point.h)? / &energy, number::given(&point.l)?);
    let x = &l * &l / (RBig::from(2) * moment * energy);
    if number::read(&point.level.x)? != x {
        return refuse("level.x");
    }
    let slab = slabs::level(certificate, orders, events, (point.slab, &point.level))?;
    let h = orders.spaces.set(&h);
    let below = slab.levels.iter().take_while(|level| level.height.below(&h)).count();
    if !slab.levels.get(below).is_none_or(|level| h.below(&level.height)) {
        return Err(Refused::uncertain("the point is not told apart from a curve"));
    }
    let (status, region) = match below.checked_sub(1) {
        None => (Status::Forbidden, None),
        Some(position) => (Status::Regular, Some(&slab.faces[position])),
    };
    if point.status != status {
        return refuse("status");
    }
    if point.region.as_ref() != region {
        return refuse("region");
    }
    let of_region = atlas.regions.iter().find(|listed| Some(&listed.id) == region);
    let components: &[ComponentDocument] = of_region.map_or(&[], |region| &region.components);
    if point.components == components { Ok(()) } else { refuse("components") }
}
