//! Regions of an atlas document.

use argmin::core::{CostFunction, Executor};
use argmin::solver::brent::BrentOpt;

use super::super::Atlas;
use super::super::names::curve_name;
use super::super::region::Region;
use super::window;
use crate::document::{
    CellDocument, ComponentDocument, MarginDocument, NeighbourDocument, RegionDocument, SampleDocument,
    UndecidedDocument, WindowDocument,
};
use crate::equilibria::{Gap, Pole};
use crate::topology::signature;

/// The regions, and whether a window left some out or cut one.
pub(super) fn documents(
    atlas: &Atlas,
    window: Option<&WindowDocument>,
    undecided: &mut Vec<UndecidedDocument>,
) -> (Vec<RegionDocument>, bool) {
    let mut clipped = false;
    let mut documents = Vec::new();
    for number in 0..atlas.regions.len() {
        let document = document(atlas, number, undecided);
        match window {
            None => documents.push(document),
            Some(window) => {
                let seen = clip(atlas, &atlas.regions[number], document, window);
                clipped |= seen.as_ref().is_none_or(|document| document.clipped);
                documents.extend(seen);
            }
        }
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

/// Id of a region.
fn region_id(number: usize) -> String {
    format!("R{}", number + 1)
}

fn document(atlas: &Atlas, number: usize, undecided: &mut Vec<UndecidedDocument>) -> RegionDocument {
    let region = &atlas.regions[number];
    let arrangement = &atlas.arrangement;
    let name = |c: usize| curve_name(&arrangement.set, c);
    let sample = SampleDocument {
        h: atlas.energy(region.sample.h),
        l: atlas.momentum(region.sample.x),
        margin: MarginDocument {
            h: atlas.energy(region.sample.margin),
            nearest: name(region.sample.nearest),
            error_bound: atlas.energy(region.sample.error),
        },
    };
    let components = match &region.components {
        Ok(components) => components.as_slice(),
        Err(error) => {
            undecided.push(UndecidedDocument {
                what: format!("the components of U in region {}: {error}", region_id(number)),
                l: sample.l,
                h: sample.h,
                curves: Vec::new(),
            });
            &[]
        }
    };
    let (mut boundary, mut neighbours) = (Vec::new(), Vec::new());
    for &(slab, position) in &region.cells {
        let strip = &arrangement.slabs[slab];
        let below = position.checked_sub(1).map(|p| strip.face_above[p]);
        let mut across = vec![(strip.order[position], below)];
        if let Some(&upper) = strip.order.get(position + 1) {
            across.push((upper, Some(strip.face_above[position + 1])));
        }
        for (curve, face) in across {
            for id in labels(atlas, curve) {
                if !boundary.contains(&id) {
                    boundary.push(id);
                }
            }
            let neighbour = NeighbourDocument { region: face.map(region_id), curve: name(curve) };
            if !neighbours.contains(&neighbour) {
                neighbours.push(neighbour);
            }
        }
    }
    let slabs = region.cells.iter().map(|&(slab, _)| arrangement.slabs[slab].x);
    let from = slabs.clone().map(|x| x[0]).fold(f64::INFINITY, f64::min);
    let to = slabs.map(|x| x[1]).fold(0.0, f64::max);
    let h_width = width(atlas, region);
    RegionDocument {
        id: region_id(number),
        sample,
        components: components.iter().map(ComponentDocument::from).collect(),
        signature: if components.is_empty() { None } else { signature(components) },
        bounded: to.is_finite() && h_width.is_some(),
        l_range: [Some(atlas.momentum(from)), to.is_finite().then(|| atlas.momentum(to))],
        h_width: h_width.map(|h| atlas.energy(h)),
        boundary,
        neighbours,
        cells: cells(atlas, region),
        clipped: false,
    }
}

/// Ids of a curve and of the pole line that runs on it.
fn labels(atlas: &Atlas, curve: usize) -> Vec<String> {
    let set = &atlas.arrangement.set;
    let pole = set.curves[curve].pole.filter(|_| set.curves[curve].is_critical()).map(|pole| match pole {
        Pole::Plus => "P+".to_owned(),
        Pole::Minus => "P-".to_owned(),
    });
    std::iter::once(curve_name(set, curve)).chain(pole).collect()
}

fn cells(atlas: &Atlas, region: &Region) -> Vec<CellDocument> {
    let arrangement = &atlas.arrangement;
    let name = |c: usize| curve_name(&arrangement.set, c);
    let mut cells: Vec<(usize, usize)> = region.cells.clone();
    cells.sort_unstable();
    cells
        .into_iter()
        .map(|(slab, position)| {
            let strip = &arrangement.slabs[slab];
            CellDocument {
                l_range: strip.x.map(|x| x.is_finite().then(|| atlas.momentum(x))),
                lower: name(strip.order[position]),
                upper: strip.order.get(position + 1).map(|&c| name(c)),
            }
        })
        .collect()
}

/// The gap between two curves as a cost, in the variable t = x/(1 + x) that brings infinity near.
struct Narrowness<'a> {
    atlas: &'a Atlas,
    lower: usize,
    upper: usize,
}

impl Narrowness<'_> {
    fn gap(&self, x: f64) -> f64 {
        let set = &self.atlas.arrangement.set;
        let point = |c: usize| set.curves[c].point(&set.frame, x);
        Gap::between(&set.frame, &point(self.upper), &point(self.lower)).value
    }
}

