//! What no change of units, no order of the axes, no reflection and no sign of l may change (Proposition 1.3 of
//! docs/mathematics.md): the same question, put in another way, has the same answer. Scaling by powers of four changes
//! no bit but the scale. Time reversal and the scales of motion stand in the tests of `dynamics`.

use bifdiag_body::{Body, Number};
use bifdiag_diagram::arrangement::RegionId;
use bifdiag_diagram::atlas::Atlas;
use bifdiag_diagram::class::Class;
use bifdiag_diagram::fast::{FastError, classify, classify_in};
use bifdiag_diagram::topology::Classification;
use bifdiag_diagram::topology::Component;
use bifdiag_equilibria::critical::{Equilibria, critical};
use dashu_ratio::RBig;
use proptest::prelude::*;
use support::aim::{Aim, number};
use support::property::{Verdict, holds_for_points};
use support::strata::{STRATA, Stratum};

/// The same body written otherwise.
struct Change {
    /// Moments are multiplied by it.
    inertia: RBig,
    /// Centre of mass and energies.
    energy: RBig,
    /// Momenta: the root of the product of these two.
    momentum: RBig,
    /// Axis k of the changed body is this one of the body.
    order: [usize; 3],
    /// r_k and γ_k of the changed body are multiplied by it.
    signs: [i8; 3],
}

impl Change {
    /// Units that differ by the squares of p and q.
    fn units(p: RBig, q: RBig) -> Self {
        let (inertia, energy, momentum) = (&p * &p, &q * &q, p * q);
        Self { inertia, energy, momentum, order: [0, 1, 2], signs: [1; 3] }
    }

    fn axes(order: [usize; 3], signs: [i8; 3]) -> Self {
        Self { order, signs, ..Self::units(RBig::ONE, RBig::ONE) }
    }

    fn body(&self, body: &Body) -> Body {
        let moments = self.order.map(|i| Number::from_rational(body.moments()[i].value() * &self.inertia));
        let center = [0, 1, 2].map(|k| {
            let r = body.center()[self.order[k]].value();
            Number::from_rational(r * &self.energy * RBig::from(self.signs[k]))
        });
        Body::new(moments, center).unwrap()
    }

    /// γ of the body, as the changed one has it.
    fn gamma(&self, gamma: [f64; 3]) -> [f64; 3] {
        [0, 1, 2].map(|k| f64::from(self.signs[k]) * gamma[self.order[k]])
    }
}

fn times(x: f64, factor: &RBig) -> Number {
    Number::from_rational(number(x).value() * factor)
}

/// What an atlas says, without its numbers.
#[derive(Debug, PartialEq)]
struct Shape {
    /// The components of each region; `None` where they are left open.
    components: Vec<Option<Vec<Component>>>,
    /// The regions beside each region.
    neighbours: Vec<Vec<Option<RegionId>>>,
    /// Kinds of events, and what meets there.
    events: Vec<String>,
}

impl Shape {
    fn of(atlas: &Atlas) -> Self {
        let set = &atlas.arrangement().set;
        let mut events: Vec<String> = atlas
            .arrangement()
            .events
            .iter()
            .map(|event| {
                let curves = event.change.curves();
                let names: Vec<_> = curves.iter().map(|&c| (set.curves[c].branch, set.curves[c].piece)).collect();
                format!("{:?} of {names:?}", std::mem::discriminant(&event.change))
            })
            .collect();
        events.sort();
        Self {
            components: atlas.regions().iter().map(|region| region.components.clone().ok()).collect(),
            neighbours: atlas.regions().ids().map(|id| neighbours(atlas, id)).collect(),
            events,
        }
    }

    /// Equal in all that both decide. Where events lie at one l their order, and with it the numbers of the regions, is
    /// a matter of rounding.
    fn agrees(&self, other: &Self, tied: bool) -> bool {
        let pairs = || self.components.iter().zip(&other.components);
        let same = if tied {
            let sorted = |shape: &Self| {
                let all: Option<Vec<_>> = shape.components.iter().map(|region| region.as_ref()).collect();
                all.map(|mut all| {
                    all.sort_by_key(|components| format!("{components:?}"));
                    format!("{all:?}")
                })
            };
            sorted(self).zip(sorted(other)).is_none_or(|(p, q)| p == q)
        } else {
            self.neighbours == other.neighbours && pairs().all(|(p, q)| p.is_none() || q.is_none() || p == q)
        };
        same && self.components.len() == other.components.len() && self.events == other.events
    }
}

/// Whether two events lie at the same l within their errors.
fn tied(atlas: &Atlas) -> bool {
    atlas
        .arrangement()
        .events
        .as_slice()
        .windows(2)
        .any(|e| (e[1].x - e[0].x).abs() <= 4.0 * (e[0].x_error + e[1].x_error))
}

