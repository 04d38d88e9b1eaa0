//! Regions of an atlas document.

use bifdiag_diagram::arrangement::{Cell, RegionId};
use bifdiag_diagram::atlas::{Atlas, Region, SamplePoint, Window};
use bifdiag_diagram::topology::signature;
use bifdiag_equilibria::curves::{CurveId, CurveName};
use bifdiag_schema::{CellDocument, NeighbourDocument, RegionDocument, SampleDocument, UndecidedDocument};

use crate::classification::{components, margin};

/// The regions, and whether a window left some out or cut one.
pub(super) fn documents(
    atlas: &Atlas,
    window: Option<&Window>,
    undecided: &mut Vec<UndecidedDocument>,
) -> (Vec<RegionDocument>, bool) {
    let mut clipped = false;
    let mut documents = Vec::new();
    for number in atlas.regions().ids() {
        let document = document(atlas, number, undecided);
        let Some(window) = window else {
            documents.push(document);
            continue;
        };
        let Some((sample, cut)) = atlas.seen_in(number, window) else {
            clipped = true;
            continue;
        };
        clipped |= cut;
        documents.push(RegionDocument { sample: sample_document(&sample), clipped: cut, ..document });
    }
    if window.is_some() {
        // Neighbours outside the window are not listed, so nothing may point to them.
        let listed: Vec<String> = documents.iter().map(|document| document.id.clone()).collect();
        for document in &mut documents {
            document.neighbours.retain(|neighbour| neighbour.region.as_ref().is_none_or(|id| listed.contains(id)));
        }
    }
    (documents, clipped)
}

fn sample_document(sample: &SamplePoint) -> SampleDocument {
    SampleDocument { h: sample.h, l: sample.l, margin: margin(&sample.margin) }
}

fn document(atlas: &Atlas, number: RegionId, undecided: &mut Vec<UndecidedDocument>) -> RegionDocument {
    let region = &atlas.regions()[number];
    let sample = sample_document(&atlas.sample(number));
    let of_u = match &region.components {
        Ok(components) => components.as_slice(),
        Err(error) => {
            undecided.push(UndecidedDocument {
                what: format!("the components of U in region {number}: {error}"),
                l: sample.l,
                h: sample.h,
                curves: Vec::new(),
            });
            &[]
        }
    };
    let edges = atlas.edges(number);
    let mut boundary: Vec<String> = Vec::new();
    for id in edges.iter().flat_map(|(curve, _)| labels(atlas, *curve)) {
        if !boundary.contains(&id) {
            boundary.push(id);
        }
    }
    let neighbour = |&(curve, beyond): &(CurveId, Option<RegionId>)| NeighbourDocument {
        region: beyond.map(|region| region.to_string()),
        curve: CurveName::of(&atlas.arrangement().set, curve).to_string(),
    };
    let [from, to] = atlas.range(number);
    RegionDocument {
        id: number.to_string(),
        sample,
        components: components(of_u),
        signature: if of_u.is_empty() { None } else { signature(of_u) },
        bounded: atlas.is_bounded(number),
        l_range: [Some(atlas.momentum(from)), to.is_finite().then(|| atlas.momentum(to))],
        boundary,
        neighbours: edges.iter().map(neighbour).collect(),
        cells: cells(atlas, region),
        clipped: false,
    }
}

/// Ids of a curve and of the pole line that runs on it.
fn labels(atlas: &Atlas, curve: CurveId) -> Vec<String> {
    let set = &atlas.arrangement().set;
    let pole = set.curves[curve].pole.filter(|_| set.curves[curve].is_critical()).map(CurveName::Pole);
    std::iter::once(CurveName::of(set, curve)).chain(pole).map(|name| name.to_string()).collect()
}

fn cells(atlas: &Atlas, region: &Region) -> Vec<CellDocument> {
    let arrangement = atlas.arrangement();
    let name = |c: CurveId| CurveName::of(&arrangement.set, c).to_string();
    let mut cells: Vec<Cell> = region.cells.clone();
    cells.sort_unstable();
    cells
        .into_iter()
        .map(|Cell { slab, position }| {
            let strip = &arrangement.slabs[slab];
            CellDocument {
                l_range: strip.x.map(|x| x.is_finite().then(|| atlas.momentum(x))),
                lower: name(strip.order[position]),
                upper: strip.order.get(position + 1).map(|&c| name(c)),
            }
        })
        .collect()
}