impl CostFunction for Narrowness<'_> {
    type Param = f64;
    type Output = f64;

    fn cost(&self, x: &f64) -> Result<f64, argmin::core::Error> {
        Ok(-self.gap(*x))
    }
}

/// The largest extent in h at one l, in the frame's units; `None` if unbounded.
fn width(atlas: &Atlas, region: &Region) -> Option<f64> {
    let mut widest = 0.0_f64;
    for &(slab, position) in &region.cells {
        let strip = &atlas.arrangement.slabs[slab];
        let (lower, upper) = (strip.order[position], *strip.order.get(position + 1)?);
        widest = widest.max(cell_width(&Narrowness { atlas, lower, upper }, strip.x)?);
    }
    Some(widest)
}

/// The largest gap over one slab; `None` if it grows without bound.
fn cell_width(cost: &Narrowness, x: [f64; 2]) -> Option<f64> {
    const SAMPLES: usize = 8;
    /// Far beyond every event a gap that stays finite has reached its limit.
    const FAR: f64 = 1e8;
    let set = &cost.atlas.arrangement.set;
    let mut limit = 0.0_f64;
    let mut high = x[1];
    if high.is_infinite() {
        let asymptote = |c: usize| set.curves[c].arcs[set.curves[c].arcs.len() - 1].asymptote(&set.frame);
        if asymptote(cost.lower).moment_gap(&set.frame, &asymptote(cost.upper)) != 0.0 {
            return None;
        }
        high = FAR * x[0].max(1.0);
        limit = cost.gap(high);
    }
    // The limits at l → 0 are reached to the last bit here.
    let low = if x[0] > 0.0 { x[0] } else { 1e-30 * high };
    let ratio = (high / low).sqrt().sqrt().sqrt();
    let places: Vec<f64> = (0..=SAMPLES)
        .scan(low, |at, _| {
            let here = *at;
            *at = (here * ratio).min(high);
            Some(here)
        })
        .chain((1..SAMPLES).map(|k| low + (high - low) * k as f64 / SAMPLES as f64))
        .collect();
    let mut sorted = places;
    sorted.sort_by(f64::total_cmp);
    let gaps: Vec<f64> = sorted.iter().map(|&x| cost.gap(x)).collect();
    let best = (0..gaps.len()).max_by(|&p, &q| gaps[p].total_cmp(&gaps[q]))?;
    let bracket = (sorted[best.saturating_sub(1)], sorted[(best + 1).min(sorted.len() - 1)]);
    let refined = Executor::new(Narrowness { ..*cost }, BrentOpt::new(bracket.0, bracket.1))
        .configure(|state| state.max_iters(40))
        .timer(false)
        .run()
        .map_or(gaps[best], |result| -result.state().get_best_cost());
    Some(refined.max(gaps[best]).max(limit))
}

/// The region as far as it lies in a window; `None` when it does not.
fn clip(atlas: &Atlas, region: &Region, document: RegionDocument, window: &WindowDocument) -> Option<RegionDocument> {
    const PLACES: usize = 24;
    let set = &atlas.arrangement.set;
    let unit = set.frame.momentum_unit;
    let mut best: Option<SampleDocument> = None;
    let mut clipped = false;
    for &(slab, position) in &region.cells {
        let strip = &atlas.arrangement.slabs[slab];
        let l = strip.x.map(|x| atlas.momentum(x));
        clipped |= l[0] < window.l[0] || l[1] > window.l[1];
        let Some([from, to]) = window::clip_l(window, l) else { continue };
        for place in 0..PLACES {
            let at = from + (to - from) * (place as f64 + 0.5) / PLACES as f64;
            let x = 0.5 * (at / unit) * (at / unit);
            let height = |c: usize| {
                let point = set.curves[c].point(&set.frame, x);
                (atlas.energy(point.h()), atlas.energy(point.h_error()))
            };
            let (low, error) = height(strip.order[position]);
            let high = strip.order.get(position + 1).map_or(f64::INFINITY, |&c| height(c).0);
            clipped |= low < window.h[0] || high > window.h[1];
            let (low_seen, high_seen) = (low.max(window.h[0]), high.min(window.h[1]));
            let half = 0.5 * (high_seen - low_seen);
            if half > 0.0 && best.as_ref().is_none_or(|sample| half > 0.5 * sample.margin.h) {
                let h = 0.5 * (low_seen + high_seen);
                let to_lower = h - low <= high - h;
                let nearest = if to_lower { position } else { position + 1 };
                let margin = (h - low).min(high - h);
                let nearest = curve_name(set, strip.order[nearest]);
                let candidate =
                    SampleDocument { h, l: at, margin: MarginDocument { h: margin, nearest, error_bound: error } };
                if best.as_ref().is_none_or(|sample| margin > sample.margin.h) {
                    best = Some(candidate);
                }
            }
        }
    }
    let mut sample = best?;
    if window::contains(window, document.sample.h, document.sample.l) {
        sample = document.sample;
    }
    Some(RegionDocument { sample, clipped, ..document })
}
