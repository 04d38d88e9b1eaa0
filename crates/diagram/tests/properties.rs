//! What must hold for every body, on bodies of all strata: two methods for the topology agree, atlases contradict no theorem,
//! and no more work is done than was asked for.

use std::cell::RefCell;
use std::collections::BTreeMap;

use bifdiag_body::{Body, Number};
use bifdiag_diagram::arrangement::{RegionId, Undecided};
use bifdiag_diagram::atlas::{Atlas, Place};
use bifdiag_diagram::fast::{FastError, classify, classify_at_momentum, classify_in};
use bifdiag_diagram::topology::{Answer, Classification};
use bifdiag_diagram::topology::{Component, latitude};
use bifdiag_equilibria::critical::{Multiplicity, critical};
use proptest::prelude::*;
use support::aim::number;
use support::property::{Verdict, holds_for_bodies, holds_for_points};
use support::strata::{STRATA, Stratum};

/// Samples of all regions: (region, h, l) in the body's units, and the margin relative to the energy scale.
fn samples(atlas: &Atlas) -> Vec<(RegionId, f64, f64, f64)> {
    let set = &atlas.arrangement().set;
    let frame = &set.frame;
    let sample = |k: RegionId| {
        let sample = &atlas.regions()[k].sample;
        let nearest = set.curves[sample.nearest].point(frame, sample.x);
        let scale = sample.x / nearest.j + frame.r_norm;
        (k, atlas.energy(sample.h), atlas.momentum(sample.x), sample.margin / scale)
    };
    atlas.regions().ids().map(sample).collect()
}

/// Margins below this are too small to place a point in `f64` with certainty.
const THIN: f64 = 1e-13;

/// The latitude sweep, which knows no critical points.
fn sweep(body: &Body, h: f64, l: f64) -> Option<Vec<Component>> {
    let frame = body.frame();
    latitude::components(&frame, h / frame.energy_unit, l / frame.momentum_unit).ok()
}

/// What is decided is `truth`; what is not has it among its candidates.
fn allows(found: &Classification, truth: &[Component]) -> bool {
    match &found.answer {
        Answer::Regular(components) => components == truth,
        Answer::Forbidden => truth.is_empty(),
        Answer::Critical(candidates) | Answer::Undecided(candidates) => candidates.iter().any(|c| c == truth),
    }
}

/// The answer of an atlas.
fn classified(atlas: &Atlas, h: &Number, l: &Number) -> Result<Classification, FastError> {
    classify_in(atlas, h, l).map(|(found, _)| found)
}

/// An answer, or none where `f64` cannot prove how the minima are joined.
fn decided<T>(found: Result<T, FastError>) -> Option<T> {
    match found {
        Err(FastError::Merge(_)) => None,
        found => Some(found.unwrap()),
    }
}

#[derive(Default, Debug)]
struct Tally {
    bodies: u32,
    /// Bodies with something undecided.
    open: u32,
    /// Bodies without an atlas.
    unresolved: u32,
    regions: u32,
    /// Regions and points that were left undecided, though the point was not too near to a curve.
    undecided: u32,
    /// Points at which joins of minima are not proved.
    unproved: u32,
    swept: u32,
    /// Points that the latitude sweep left undecided.
    unswept: u32,
}

#[test]
fn merge_tree_latitude_sweep_and_point_location_agree_on_all_regions() {
    let mut tally: BTreeMap<Stratum, Tally> = BTreeMap::new();
    for stratum in STRATA {
        let counts = RefCell::new(Tally::default());
        holds_for_bodies(stratum, 150, |body| regions_are_confirmed(body, &mut counts.borrow_mut()));
        tally.insert(stratum, counts.into_inner());
    }
    println!("{tally:#?}");
    for (stratum, t) in tally.iter().filter(|(stratum, _)| !stratum.is_planted()) {
        assert_eq!((t.open, t.unresolved, t.undecided), (0, 0, 0), "{stratum:?}: left open without need");
        assert!(t.unswept * 50 < t.swept, "{stratum:?}: too many regions are beyond the sweep");
    }
    for (stratum, t) in &tally {
        assert!(t.undecided * 20 < t.regions && t.unresolved * 5 < t.bodies, "{stratum:?}: too much is left open");
        assert!(t.unswept * 2 < t.swept, "{stratum:?}: too many regions are beyond the sweep");
    }
}

