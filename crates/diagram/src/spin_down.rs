//! How a steady rotation ends when friction at the pivot or in the air lowers l slowly.
//!
//! Where friction that conserves l damps all that is not steady, and l is lost much more slowly, the state stays on a curve of
//! minima of U_l, dh = Ω dl, to the point at which the curve ends. At a pitchfork it goes over to the curve or the pair that is a minimum beyond;
//! without one, and at a cusp, the body falls, and comes to rest on another minimum at that l. While it falls its energy decreases,
//! so it stays in its component of {U_l ≤ h}, which is not decided where it falls from a pitchfork: the degenerate point there may be
//! a saddle too flat for f64. All this in the limit of a vanishing loss of l.

use crate::arrangement::{Arrangement, Change, Event, EventId, RegionId, SlabId};
use crate::atlas::partition_below;
use bifdiag_equilibria::curves::{CriticalSet, CurveId, Orbit, Point};

/// A stretch of a curve along which the neighbouring regions are the same, by falling x = l²/2.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stretch {
    /// The curve.
    pub curve: CurveId,
    /// From the larger x to the smaller one.
    pub x: [f64; 2],
    /// The regions just below (`None`: forbidden) and just above in h.
    pub regions: [Option<RegionId>; 2],
}

/// Where a stretch ends.
#[derive(Clone, Debug, PartialEq)]
pub enum Turn {
    /// Another curve crosses: the neighbouring regions change.
    Crossing(EventId),
    /// The curve goes over into another minimum, at a pitchfork.
    Onto(EventId, CurveId),
    /// The minimum ends, and the body falls; these are the minima at that l of less energy to which it may fall: where the
    /// component in which it begins is not decided, all.
    Fall(EventId, Vec<CurveId>),
    /// The start is no minimum: with friction the body falls from it at once, to one of these.
    Lost(Vec<CurveId>),
    /// The body comes to rest, and hangs if it has weight.
    Rest,
}

/// The way of a rotation from a point of a curve down to rest, or to a fall after which several minima are left.
#[must_use]
pub fn spin_down(arrangement: &Arrangement, from: CurveId, x: f64) -> Vec<(Stretch, Turn)> {
    let down = Down { arrangement };
    let mut way = Vec::new();
    // x may lie beyond the upper end of the curve by its rounding.
    let mut along = arrangement.slabs.pairs().filter(|(_, slab)| slab.x[0] < x && slab.order.contains(&from));
    let Some((slab, start)) = along.next_back() else { return way };
    let end = down.event_at(from, start.x[1], x).or_else(|| down.event_at(from, start.x[0], x));
    // A minimum that ends there continues as one of the curves that it meets.
    let curve = match end.map(|event| event.change) {
        Some(Change::Close { pair, .. }) if down.is_minimum(pair) && start.order.contains(&pair) => pair,
        _ => from,
    };
    let mut place = Some(Place { curve, slab, x: x.min(start.x[1]) });
    while let Some(here) = place {
        let found = if down.is_minimum(here.curve) { down.along(&here) } else { Some(down.lost(&here, end)) };
        let Some((stretch, turn, slab)) = found else { break };
        let next = match &turn {
            Turn::Crossing(_) => Some(here.curve),
            Turn::Onto(_, next) => Some(*next),
            Turn::Fall(_, left) | Turn::Lost(left) => match left[..] {
                [next] => Some(next),
                _ => None,
            },
            Turn::Rest => None,
        };
        place = next.map(|curve| Place { curve, slab, x: stretch.x[1] });
        way.push((stretch, turn));
    }
    way
}

/// A point of a curve over a slab.
struct Place {
    curve: CurveId,
    slab: SlabId,
    x: f64,
}

/// The way down.
struct Down<'a> {
    arrangement: &'a Arrangement,
}