/// Regions above and below a region; `None` below all curves.
fn neighbours(atlas: &Atlas, region: RegionId) -> Vec<Option<RegionId>> {
    let mut found: Vec<Option<RegionId>> = Vec::new();
    for strip in &atlas.arrangement().slabs {
        let above = &strip.region_above;
        for place in (0..above.len()).filter(|&place| above[place] == region) {
            found.push(place.checked_sub(1).map(|below| above[below]));
            found.extend(above.get(place + 1).map(|next| Some(*next)));
        }
    }
    found.sort();
    found.dedup();
    found
}

/// l and h of the events and samples.
fn places(atlas: &Atlas) -> Vec<(f64, f64)> {
    let events = atlas.arrangement().events.iter().map(|e| (atlas.energy(e.h), atlas.momentum(e.x)));
    let samples = atlas.regions().iter().map(|r| (atlas.energy(r.sample.h), atlas.momentum(r.sample.x)));
    events.chain(samples).collect()
}

/// The atlas, unless it is left open.
fn atlas(body: &Body) -> Option<Atlas> {
    match bifdiag_diagram::fast::atlas(body) {
        Err(FastError::Unresolved { .. }) => None,
        atlas => Some(atlas.unwrap()),
    }
}

/// The answer of an atlas.
fn classified(atlas: &Atlas, h: &Number, l: &Number) -> Result<Classification, FastError> {
    classify_in(atlas, h, l).map(|(found, _)| found)
}

/// An answer, or none where `f64` cannot prove how the minima are joined.
fn decided(found: Result<Classification, FastError>) -> Option<Classification> {
    match found {
        Err(FastError::Merge(_)) => None,
        found => Some(found.unwrap()),
    }
}

/// Decided answers are equal, and what one decides the other does not exclude.
fn compatible(one: &Classification, other: &Classification) -> bool {
    let allows = |open: &Classification, decided: &[Component]| match open.components() {
        Some(components) => components == decided,
        None => open.candidates().iter().any(|candidate| candidate == decided),
    };
    one.components().is_none_or(|decided| allows(other, decided))
        && other.components().is_none_or(|decided| allows(one, decided))
}

/// Powers of four change the exponents of all results and no other bit.
fn exactly_the_same(body: &Body, aim: &Aim, change: &Change) -> Verdict {
    let other = change.body(body);
    let (Some(atlas), Some(changed)) = (atlas(body), atlas(&other)) else { return Ok(()) };
    let factors = [&change.energy, &change.momentum].map(|factor| factor.to_f64().value());
    let scaled: Vec<_> = places(&atlas).into_iter().map(|(h, l)| (h * factors[0], l * factors[1])).collect();
    prop_assert_eq!(places(&changed), scaled);
    prop_assert_eq!(Shape::of(&changed), Shape::of(&atlas));
    let (h, l) = aim.at(&atlas);
    let here = decided(classify(body, &number(h), &number(l)));
    let there = decided(classify(&other, &number(h * factors[0]), &number(l * factors[1])));
    prop_assert_eq!(here.as_ref().map(|found| &found.answer), there.as_ref().map(|found| &found.answer));
    let margins = |found: Option<Classification>| found.map(|found| [found.margin.h, found.margin.error_bound]);
    prop_assert_eq!(margins(here).map(|numbers| numbers.map(|x| x * factors[0])), margins(there));
    let [here, there] = [(body, l), (&other, l * factors[1])].map(|(body, l)| critical(body, &number(l)).unwrap());
    prop_assert_eq!((here.list.len(), here.complete), (there.list.len(), there.complete));
    for (p, q) in here.list.iter().zip(&there.list) {
        prop_assert_eq!((p.h * factors[0], p.gamma, p.index), (q.h, q.gamma, q.index));
        prop_assert_eq!((p.multiplicity, &p.stability, &p.curve), (q.multiplicity, &q.stability, &q.curve));
    }
    Ok(())
}

