//! Closed-form relative equilibria against oracles made in exact rational arithmetic.

use bifdiag_body::{Body, Number};
use bifdiag_equilibria::curves::{CriticalSet, RelativeEquilibrium};
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
        let set = CriticalSet::new(body.frame()).unwrap();
        let l: Number = case["l"].as_str().unwrap().parse().unwrap();
        let scaled = l.to_f64() / set.frame.momentum_unit;
        let found = set.equilibria_at(0.5 * scaled * scaled);
        let expected = case["critical"].as_array().unwrap();
        assert_eq!(found.list.len(), expected.len(), "{line}");
        assert!(found.complete);
        for truth in expected {
            let gamma: Vec<f64> = truth["gamma"].as_array().unwrap().iter().map(number).collect();
            let distance = |e: &RelativeEquilibrium| -> f64 {
                let g = set.frame.vector_to_body(e.point.gamma);
                (0..3).map(|k| (g[k] - gamma[k]) * (g[k] - gamma[k])).sum()
            };
            let nearest = found.list.iter().min_by(|p, q| distance(p).total_cmp(&distance(q))).unwrap();
            let h = nearest.point.h() * set.frame.energy_unit;
            let scale = (nearest.point.x / nearest.point.j + set.frame.r_norm) * set.frame.energy_unit;
            let error = (h - number(&truth["h"])).abs();
            worst = worst.max(error / scale);
            assert!(error < 1e-13 * scale, "h off by {error:e}: {line}");
            assert!(nearest.point.h_error() * set.frame.energy_unit >= error, "bound too small: {line}");
        }
    }
    assert!(worst < 2e-15, "worst error {worst:e}");
}
