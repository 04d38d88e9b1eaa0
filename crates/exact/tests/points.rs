//! Single points, decided exactly: on curves of every kind, next to them, and the findings of the review.
//!
//! The truth beside a curve comes from the critical points of `f64` over a slightly other l and the sweep over
//! latitudes between them, which share nothing with the exact path.

mod ties;

use std::cell::RefCell;

use bifdiag_body::{Body, Number};
use bifdiag_diagram::topology::{Answer, Classification};
use bifdiag_diagram::topology::{latitude, whole_sphere};
use bifdiag_exact::{Accuracy, classify, classify_exactly};
use dashu_ratio::RBig;
use proptest::prelude::*;
use support::property::holds_for_bodies;
use support::random::SplitMix64;
use support::strata::STRATA;
use ties::{KINDS, Kind, Tie};

fn number(text: &str) -> Number {
    text.parse().unwrap()
}

fn exactly([a, r]: [&str; 2], h: &str, l: &str) -> (Body, Classification) {
    let [a, r] = [a, r].map(|list| list.split(',').collect::<Vec<_>>());
    let body = Body::parse(&a, &r).unwrap();
    let found = classify(&body, &number(h), &number(l), Accuracy::Exact).unwrap();
    (body, found)
}

/// How far the truth is taken from a point, relative to l.
const STEP: f64 = 1e-3;

/// No curve passes near but those through the point.
fn is_alone(tie: &Tie) -> bool {
    let frame = tie.body.frame();
    let [h, l] = [tie.h.to_f64(), tie.l.to_f64()];
    let momentum = l / frame.momentum_unit;
    let room = 80.0 * STEP * momentum * momentum / frame.a[0] * frame.energy_unit;
    heights(tie, l).into_iter().map(|height| (height - h).abs()).all(|d| d < 1e-10 * (h.abs() + room) || d > room)
}

/// The classes that meet at (h, l): between the heights near h over l and over l (1 ± [`STEP`]).
fn classes_around(tie: &Tie) -> Vec<String> {
    let frame = tie.body.frame();
    let (h, l) = (tie.h.to_f64() / frame.energy_unit, tie.l.to_f64() / frame.momentum_unit);
    let mut found = Vec::new();
    for momentum in [l * (1.0 - STEP), l, l * (1.0 + STEP)] {
        let room = 4.0 * STEP * l * l / frame.a[0];
        let mut heights = heights(tie, momentum * frame.momentum_unit);
        heights.retain(|height| (height / frame.energy_unit - h).abs() < room);
        let mut marks = vec![h - room];
        marks.extend(heights.iter().map(|height| height / frame.energy_unit));
        marks.push(h + room);
        for pair in marks.windows(2).filter(|pair| pair[1] - pair[0] > 1e-9 * room) {
            if let Ok(components) = latitude::components(&frame, 0.5 * (pair[0] + pair[1]), momentum) {
                found.push(format!("{components:?}"));
            }
        }
    }
    found.sort();
    found.dedup();
    found
}

/// Critical values and energies of the poles over l, ascending, by `f64`.
fn heights(tie: &Tie, l: f64) -> Vec<f64> {
    let list = bifdiag_equilibria::critical::critical(&tie.body, &Number::from_f64(l).unwrap()).unwrap().list;
    let mut heights: Vec<f64> = list.iter().map(|point| point.h).collect();
    let (a, r) = (tie.body.moments_f64(), tie.body.center_f64());
    let r2: f64 = r.iter().map(|r| r * r).sum();
    let j: f64 = (0..3).map(|k| a[k] * r[k] * r[k]).sum::<f64>() / r2;
    heights.extend([-1.0, 1.0].map(|side| 0.5 * l * l / j + side * r2.sqrt()));
    heights.sort_by(f64::total_cmp);
    heights
}

fn candidates(found: &Classification) -> Vec<String> {
    let mut all: Vec<String> = found.candidates().iter().map(|class| format!("{class:?}")).collect();
    all.sort();
    all
}

fn ties(kind: Kind, count: usize) -> Vec<Tie> {
    let mut random = SplitMix64::new(17);
    let found = std::iter::repeat_with(|| kind.tie(&mut random)).take(2000).flatten();
    let found: Vec<Tie> = found.filter(is_alone).take(count).collect();
    assert_eq!(found.len(), count, "{kind:?}");
    found
}

