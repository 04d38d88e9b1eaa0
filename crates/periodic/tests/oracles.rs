//! Periodic orbits against those of SciPy: `data/oracles/periodic_orbits.py`.

use bifdiag_body::Body;
use bifdiag_dynamics::field::{HeavyTop, State};
use bifdiag_periodic::orbit::{Fixed, PeriodicOrbit, correct};
use serde_json::Value;

fn vector(value: &Value) -> [f64; 3] {
    std::array::from_fn(|i| value[i].as_f64().unwrap())
}

#[test]
fn periods_and_multipliers_are_those_of_scipy() {
    let mut count = 0;
    for line in support::data("oracles/periodic_orbits.jsonl").lines() {
        let case: Value = serde_json::from_str(line).unwrap();
        let texts = |name: &str| -> [String; 3] { std::array::from_fn(|i| case[name][i].as_str().unwrap().to_owned()) };
        let (a, r) = (texts("A"), texts("r"));
        let [a, r] = [&a, &r].map(|v| v.each_ref().map(String::as_str));
        let top = HeavyTop::new(&Body::parse(&a, &r).unwrap());
        let start = State { gamma: vector(&case["gamma"]), l: vector(&case["momentum"]) };
        let [period, trace, h] = ["period", "trace", "h"].map(|name| case[name].as_f64().unwrap());
        let (found, time) =
            correct(&top, &start, 1.001 * period, Fixed::Both).unwrap_or_else(|error| panic!("{error} {case}"));
        let orbit = PeriodicOrbit::new(&top, &found, time).unwrap();
        assert!((orbit.period / period - 1.0).abs() < 1e-9, "{orbit:?} {case}");
        assert!((orbit.trace - trace).abs() < 1e-7 * (1.0 + trace.abs()), "{orbit:?} {case}");
        // One point in doubles closes as well as its rounding, which an unstable orbit stretches.
        let rounding = 1e-14 * (10.0 + trace.abs());
        assert!((orbit.h - h).abs() < 1e-10 && orbit.residual <= rounding, "{orbit:?} {case}");
        count += 1;
    }
    assert!(count >= 60, "{count}");
}
