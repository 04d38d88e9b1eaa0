//! The classes of all regions that meet at a point on curves.
//!
//! Over the point's own x these are the cells just below and above it. Over x ∓ δ they are those between the curves that
//! pass through the point: every curve has a slope dh/dx between 1/a₃ and 1/a₁ (Proposition 3.6), so that with δ small
//! against the cell around the point no other curve comes near, and δ is less than half the distance to the next cusp
//! or pitchfork beside the point.

use dashu_int::IBig;
use dashu_ratio::RBig;
use numbers::enclosure::{Arithmetic, Enclosure};
use numbers::wide::Wide;
use top::classify::Components;

use super::curves::Curves;
use super::family::{Half, State};
use super::heights::Heights;
use super::model::Constants;
use super::plane::{Gap, Open, Plane};

/// Bits of the places of cusps and pitchforks.
const BITS: usize = 192;

/// Each class that meets at (h, x), once: from below upwards, over x, x − δ and x + δ.
pub(super) fn candidates(plane: &Plane<'_>, x: &RBig, h: &RBig, gap: &Gap) -> Result<Vec<Components>, Open> {
    let mut found: Vec<Components> = Vec::new();
    let mut add = |components: Components| {
        if !found.contains(&components) {
            found.push(components);
        }
    };
    add(plane.class(x, &Gap { low: gap.low.clone(), high: Some(h.clone()) })?);
    add(plane.class(x, &Gap { low: Some(h.clone()), high: gap.high.clone() })?);
    let room = room(plane, x, h, gap);
    let step = step(plane, x, &room);
    for beside in [x - &step, x + &step] {
        for cell in cells(plane, beside.clone(), h, &room)? {
            add(plane.class(&beside, &cell)?);
        }
    }
    Ok(found)
}

/// A quarter of the distance from h to the next height on either side.
fn room(plane: &Plane<'_>, x: &RBig, h: &RBig, gap: &Gap) -> RBig {
    let below = gap.low.as_ref().map(|low| h - low);
    let above = gap.high.as_ref().map(|high| high - h);
    let room = below.into_iter().chain(above).min();
    room.unwrap_or_else(|| x / plane.model.a(plane.model.groups.len() - 1)) / RBig::from(4)
}

/// δ: a power of two.
fn step(plane: &Plane<'_>, x: &RBig, room: &RBig) -> RBig {
    let model = plane.model;
    let mut reach = (room * model.a(0)).min(x.clone());
    if let Ok(curves) = Curves::new(model, BITS) {
        let c = Constants::<Wide>::new(model, BITS);
        let at = |half: Half, y: &Wide| State::at(model, &c, half, y).x;
        let cusps = curves.cusps.iter().map(|cusp| {
            let [lo, hi] = [&cusp.place.lo, &cusp.place.hi].map(|y| Wide::rational(y, BITS));
            at(cusp.place.half, &lo.hull(&hi))
        });
        let forks = curves.pitchforks.iter().map(|fork| at(Half::Over { group: fork.group }, &c.small(0)));
        for [lo, hi] in cusps.chain(forks).filter_map(|event| event.exact_bounds()) {
            // An enclosure that holds x is an event at x.
            if *x < lo {
                reach = reach.min(lo - x);
            } else if hi < *x {
                reach = reach.min(x - hi);
            }
        }
    }
    let reach = reach / RBig::from(IBig::ONE << 24);
    let mut step = RBig::ONE;
    while step > reach {
        step /= RBig::from(2);
    }
    step
}

/// The cells between the curves over x that pass within `room` of h, with those below and above.
fn cells(plane: &Plane<'_>, x: RBig, h: &RBig, room: &RBig) -> Result<Vec<Gap>, Open> {
    let mut heights = Heights::new(plane.model, x);
    let [floor, ceiling] = [h - room, h + room];
    for stage in 1..Heights::stages() {
        let all = heights.enclosed(stage).map_err(|_none| Open::Roots)?;
        let bounds = all.iter().map(|(_, height)| height.exact_bounds());
        let Some(mut bounds) = bounds.collect::<Option<Vec<[RBig; 2]>>>() else { continue };
        bounds.sort();
        if bounds.windows(2).any(|pair| pair[0][1] >= pair[1][0]) {
            continue;
        }
        let within = |bound: &[RBig; 2]| floor < bound[1] && bound[0] < ceiling;
        let first = bounds.iter().position(within);
        let Some(first) = first else { return Ok(Vec::new()) };
        let count = bounds.iter().filter(|bound| within(bound)).count();
        let height = |number: Option<usize>, end: usize| number.and_then(|k| bounds.get(k)).map(|b| b[end].clone());
        let cell = |k: usize| Gap { low: height(k.checked_sub(1), 1), high: height(Some(k), 0) };
        return Ok((first..=first + count).map(cell).collect());
    }
    Err(Open::Beside)
}