#[test]
fn points_on_curves_are_critical_with_the_classes_that_meet_there() {
    for kind in KINDS {
        for tie in ties(kind, 12) {
            let found = classify(&tie.body, &tie.h, &tie.l, Accuracy::Exact).unwrap();
            assert!(matches!(found.answer, Answer::Critical(_)), "{kind:?} {tie:?}: {found:?}");
            assert_eq!(candidates(&found), classes_around(&tie), "{kind:?} {tie:?}");
            assert_eq!((found.margin.h, found.margin.error_bound), (0.0, 0.0), "{kind:?} {tie:?}");
        }
    }
}

#[test]
fn points_next_to_curves_are_regular_however_near() {
    for kind in KINDS {
        for (tie, exponent) in ties(kind, 5).into_iter().zip([16, 20, 30, 45, 60]) {
            let step = tie.scale() / RBig::from(10).pow(exponent);
            let beside: Vec<Classification> = [-1, 1]
                .map(|side| {
                    let h = Number::from_rational(tie.h.value() + &step * RBig::from(side));
                    classify(&tie.body, &h, &tie.l, Accuracy::Exact).unwrap()
                })
                .into();
            let on = classify(&tie.body, &tie.h, &tie.l, Accuracy::Exact).unwrap();
            for found in &beside {
                let components = found.components().unwrap_or_else(|| panic!("{kind:?} {tie:?}: {found:?}"));
                assert!(on.candidates().iter().any(|class| class == components), "{kind:?} {tie:?}: {found:?}");
                let distance = step.to_f64().value();
                assert!((found.margin.h / distance - 1.0).abs() < 1e-9, "{kind:?} {tie:?}: {found:?}");
            }
            // The first two candidates are those just below and just above.
            assert_eq!(on.candidates()[0], beside[0].components().unwrap(), "{kind:?} {tie:?}");
        }
    }
}

/// classify --A 1.3,1,0.7 --r 1,1e-16,2e-16 --h 105783887850000000000000000000002623321e-38 --l 0.38779
#[test]
fn a_cell_thinner_than_rounding_has_its_class_and_no_sphere_with_one_pole() {
    let (_, found) = exactly(["1.3,1,0.7", "1,1e-16,2e-16"], "105783887850000000000000000000002623321e-38", "0.38779");
    let components = found.components().expect("regular");
    assert!(components.iter().all(|component| component.boundary_circles > 0), "{found:?}");
}

/// classify --A 1.2268999252988841,0.21015454706989597,1.2268999067158415
/// --r=-1.5404249988253296e-09,1.0,1.0582905332252536e-08 --h=1.000000038737586816573450309527131260653 --l=1.276e-04
#[test]
fn without_an_atlas_in_f64_the_class_is_one_that_bodies_have() {
    let body = [
        "1.2268999252988841,0.21015454706989597,1.2268999067158415",
        "-1.5404249988253296e-09,1.0,1.0582905332252536e-08",
    ];
    let (_, found) = exactly(body, "1.000000038737586816573450309527131260653", "1.276e-04");
    assert!(matches!(found.answer, Answer::Regular(_)), "{found:?}");
}

/// On the line L- of A = (1, 8/9, 1/2), r = (1, 0, 0), beside the pitchfork at l = 3: what leaves the line there is no
/// candidate, however near the pitchfork is.
#[test]
fn a_pitchfork_beside_a_point_is_not_at_the_point() {
    let at = |exponent: usize, side: i32| {
        let l = RBig::from(3) + RBig::from(side) / RBig::from(10).pow(isize::try_from(exponent).unwrap());
        let h = &l * &l / RBig::from(2) + RBig::ONE;
        let body = Body::parse(&["1", "8/9", "1/2"], &["1", "0", "0"]).unwrap();
        let found = classify(&body, &Number::from_rational(h), &Number::from_rational(l), Accuracy::Exact).unwrap();
        candidates(&found)
    };
    let far = [-1, 1].map(|side| at(3, side));
    assert_eq!((far[0].len(), far[1].len()), (2, 2), "{far:?}");
    assert_ne!(far[0], far[1]);
    for exponent in [20, 60, 70, 300] {
        assert_eq!([-1, 1].map(|side| at(exponent, side)), far, "1e-{exponent}");
    }
    // At the pitchfork itself all of them meet.
    let on = at(0, 0);
    assert!(far.iter().flatten().all(|class| on.contains(class)), "{on:?}");
}