impl<'a> Down<'a> {
    fn set(&self) -> &'a CriticalSet {
        &self.arrangement.set
    }

    fn is_minimum(&self, curve: CurveId) -> bool {
        self.set().curves[curve].index == Some(0)
    }

    /// The event of a curve at an end of a slab, if x is this end. Other events may be at the same x, with empty slabs
    /// between.
    fn event_at(&self, curve: CurveId, end: f64, x: f64) -> Option<&'a Event> {
        if end.is_infinite() {
            return None;
        }
        let room = 4.0 * f64::EPSILON * end;
        let is_there = |event: &&Event| (event.x - end).abs() <= room && event.change.curves().contains(&curve);
        if (end - x).abs() <= room { self.arrangement.events.iter().find(is_there) } else { None }
    }

    /// The regions just below and just above a curve in a slab, or at an event: the curves that meet there bound no
    /// region there.
    fn regions(&self, slab: SlabId, curve: CurveId, event: Option<&Event>) -> [Option<RegionId>; 2] {
        let strip = &self.arrangement.slabs[slab];
        let meets =
            |other: &CurveId| *other == curve || event.is_some_and(|event| event.change.curves().contains(other));
        let (lowest, highest) = (strip.order.iter().position(meets), strip.order.iter().rposition(meets));
        let region = |place: usize| strip.region_above[place];
        [lowest.and_then(|place| place.checked_sub(1)).map(region), highest.map(region)]
    }

    /// Minima at x in a slab of less energy than h.
    fn below(&self, slab: SlabId, x: f64, h: f64) -> Vec<CurveId> {
        let set = self.set();
        let is_below = |&other: &CurveId| self.is_minimum(other) && set.curves[other].point(&set.frame, x).h() < h;
        self.arrangement.slabs[slab].order.iter().copied().filter(is_below).collect()
    }

    /// From a minimum down to the next event of its curve, and the slab below it; `None` where the curve is not in a slab.
    fn along(&self, from: &Place) -> Option<(Stretch, Turn, SlabId)> {
        let Place { curve, mut slab, x } = *from;
        loop {
            let strip = &self.arrangement.slabs[slab];
            if !strip.order.contains(&curve) {
                return None;
            }
            // A stretch of no length is the event at which the curve begins.
            let regions = self.regions(slab, curve, self.event_at(curve, strip.x[0], x));
            let stretch = Stretch { curve, x: [x, strip.x[0]], regions };
            let Some(before) = slab.before() else { return Some((stretch, Turn::Rest, slab)) };
            slab = before;
            let mut events = self.arrangement.events_after(before);
            if let Some(event) = events.find(|event| self.arrangement.events[*event].change.curves().contains(&curve)) {
                return Some((stretch, self.turn(curve, event, before), before));
            }
        }
    }

    /// What becomes of a minimum at an event of its curve above a slab.
    fn turn(&self, curve: CurveId, event: EventId, slab: SlabId) -> Turn {
        let (set, Event { change, x, h, .. }) = (self.set(), &self.arrangement.events[event]);
        let minimum = |curves: &[CurveId]| curves.iter().copied().find(|&curve| self.is_minimum(curve));
        let onto = match *change {
            Change::Swap(_) => return Turn::Crossing(event),
            Change::Birth(_) | Change::Death(_) => None,
            Change::Open { through: [before, _], .. } => minimum(&[before]),
            Change::Close { through: [before, _], pair } => minimum(&[pair, before]),
        };
        if let Some(next) = onto {
            return Turn::Onto(event, next);
        }
        let mut left = self.below(slab, *x, *h);
        if let Change::Birth(_) | Change::Death(_) = change {
            let place = set.curves[curve].point(&set.frame, *x);
            let lower = self.arrangement.slabs[slab].order.iter().copied();
            keep_reachable(set, *x, &place, lower.filter(|other| !change.curves().contains(other)), &mut left);
        }
        Turn::Fall(event, left)
    }

    /// From a point that is no minimum, at an end of its curve if there is an event.
    fn lost(&self, from: &Place, end: Option<&Event>) -> (Stretch, Turn, SlabId) {
        let (set, &Place { curve, slab, x }) = (self.set(), from);
        let meets = |other: &CurveId| end.is_some_and(|event| event.change.curves().contains(other));
        // Between events what lies below is the same, but nowhere as clear as in the middle.
        let clear = if end.is_some() { x } else { self.arrangement.middle(slab) };
        let place = set.curves[curve].point(&set.frame, clear);
        let mut left = self.below(slab, clear, place.h());
        left.retain(|other| *other != curve && !meets(other));
        // At a cusp the curves that meet change no component.
        if !end.is_some_and(|event| matches!(event.change, Change::Open { .. } | Change::Close { .. })) {
            let others = self.arrangement.slabs[slab].order.iter().copied();
            keep_reachable(set, clear, &place, others.filter(|other| !meets(other)), &mut left);
        }
        let regions = self.regions(slab, curve, end);
        (Stretch { curve, x: [x; 2], regions }, Turn::Lost(left), slab)
    }
}

/// Keeps of some minima at x those in the component of {U_l ≤ h} of a point with U_l = h, given the curves at x; all where f64
/// does not decide which these are.
fn keep_reachable(
    set: &CriticalSet,
    x: f64,
    from: &Point,
    curves: impl Iterator<Item = CurveId>,
    minima: &mut Vec<CurveId>,
) {
    let points: Vec<(CurveId, Point)> = curves.map(|curve| (curve, set.curves[curve].point(&set.frame, x))).collect();
    let below: Vec<(CurveId, &Point)> =
        points.iter().filter(|(_, point)| point.h() <= from.h()).map(|(curve, point)| (*curve, point)).collect();
    let Ok(partition) = partition_below(set, x, below.into_iter()) else { return };
    let Some(component) = partition.component_of(from.gamma) else { return };
    minima.retain(|minimum| {
        let point = points.iter().find(|(curve, _)| curve == minimum).map(|(_, point)| point.gamma);
        // Of a pair one suffices.
        point.is_some_and(|gamma| {
            let mut mirrored = gamma;
            if let Orbit::Pair(axis) = set.curves[*minimum].orbit {
                mirrored[axis] = -mirrored[axis];
            }
            partition.has_minimum(component, gamma) || partition.has_minimum(component, mirrored)
        })
    });
}
