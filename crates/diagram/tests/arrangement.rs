//! Arrangements: known bodies, oracles, and invariants on many random bodies.

use bifdiag_body::Body;
use bifdiag_diagram::arrangement::{Arrangement, Change};
use bifdiag_equilibria::curves::CriticalSet;
use serde_json::Value;

fn arrangement(a: [&str; 3], r: [&str; 3]) -> Arrangement {
    let body = Body::parse(&a, &r).unwrap();
    Arrangement::new(CriticalSet::new(body.frame()).unwrap())
}

#[test]
fn the_papers_body_has_five_events_and_nine_faces() {
    let found = arrangement(["2", "1.1", "1"], ["0.94868", "0", "0.61623"]);
    support::sanity::check_arrangement(&found).unwrap();
    assert!(found.undecided.is_empty(), "{:?}", found.undecided);
    let l: Vec<f64> = found.events.iter().map(|e| (2.0 * e.x).sqrt() * found.set.frame.momentum_unit).collect();
    for (found, expected) in l.iter().zip([2.0114, 2.5714, 2.8585, 2.8708, 6.8816]) {
        assert!((found - expected).abs() < 1e-4, "{l:?}");
    }
    assert_eq!((found.events.len(), found.region_count), (5, 9));
}

/// `data/cases/regions.jsonl`: number of regions and events by an independent sweep over l.
#[test]
fn regions_and_events_of_generic_bodies_match_the_oracle() {
    for line in support::data("cases/regions.jsonl").lines() {
        let case: Value = serde_json::from_str(line).unwrap();
        let triple = |key: &str| -> [f64; 3] { serde_json::from_value(case[key].clone()).unwrap() };
        let body = Body::from_f64(triple("A"), triple("r")).unwrap();
        let found = Arrangement::new(CriticalSet::new(body.frame()).unwrap());
        support::sanity::check_arrangement(&found).unwrap();
        assert!(found.undecided.is_empty());
        assert_eq!(
            (found.region_count as u64, found.events.len() as u64),
            (case["regions"].as_u64().unwrap(), case["events"].as_u64().unwrap()),
            "{line}"
        );
    }
}

/// Moments at equal distances, r on the middle axis: both pitchforks lie at exactly the same l.
#[test]
fn two_pitchforks_at_the_same_l_on_different_curves_commute() {
    for (a, faces) in [(["2", "1", "3"], 5), (["2", "3", "1"], 5), (["1", "79/100", "121/100"], 4)] {
        let found = arrangement(a, ["1", "0", "0"]);
        support::sanity::check_arrangement(&found).unwrap();
        assert!(found.undecided.is_empty(), "{:?}", found.undecided);
        assert_eq!(
            found.events.iter().filter(|e| matches!(e.change, Change::Open { .. } | Change::Close { .. })).count(),
            2
        );
        assert_eq!(found.region_count, faces, "{a:?}");
    }
}

/// A1 = 1, r = (1, 0, 0), A2 just below 3/4: cusp, crossing and pitchfork of the pair within 1e-11 of each other in l.
#[test]
fn a_pair_whose_cusp_has_just_left_its_pitchfork() {
    for a in ["0.749", "0.74999", "0.749997", "0.749999"] {
        let found = arrangement(["1", a, "0.86"], ["1", "0", "0"]);
        support::sanity::check_arrangement(&found).unwrap();
        assert!(found.undecided.is_empty(), "{:?}", found.undecided);
        assert_eq!((found.events.len(), found.region_count), (4, 5));
    }
}

/// A2 in the middle of A1 and A3, r2 = 0: the pitchfork lies where the two halves of the branch's parameter meet. The
/// numbers are those of the sweep in `data/oracles/regions2.py`.
#[test]
fn a_pitchfork_in_the_middle_between_two_moments() {
    for (a, r, events, faces) in [
        (["1", "2", "3"], ["1", "0", "1"], 4, 8),
        (["1", "2", "3"], ["2", "0", "1"], 5, 9),
        (["2", "3", "4"], ["2", "0", "1"], 5, 9),
    ] {
        let found = arrangement(a, r);
        support::sanity::check_arrangement(&found).unwrap();
        assert!(found.undecided.is_empty(), "{:?}", found.undecided);
        assert_eq!((found.events.len(), found.region_count), (events, faces), "{a:?} {r:?}");
    }
}

/// r so close to the axis of A₁ that |r| and r₁ are the same number: P+, h = x/J_r − r, still meets the branch with
/// h = x/A₁ + r + O(1/x), at x = 2r A₁J_r/(A₁ − J_r) with A₁ − J_r = ε²(A₁ − A₃)/(1 + ε²) for r = (1, 0, ε).
#[test]
fn next_to_an_axis_the_far_crossing_is_found_to_relative_accuracy() {
    for (text, epsilon) in [("1e-4", 1e-4), ("1e-8", 1e-8), ("1e-12", 1e-12), ("1e-13", 1e-13_f64)] {
        let found = arrangement(["2", "1.1", "1"], ["1", "0", text]);
        assert!(found.undecided.is_empty(), "{text}: {:?}", found.undecided);
        assert_eq!((found.region_count, found.events.len()), (17, 16), "{text}");
        let last = *found.events.last().unwrap();
        let x = last.x * found.set.frame.momentum_unit * found.set.frame.momentum_unit;
        let expected = 8.0 / (epsilon * epsilon);
        assert!((x / expected - 1.0).abs() < 4.0 * epsilon * epsilon + 1e-13, "{text}: {x:e} {expected:e}");
        assert!(last.x_error < 1e-13 * last.x, "{text}: {last:?}");
        support::sanity::check_arrangement(&found).unwrap();
    }
}
