//! The topology that is claimed of each region, against boxes and Morse theory.

use dashu_ratio::RBig;
use schema::{AtlasDocument, CertificateDocument, ComponentDocument, RegionDocument};

use super::component::{Component, documents, signature, words};
use super::fixed::Fixed;
use super::morse::{Nature, nature};
use super::orders::Orders;
use super::regions::Cell;
use super::slabs::Slab;
use super::sphere::{self, Extrema, Function};
use super::{Refused, number};

/// Checks every region; those that the atlas leaves open, or that these boxes do not decide, are listed.
pub(super) fn check(
    document: &AtlasDocument,
    certificate: &CertificateDocument,
    orders: &Orders,
    slabs: &[Slab],
    cells: &[Vec<Cell>],
) -> Result<Vec<String>, Refused> {
    let mut open = Vec::new();
    for (region, cells) in document.regions.iter().zip(cells) {
        if region.components.is_empty() {
            open.push(region.id.clone());
            continue;
        }
        let (slab, position, h) = sample(certificate, region, slabs, cells)?;
        match components(orders, slab, position, &h)? {
            Some(found) => compare(region, &found)?,
            None => open.push(region.id.clone()),
        }
    }
    Ok(open)
}

/// The components that were found are those that a region claims.
pub(super) fn compare(region: &RegionDocument, found: &[ComponentDocument]) -> Result<(), Refused> {
    if found == region.components && signature(found) == region.signature {
        return Ok(());
    }
    let claimed = words(&region.components);
    Err(Refused::Topology { region: region.id.clone(), claimed, found: words(found) })
}

/// The sample of a region: a slab, the position of the curve below it, and h. It lies in the region.
fn sample<'a>(
    certificate: &CertificateDocument,
    region: &RegionDocument,
    slabs: &'a [Slab],
    cells: &[Cell],
) -> Result<(&'a Slab, usize, RBig), Refused> {
    let refuse = |why| Refused::Region { region: region.id.clone(), why };
    let sample = certificate.samples.iter().find(|sample| sample.region == region.id);
    let sample = sample.ok_or_else(|| refuse("it has no sample"))?;
    let slab = slabs.get(sample.slab).ok_or_else(|| refuse("its sample lies in no slab"))?;
    let h = number::read(&sample.h)?;
    let h_set = Fixed::of(&h);
    let below = slab.levels.iter().take_while(|level| level.height.below(&h_set)).count();
    let above = slab.levels.get(below).is_none_or(|level| h_set.below(&level.height));
    match below.checked_sub(1).filter(|_| above) {
        None => Err(refuse("its sample is not inside")),
        Some(position) if !cells.contains(&(sample.slab, position)) => Err(refuse("its sample lies in another region")),
        Some(position) => Ok((slab, position, h)),
    }
}

/// The components of U at the height h above a curve of a slab; `None` when the boxes do not decide.
fn components(
    orders: &Orders,
    slab: &Slab,
    position: usize,
    h: &RBig,
) -> Result<Option<Vec<ComponentDocument>>, Refused> {
    let (spaces, pieces) = (orders.spaces, orders.pieces);
    let has_poles = !spaces.active.is_empty();
    if position + 1 == slab.levels.len() {
        // Above every critical value U is the sphere.
        let poles = has_poles.then_some([true, true]);
        return Ok(Some(documents(&[Component { boundary_circles: 0, poles }])));
    }
    let mut extrema = Extrema { minima: Vec::new(), maxima: Vec::new(), pole: None };
    for (place, level) in slab.levels.iter().enumerate() {
        let piece = &pieces.list[level.curve];
        if !piece.critical {
            continue;
        }
        let refused = || Refused::Place { curve: piece.id.clone(), x: slab.x.to_f64().value() };
        match nature(spaces, piece.branch, &level.point).ok_or_else(refused)? {
            // Minima in U and maxima of its complement.
            Nature::Extremum(found) if found.minimum && place <= position => extrema.minima.extend(found.gamma),
            Nature::Extremum(found) if !found.minimum && place > position => extrema.maxima.extend(found.gamma),
            Nature::Extremum(_) | Nature::Saddle => {}
        }
    }
    extrema.pole = has_poles.then(|| spaces.r.each_ref().map(|r| r.to_f64().value()));
    let found = sphere::components(&Function::new(spaces, h, &slab.x), &extrema);
    Ok(found.map(|found| documents(&found)))
}
