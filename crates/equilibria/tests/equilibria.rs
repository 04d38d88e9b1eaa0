//! Closed-form relative equilibria against oracles made in exact rational arithmetic.

use bifdiag_body::{Body, Number};
use bifdiag_equilibria::critical::{Equilibrium, critical};
use serde_json::Value;

fn texts(value: &Value) -> Vec<String> {
    value.as_array().unwrap().iter().map(|x| x.as_str().unwrap().to_owned()).collect()
}

fn number(value: &Value) -> f64 {
    value.as_str().unwrap().parse().unwrap()
}

/// `data/cases/extremes.jsonl`: critical points complete, h right to 1e-13 of l²/2J + r and within its own bound.
#[test]
fn extremes_are_complete_and_accurate() {
    let text = support::data("cases/extremes.jsonl");
    let mut worst: f64 = 0.0;
    for line in text.lines() {
        let case: Value = serde_json::from_str(line).unwrap();
        let body = Body::parse(&texts(&case["A"]), &texts(&case["r"])).unwrap();
        let l: Number = case["l"].as_str().unwrap().parse().unwrap();
        let found = critical(&body, &l).unwrap();
        let expected = case["critical"].as_array().unwrap();
        assert_eq!(found.list.len(), expected.len(), "{line}");
        assert!(found.complete);
        for truth in expected {
            let gamma: Vec<f64> = truth["gamma"].as_array().unwrap().iter().map(number).collect();
            let distance =
                |e: &Equilibrium| -> f64 { (0..3).map(|k| (e.gamma[k] - gamma[k]) * (e.gamma[k] - gamma[k])).sum() };
            let nearest = found.list.iter().min_by(|p, q| distance(p).total_cmp(&distance(q))).unwrap();
            // l²/2J = lω/2.
            let scale = 0.5 * l.to_f64() * nearest.omega + body.center_squared().to_f64().value().sqrt();
            let error = (nearest.h - number(&truth["h"])).abs();
            worst = worst.max(error / scale);
            assert!(error < 1e-13 * scale, "h off by {error:e}: {line}");
            assert!(found.error_bound >= error, "bound too small: {line}");
        }
    }
    assert!(worst < 2e-15, "worst error {worst:e}");
}
