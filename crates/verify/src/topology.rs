//! The topology that is claimed of each region, against Morse theory.

use dashu_ratio::RBig;
use schema::{AtlasDocument, CertificateDocument, ComponentDocument, RegionDocument};

use super::component::{Component, documents, signature, words};
use super::merging::Merging;
use super::orders::Orders;
use super::regions::Cell;
use super::rings::Rings;
use super::slabs::Slab;
use super::{Refused, number};

/// How U changes with h over the abscissa of a slab.
enum Landscape {
    Points(Merging),
    Circles(Rings),
}

/// Checks every region.
pub(super) fn check(
    document: &AtlasDocument,
    certificate: &CertificateDocument,
    orders: &Orders,
    slabs: &[Slab],
    cells: &[Vec<Cell>],
) -> Result<(), Refused> {
    let mut known: Vec<Option<Landscape>> = slabs.iter().map(|_| None).collect();
    for (region, cells) in document.regions.iter().zip(cells) {
        let (number, position, _) = sample(certificate, region, orders, slabs, cells)?;
        let open = || Refused::Open { region: region.id.clone() };
        let slab = &slabs[number];
        let found = if position + 1 == slab.levels.len() {
            // Above every critical value U is the sphere.
            let poles = (!orders.spaces.active.is_empty()).then_some([true, true]);
            vec![Component { boundary_circles: 0, poles }]
        } else {
            let landscape = match known[number].take() {
                Some(landscape) => landscape,
                None => Landscape::new(orders, slab).ok_or_else(open)?,
            };
            let found = landscape.components(position);
            known[number] = Some(landscape);
            found.ok_or_else(open)?
        };
        compare(region, &documents(&found))?;
    }
    Ok(())
}

impl Landscape {
    fn new(orders: &Orders, slab: &Slab) -> Option<Self> {
        let spaces = &orders.spaces;
        let symmetric = spaces.passive().into_iter().any(|k| spaces.list[k].axes.len() == 2);
        if symmetric {
            let axis = spaces.list.iter().position(|space| space.axes.len() == 1)?;
            Some(Self::Circles(Rings::new(orders, slab, axis)?))
        } else {
            Some(Self::Points(Merging::new(orders, slab)?))
        }
    }

    fn components(&self, position: usize) -> Option<Vec<Component>> {
        match self {
            Self::Points(merging) => merging.components(position),
            Self::Circles(rings) => Some(rings.components(position)),
        }
    }
}

/// The components that were found are those that a region claims.
pub(super) fn compare(region: &RegionDocument, found: &[ComponentDocument]) -> Result<(), Refused> {
    if found == region.components && signature(found) == region.signature {
        return Ok(());
    }
    let claimed = words(&region.components);
    Err(Refused::Topology { region: region.id.clone(), claimed, found: words(found) })
}

/// The sample of a region: the number of a slab, the position of the curve below it, and its h. It lies in the region.
pub(super) fn sample(
    certificate: &CertificateDocument,
    region: &RegionDocument,
    orders: &Orders,
    slabs: &[Slab],
    cells: &[Cell],
) -> Result<(usize, usize, RBig), Refused> {
    let refuse = |why| Refused::Region { region: region.id.clone(), why };
    let sample = certificate.samples.iter().find(|sample| sample.region == region.id);
    let sample = sample.ok_or_else(|| refuse("it has no sample"))?;
    let slab = slabs.get(sample.slab).ok_or_else(|| refuse("its sample lies in no slab"))?;
    let exact = number::read(&sample.h)?;
    let h = orders.spaces.set(&exact);
    let below = slab.levels.iter().take_while(|level| level.height.below(&h)).count();
    let above = slab.levels.get(below).is_none_or(|level| h.below(&level.height));
    match below.checked_sub(1).filter(|_| above) {
        None => Err(refuse("its sample is not inside")),
        Some(position) if !cells.contains(&(sample.slab, position)) => Err(refuse("its sample lies in another region")),
        Some(position) => Ok((sample.slab, position, exact)),
    }
}
