//! The topology that is claimed of each region, against Morse theory.

pub(crate) mod component;
mod descent;
mod joining;
mod landscape;
mod merging;
pub(crate) mod morse;
mod path;
mod rings;

use bifdiag_schema::{AtlasDocument, ComponentDocument, RegionDocument};

use crate::Refused;
use crate::order::orders::Orders;
use crate::order::regions::Sample;
use crate::order::slabs::Slab;
use component::{Component, documents, signature, words};
use merging::Merging;
use rings::Rings;

/// How U changes with h over the abscissa of a slab.
enum Landscape {
    Points(Merging),
    Circles(Rings),
}

/// Checks every region.
pub(crate) fn check(
    document: &AtlasDocument,
    orders: &Orders,
    slabs: &[Slab],
    samples: &[Sample],
) -> Result<(), Refused> {
    let mut known: Vec<Option<Landscape>> = slabs.iter().map(|_| None).collect();
    for (region, sample) in document.regions.iter().zip(samples) {
        let (number, position) = sample.cell;
        let open = || Refused::Region {
            region: region.id.clone(),
            why: "its topology is neither confirmed nor refuted: no path was proved",
        };
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
pub(crate) fn compare(region: &RegionDocument, found: &[ComponentDocument]) -> Result<(), Refused> {
    if found == region.components && signature(found) == region.signature {
        return Ok(());
    }
    let (region_id, claimed, found) = (region.id.clone(), words(&region.components), words(found));
    Err(if claimed == found {
        Refused::Region {
            region: region_id,
            why: "its energy surfaces, sections or signature do not follow from its U",
        }
    } else {
        Refused::Topology { region: region_id, claimed, found }
    })
}
