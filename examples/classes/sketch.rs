//! A class as a small picture: its diagram with events at even steps of l and curves at even steps of h.
//!
//! Nothing but the class shows: the order of the events that have nothing to do with each other is that of the witness.

use std::collections::BTreeMap;
use std::fmt::{self, Write};

use bifdiag_diagram::arrangement::{Arrangement, RegionId, Slab};
use bifdiag_diagram::atlas::Atlas;
use bifdiag_equilibria::curves::{Curve, CurveId, Orbit};

/// So wide that a label fits between curves that meet at both ends of a step.
const STEP: f64 = 46.0;
const RISE: f64 = 22.0;
const MARGIN: f64 = 14.0;

/// The picture as SVG.
pub fn sketch(atlas: &Atlas) -> Result<String, fmt::Error> {
    let sheet = Sheet::new(atlas);
    let [width, height] = sheet.size;
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" font-family=\"sans-serif\" font-size=\"8.5\">"
    );
    out.push_str("<style>path{fill:none;stroke-width:1.6}.m{stroke:#1f5fa8}.s{stroke:#2e8b57}.x{stroke:#b3322b}");
    out.push_str(".p{stroke:#777;stroke-dasharray:4 2}text{text-anchor:middle;fill:#444}</style>");
    write!(out, "<rect width=\"{width}\" height=\"{height}\" fill=\"#fff\"/>")?;
    for (id, curve) in atlas.arrangement().set.curves.pairs() {
        write!(out, "<path class=\"{}\" d=\"{}\"/>", kind(curve), path(&sheet.course(id))?)?;
    }
    for (region, [slab, place]) in labels(atlas) {
        let [x, y] = sheet.at(slab, 0.5, place as f64 + 0.5);
        write!(out, "<text x=\"{x:.0}\" y=\"{:.0}\">{region}</text>", y + 3.0)?;
    }
    out.push_str("</svg>\n");
    Ok(out)
}

/// The slabs between events, a step wide each.
struct Sheet<'a> {
    arrangement: &'a Arrangement,
    slabs: Vec<&'a Slab>,
    size: [f64; 2],
}

impl<'a> Sheet<'a> {
    fn new(atlas: &'a Atlas) -> Self {
        let arrangement = atlas.arrangement();
        let slabs: Vec<_> = arrangement.slabs.iter().collect();
        let most = slabs.iter().map(|slab| slab.order.len()).max().unwrap_or(1) as f64;
        let size = [2.0 * MARGIN + STEP * slabs.len() as f64, 2.0 * MARGIN + RISE * (most + 1.0)];
        Self { arrangement, slabs, size }
    }

    /// A place within a slab. The lowest curve, which every slab has, is level.
    fn at(&self, slab: usize, share: f64, rank: f64) -> [f64; 2] {
        [MARGIN + STEP * (slab as f64 + share), self.size[1] - MARGIN - RISE * (rank + 0.7)]
    }

    fn rank(&self, slab: usize, curve: CurveId) -> Option<f64> {
        self.slabs[slab].order.iter().position(|c| *c == curve).map(|place| place as f64)
    }

    /// Where the curves of an event meet: between the slabs beside it.
    fn meeting(&self, event: usize, curve: CurveId) -> Option<f64> {
        let change = self.arrangement.events.iter().nth(event)?.change;
        let curves = change.curves();
        curves.contains(&curve).then(|| {
            let beside = |c: &CurveId| [self.rank(event, *c), self.rank(event + 1, *c)];
            let ranks: Vec<f64> = curves.iter().flat_map(beside).flatten().collect();
            ranks.iter().sum::<f64>() / ranks.len().max(1) as f64
        })
    }

    /// The places through which a curve goes.
    fn course(&self, curve: CurveId) -> Vec<[f64; 2]> {
        let mut course = Vec::new();
        for slab in 0..self.slabs.len() {
            let Some(here) = self.rank(slab, curve) else { continue };
            let begin = match slab.checked_sub(1) {
                Some(event) => self.meeting(event, curve),
                None => Some(here),
            };
            let end = self.meeting(slab, curve).or((slab + 1 == self.slabs.len()).then_some(here));
            course.extend(begin.map(|rank| self.at(slab, 0.0, rank)));
            course.push(self.at(slab, 0.5, here));
            course.extend(end.map(|rank| self.at(slab, 1.0, rank)));
        }
        course
    }
}

/// A smooth line, level at each place.
fn path(course: &[[f64; 2]]) -> Result<String, fmt::Error> {
    let mut path = String::new();
    if let Some([x, y]) = course.first() {
        write!(path, "M{x:.0} {y:.0}")?;
    }
    for ([x0, y0], [x1, y1]) in course.iter().zip(course.iter().skip(1)) {
        let half = 0.5 * (x0 + x1);
        write!(path, "C{half:.0} {y0:.0} {half:.0} {y1:.0} {x1:.0} {y1:.0}")?;
    }
    Ok(path)
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
