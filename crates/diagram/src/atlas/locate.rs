//! Point location: the region of a point on a prepared body, without tracing anything.

use std::ops::RangeInclusive;

use super::Atlas;
use super::region::is_ordered;
use crate::arrangement::{Change, EventId, RegionId, SlabId};
use bifdiag_equilibria::curves::{CurveId, MomentumError, Point, X_ROUNDINGS, abscissa};
use bifdiag_numbers::UNIT_ROUNDOFF;
use bifdiag_numbers::table::Id;

/// Where a point (h, l) lies.
#[derive(Clone, Debug, PartialEq)]
pub struct Location {
    /// In a region, below all, or too near to a curve.
    pub place: Place,
    /// Distance in h to the nearest curve at this l, in the body's units.
    pub distance: f64,
    /// The nearest curve.
    pub nearest: CurveId,
    /// Bound on the error of `distance`, the rounding of h and l included. Within rounding of a cusp or pitchfork it holds
    /// whichever side the exact l is on.
    pub error_bound: f64,
    /// The nearest curve is named for certain: no event lies within rounding of l, so that the curves over l and their order are
    /// those of one slab, and of the curves below and above h one is nearer by more than the errors of both.
    pub named: bool,
    /// Points of curves that were computed.
    pub curve_points: usize,
}

/// What a location says.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Place {
    /// Inside this region.
    Region(RegionId),
    /// Below the lowest critical value.
    Forbidden,
    /// Closer to a curve than the error bound: one of these regions (`None`: forbidden).
    Undecided(Vec<Option<RegionId>>),
}

/// Bound on the error of h − h_curve: of the curve, of x and of h.
pub(crate) fn comparison_error(point: &Point, h: f64) -> f64 {
    point.h_error() + UNIT_ROUNDOFF * (2.0 * X_ROUNDINGS * point.x * point.slope() + 4.0 * h.abs())
}

impl Atlas {
    /// Locates a point (h, l), l ≠ 0: a binary search over events, then over the curves of one slab.
    ///
    /// # Errors
    /// [`MomentumError`] when |l| is out of range; l = 0 is answered by [`crate::fast`].
    pub fn locate(&self, h: f64, l: f64) -> Result<Location, MomentumError> {
        let frame = &self.arrangement.set.frame;
        let x = abscissa(frame, l)?;
        let mut location = self.locate_scaled(h / frame.energy_unit, x);
        location.distance *= frame.energy_unit;
        location.error_bound *= frame.energy_unit;
        Ok(location)
    }

    pub(super) fn locate_scaled(&self, h: f64, x: f64) -> Location {
        let slabs = &self.arrangement.slabs;
        let number = self.slab_at(x);
        let around = self.slabs_near(number, x, true);
        let between_events = around.start() == around.end();
        let Bracket { low, under, over, curve_points } = self.bracket(number, h, x);
        let order = &slabs[number].order;
        let (distance, nearest) =
            if under.0 <= over.0 { (under.0, order[low - 1]) } else { (over.0, order[low.min(order.len() - 1)]) };
        let rounding = under.1.max(over.1);
        let named = between_events && (under.0 - over.0).abs() > under.1 + over.1;
        let decided = |distance: f64| {
            if distance <= rounding || !self.order_is_certain(number, x) {
                Place::Undecided(self.candidates(h, x, around.clone()))
            } else if low == 0 {
                Place::Forbidden
            } else {
                Place::Region(slabs[number].region_above[low - 1])
            }
        };
        let near = if between_events { around.clone() } else { self.slabs_near(number, x, false) };
        if near.start() == near.end() {
            let place = decided(distance);
            return Location { place, distance, nearest, error_bound: rounding, named, curve_points };
        }
        // Within rounding of an event the curves that are born or vanish there count, on whichever side x is.
        let places = self.candidates(h, x, around.clone());
        let Nearest { distance, curve: nearest, error_bound } =
            self.nearest_in(h, x, near).unwrap_or(Nearest { distance, curve: nearest, error_bound: rounding });
        let place = if places.len() > 1 { Place::Undecided(places) } else { decided(distance) };
        Location { place, distance, nearest, error_bound, named, curve_points }
    }

    /// The slab of x, as the events are rounded.
    pub(super) fn slab_at(&self, x: f64) -> SlabId {
        let slabs = &self.arrangement.slabs;
        SlabId::at(slabs.as_slice().partition_point(|slab| slab.x[1] < x).min(slabs.len() - 1))
    }

    /// Binary search for h among the curves of a slab.
    fn bracket(&self, slab: SlabId, h: f64, x: f64) -> Bracket {
        let order = &self.arrangement.slabs[slab].order;
        let point = |c: CurveId| self.arrangement.set.curves[c].point(&self.arrangement.set.frame, x);
        // Curves order[..low] lie below h, order[high..] above.
        let (mut low, mut high) = (0, order.len());
        let (mut below, mut above): (Option<Point>, Option<Point>) = (None, None);
        let mut curve_points = 0;
        while low < high {
            let middle = usize::midpoint(low, high);
            let candidate = point(order[middle]);
            curve_points += 1;
            if candidate.h() <= h {
                low = middle + 1;
                below = Some(candidate);
            } else {
                high = middle;
                above = Some(candidate);
            }
        }
        let side = |p: &Option<Point>| p.map_or((f64::INFINITY, 0.0), |p| ((h - p.h()).abs(), comparison_error(&p, h)));
        Bracket { low, under: side(&below), over: side(&above), curve_points }
    }