fn regions_are_confirmed(body: &Body, counts: &mut Tally) -> Verdict {
    counts.bodies += 1;
    let atlas = match bifdiag_diagram::fast::atlas(body) {
        Err(FastError::Unresolved { .. }) => {
            counts.unresolved += 1;
            return Ok(());
        }
        atlas => atlas.unwrap(),
    };
    let arrangement = atlas.arrangement();
    counts.open += u32::from(!arrangement.undecided.is_empty());
    let unordered = arrangement.undecided.iter().any(|u| matches!(u, Undecided::Order { .. }));
    prop_assert!(!unordered, "{:?}", arrangement.undecided);
    if let Err(contradiction) = support::sanity::check(&atlas) {
        return Err(TestCaseError::fail(contradiction.to_string()));
    }
    for (k, h, l, margin) in samples(&atlas) {
        counts.regions += 1;
        let here = format!("{k} at h = {h:e}, l = {l:e}, margin {margin:e}");
        let Ok(own) = &atlas.regions()[k].components else {
            counts.undecided += u32::from(margin > THIN);
            continue;
        };
        for found in [classify(body, &number(h), &number(l)), classified(&atlas, &number(h), &number(l))].map(decided) {
            let decided = found.as_ref().is_some_and(|found| found.components().is_some());
            prop_assert!(found.as_ref().is_none_or(|found| allows(found, own)), "{found:?} for {own:?}, {here}");
            counts.undecided += u32::from(margin > THIN && !decided);
        }
        let place = atlas.locate(h, l).unwrap().place;
        let at_home = match &place {
            Place::Region(found) => *found == k,
            Place::Forbidden => false,
            Place::Undecided(places) => places.contains(&Some(k)),
        };
        prop_assert!(margin <= THIN || at_home, "located in {place:?}, {here}");
        match sweep(body, h, l) {
            Some(swept) => {
                counts.swept += 1;
                prop_assert!(swept == *own || margin <= THIN, "sweep {swept:?}, merge tree {own:?}, {here}");
            }
            None => counts.unswept += 1,
        }
    }
    Ok(())
}

#[test]
fn points_beside_curves_and_events_agree_with_the_sweep_cold_and_prepared() {
    let mut tally: BTreeMap<Stratum, Tally> = BTreeMap::new();
    for stratum in STRATA {
        let counts = RefCell::new(Tally::default());
        holds_for_points(stratum, 300, |body, aim| {
            let mut counts = counts.borrow_mut();
            counts.bodies += 1;
            let Ok(atlas) = bifdiag_diagram::fast::atlas(body) else {
                counts.unresolved += 1;
                return Ok(());
            };
            let (h, l) = aim.at(&atlas);
            let here = format!("--h={h:e} --l {l:e}");
            let (h_exact, l_exact) = (number(h), number(l));
            let found = [classify(body, &h_exact, &l_exact), classified(&atlas, &h_exact, &l_exact)].map(decided);
            let [Some(cold), Some(prepared)] = found else {
                counts.unproved += 1;
                return Ok(());
            };
            for (one, other) in [(&cold, &prepared), (&prepared, &cold)] {
                if let Some(decided) = one.components() {
                    prop_assert!(allows(other, decided), "cold {cold:?}, prepared {prepared:?}, {here}");
                }
            }
            counts.undecided += u32::from(cold.components().is_none());
            match sweep(body, h, l) {
                Some(swept) => {
                    counts.swept += 1;
                    prop_assert!(allows(&cold, &swept), "{cold:?}, sweep {swept:?}, {here}");
                    prop_assert!(allows(&prepared, &swept), "{prepared:?}, sweep {swept:?}, {here}");
                }
                None => counts.unswept += 1,
            }
            Ok(())
        });
        tally.insert(stratum, counts.into_inner());
    }
    println!("{tally:#?}");
    let all = |count: fn(&Tally) -> u32| tally.values().map(count).sum::<u32>();
    assert!(all(|t| t.swept) * 2 > all(|t| t.bodies), "the sweep answers too few points");
}

