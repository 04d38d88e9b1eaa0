//! The regions of the atlas against the faces: cells, boundaries, neighbours, totals.

use bifdiag_schema::{AtlasDocument, CertificateDocument, RegionDocument};
use dashu_ratio::RBig;

use super::orders::Orders;
use super::slabs::Slab;
use crate::Refused;
use crate::equilibria::pieces::{Branch, Pieces};
use crate::numbers::number;

/// A cell: a slab, and the position in it of the curve below.
pub(crate) type Cell = (usize, usize);

/// The point of a region that the certificate gives: its cell, and its h in the certificate's unit.
pub(crate) struct Sample {
    pub cell: Cell,
    pub h: RBig,
}

/// What a face is made of, in the terms of a document: by its cells with l, then h, rising, the curve below before the one
/// above.
#[derive(Default)]
struct Face {
    cells: Vec<Cell>,
    /// The curves below and above each cell.
    described: Vec<(String, Option<String>)>,
    boundary: Vec<String>,
    neighbours: Vec<(Option<String>, String)>,
}

/// Compares the regions of the atlas with the faces; the cells of each.
pub(crate) fn regions(
    document: &AtlasDocument,
    certificate: &CertificateDocument,
    pieces: &Pieces,
    slabs: &[Slab],
) -> Result<Vec<Vec<Cell>>, Refused> {
    let mut names: Vec<&str> = slabs.iter().flat_map(|slab| slab.faces.iter().map(String::as_str)).collect();
    names.sort_unstable();
    names.dedup();
    let sources: usize = certificate.events.iter().map(|event| event.sources.len()).sum();
    for (what, claimed, found) in [
        ("regions", document.regions.len(), names.len()),
        ("regions", document.summary.regions, names.len()),
        ("events", document.summary.events, sources),
        ("events", document.events.len(), sources),
    ] {
        if claimed != found {
            return Err(Refused::Summary { what, claimed, found });
        }
    }
    let named = |(number, region): (usize, &RegionDocument)| region.id == format!("R{}", number + 1);
    if !document.regions.iter().enumerate().all(named) {
        return Err(Refused::Field { field: "regions.id" });
    }
    let cells = |region: &RegionDocument| {
        let face = Face::named(&region.id, pieces, slabs);
        face.compared(region).map_err(|why| Refused::Region { region: region.id.clone(), why })
    };
    document.regions.iter().map(cells).collect()
}

/// The sample of each region, which lies in it.
pub(crate) fn samples(
    document: &AtlasDocument,
    certificate: &CertificateDocument,
    orders: &Orders,
    slabs: &[Slab],
    cells: &[Vec<Cell>],
) -> Result<Vec<Sample>, Refused> {
    if certificate.samples.len() > document.regions.len() {
        return Err(Refused::Field { field: "certificate.samples" });
    }
    let found = |(number, (region, cells)): (usize, (&RegionDocument, &Vec<Cell>))| {
        let refuse = |why| Refused::Region { region: region.id.clone(), why };
        let sample = certificate.samples.get(number).filter(|sample| sample.region == region.id);
        let sample = sample.ok_or_else(|| refuse("it has no sample at its place"))?;
        let slab = slabs.get(sample.slab).ok_or_else(|| refuse("its sample lies in no slab"))?;
        let exact = number::read(&sample.h)?;
        let h = orders.spaces.set(&exact);
        let below = slab.levels.iter().take_while(|level| level.height.below(&h)).count();
        let above = slab.levels.get(below).is_none_or(|level| h.below(&level.height));
        match below.checked_sub(1).filter(|_| above) {
            None => Err(refuse("its sample is not inside")),
            Some(position) if !cells.contains(&(sample.slab, position)) => {
                Err(refuse("its sample lies in another region"))
            }
            Some(position) => Ok(Sample { cell: (sample.slab, position), h: exact }),
        }
    };
    document.regions.iter().zip(cells).enumerate().map(found).collect()
}

impl Face {
    fn named(name: &str, pieces: &Pieces, slabs: &[Slab]) -> Self {
        let mut face = Self::default();
        for (number, slab) in slabs.iter().enumerate() {
            for position in (0..slab.faces.len()).filter(|&k| slab.faces[k] == name) {
                face.add((number, position), pieces, slab);
            }
        }
        face
    }

    fn add(&mut self, cell: Cell, pieces: &Pieces, slab: &Slab) {
        let id = |curve: usize| pieces.list[curve].id.clone();
        let position = cell.1;
        let lower = slab.levels[position].curve;
        let upper = slab.levels.get(position + 1).map(|level| level.curve);
        let below = position.checked_sub(1).map(|k| slab.faces[k].clone());
        let above = upper.map(|upper| (Some(slab.faces[position + 1].clone()), upper));
        for (face, curve) in [(below, lower)].into_iter().chain(above) {
            add_new(&mut self.boundary, id(curve));
            // A critical line is also a pole line.
            if let (true, Branch::Line(plus)) = (pieces.list[curve].critical, pieces.list[curve].branch) {
                add_new(&mut self.boundary, if plus { "P+" } else { "P-" }.to_owned());
            }
            add_new(&mut self.neighbours, (face, id(curve)));
        }
        self.described.push((id(lower), upper.map(id)));
        self.cells.push(cell);
    }

    /// The cells, if the region describes this face.
    fn compared(self, region: &RegionDocument) -> Result<Vec<Cell>, &'static str> {
        let described = region.cells.iter().map(|cell| (&cell.lower, cell.upper.as_ref()));
        if self.cells.is_empty() || !described.eq(self.described.iter().map(|(p, q)| (p, q.as_ref()))) {
            return Err("its cells are not those of the face");
        }
        if region.boundary != self.boundary {
            return Err("its boundary is another");
        }
        let neighbours = region.neighbours.iter().map(|n| (&n.region, &n.curve));
        let found = self.neighbours.iter().map(|(region, curve)| (region, curve));
        if neighbours.eq(found) { Ok(self.cells) } else { Err("its neighbours are others") }
    }
}

fn add_new<T: PartialEq>(list: &mut Vec<T>, entry: T) {
    if !list.contains(&entry) {
        list.push(entry);
    }
}
