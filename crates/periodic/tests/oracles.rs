//! Periodic orbits against those of SciPy: `data/oracles/periodic_orbits.py`, `kovalevskaya.py`.

use bifdiag_body::Body;
use bifdiag_dynamics::field::{HeavyTop, State};
use bifdiag_dynamics::poincare::SectionSetting;
use bifdiag_dynamics::section::Monitor;
use bifdiag_periodic::list::{ListOptions, list};
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

/// The isolated critical circles of Kovalevskaya's integral with at most four crossings are what the lists hold, with their stability;
/// tori between them are resonant at some points, where lists say that they are not complete.
#[test]
fn the_critical_circles_of_kovalevskaya_are_found() {
    let body = Body::parse(&["2", "2", "1"], &["1", "0", "0"]).unwrap();
    // Beside many short continua; minutes of work.
    let hard = [[1.635, 1.6], [1.822, 1.825]];
    let mut complete = 0;
    for line in support::data("oracles/kovalevskaya.jsonl").lines() {
        let case: Value = serde_json::from_str(line).unwrap();
        let at = ["h", "l"].map(|name| case[name].as_f64().unwrap());
        if hard.contains(&at) {
            continue;
        }
        let [h, l] = at.map(|x| format!("{x:?}").parse().unwrap());
        let setting = SectionSetting::new(&body, &h, &l).unwrap();
        let found =
            list(&setting, &ListOptions { crossings: 4, ..ListOptions::default() }, &Monitor::default()).unwrap();
        let mut orbits: Vec<&PeriodicOrbit> = found.orbits.iter().map(|listed| &listed.orbit).collect();
        for circle in
            case["circles"].as_array().unwrap().iter().filter(|circle| circle["crossings"].as_u64() <= Some(4))
        {
            let [period, trace] = ["period", "trace"].map(|name| circle[name].as_f64().unwrap());
            let is_it = |orbit: &&PeriodicOrbit| {
                (orbit.period / period - 1.0).abs() < 1e-8 && (orbit.trace - trace).abs() < 1e-4 * (1.0 + trace.abs())
            };
            let place =
                orbits.iter().position(is_it).unwrap_or_else(|| panic!("at {at:?} {circle} is not among {orbits:?}"));
            assert_eq!(circle["stability"] == "elliptic", orbits[place].trace.abs() < 2.0, "at {at:?} {circle}");
            orbits.swap_remove(place);
        }
        assert!(orbits.is_empty(), "at {at:?} {orbits:?}");
        complete += usize::from(found.gaps.is_empty());
    }
    assert_eq!(complete, 10);
}
