//! The default view of a body: the windows in which its diagram is seen.
//!
//! The part of the (h, l) plane that was asked for.

use crate::arrangement::{Cell, RegionId};
use crate::atlas::Atlas;
use crate::topology::Margin;
use bifdiag_equilibria::curves::{Curve, CurveId, CurveName};

/// Margin beyond the last event, as a share of its l.
const BEYOND_EVENTS: f64 = 0.25;
/// Curves that start at the top of the energies at l = 0 are followed by at least this share of their range.
const BEYOND_START: f64 = 0.5;
/// Margin at both ends in h, as a share of the range.
const MARGIN: f64 = 0.05;
/// An event at more than this multiple of the l of the one before would leave the others no room.
const FAR_BEYOND: f64 = 12.0;
/// Without events the window ends in h at most at this multiple of the median of the curves.
const MEDIAN_MULTIPLE: f64 = 4.0;

/// The windows of a diagram.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// All events but those that lie far beyond all others.
    pub main: Window,
    /// All events, and a part of every unbounded region.
    pub everything: Window,
}

impl Atlas {
    /// The default view: it depends on the diagram alone, not on what draws it.
    #[must_use]
    pub fn view(&self) -> View {
        let l: Vec<f64> = self.arrangement.events.iter().map(|event| self.momentum(event.x)).collect();
        let last = l.last().copied().unwrap_or(0.0);
        // The events up to the first leap; those beyond it are for insets.
        let before_leap = l.windows(2).find(|pair| pair[1] > FAR_BEYOND * pair[0]).map_or(last, |pair| pair[0]);
        let everything = self.view_of_events(last);
        let main = if before_leap < last { self.view_of_events(before_leap) } else { everything };
        View { main, everything }
    }

    /// A window for the events up to `last_event` in l.
    fn view_of_events(&self, last_event: f64) -> Window {
        let events = || {
            let events = self.arrangement.events.iter().filter(move |event| self.momentum(event.x) <= last_event);
            events.map(|event| (self.momentum(event.x), self.energy(event.h), event.change.curves()))
        };
        let end = self.drawn_up_to();
        let l_top = if last_event > 0.0 {
            let start = self.start_of_positive_energies(end.min(FAR_BEYOND * last_event));
            last_event.max(start) * (1.0 + BEYOND_EVENTS)
        } else {
            end
        };
        let mut at_top = Vec::new();
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for curve in &self.arrangement.set.curves {
            let Some([(from, first), (to, last)]) = self.ends_below(curve, l_top) else { continue };
            low = low.min(first);
            if from == 0.0 {
                high = high.max(first);
            }
            if to >= l_top {
                // A pole line that runs on a critical curve is a curve of its own.
                at_top.extend(std::iter::repeat_n(last, 1 + usize::from(curve.is_critical() && curve.pole.is_some())));
            }
        }
        if high.is_finite() {
            high += BEYOND_START * (high - low).max(0.0);
        }
        at_top.sort_by(f64::total_cmp);
        high = events().map(|(_, h, _)| h).fold(high, f64::max);
        // What begins at one of the last events must be seen to open.
        let late = events().filter(|(l, ..)| *l > 0.7 * last_event).flat_map(|(.., curves)| curves);
        for curve in late.collect::<Vec<CurveId>>() {
            let ends = self.ends_below(&self.arrangement.set.curves[curve], l_top);
            high = high.max(ends.map_or(high, |[_, (_, h)]| h));
        }
        if let (Some(&median), Some(&largest)) = (at_top.get(at_top.len() / 2), at_top.last()) {
            let without_events = largest.min(MEDIAN_MULTIPLE * median.abs());
            high = high.max(median).max(if last_event > 0.0 { high } else { without_events });
        }
        let margin = MARGIN * (high - low);
        Window { h: [low - margin, high + margin], l: [0.0, l_top] }
    }

    /// l and h at both ends of the part of a curve up to `l_top`.
    fn ends_below(&self, curve: &Curve, l_top: f64) -> Option<[(f64, f64); 2]> {
        let [from, to] = curve.x().map(|x| self.momentum(x));
        let to = to.min(l_top);
        (from <= to).then(|| [from, to].map(|l| (l, self.h_at(curve, l))))
    }

    /// The l at which the lowest curve from l = 0 reaches h = 0, at most `l_top`; 0 where it starts there.
    fn start_of_positive_energies(&self, l_top: f64) -> f64 {
        let starting = self.arrangement.set.curves.iter().filter(|curve| curve.x()[0] == 0.0);
        let lowest = starting.min_by(|p, q| self.h_at(p, 0.0).total_cmp(&self.h_at(q, 0.0)));
        let Some((curve, [_, (end, h)])) = lowest.and_then(|curve| Some((curve, self.ends_below(curve, l_top)?)))
        else {
            return 0.0;
        };
        if h < 0.0 {
            return 0.0;
        }
        self.rises_through(curve, 0.0, [0.0, end])
    }

    /// Where in a range of l a curve reaches an energy: h rises with l along every curve. The end where it is below everywhere, the
    /// beginning where it is nowhere.
    fn rises_through(&self, curve: &Curve, h: f64, [from, to]: [f64; 2]) -> f64 {
        const HALVINGS: usize = 40;
        let (mut below, mut above) = (from, to);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (below + above);
            if self.h_at(curve, middle) < h { below = middle } else { above = middle }
        }
        above
    }
}

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
            let (lower, upper) =
                (&set.curves[strip.order[position]], strip.order.get(position + 1).map(|&c| &set.curves[c]));
            clipped |= self.h_at(lower, from) < window.h[0];
            clipped |= upper.is_none_or(|upper| self.h_at(upper, to) > window.h[1]);
            // Between these it is seen.
            let from = upper.map_or(from, |upper| self.rises_through(upper, window.h[0], [from, to]));
            let to = self.rises_through(lower, window.h[1], [from, to]);
            for place in 0..PLACES {
                let at = from + (to - from) * (place as f64 + 0.5) / PLACES as f64;
                let x = 0.5 * (at / unit) * (at / unit);
                let height = |c: CurveId| {
                    let point = set.curves[c].point(&set.frame, x);
                    (self.energy(point.h()), self.energy(point.h_error()))
                };
                let (low, error_bound) = height(strip.order[position]);
                let high = strip.order.get(position + 1).map_or(f64::INFINITY, |&c| height(c).0);
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
