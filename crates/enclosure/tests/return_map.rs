//! The return to the section with its derivative.

use std::sync::atomic::{AtomicBool, AtomicU64};

use bifdiag_body::{Body, Number};
use bifdiag_enclosure::orbit::{ProofOptions, prove};
use bifdiag_enclosure::return_map::{Return, ReturnError, first_return};
use bifdiag_enclosure::start::ExactStart;
use bifdiag_numbers::Sign;
use dashu_ratio::RBig;

fn exact(text: &str) -> RBig {
    text.parse::<Number>().unwrap().value().clone()
}

fn paper() -> Body {
    Body::parse(&["2", "1.1", "1"], &["0.94868", "0", "0.61623"]).unwrap()
}

/// On the section: r×γ is along the second axis, about which the body does not turn.
fn start(omega: [&str; 3]) -> ExactStart {
    ExactStart { gamma: ["0.6", "0", "0.8"].map(exact), omega: omega.map(exact), phi: RBig::ZERO }
}

fn section(body: &Body, x: &[f64]) -> f64 {
    let ([r1, r2, r3], [g1, g2, g3]) = (body.center_f64(), [x[0], x[1], x[2]]);
    x[3] * (r2 * g3 - r3 * g2) + x[4] * (r3 * g1 - r1 * g3) + x[5] * (r1 * g2 - r2 * g1)
}

fn middles(found: &Return) -> Vec<f64> {
    found.state.iter().map(|x| 0.5 * (x.lo + x.hi)).collect()
}

/// It lies on the section and on the enclosed motion, and is as narrow as rounding lets it be.
#[test]
fn the_return_lies_on_the_motion_and_on_the_section() {
    for omega in [["1", "0", "1"], ["0.5", "0", "-1"], ["3", "0", "2"]] {
        let (body, start) = (paper(), start(omega));
        for direction in [None, Some(Sign::Positive), Some(Sign::Negative)] {
            let found = first_return(&body, &start, 0.0, direction, 100.0).unwrap();
            let width = found.state.iter().map(|x| x.hi - x.lo).fold(0.0, f64::max);
            assert!(width < 1e-12 && found.time[1] - found.time[0] < 1e-10, "{width} {:?}", found.time);
            assert!(section(&body, &middles(&found)).abs() < 1e-12);
            let stop = AtomicBool::new(false);
            let time = RBig::try_from(0.5 * (found.time[0] + found.time[1])).unwrap();
            let motion = prove(
                &body,
                &start,
                &[time],
                &ProofOptions { digits: None, bound: 1e-13, stop: &stop, steps: &AtomicU64::new(0) },
            );
            let sample = &motion.samples[0];
            for (x, [lo, hi]) in found.state.iter().zip(sample.gamma.iter().chain(&sample.omega)) {
                let (lo, hi) = (lo.to_f64().value(), hi.to_f64().value());
                assert!(x.lo <= hi + 1e-10 && lo - 1e-10 <= x.hi, "{x:?} {lo} {hi}");
            }
            if let Some(direction) = direction {
                assert_eq!(found.direction, direction);
            }
        }
    }
}

/// The derivative holds differences of returns from starts beside it.
#[test]
fn the_derivative_holds_differences() {
    const STEP: f64 = 1e-4;
    let (body, start) = (paper(), start(["1", "0", "1"]));
    let found = first_return(&body, &start, 0.0, Some(Sign::Negative), 100.0).unwrap();
    // γ changes length, which the start would undo: only ω is displaced.
    for j in 0..3 {
        let returns = [STEP, -STEP].map(|step| {
            let mut beside = start.clone();
            beside.omega[j] = &beside.omega[j] + RBig::try_from(step).unwrap();
            middles(&first_return(&body, &beside, 0.0, Some(Sign::Negative), 100.0).unwrap())
        });
        for i in 0..6 {
            let difference = (returns[0][i] - returns[1][i]) / (2.0 * STEP);
            let entry = found.derivative[i][3 + j];
            assert!(entry.hi - entry.lo < 1e-4, "{entry:?}");
            assert!(entry.lo - 1e-5 < difference && difference < entry.hi + 1e-5, "{i} {j} {entry:?} {difference}");
        }
    }
}

/// A motion that stays on the section is no crossing, and a body without weight has no section.
#[test]
fn tangencies_are_told() {
    let rest = ExactStart { gamma: ["0", "0", "1"].map(exact), omega: ["0", "0", "1"].map(exact), phi: RBig::ZERO };
    let lagrange = Body::parse(&["2", "2", "1"], &["0", "0", "1"]).unwrap();
    let found = first_return(&lagrange, &rest, 0.0, None, 10.0);
    assert!(matches!(found, Err(ReturnError::Tangency { .. })), "{found:?}");
    let euler = Body::parse(&["2", "1.5", "1"], &["0", "0", "0"]).unwrap();
    assert_eq!(first_return(&euler, &rest, 0.0, None, 10.0), Err(ReturnError::NoSection));
    let early = first_return(&paper(), &start(["1", "0", "1"]), 0.0, None, 0.1);
    assert!(matches!(early, Err(ReturnError::NotBack { .. })), "{early:?}");
}
