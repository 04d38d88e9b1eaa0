//! How a steady rotation ends when friction at the pivot or in the air lowers l slowly.
//!
//! Where friction that conserves l damps all that is not steady, and l is lost much more slowly, the state stays on a curve of
//! minima of U_l, dh = Ω dl, to the point at which the curve ends. At a pitchfork it goes over to the curve or the pair that is a minimum beyond;
//! without one, and at a cusp, the body falls, and comes to rest on another minimum at that l. While it falls its energy decreases,
//! so it stays in its component of {U_l ≤ h}, which is not decided where it falls from a pitchfork: the degenerate point there may be
//! a saddle too flat for f64. All this in the limit of a vanishing loss of l.

use crate::arrangement::{Arrangement, Change, EventId, RegionId, SlabId};
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

/// The way of a rotation from a point of a curve down to rest, or to a fall after which several minima are left.
#[must_use]
pub fn spin_down(arrangement: &Arrangement, from: CurveId, x: f64) -> Vec<(Stretch, Turn)> {
    let set = &arrangement.set;
    let is_minimum = |curve: CurveId| set.curves[curve].index == Some(0);
    let mut way = Vec::new();
    // x may lie beyond the upper end of the curve by its rounding.
    let mut along = arrangement.slabs.pairs().filter(|(_, slab)| slab.x[0] < x && slab.order.contains(&from));
    let Some((mut slab, start)) = along.next_back() else { return way };
    let (mut curve, mut upper) = (from, x.min(start.x[1]));
    // At its upper end the curve meets others: a minimum there continues as one of them, and they bound no region
    // there.
    let is_end = start.x[1] - x <= 4.0 * f64::EPSILON * start.x[1];
    let of_curve = |event: &EventId, curve: CurveId| arrangement.events[*event].change.curves().contains(&curve);
    let end = arrangement.events_after(slab).find(|event| is_end && of_curve(event, from));
    let end = end.map(|event| &arrangement.events[event]);
    if let Some(Change::Close { pair, .. }) = end.map(|event| event.change)
        && is_minimum(pair)
    {
        curve = pair;
    }
    let meets = |other: &CurveId| end.is_some_and(|event| event.change.curves().contains(other));
    // Minima of less energy at x in a slab.
    let below = |slab: SlabId, x: f64, h: f64| -> Vec<CurveId> {
        let is_below = |&other: &CurveId| is_minimum(other) && set.curves[other].point(&set.frame, x).h() < h;
        arrangement.slabs[slab].order.iter().copied().filter(is_below).collect()
    };
    while let Some(place) = arrangement.slabs[slab].order.iter().position(|&other| other == curve) {
        let strip = &arrangement.slabs[slab];
        let regions = [place.checked_sub(1).map(|below| strip.region_above[below]), Some(strip.region_above[place])];
        let stretch = Stretch { curve, x: [upper, strip.x[0]], regions };
        let falls = if is_minimum(curve) {
            let Some(before) = slab.before() else {
                way.push((stretch, Turn::Rest));
                break;
            };
            slab = before;
            let Some(event) = arrangement.events_after(before).find(|event| of_curve(event, curve)) else { continue };
            let change = arrangement.events[event].change;
            upper = stretch.x[1];
            let minimum = |curves: &[CurveId]| curves.iter().copied().find(|&curve| is_minimum(curve));
            let onto = match change {
                Change::Swap(_) => {
                    way.push((stretch, Turn::Crossing(event)));
                    continue;
                }
                Change::Birth(_) | Change::Death(_) => None,
                Change::Open { through: [before, _], .. } => minimum(&[before]),
                Change::Close { through: [before, _], pair } => minimum(&[pair, before]),
            };
            if let Some(next) = onto {
                way.push((stretch, Turn::Onto(event, next)));
                curve = next;
                continue;
            }
            let mut left = below(slab, upper, arrangement.events[event].h);
            if let Change::Birth(_) | Change::Death(_) = change {
                let place = set.curves[curve].point(&set.frame, upper);
                let lower = arrangement.slabs[slab].order.iter().copied();
                keep_reachable(set, upper, &place, lower.filter(|other| !change.curves().contains(other)), &mut left);
            }
            way.push((stretch, Turn::Fall(event, left.clone())));
            left
        } else {
            let mut left = below(slab, upper, set.curves[curve].point(&set.frame, upper).h());
            left.retain(|other| !meets(other));
            let is_fork = end.is_some_and(|event| matches!(event.change, Change::Open { .. } | Change::Close { .. }));
            if !is_fork {
                // At a cusp the curves that meet change no component.
                let place = set.curves[curve].point(&set.frame, upper);
                let curves = strip.order.iter().copied().filter(|other| !meets(other));
                keep_reachable(set, upper, &place, curves, &mut left);
            }
            let order = &strip.order;
            let lowest = order.iter().position(meets).unwrap_or(place);
            let highest = order.iter().rposition(meets).unwrap_or(place);
            let regions =
                [lowest.checked_sub(1).map(|below| strip.region_above[below]), Some(strip.region_above[highest])];
            way.push((Stretch { x: [upper; 2], regions, ..stretch }, Turn::Lost(left.clone())));
            left
        };
        let [next] = falls[..] else { break };
        curve = next;
    }
    way
}