/// classify --A 1,3/4,1.4 --r 1,0,0 --h 3 --l 2, and --A 7/6,1,137/96 --r 5/2,0,205/24 --h 25 --l 20/3: the pair leaves its
/// curve with a cusp, where its curvature is infinite.
#[test]
fn where_a_pitchfork_turns_over_the_classes_beside_it_meet() {
    let borders = [
        (["1,3/4,1.4", "1,0,0"], "3", "2"),
        (["1,3/4,0.6", "1,0,0"], "3", "2"),
        (["1,3/4,3/4", "1,0,0"], "3", "2"),
        (["3,3,4", "0,0,1"], "3", "4"),
        (["7/6,1,137/96", "5/2,0,205/24"], "25", "20/3"),
    ];
    for (numbers, h, l) in borders {
        let (body, found) = exactly(numbers, h, l);
        let mut around = classes_around(&Tie { body, h: number(h), l: number(l) });
        around.sort();
        around.dedup();
        assert_eq!((candidates(&found), 3), (around.clone(), around.len()), "{numbers:?}");
    }
}

/// classify --A 2,1,3 --r 1,2,2 --h=-11999999/4000000 --l 1/1000
#[test]
fn on_a_pole_line_above_the_minimum_u_is_not_empty() {
    let (_, found) = exactly(["2,1,3", "1,2,2"], "-11999999/4000000", "1/1000");
    let Answer::Critical(candidates) = &found.answer else { panic!("{found:?}") };
    assert_eq!(candidates.len(), 2, "{found:?}");
    assert!(candidates.iter().all(|class| !class.is_empty()), "{found:?}");
}

/// classify --body paper --h 5 --l 2.011434659319437
#[test]
fn beside_the_momentum_of_a_cusp_a_point_far_from_every_curve_is_regular() {
    let body = ["2,1.1,1", "0.94868,0,0.61623"];
    let (paper, found) = exactly(body, "5", "2.011434659319437");
    assert_eq!(found.components(), Some(&[whole_sphere(true)][..]));
    let exact = classify_exactly(&paper, &number("5"), &number("2.011434659319437")).unwrap();
    assert!((exact.margin.h - 2.26).abs() < 0.01, "{exact:?}");
}

/// classify --A 2,1.1,1 --r 0.94868,1e-13,0.61623 --h 0 --l 0.079255, and --A 1,1.4,0.7499999999999999 --r 1,0,0
#[test]
fn ordinary_cells_of_bodies_near_special_ones_are_decided() {
    let (body, _) = exactly(["2,1.1,1", "0.94868,1e-13,0.61623"], "0", "0.079255");
    let found = classify_exactly(&body, &number("0"), &number("0.079255")).unwrap();
    assert!((found.margin.h - 1.1).abs() < 0.05 && found.components().is_some(), "{found:?}");
    let (katok, _) = exactly(["1,1.4,0.7499999999999999", "1,0,0"], "0.5", "1.3");
    assert!(classify_exactly(&katok, &number("0.5"), &number("1.3")).unwrap().components().is_some());
}

/// classify --A 543854/68355,589424/68355,288662/68355 --r 26000000/9,5000000/3,400000 --h 81119800000/13671
/// --l 261299200/41013
#[test]
fn a_tie_beside_another_curve_names_the_right_curve_and_every_class() {
    let body = ["543854/68355,589424/68355,288662/68355", "26000000/9,5000000/3,400000"];
    let (_, found) = exactly(body, "81119800000/13671", "261299200/41013");
    assert!(matches!(found.answer, Answer::Critical(_)), "{found:?}");
    assert!(found.candidates().len() >= 2, "{found:?}");
    assert!(!found.margin.nearest.unwrap().to_string().starts_with('P'), "{found:?}");
}

