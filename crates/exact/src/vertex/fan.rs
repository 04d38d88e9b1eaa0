//! The curves that leave a point on one side of it, and the proof that they do not meet on the way.
//!
//! A point of the plane on curves.

use std::cmp::Ordering;

use crate::critical_values::{CriticalSource, CriticalValue, CriticalValues, ordered};
use crate::curves::Place;
use crate::family::{Curvature, Half, State};
use crate::model::{Constants, Model};
use crate::plane::Plane;
use bifdiag_numbers::Sign;
use bifdiag_numbers::enclosure::{Arithmetic, Enclosure};
use bifdiag_numbers::wide::Wide;
use dashu_ratio::RBig;

/// Bits of the ranges of J.
const BITS: usize = 256;

/// A curve between the point and an x beside it.
struct Arc<'a> {
    at: &'a CriticalSource,
    beside: &'a CriticalSource,
}

/// The curves with these numbers among the sources beside the point come from it and do not meet between (Proposition
/// 8.6): for each two the ranges of J are disjoint, or they are the arms of a cusp, or the pair and what it leaves at a
/// pitchfork.
pub(super) fn is_ordered(vertex: &Vertex<'_>, sources: &[CriticalSource], near: &[usize]) -> bool {
    if near.len() < 2 {
        return true;
    }
    let model = vertex.plane.model;
    let Some(arcs) = near.iter().map(|&k| arc(vertex, sources, k)).collect::<Option<Vec<_>>>() else { return false };
    let c = Constants::new(model, BITS);
    let moments: Vec<Option<Wide>> = arcs.iter().map(|arc| arc.moment(model, &c)).collect();
    (0..arcs.len()).all(|b| {
        (0..b).all(|a| {
            let slopes = moments[a].clone().zip(moments[b].clone());
            slopes.is_some_and(|(p, q)| (p - q).strict_sign().is_some())
                || are_arms(model, &c, &arcs[a], &arcs[b])
                || are_forked(model, &c, [&arcs[a], &arcs[b]])
                || are_forked(model, &c, [&arcs[b], &arcs[a]])
        })
    })
}

/// The curve of a source beside the point, back to the point.
fn arc<'a>(vertex: &'a Vertex<'_>, sources: &'a [CriticalSource], number: usize) -> Option<Arc<'a>> {
    let beside = &sources[number];
    let mut ends = vertex.levels.iter().filter(|level| level.sign == Sign::Zero).map(|level| &level.source);
    let at = match beside {
        CriticalSource::Line(pole) => ends.find(|end| matches!(end, CriticalSource::Line(other) if other == pole)),
        CriticalSource::Euler { group } => {
            ends.find(|end| matches!(end, CriticalSource::Euler { group: other } if other == group))
        }
        // Two points over one x lie on both sides of the cusp.
        CriticalSource::Over { group, .. } => {
            ends.find(|end| matches!(end, CriticalSource::Over { group: other, .. } if other == group))
        }
        CriticalSource::Generic { number, place } => return generic_arc(vertex, sources, *number, place, beside),
    };
    at.map(|at| Arc { at, beside })
}

/// The place of a source on an interval of the generic family.
fn place_on(source: &CriticalSource, interval: usize) -> Option<&Place> {
    match source {
        CriticalSource::Generic { number, place } if *number == interval => Some(place),
        _ => None,
    }
}

/// On the generic family: between neighbours among the points over both x, x lies between the two, and has no extremum as
/// there is no cusp.
fn generic_arc<'a>(
    vertex: &'a Vertex<'_>,
    sources: &[CriticalSource],
    interval: usize,
    place: &Place,
    beside: &'a CriticalSource,
) -> Option<Arc<'a>> {
    let model = vertex.plane.model;
    let is_itself = |other: &&Place| other.lo == place.lo && other.hi == place.hi && other.half == place.half;
    let others = sources.iter().filter_map(|source| place_on(source, interval));
    let others: Vec<&Place> = others.filter(|other| !is_itself(other)).collect();
    let mut found = None;
    for side in [Ordering::Less, Ordering::Greater] {
        let Some((level, at)) = nearest(vertex, interval, place, side).ok()? else { continue };
        if level.sign != Sign::Zero {
            continue;
        }
        let lies_between =
            |other: &&Place| Some(ordered(model, other, place)? == side && ordered(model, at, other)? == side);
        let between = others.iter().map(lies_between).collect::<Option<Vec<bool>>>()?;
        if !between.contains(&true) && found.replace(Arc { at: &level.source, beside }).is_some() {
            return None;
        }
    }
    found
}

/// The order of two places is not known.
struct Unordered;

