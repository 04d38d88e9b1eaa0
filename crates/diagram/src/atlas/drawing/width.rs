//! The largest extents of the regions in h at one l.

use std::cell::OnceCell;

use crate::arrangement::{RegionId, Slab};
use crate::atlas::Atlas;
use bifdiag_equilibria::curves::{CriticalSet, CurveId, Gap, Point};
use bifdiag_numbers::root;
use bifdiag_numbers::table::Table;

impl Atlas {
    /// For each region its largest extent in h at one l; `None` if unbounded.
    #[must_use]
    pub fn h_widths(&self) -> Table<RegionId, Option<f64>> {
        let mut widths = self.regions.map(|_| Some(0.0_f64));
        for slab in &self.arrangement.slabs {
            let strips = Strips::new(&self.arrangement.set, slab);
            for (position, &region) in slab.region_above.iter().enumerate() {
                if let Some(widest) = widths[region] {
                    widths[region] = strips.width(position).map(|width| widest.max(width));
                }
            }
        }
        widths.map(|width| width.map(|width| self.energy(width)))
    }
}

/// The gaps between the curves of a slab.
struct Strips<'a> {
    set: &'a CriticalSet,
    order: &'a [CurveId],
    /// Over an unbounded slab: far enough out that a gap that stays finite has reached its limit.
    far: Option<f64>,
    /// Places at which all gaps are taken, by rising x.
    places: Vec<f64>,
    /// The points of each curve there.
    points: Vec<OnceCell<Vec<Point>>>,
}

impl<'a> Strips<'a> {
    fn new(set: &'a CriticalSet, slab: &'a Slab) -> Self {
        const SAMPLES: usize = 8;
        const FAR: f64 = 1e8;
        let [from, to] = slab.x;
        let far = to.is_infinite().then(|| FAR * from.max(1.0));
        let high = far.unwrap_or(to);
        // The limits at l → 0 are reached to the last bit here.
        let low = if from > 0.0 { from } else { 1e-30 * high };
        let ratio = (high / low).sqrt().sqrt().sqrt();
        let geometric = (0..=SAMPLES).scan(low, |at, _| {
            let here = *at;
            *at = (here * ratio).min(high);
            Some(here)
        });
        let even = (1..SAMPLES).map(|k| low + (high - low) * k as f64 / SAMPLES as f64);
        let mut places: Vec<f64> = geometric.chain(even).collect();
        places.sort_by(f64::total_cmp);
        Self { set, order: &slab.order, far, places, points: vec![OnceCell::new(); slab.order.len()] }
    }

    fn point(&self, position: usize, x: f64) -> Point {
        self.set.curves[self.order[position]].point(&self.set.frame, x)
    }

    fn points(&self, position: usize) -> &[Point] {
        self.points[position].get_or_init(|| self.places.iter().map(|&x| self.point(position, x)).collect())
    }

    /// The largest gap above the curve at a position; `None` if it is or grows without bound.
    fn width(&self, position: usize) -> Option<f64> {
        let pair = [position, position + 1];
        let [lower, upper] = [self.order[position], *self.order.get(position + 1)?];
        let gap = |[lower, upper]: [&Point; 2]| Gap::between(&self.set.frame, upper, lower).value;
        let slope = |[lower, upper]: [&Point; 2]| Gap::slope(&self.set.frame, upper, lower);
        let at = |x: f64| pair.map(|position| self.point(position, x));
        let mut limit = 0.0_f64;
        if let Some(far) = self.far {
            let curves = &self.set.curves;
            let asymptote = |c: CurveId| curves[c].arcs[curves[c].arcs.len() - 1].asymptote(&self.set.frame);
            if asymptote(lower).moment_gap(&self.set.frame, &asymptote(upper)) != 0.0 {
                return None;
            }
            limit = gap(at(far).each_ref());
        }
        let points = pair.map(|position| self.points(position));
        let here = |place: usize| points.map(|points| &points[place]);
        let gaps: Vec<f64> = (0..self.places.len()).map(|place| gap(here(place))).collect();
        let mut widest = gaps.iter().fold(limit, |widest, gap| widest.max(*gap));
        for from in 1..gaps.len() {
            let ends = [from - 1, from];
            let [[x, y], slopes] = [ends.map(|place| self.places[place]), ends.map(|place| slope(here(place)))];
            if slopes[0] > 0.0 && slopes[1] < 0.0 {
                let top = root::itp(x, y, slopes[0], slopes[1], 0.0, |x| slope(at(x).each_ref()));
                widest = widest.max(gap(at(top).each_ref()));
            }
        }
        Some(widest)
    }
}