/// section --A 0.3,0.21,0.17 --r 0,1e60,1e60 --h 0 --l 0 and its like: scaling by powers of two changes the scale alone.
#[test]
fn scaling_by_powers_of_two_changes_nothing_but_the_scale() {
    let power = |k: i32| {
        let two = RBig::from(2).pow(isize::try_from(k.abs()).unwrap());
        if k < 0 { RBig::ONE / two } else { two }
    };
    let exact = |texts: [&str; 3]| texts.map(|text| number(text).value().clone());
    for (a, r) in [(["0.3", "0.21", "0.17"], ["0", "1", "1"]), (["2", "1.1", "1"], ["0.2", "0.3", "0.6"])] {
        let (a, r) = (exact(a), exact(r));
        for (p, q) in [(200, 0), (0, 200), (-200, 0), (0, -200), (100, -300)] {
            let scaled = |list: &[RBig; 3], k: i32| list.clone().map(|x| Number::from_rational(x * power(k)));
            let bodies = [(0, 0), (p, q)].map(|(p, q)| Body::new(scaled(&a, p), scaled(&r, q)).unwrap());
            for (h, l) in [("0", "0"), ("0.3", "0.4"), ("1.1", "0.7"), ("-0.2", "0.1"), ("4", "1.5")] {
                let (h, l) = (number(h).value().clone(), number(l).value().clone());
                // h scales as r, l as √(A r).
                let place =
                    |p: i32, q: i32| [&h * power(q), &l * power(i32::midpoint(p, q))].map(Number::from_rational);
                let [plain, moved] = [(0, 0), (p, q)].map(|(p, q)| place(p, q));
                let plain = classify(&bodies[0], &plain[0], &plain[1], Accuracy::Exact).unwrap();
                let moved = classify(&bodies[1], &moved[0], &moved[1], Accuracy::Exact).unwrap();
                assert_eq!(plain.answer, moved.answer, "2^{p}, 2^{q} at ({h}, {l})");
                assert_eq!((plain.margin.h * power(q).to_f64().value()).to_bits(), moved.margin.h.to_bits());
            }
        }
    }
}

/// The answers of `f64` with bounds are those of the proof, for every body and point that the strata give.
#[test]
fn without_the_f64_filter_the_answers_are_the_same() {
    let compared = RefCell::new(0);
    for stratum in STRATA {
        holds_for_bodies(stratum, 3, |body| {
            let frame = body.frame();
            for (h, l) in [(-0.6, 0.3), (0.2, 0.7), (0.9, 1.3), (1.4, 1.9), (2.5, 3.1)] {
                let place = [h * frame.energy_unit, l * frame.momentum_unit].map(|x| Number::from_f64(x).unwrap());
                let filtered = classify(body, &place[0], &place[1], Accuracy::Exact);
                let proved = classify_exactly(body, &place[0], &place[1]);
                if let (Ok(filtered), Ok(proved)) = (&filtered, &proved) {
                    prop_assert_eq!(&filtered.answer, &proved.answer, "({}, {})", h, l);
                    *compared.borrow_mut() += 1;
                } else {
                    prop_assert!(stratum.is_planted(), "{filtered:?} {proved:?}");
                }
            }
            Ok(())
        });
    }
    assert!(compared.into_inner() > 200);
}

#[test]
fn energies_with_eighty_digits_are_used_with_eighty_digits() {
    // P- of A = (2, 1, 3), r = (1, 2, 2) at l = 2: J_r = 2, h = 1 + 3.
    let on = RBig::from(4);
    let tail = RBig::from(1) / RBig::from(10).pow(79);
    let body = Body::parse(&["2", "1", "3"], &["1", "2", "2"]).unwrap();
    let at = |h: RBig| classify(&body, &Number::from_rational(h), &number("2"), Accuracy::Exact).unwrap();
    let [below, above] = [at(&on - &tail), at(&on + &tail)];
    assert!(matches!(at(on).answer, Answer::Critical(_)));
    assert_ne!(below.answer, above.answer);
    assert!((below.margin.h / 1e-79 - 1.0).abs() < 1e-9, "{below:?}");
    assert_eq!(below.margin.nearest.unwrap().to_string(), "P-");
}

#[test]
fn momenta_from_1e_minus_30_to_1e30_are_decided() {
    for exponent in [-30, -12, -4, 4, 12, 30] {
        let l = number(&format!("1e{exponent}"));
        let body = Body::parse(&["2", "1.1", "1"], &["0.2", "0.3", "0.6"]).unwrap();
        // J_r and r: on P+, 1e-70 of r above it.
        let j = (RBig::from(8) + RBig::from(99) / RBig::from(10) + RBig::from(36)) / RBig::from(49);
        let line = l.value() * l.value() / (RBig::from(2) * j) - RBig::from(7) / RBig::from(10);
        let above = &line + RBig::ONE / RBig::from(10).pow(70);
        let at = |h: RBig| classify(&body, &Number::from_rational(h), &l, Accuracy::Exact).unwrap();
        assert!(matches!(at(line).answer, Answer::Critical(_)), "1e{exponent}");
        let above = at(above);
        assert!(matches!(above.answer, Answer::Regular(_)), "1e{exponent}: {above:?}");
        assert!((above.margin.h / 1e-70 - 1.0).abs() < 1e-9, "1e{exponent}: {above:?}");
    }
}
