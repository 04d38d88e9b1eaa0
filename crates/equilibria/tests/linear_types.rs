//! The linear types along all curves, by f64 with bounds, against the exact ones.

use std::cell::RefCell;
use std::collections::BTreeMap;

use bifdiag_body::Body;
use bifdiag_equilibria::curves::CriticalSet;
use bifdiag_equilibria::stability::{LinearTypes, StabilityChange, StabilitySpan};
use proptest::prelude::*;
use support::property::{Verdict, holds_for_bodies};
use support::strata::{STRATA, Stratum};

#[derive(Default, Debug)]
struct Tally {
    bodies: u32,
    quick: u32,
    changes: usize,
}

/// Everything about a change but where it is.
fn what(change: &StabilityChange) -> impl PartialEq + std::fmt::Debug + use<> {
    (change.curve, change.onto, change.kind, change.from, change.to)
}

fn near(p: f64, q: f64, bound: f64) -> bool {
    (p - q).abs() <= bound + 4.0 * f64::EPSILON * p.abs().max(q.abs())
}

fn types_agree(body: &Body, tally: &mut Tally) -> Verdict {
    let Ok(set) = CriticalSet::new(body.frame()) else { return Ok(()) };
    let types = LinearTypes::new(body, &set);
    tally.bodies += 1;
    if !types.is_quick() {
        return Ok(());
    }
    tally.quick += 1;
    let exact = LinearTypes::exact(body, &set);
    let (mut found, mut expected) = (types.changes(), exact.changes());
    tally.changes += found.len();
    // Changes at one l may stand in another order.
    for list in [&mut found, &mut expected] {
        list.sort_by(|p, q| (p.curve, p.onto).cmp(&(q.curve, q.onto)).then(p.l.total_cmp(&q.l)));
    }
    prop_assert_eq!(found.len(), expected.len(), "{:?} {:?}", found, expected);
    for (one, other) in found.iter().zip(&expected) {
        prop_assert_eq!(what(one), what(other));
        let bound = one.error_bound + other.error_bound;
        prop_assert!(near(one.l, other.l, bound) && near(one.h, other.h, bound), "{one:?} {other:?}");
        prop_assert!(one.error_bound <= 1e-12 * (1.0 + one.l.abs() + one.h.abs()), "{one:?}");
    }
    for id in set.curves.ids() {
        let (one, other) = (types.spans(id).unwrap(), exact.spans(id).unwrap());
        let types = |spans: &[StabilitySpan]| -> Vec<_> { spans.iter().map(|s| s.stability).collect() };
        prop_assert_eq!(types(&one), types(&other));
    }
    Ok(())
}

#[test]
fn quick_types_are_the_exact_ones() {
    let mut tally: BTreeMap<Stratum, Tally> = BTreeMap::new();
    for stratum in STRATA {
        let counts = RefCell::new(Tally::default());
        holds_for_bodies(stratum, 24, |body| types_agree(body, &mut counts.borrow_mut()));
        tally.insert(stratum, counts.into_inner());
    }
    println!("{tally:#?}");
    // Where the body is far from every coincidence, nothing is left to polynomials.
    for stratum in [Stratum::Generic, Stratum::Unphysical] {
        let Tally { bodies, quick, changes } = tally[&stratum];
        assert!(10 * quick >= 9 * bodies && changes > 0, "{stratum:?}: {quick} of {bodies}");
    }
}