#[test]
fn indices_of_all_equilibria_sum_to_two() {
    let (checked, open) = (RefCell::new(0), RefCell::new(0));
    for stratum in STRATA {
        holds_for_points(stratum, 300, |body, aim| {
            let Ok(atlas) = bifdiag_diagram::fast::atlas(body) else { return Ok(()) };
            let (_, l) = aim.at(&atlas);
            let found = critical(body, &number(l)).unwrap();
            if !found.complete {
                *open.borrow_mut() += 1;
                return Ok(());
            }
            *checked.borrow_mut() += 1;
            let terms = found.list.iter().map(|e| match e.multiplicity {
                Multiplicity::Points(count) => i32::try_from(count).unwrap() * if e.index == 1 { -1 } else { 1 },
                Multiplicity::Circle => 0,
                Multiplicity::Sphere => 2,
            });
            prop_assert_eq!(terms.sum::<i32>(), 2, "l = {:e}: {:?}", l, found);
            Ok(())
        });
    }
    let (checked, open) = (checked.into_inner(), open.into_inner());
    println!("{checked} checked, {open} open");
    assert!(open * 10 <= checked);
}

/// What is asked decides what is computed.
#[test]
fn a_cold_point_costs_one_point_per_curve_and_a_prepared_one_a_binary_search() {
    for stratum in STRATA {
        holds_for_points(stratum, 50, |body, aim| {
            let Ok(atlas) = bifdiag_diagram::fast::atlas(body) else { return Ok(()) };
            let (h, l) = aim.at(&atlas);
            let Some(found) = decided(classify_at_momentum(body, &number(h), &number(l))) else {
                return Ok(());
            };
            let before = atlas.clone();
            let location = atlas.locate(h, l).unwrap();
            // One critical value or pole line each: curves over this l, no more.
            let scaled = l / atlas.arrangement().set.frame.momentum_unit;
            let x = 0.5 * scaled * scaled;
            let slab = atlas.arrangement().slabs.iter().find(|slab| x <= slab.x[1]).unwrap();
            if let Some((found, _)) = found {
                prop_assert!(found.components().is_some());
                let (over, _) = atlas.arrangement().set.curves_over(x);
                prop_assert!(over.len().abs_diff(slab.order.len()) <= 2, "{} points", over.len());
            }
            let bound = usize::BITS - slab.order.len().leading_zeros();
            prop_assert!(location.curve_points <= bound as usize, "{} points, bound {bound}", location.curve_points);
            let _ = decided(classified(&atlas, &number(h), &number(l)));
            // As text, since r = 0 has no J_r: NaN differs from itself.
            let text = |atlas: &Atlas| format!("{:?}", atlas.arrangement());
            prop_assert_eq!(text(&atlas), text(&before), "a prepared body is not touched");
            Ok(())
        });
    }
}

/// Whole numbers make what random numbers never do: events at exactly the same l, coincident curves, plates.
#[test]
fn bodies_of_small_whole_numbers_have_complete_atlases() {
    let mut failures = Vec::new();
    let (mut bodies, mut open, mut regions) = (0, 0, 0);
    for n in 0..64 * 27 {
        let a: [u32; 3] = [1 + n % 4, 1 + n / 4 % 4, 1 + n / 16 % 4];
        let r: [u32; 3] = [n / 64 % 3, n / 192 % 3, n / 576 % 3];
        if !a.is_sorted() {
            continue;
        }
        let body = Body::parse(&a.map(|x| x.to_string()), &r.map(|x| x.to_string())).unwrap();
        bodies += 1;
        let atlas = match bifdiag_diagram::fast::atlas(&body) {
            Ok(atlas) => atlas,
            Err(error) => {
                failures.push(format!("{error}: A={a:?} r={r:?}"));
                continue;
            }
        };
        let arrangement = atlas.arrangement();
        if let Err(contradiction) = support::sanity::check(&atlas) {
            failures.push(format!("{contradiction}: A={a:?} r={r:?}"));
        }
        if !arrangement.undecided.is_empty() {
            open += 1;
            failures.push(format!("{:?}: A={a:?} r={r:?}", arrangement.undecided));
        }
        for (k, h, l, _) in samples(&atlas) {
            regions += 1;
            let own = atlas.regions()[k].components.as_ref();
            let swept = sweep(&body, h, l);
            if own.is_err() || swept.as_ref().is_some_and(|swept| Ok(swept) != own) {
                failures.push(format!("{k} (h={h}, l={l}) {own:?} sweep {swept:?}: A={a:?} r={r:?}"));
            }
        }
    }
    println!("{bodies} bodies, {open} open, {regions} regions");
    assert!(failures.is_empty(), "{} failures\n{}", failures.len(), failures.join("\n"));
}