    /// The slab of x, and those beyond events within rounding of x: all events, or only those at which curves begin or
    /// end. (Curves that cross within rounding of x are both seen from either side.)
    pub(super) fn slabs_near(&self, number: SlabId, x: f64, crossings: bool) -> RangeInclusive<SlabId> {
        let near = |event: EventId| {
            let event = &self.arrangement.events[event];
            let counts = crossings || !matches!(event.change, Change::Swap(_));
            counts && (event.x - x).abs() <= 4.0 * event.x_error + 4.0 * X_ROUNDINGS * UNIT_ROUNDOFF * x
        };
        let (mut first, mut last) = (number, number);
        while let Some(before) = first.before()
            && self.arrangement.events_after(before).any(near)
        {
            first = before;
        }
        while self.arrangement.events_after(last).any(near) {
            last = last.after();
        }
        first..=last
    }

    /// The points of the curves of a slab at x. Where x lies just outside of the slab, γ is that of its end: U(γ) is linear
    /// in x and stationary in γ, so that its value at x itself is the height up to second order (Proposition 3.6).
    pub(super) fn points_in(&self, slab: SlabId, x: f64) -> Vec<Point> {
        let slab = &self.arrangement.slabs[slab];
        // Events that rounding has put out of order are settled by gluing: between two of them the slab is inverted.
        let [from, to] = [slab.x[0].min(slab.x[1]), slab.x[0].max(slab.x[1])];
        let at = x.clamp(from.max(f64::MIN_POSITIVE), to);
        let set = &self.arrangement.set;
        slab.order.iter().map(|&c| Point { x, ..set.curves[c].point(&set.frame, at) }).collect()
    }

    /// The nearest curve in any of several slabs. The distance over the exact x, which lies in one of them, is at least the
    /// least d − e of all curves, and at most, in its own slab, the least d + e.
    fn nearest_in(&self, h: f64, x: f64, slabs: RangeInclusive<SlabId>) -> Option<Nearest> {
        let mut best: Option<(f64, CurveId)> = None;
        let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
        for slab in each(slabs) {
            let mut most_here = f64::INFINITY;
            for (point, &curve) in self.points_in(slab, x).iter().zip(&self.arrangement.slabs[slab].order) {
                let (distance, error) = ((point.h() - h).abs(), comparison_error(point, h));
                least = least.min(distance - error);
                most_here = most_here.min(distance + error);
                if best.is_none_or(|(nearest, _)| distance < nearest) {
                    best = Some((distance, curve));
                }
            }
            most = most.max(most_here);
        }
        let (distance, curve) = best?;
        Some(Nearest { distance, curve, error_bound: (distance - least).max(most - distance) })
    }

    /// False when something is undecided and the heights at x contradict the order of the slab.
    pub(super) fn order_is_certain(&self, number: SlabId, x: f64) -> bool {
        let set = &self.arrangement.set;
        if self.arrangement.undecided.is_empty() {
            return true;
        }
        let order = &self.arrangement.slabs[number].order;
        let points: Vec<Point> = order.iter().map(|&c| set.curves[c].point(&set.frame, x)).collect();
        is_ordered(&points)
    }

    /// Every region that meets the box of rounding around a point in these slabs.
    fn candidates(&self, h: f64, x: f64, slabs: RangeInclusive<SlabId>) -> Vec<Option<RegionId>> {
        let mut found = Vec::new();
        for number in each(slabs) {
            let points = self.points_in(number, x);
            let reaches = |p: &Point| {
                let error = 2.0 * comparison_error(p, h);
                (p.h() - error <= h, p.h() + error >= h)
            };
            for gap in 0..=points.len() {
                let above_lower = gap == 0 || reaches(&points[gap - 1]).0;
                let below_upper = gap == points.len() || reaches(&points[gap]).1;
                let region = gap.checked_sub(1).map(|position| self.arrangement.slabs[number].region_above[position]);
                if above_lower && below_upper && !found.contains(&region) {
                    found.push(region);
                }
            }
        }
        found
    }
}

/// The slabs of a range.
pub(super) fn each(slabs: RangeInclusive<SlabId>) -> impl Iterator<Item = SlabId> {
    (slabs.start().index()..=slabs.end().index()).map(SlabId::at)
}

/// The nearest of the curves of several slabs.
struct Nearest {
    distance: f64,
    curve: CurveId,
    /// Bound on the error of the distance.
    error_bound: f64,
}

/// The position of h among the curves of a slab.
struct Bracket {
    /// So many curves lie below h.
    low: usize,
    /// Distance to the curve below and the error bound of that distance.
    under: (f64, f64),
    /// Distance to the curve above and the error bound of that distance.
    over: (f64, f64),
    /// Points of curves that were computed.
    curve_points: usize,
}
