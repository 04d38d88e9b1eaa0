//! Arrangements: known bodies, oracles, and invariants on many random bodies.

use bifdiag::arrangement::Arrangement;
use bifdiag::body::Body;
use bifdiag::equilibria::CriticalSet;
use serde_json::Value;

fn arrangement(a: [&str; 3], r: [&str; 3]) -> Arrangement {
    let body = Body::parse(&a, &r).unwrap();
    Arrangement::new(CriticalSet::new(body.frame()).unwrap())
}

#[test]
fn the_papers_body_has_five_events_and_nine_faces() {
    let found = arrangement(["2", "1.1", "1"], ["0.94868", "0", "0.61623"]);
    found.check_invariants().unwrap();
    assert!(found.undecided.is_empty(), "{:?}", found.undecided);
    let l: Vec<f64> = found.events.iter().map(|e| (2.0 * e.x).sqrt() * found.set.frame.momentum_unit).collect();
    for (found, expected) in l.iter().zip([2.0114, 2.5714, 2.8585, 2.8708, 6.8816]) {
        assert!((found - expected).abs() < 1e-4, "{l:?}");
    }
    assert_eq!((found.events.len(), found.faces), (5, 9));
}

/// `data/cases/regions.jsonl`: number of regions and events by an independent sweep over l.
#[test]
fn regions_and_events_of_generic_bodies_match_the_oracle() {
    for line in include_str!("../data/cases/regions.jsonl").lines() {
        let case: Value = serde_json::from_str(line).unwrap();
        let triple = |key: &str| -> [f64; 3] { serde_json::from_value(case[key].clone()).unwrap() };
        let body = Body::from_f64(triple("A"), triple("r")).unwrap();
        let found = Arrangement::new(CriticalSet::new(body.frame()).unwrap());
        found.check_invariants().unwrap();
        assert!(found.undecided.is_empty());
        assert_eq!(
            (found.faces as u64, found.events.len() as u64),
            (case["regions"].as_u64().unwrap(), case["events"].as_u64().unwrap()),
            "{line}"
        );
    }
}

/// |A2 − A1| = |A3 − A1|: both pitchforks lie at the same l, on different lines.
#[test]
fn events_at_exactly_the_same_momentum_commute() {
    let found = arrangement(["1", "0.79", "1.21"], ["1", "0", "0"]);
    found.check_invariants().unwrap();
    assert!(found.undecided.is_empty(), "{:?}", found.undecided);
    assert_eq!((found.events.len(), found.faces), (2, 4));
}