/// The point over the x of the vertex that is nearest to a place on one side of it.
fn nearest<'a>(
    vertex: &'a Vertex<'_>,
    interval: usize,
    place: &Place,
    side: Ordering,
) -> Result<Option<(&'a CriticalValue, &'a Place)>, Unordered> {
    let is_beyond = |p: &Place, q: &Place| Ok(ordered(vertex.plane.model, p, q).ok_or(Unordered)? == side);
    let mut nearest: Option<(&CriticalValue, &Place)> = None;
    for level in vertex.levels {
        let Some(at) = place_on(&level.source, interval) else { continue };
        if !is_beyond(at, place)? {
            continue;
        }
        let is_nearer = match nearest {
            Some((_, best)) => is_beyond(best, at)?,
            None => true,
        };
        if is_nearer {
            nearest = Some((level, at));
        }
    }
    Ok(nearest)
}

/// All places between two of one family, on the half of the first.
fn hull(model: &Model, p: &Place, q: &Place) -> Option<(Half, Wide)> {
    let ends = match p.half {
        Half::Over { .. } => [(&p.lo).min(&q.lo).clone(), (&p.hi).max(&q.hi).clone()],
        Half::Generic { base, sign } => {
            let ([a, b], [c, d]) = (p.mu(model), q.mu(model));
            let [low, high] = [a.min(c) - model.a(base), b.max(d) - model.a(base)];
            if sign == Sign::Positive { [low, high] } else { [-high, -low] }
        }
    };
    let number = |y: &RBig| Wide::rational(y, BITS);
    (ends[0] >= RBig::ZERO).then(|| (p.half, number(&ends[0]).hull(&number(&ends[1]))))
}

fn place(source: &CriticalSource) -> Option<&Place> {
    match source {
        CriticalSource::Generic { place, .. } | CriticalSource::Over { place, .. } => Some(place),
        CriticalSource::Line(_) | CriticalSource::Euler { .. } => None,
    }
}

impl Arc<'_> {
    /// All states of the curve between both ends; `None` on a line.
    fn states(&self, model: &Model, c: &Constants<Wide>) -> Option<State<Wide>> {
        let (half, y) = hull(model, place(self.at)?, place(self.beside)?)?;
        Some(State::at(model, c, half, &y))
    }

    /// All of its J.
    fn moment(&self, model: &Model, c: &Constants<Wide>) -> Option<Wide> {
        match self.at {
            CriticalSource::Line(_) => c.j_r.clone(),
            CriticalSource::Euler { group } => Some(c.a[*group].clone()),
            CriticalSource::Generic { .. } | CriticalSource::Over { .. } => Some(self.states(model, c)?.j),
        }
    }

    /// All of its d²h/dx².
    fn curvature(&self, model: &Model, c: &Constants<Wide>) -> Option<Curvature<Wide>> {
        match self.at {
            CriticalSource::Line(_) | CriticalSource::Euler { .. } => Some(Curvature::zero(c)),
            CriticalSource::Generic { .. } | CriticalSource::Over { .. } => {
                let state = |place: &Place| {
                    let y = Wide::rational(&place.lo, BITS).hull(&Wide::rational(&place.hi, BITS));
                    State::at(model, c, place.half, &y)
                };
                let [end, inside] = [state(place(self.at)?), state(place(self.beside)?)];
                Some(Curvature::of(&self.states(model, c)?, [&end, &inside]))
            }
        }
    }
}

/// Both arms of one cusp, with J monotone from one to the other (Lemma 7.4).
fn are_arms(model: &Model, c: &Constants<Wide>, a: &Arc<'_>, b: &Arc<'_>) -> bool {
    match (a.at, b.at) {
        (CriticalSource::Generic { .. }, CriticalSource::Generic { .. }) if std::ptr::eq(a.at, b.at) => {
            let range = place(a.beside).zip(place(b.beside)).and_then(|(p, q)| hull(model, p, q));
            range.is_some_and(|(half, y)| State::at(model, c, half, &y).j_slope.strict_sign().is_some())
        }
        // J = a − R̂/v.
        (CriticalSource::Over { .. }, CriticalSource::Over { .. }) => std::ptr::eq(a.at, b.at),
        _ => false,
    }
}

/// The pair that leaves at a pitchfork, and the curve that it leaves, with different curvatures (Lemma 7.3).
fn are_forked(model: &Model, c: &Constants<Wide>, [through, pair]: [&Arc<'_>; 2]) -> bool {
    let CriticalSource::Over { group, place } = pair.at else { return false };
    if place.lo != RBig::ZERO || place.hi != RBig::ZERO {
        return false;
    }
    let passes = match through.at {
        CriticalSource::Generic { place, .. } => {
            let [lo, hi] = place.mu(model);
            let a = model.a(*group);
            lo <= *a && *a <= hi
        }
        CriticalSource::Line(_) => model.active.len() == 1,
        CriticalSource::Over { .. } | CriticalSource::Euler { .. } => false,
    };
    let curvatures = through.curvature(model, c).zip(pair.curvature(model, c));
    passes && curvatures.is_some_and(|(p, q)| p.minus(&q).is_some())
}

/// The point, and the heights over its x.
pub(crate) struct Vertex<'a> {
    pub plane: &'a Plane<'a>,
    pub heights: &'a CriticalValues<'a>,
    pub h: &'a RBig,
    pub levels: &'a [CriticalValue],
}
