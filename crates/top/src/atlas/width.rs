//! The largest extent of a region in h at one l.

use super::Atlas;
use crate::curves::{CurveId, Gap, Point};
use crate::diagram::{Cell, RegionId};
use numbers::root;

/// The gap between two curves over a slab.
struct Strip<'a> {
    atlas: &'a Atlas,
    lower: CurveId,
    upper: CurveId,
}

impl Atlas {
    /// The largest extent in h at one l of a region; `None` if unbounded.
    #[must_use]
    pub fn h_width(&self, region: RegionId) -> Option<f64> {
        let mut widest = 0.0_f64;
        for &Cell { slab, position } in &self.regions[region].cells {
            let strip = &self.arrangement.slabs[slab];
            let (lower, upper) = (strip.order[position], *strip.order.get(position + 1)?);
            widest = widest.max(Strip { atlas: self, lower, upper }.width(strip.x)?);
        }
        Some(self.energy(widest))
    }
}

impl Strip<'_> {
    fn points(&self, x: f64) -> [Point; 2] {
        let set = &self.atlas.arrangement.set;
        [self.upper, self.lower].map(|c| set.curves[c].point(&set.frame, x))
    }

    fn gap(&self, x: f64) -> f64 {
        let [upper, lower] = self.points(x);
        Gap::between(&self.atlas.arrangement.set.frame, &upper, &lower).value
    }

    /// Derivative of the gap: dh/dx = 1/J on both curves.
    fn slope(&self, x: f64) -> f64 {
        let [upper, lower] = self.points(x);
        upper.slope() - lower.slope()
    }

    /// The largest gap over a slab; `None` if it grows without bound.
    fn width(&self, x: [f64; 2]) -> Option<f64> {
        const SAMPLES: usize = 8;
        /// Far beyond every event a gap that stays finite has reached its limit.
        const FAR: f64 = 1e8;
        let set = &self.atlas.arrangement.set;
        let mut limit = 0.0_f64;
        let mut high = x[1];
        if high.is_infinite() {
            let asymptote = |c: CurveId| set.curves[c].arcs[set.curves[c].arcs.len() - 1].asymptote(&set.frame);
            if asymptote(self.lower).moment_gap(&set.frame, &asymptote(self.upper)) != 0.0 {
                return None;
            }
            high = FAR * x[0].max(1.0);
            limit = self.gap(high);
        }
        // The limits at l → 0 are reached to the last bit here.
        let low = if x[0] > 0.0 { x[0] } else { 1e-30 * high };
        let ratio = (high / low).sqrt().sqrt().sqrt();
        let geometric = (0..=SAMPLES).scan(low, |at, _| {
            let here = *at;
            *at = (here * ratio).min(high);
            Some(here)
        });
        let even = (1..SAMPLES).map(|k| low + (high - low) * k as f64 / SAMPLES as f64);
        let mut places: Vec<f64> = geometric.chain(even).collect();
        places.sort_by(f64::total_cmp);
        let gaps: Vec<f64> = places.iter().map(|&x| self.gap(x)).collect();
        let best = (0..gaps.len()).max_by(|&p, &q| gaps[p].total_cmp(&gaps[q]))?;
        let [from, to] = [places[best.saturating_sub(1)], places[(best + 1).min(places.len() - 1)]];
        let slopes = [self.slope(from), self.slope(to)];
        let refined = if slopes[0] > 0.0 && slopes[1] < 0.0 {
            self.gap(root::itp(from, to, slopes[0], slopes[1], 0.0, |x| self.slope(x)).at)
        } else {
            gaps[best]
        };
        Some(refined.max(gaps[best]).max(limit))
    }
}
