//! The part of the (h, l) plane that was asked for.

use super::{Atlas, Margin};
use crate::arrangement::{Cell, RegionId};
use bifdiag_equilibria::curves::{CurveId, CurveName};

/// A part of the (h, l) plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Window {
    /// Energies.
    pub h: [f64; 2],
    /// Vertical angular momenta.
    pub l: [f64; 2],
}

/// A point inside a region, with its distance to the boundary, in the body's units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SamplePoint {
    /// Energy.
    pub h: f64,
    /// Vertical angular momentum.
    pub l: f64,
    /// Distance to the boundary.
    pub margin: Margin,
}

impl Window {
    /// True when the point lies in the window.
    #[must_use]
    pub fn contains(&self, h: f64, l: f64) -> bool {
        (self.h[0]..=self.h[1]).contains(&h) && (self.l[0]..=self.l[1]).contains(&l)
    }

    /// The part of a range of l inside the window.
    fn clip_l(&self, l: [f64; 2]) -> Option<[f64; 2]> {
        let clipped = [l[0].max(self.l[0]), l[1].min(self.l[1])];
        (clipped[0] < clipped[1]).then_some(clipped)
    }
}

impl Atlas {
    /// The sample of a region.
    #[must_use]
    pub fn sample(&self, region: RegionId) -> SamplePoint {
        let sample = &self.regions[region].sample;
        SamplePoint {
            h: self.energy(sample.h),
            l: self.momentum(sample.x),
            margin: Margin {
                h: self.energy(sample.margin),
                nearest: Some(CurveName::of(&self.arrangement.set, sample.nearest)),
                error_bound: self.energy(sample.error),
            },
        }
    }

    /// A sample of a region inside a window, and whether the window cuts the region; `None` when no part of it is seen.
    #[must_use]
    pub fn seen_in(&self, region: RegionId, window: &Window) -> Option<(SamplePoint, bool)> {
        const PLACES: usize = 24;
        let set = &self.arrangement.set;
        let unit = set.frame.momentum_unit;
        let mut best: Option<SamplePoint> = None;
        let mut clipped = false;
        for &Cell { slab, position } in &self.regions[region].cells {
            let strip = &self.arrangement.slabs[slab];
            let l = strip.x.map(|x| self.momentum(x));
            clipped |= l[0] < window.l[0] || l[1] > window.l[1];
            let Some([from, to]) = window.clip_l(l) else { continue };
            for place in 0..PLACES {
                let at = from + (to - from) * (place as f64 + 0.5) / PLACES as f64;
                let x = 0.5 * (at / unit) * (at / unit);
                let height = |c: CurveId| {
                    let point = set.curves[c].point(&set.frame, x);
                    (self.energy(point.h()), self.energy(point.h_error()))
                };
                let (low, error_bound) = height(strip.order[position]);
                let high = strip.order.get(position + 1).map_or(f64::INFINITY, |&c| height(c).0);
                clipped |= low < window.h[0] || high > window.h[1];
                let (low_seen, high_seen) = (low.max(window.h[0]), high.min(window.h[1]));
                let half = 0.5 * (high_seen - low_seen);
                if half <= 0.0 || best.as_ref().is_some_and(|place| half <= 0.5 * place.margin.h) {
                    continue;
                }
                let h = 0.5 * (low_seen + high_seen);
                let nearest = strip.order[if h - low <= high - h { position } else { position + 1 }];
                let margin = (h - low).min(high - h);
                if best.as_ref().is_none_or(|place| margin > place.margin.h) {
                    let nearest = Some(CurveName::of(set, nearest));
                    best = Some(SamplePoint { h, l: at, margin: Margin { h: margin, nearest, error_bound } });
                }
            }
        }
        let own = self.sample(region);
        best.map(|best| (if window.contains(own.h, own.l) { own } else { best }, clipped))
    }
}
