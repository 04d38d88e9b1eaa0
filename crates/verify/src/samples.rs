//! The samples that a document lists, against those of the certificate, which are proved to lie in their regions.

use dashu_ratio::RBig;
use schema::{AtlasDocument, CertificateDocument, RegionDocument};

use super::bounds::{is_at_most, roundings};
use super::fixed::Fixed;
use super::measures::{CONVERTED, is_near};
use super::orders::Orders;
use super::regions::Sample;
use super::slabs::Slab;
use super::{Refused, number};

/// Heights in doubles are good to 2⁻ᵇ of the energies there.
const HEIGHT: usize = 30;
/// The error of a margin that is stated is at most so many roundings of them.
const ROUNDINGS: u32 = 4;

/// Checks each sample: (h, l) is the certificate's, rounded; its distance to the curves around, and which of them is nearest.
pub(super) fn check(
    document: &AtlasDocument,
    certificate: &CertificateDocument,
    orders: &Orders,
    slabs: &[Slab],
    samples: &[Sample],
) -> Result<(), Refused> {
    let (moment, energy) = (number::unit(&certificate.units.moment)?, number::unit(&certificate.units.energy)?);
    let l2 = moment * &energy * RBig::from(2);
    for (region, Sample { cell: (slab, position), h }) in document.regions.iter().zip(samples) {
        let slab = &slabs[*slab];
        let refuse = |why| Err(Refused::Region { region: region.id.clone(), why });
        let x = orders.spaces.set(&slab.x);
        let sample = &region.sample;
        let at_l = is_near(sample.l, 2, &l2, &x, &slab.x, CONVERTED);
        let size = h.clone().max(-h);
        if !at_l || !is_near(sample.h, 1, &energy, &orders.spaces.set(h), &size, CONVERTED) {
            return refuse("its sample is not that of its certificate");
        }
        if !margin(region, orders, slab, *position, h, &energy) {
            return refuse("the margin of its sample is another");
        }
    }
    Ok(())
}

/// The distance to the curves around is as stated, and the one that is named is as near as it.
fn margin(region: &RegionDocument, orders: &Orders, slab: &Slab, position: usize, h: &RBig, energy: &RBig) -> bool {
    let at = orders.spaces.set(h);
    let around = [Some(position), Some(position + 1)];
    let levels = around.into_iter().flatten().filter_map(|k| slab.levels.get(k));
    let distances: Vec<(&str, Fixed)> = levels
        .map(|level| {
            let distance = &at - &level.height;
            let distance = if distance.is_positive() { distance } else { -&distance };
            (orders.pieces.list[level.curve].id.as_str(), distance)
        })
        .collect();
    let claim = &region.sample.margin;
    let Ok(error) = RBig::try_from(claim.error_bound) else { return false };
    let scale = h.clone().max(-h) + &slab.x + orders.spaces.norm.ends()[1].clone();
    if !is_at_most(claim.error_bound, &roundings(ROUNDINGS, &(&scale * energy))) {
        return false;
    }
    let room = error / energy + scale / RBig::from(dashu_int::IBig::ONE << HEIGHT);
    let near = |distance: &Fixed| is_near(claim.h, 1, energy, distance, &room, 0);
    let named = distances.iter().find(|(id, _)| *id == claim.nearest);
    let Ok(least) = RBig::try_from(claim.h) else { return false };
    let least = orders.spaces.set(&(least / energy - &room));
    named.is_some_and(|(_, distance)| near(distance)) && distances.iter().all(|(_, distance)| least.at_most(distance))
}