/// Any other change may move the last bits, so that what lies within rounding is decided on one side only.
fn the_same(body: &Body, aim: &Aim, change: &Change) -> Verdict {
    let other = change.body(body);
    let (Some(atlas), Some(changed)) = (atlas(body), atlas(&other)) else { return Ok(()) };
    let open = !atlas.arrangement().undecided.is_empty() || !changed.arrangement().undecided.is_empty();
    let [here, there] = [&atlas, &changed].map(Shape::of);
    let tied = tied(&atlas) || tied(&changed);
    prop_assert!(open || here.agrees(&there, tied), "{here:?}\n{there:?}");
    if let (false, Ok(here), Ok(there)) = (open, Class::of(&atlas), Class::of(&changed)) {
        prop_assert_eq!(here.name(), there.name());
    }
    let (h, l) = aim.at(&atlas);
    let (there_h, there_l) = (times(h, &change.energy), times(l, &change.momentum));
    let here = decided(classify(body, &number(h), &number(l)));
    for there in [classify(&other, &there_h, &there_l), classified(&changed, &there_h, &there_l)].map(decided) {
        if let (Some(here), Some(there)) = (&here, &there) {
            prop_assert!(compatible(here, there), "{here:?} {there:?} at --h={h:e} --l {l:e}");
        }
    }
    let [here, there] = [critical(body, &number(l)).unwrap(), critical(&other, &there_l).unwrap()];
    if here.complete && there.complete {
        same_equilibria(&here, &there, change)?;
    }
    Ok(())
}

fn same_equilibria(here: &Equilibria, there: &Equilibria, change: &Change) -> Verdict {
    prop_assert_eq!(here.list.len(), there.list.len());
    let energy = change.energy.to_f64().value();
    let allowed = here.error_bound * energy + there.error_bound;
    let mut left: Vec<_> = there.list.iter().collect();
    for p in &here.list {
        let gamma = change.gamma(p.gamma);
        let distance = |q: [f64; 3]| (0..3).map(|k| (q[k] - gamma[k]).abs()).fold(0.0, f64::max);
        let same_height: Vec<usize> = (0..left.len())
            .filter(|&k| {
                (left[k].h - p.h * energy).abs() <= allowed
                    && (left[k].index, left[k].multiplicity) == (p.index, p.multiplicity)
            })
            .collect();
        let nearest =
            same_height.into_iter().min_by(|&i, &j| distance(left[i].gamma).total_cmp(&distance(left[j].gamma)));
        let Some(nearest) = nearest else { return Err(TestCaseError::fail(format!("{p:?} is lost: {there:?}"))) };
        left.swap_remove(nearest);
    }
    Ok(())
}

fn rational(p: i32, q: u32) -> RBig {
    RBig::from_parts(p.into(), q.into())
}

#[test]
fn powers_of_four_change_the_scale_and_no_bit_besides() {
    let two = RBig::from(2);
    for stratum in STRATA {
        // A by 4^e, r by 4^f; r = 0 has no unit.
        let scales = [(1, 0), (0, -1), (-7, 5), (20, 20)];
        for (e, f) in scales.into_iter().filter(|(_, f)| stratum != Stratum::Euler || *f == 0) {
            let power = |e: isize| if e < 0 { RBig::ONE / two.pow(-e) } else { two.pow(e) };
            let change = Change::units(power(e), power(f));
            holds_for_points(stratum, 40, |body, aim| exactly_the_same(body, aim, &change));
        }
    }
}

#[test]
fn other_units_change_nothing_but_the_scale() {
    for stratum in STRATA {
        for (p, q) in [((7, 3), (1, 1000)), ((22, 7), (10, 1))] {
            let change = Change::units(rational(p.0, p.1), rational(q.0, q.1));
            holds_for_points(stratum, 60, |body, aim| the_same(body, aim, &change));
        }
    }
}

#[test]
fn the_order_of_the_axes_changes_nothing() {
    for stratum in STRATA {
        for order in [[1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]] {
            let change = Change::axes(order, [1; 3]);
            holds_for_points(stratum, 30, |body, aim| the_same(body, aim, &change));
        }
    }
}

#[test]
fn reflections_change_nothing() {
    for stratum in STRATA {
        for signs in [[-1, 1, 1], [1, -1, 1], [1, 1, -1], [-1, -1, -1]] {
            let change = Change::axes([0, 1, 2], signs);
            holds_for_points(stratum, 30, |body, aim| the_same(body, aim, &change));
        }
    }
}

#[test]
fn the_sign_of_l_changes_nothing_but_those_of_l_and_omega() {
    for stratum in STRATA {
        holds_for_points(stratum, 100, |body, aim| {
            let Some(atlas) = atlas(body) else { return Ok(()) };
            let (h, l) = aim.at(&atlas);
            let (h, plus, minus) = (number(h), number(l), number(-l));
            prop_assert_eq!(classify(body, &h, &plus), classify(body, &h, &minus));
            prop_assert_eq!(classify_in(&atlas, &h, &plus), classify_in(&atlas, &h, &minus));
            let mut mirrored = critical(body, &minus).unwrap();
            for equilibrium in &mut mirrored.list {
                equilibrium.omega = -equilibrium.omega;
                equilibrium.l = -equilibrium.l;
            }
            prop_assert_eq!(critical(body, &plus).unwrap(), mirrored);
            Ok(())
        });
    }
}
