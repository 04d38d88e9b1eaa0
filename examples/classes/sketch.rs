//! A class as a small picture: its diagram with events at even steps of l and curves at even steps of h.
//!
//! Nothing but the class shows: the order of the events that have nothing to do with each other is that of the witness.

use std::collections::BTreeMap;
use std::fmt::Write;

use top::atlas::Atlas;
use top::curves::{Curve, CurveId, Orbit};
use top::diagram::RegionId;

/// So wide that a label fits between curves that meet at both ends of a step.
const STEP: f64 = 46.0;
const RISE: f64 = 22.0;
const MARGIN: f64 = 14.0;

/// The picture as SVG.
pub fn sketch(atlas: &Atlas) -> String {
    let arrangement = atlas.arrangement();
    let slabs: Vec<_> = arrangement.slabs.iter().collect();
    let most = slabs.iter().map(|slab| slab.order.len()).max().unwrap_or(1) as f64;
    let size = [2.0 * MARGIN + STEP * slabs.len() as f64, 2.0 * MARGIN + RISE * (most + 1.0)];
    let x = |slab: usize, share: f64| MARGIN + STEP * (slab as f64 + share);
    // The lowest curve, which every slab has, is level.
    let y = |place: f64| size[1] - MARGIN - RISE * (place + 0.7);
    let rank = |slab: usize, curve: CurveId| slabs[slab].order.iter().position(|c| *c == curve).map(|p| p as f64);
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" font-family=\"sans-serif\" font-size=\"8.5\">",
        size[0], size[1]
    );
    out.push_str("<style>path{fill:none;stroke-width:1.6}.m{stroke:#1f5fa8}.s{stroke:#2e8b57}.x{stroke:#b3322b}");
    out.push_str(".p{stroke:#777;stroke-dasharray:4 2}text{text-anchor:middle;fill:#444}</style>");
    let _always = write!(out, "<rect width=\"{}\" height=\"{}\" fill=\"#fff\"/>", size[0], size[1]);
    // Where the curves of an event meet: between the slabs beside it.
    let meeting = |event: usize, curve: CurveId| {
        let change = arrangement.events.iter().nth(event)?.change;
        let curves = change.curves();
        curves.contains(&curve).then(|| {
            let ranks: Vec<f64> =
                curves.iter().flat_map(|c| [rank(event, *c), rank(event + 1, *c)]).flatten().collect();
            ranks.iter().sum::<f64>() / ranks.len().max(1) as f64
        })
    };
    for (id, curve) in arrangement.set.curves.pairs() {
        let mut path = String::new();
        let mut last: Option<[f64; 2]> = None;
        let mut go = |to: [f64; 2]| {
            match last {
                None => write!(path, "M{:.0} {:.0}", to[0], to[1]),
                Some(from) => {
                    let half = 0.5 * (from[0] + to[0]);
                    write!(path, "C{half:.0} {:.0} {half:.0} {:.0} {:.0} {:.0}", from[1], to[1], to[0], to[1])
                }
            }
            .unwrap_or_default();
            last = Some(to);
        };
        for slab in 0..slabs.len() {
            let Some(here) = rank(slab, id) else { continue };
            let before = slab.checked_sub(1).and_then(|event| meeting(event, id));
            match before {
                Some(place) => go([x(slab, 0.0), y(place)]),
                None if slab == 0 => go([x(0, 0.0), y(here)]),
                None => {}
            }
            go([x(slab, 0.5), y(here)]);
            if let Some(place) = meeting(slab, id) {
                go([x(slab, 1.0), y(place)]);
            } else if slab + 1 == slabs.len() {
                go([x(slab, 1.0), y(here)]);
            }
        }
        let _always = write!(out, "<path class=\"{}\" d=\"{path}\"/>", kind(curve));
    }
    for (region, [slab, place]) in labels(atlas) {
        let (x, y) = (x(slab, 0.5), y(place as f64 + 0.5) + 3.0);
        let _always = write!(out, "<text x=\"{x:.0}\" y=\"{y:.0}\">{region}</text>");
    }
    out.push_str("</svg>\n");
    out
}

fn kind(curve: &Curve) -> char {
    match (curve.orbit, curve.index) {
        (Orbit::Pole(_), _) | (_, None) => 'p',
        (_, Some(0)) => 'm',
        (_, Some(2)) => 'x',
        _ => 's',
    }
}

/// Where each region is named: the slab, and the place of the curve below it there. Of the slabs in which the region goes on
/// level on most sides, the one nearest to its middle.
fn labels(atlas: &Atlas) -> BTreeMap<RegionId, [usize; 2]> {
    let mut cells: BTreeMap<RegionId, Vec<[usize; 2]>> = BTreeMap::new();
    for (number, slab) in atlas.arrangement().slabs.iter().enumerate() {
        for (place, region) in slab.region_above.iter().enumerate() {
            cells.entry(*region).or_default().push([number, place]);
        }
    }
    let best = |cells: Vec<[usize; 2]>| {
        let level = |[slab, place]: [usize; 2]| {
            let beside = [slab.checked_sub(1), Some(slab + 1)];
            beside.into_iter().flatten().filter(|&slab| cells.contains(&[slab, place])).count()
        };
        let off = |k: usize| k.abs_diff(cells.len() / 2);
        let chosen = (0..cells.len()).max_by_key(|&k| (level(cells[k]), std::cmp::Reverse(off(k)))).unwrap_or_default();
        cells[chosen]
    };
    cells.into_iter().map(|(region, cells)| (region, best(cells))).collect()
}
