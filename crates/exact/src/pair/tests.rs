//! Crossings against those of the arrangement in `f64`.

use super::*;
use crate::curves::{Curves, Shape};
use crate::evaluator::Evaluator;
use crate::model::Model;
use bifdiag_body::{Body, Preset};
use bifdiag_diagram::arrangement::{Arrangement, Change};
use bifdiag_equilibria::curves::{CriticalSet, CurveId};
use bifdiag_numbers::interval::Interval;
use bifdiag_numbers::wide::Interval128;

fn crossings(body: &Body) -> usize {
    let model = Model::new(body, &body.frame());
    let curves = Curves::new(&model, 160).unwrap();
    let evaluator = Evaluator::<Interval>::new(&model, &curves, &[], ());
    let arrangement = Arrangement::new(CriticalSet::new(body.frame()).unwrap());
    let mut found = Vec::new();
    for b in curves.list.ids() {
        for a in curves.list.ids().take_while(|a| *a < b) {
            let family = |c: CurveId| matches!(curves.list[c].shape, Shape::Family(_)) && !curves.list[c].lowest;
            if !family(a) || !family(b) {
                continue;
            }
            if let Some(proof) =
                evaluator.pair(a, b, POINTS).unwrap_or_else(|open| panic!("{body:?} {a:?} {b:?} {open:?}"))
            {
                found.extend(proof.stretches.iter().filter_map(|s| match &s.proof {
                    Proof::Crossing(x) => Some(x.clone().map(|x| x.to_f64().value())),
                    Proof::Constant => None,
                }));
            }
        }
    }
    found.sort_by(|p, q| p[0].total_cmp(&q[0]));
    let lines = |c: CurveId| arrangement.set.curves[c].pole.is_some() || !arrangement.set.curves[c].is_critical();
    let expected: Vec<f64> = arrangement
        .events
        .iter()
        .filter(|e| matches!(e.change, Change::Swap([a, b]) if !lines(a) && !lines(b)))
        .map(|e| e.x)
        .collect();
    assert_eq!(found.len(), expected.len(), "{body:?} {found:?} {expected:?}");
    for (x, e) in found.iter().zip(expected) {
        assert!((x[0] - e).abs() < 1e-9 * e && x[1] - x[0] < 1e-9 * e, "{x:?} {e}");
    }
    found.len()
}

#[test]
fn pairs_cross_where_the_standard_arrangement_says() {
    for preset in Preset::all() {
        crossings(&preset.body());
    }
    let mut total = 0;
    for (a, r) in [
        (["2", "1.1", "1"], ["0.3", "0.5", "0.7"]),
        (["1", "1.7", "2.2"], ["0.1", "0.1", "0.9"]),
        (["1", "1.0001", "1.9"], ["0.8", "1e-4", "0.6"]),
        (["2", "1.1", "1"], ["0.94868", "1e-6", "0.61623"]),
    ] {
        total += crossings(&Body::parse(&a, &r).unwrap());
    }
    assert!(total > 0);
}

/// The gap is as (x − end)^(3/2) beside a cusp, and its zero lies 10⁻¹² from the end: found in the exponent, not by halving.
#[test]
fn a_crossing_very_near_to_a_cusp_takes_few_points() {
    let body = Body::parse(&["2", "1.1", "1"], &["1", "1e-18", "2e-18"]).unwrap();
    let model = Model::new(&body, &body.frame());
    let curves = Curves::new(&model, 200).unwrap();
    let evaluator = Evaluator::<Interval128>::new(&model, &curves, &[], ());
    let family = |c: &CurveId| matches!(curves.list[*c].shape, Shape::Family(_)) && !curves.list[*c].lowest;
    let mut crossings = 0;
    for b in curves.list.ids().filter(family) {
        for a in curves.list.ids().take_while(|a| *a < b).filter(family) {
            let proof = evaluator.pair(a, b, 120).unwrap_or_else(|open| panic!("{a:?} {b:?}: {open:?}"));
            let stretches = proof.iter().flat_map(|proof| &proof.stretches);
            crossings += stretches.filter(|stretch| matches!(stretch.proof, Proof::Crossing(_))).count();
        }
    }
    assert!(crossings >= 4, "{crossings}");
}
