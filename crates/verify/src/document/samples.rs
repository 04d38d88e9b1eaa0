//! The samples that a document lists, against those of the certificate, which are proved to lie in their regions.

use bifdiag_schema::{AtlasDocument, MarginDocument};
use dashu_base::Abs;
use dashu_int::IBig;
use dashu_ratio::RBig;

use super::curves::CONVERTED;
use crate::Refused;
use crate::numbers::bounds::{exact, roundings};
use crate::numbers::fixed::Fixed;
use crate::order::orders::Orders;
use crate::order::regions::Sample;
use crate::order::slabs::Slab;

/// Largest error of a margin, in roundings of the energies there.
const ROUNDINGS: u32 = 8;

/// A sample as written and as proved, in the certificate's units.
struct WrittenSample<'a> {
    /// x and h of the certificate.
    exact: [&'a RBig; 2],
    /// l²/2 and h of the document.
    written: [RBig; 2],
}

/// Checks each sample: (h, l) is the certificate's, rounded; its distance to the curves around, and which of them is nearest.
pub(crate) fn check(
    document: &AtlasDocument,
    orders: &Orders,
    slabs: &[Slab],
    samples: &[Sample],
) -> Result<(), Refused> {
    let (energy, l2) = (&orders.spaces.energy, orders.spaces.square_of_momentum());
    for (region, Sample { cell: (slab, position), h }) in document.regions.iter().zip(samples) {
        let slab = &slabs[*slab];
        let refuse = |why| Err(Refused::Region { region: region.id.clone(), why });
        let sample = &region.sample;
        let [Some(l), Some(written)] = [sample.l, sample.h].map(exact) else {
            return refuse("its sample is not that of its certificate");
        };
        if l <= RBig::ZERO {
            return refuse("its sample is not at a positive l");
        }
        let place = WrittenSample { exact: [&slab.x, h], written: [&l * &l / &l2, written / energy] };
        if !place.is_near() {
            return refuse("its sample is not that of its certificate");
        }
        if !place.has_margin(&region.sample.margin, orders, slab, *position) {
            return refuse("the margin of its sample is another");
        }
    }
    Ok(())
}

impl WrittenSample<'_> {
    /// The written sample is the exact one except for the last bits.
    fn is_near(&self) -> bool {
        let near = |exact: &RBig, written: &RBig| {
            let room = exact.clone().abs() / RBig::from(IBig::ONE << CONVERTED);
            (written - exact).abs() <= room
        };
        (0..2).all(|k| near(self.exact[k], &self.written[k]))
    }

    /// How far rounding to doubles, and of these to decimals, may move a distance to the curves (Lemma 8.7):
    /// Δh + (max(|h|, |h′|) + D + |r|) Δx / min(x, x′), where a decimal adds 2⁻⁵³|h′| to |h′ − h| and 2⁻⁵²x′ to |x′ − x|.
    fn rounding(&self, distance: &RBig, norm: &RBig) -> Option<RBig> {
        let ([x, h], [other_x, other_h]) = (self.exact, &self.written);
        let least = x.min(other_x);
        if *least <= RBig::ZERO {
            return None;
        }
        let energies = h.clone().abs().max(other_h.clone().abs()) + distance + norm;
        let decimal = |size: &RBig, power: usize| size.clone().abs() / RBig::from(IBig::ONE << power);
        let across = (other_h - h).abs() + decimal(other_h, 53);
        let along = (other_x - x).abs() + decimal(other_x, 52);
        Some(across + energies * along / least)
    }

    /// The distance to the curves around is as stated, also where the sample is written, and the one that is named is the
    /// nearest.
    fn has_margin(&self, claim: &MarginDocument, orders: &Orders, slab: &Slab, position: usize) -> bool {
        let energy = &orders.spaces.energy;
        let at = orders.spaces.set(self.exact[1]);
        let below = slab.levels.get(position).map(|level| (level, &at - &level.height));
        let above = slab.levels.get(position + 1).map(|level| (level, &level.height - &at));
        let around: Vec<(usize, Fixed)> =
            [below, above].into_iter().flatten().map(|(level, distance)| (level.curve, distance)).collect();
        let is_named = |curve: usize| orders.pieces.list[curve].id == claim.nearest;
        let Some((_, nearest)) = around.iter().find(|(curve, _)| is_named(*curve)) else {
            return false;
        };
        if around.iter().any(|(_, distance)| distance.below(nearest)) {
            return false;
        }
        let [Some(margin), Some(error)] = [claim.h, claim.error_bound].map(exact) else {
            return false;
        };
        let (margin, error) = (margin / energy, error / energy);
        let (ends, norm) = (nearest.ends(), orders.spaces.norm.ends()[1].clone());
        let most = roundings(ROUNDINGS, &(self.exact[1].clone().abs() + &norm));
        let off = ends.iter().map(|end| (end - &margin).abs()).max();
        let Some((off, rounding)) = off.zip(self.rounding(&ends[1], &norm)) else {
            return false;
        };
        margin >= RBig::ZERO && off + rounding <= error && error <= most
    }
}
