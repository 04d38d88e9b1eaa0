//! The body's motion in space: attitude and φ against each other, against exact solutions and against plain quadrature.

use std::sync::atomic::AtomicBool;

use bifdiag_body::Body;
use bifdiag_dynamics::field::{HeavyTop, State, cross, dot, norm, scale, sub};
use bifdiag_dynamics::integrator::DEFAULT_TOLERANCE;
use bifdiag_dynamics::motion::{Motion, MotionError, MotionOptions, MotionSample, Quaternion, azimuth_rate, follow};
use support::peers::Method;

fn top(moments: [f64; 3], center: [f64; 3]) -> HeavyTop {
    HeavyTop::new(&Body::from_f64(moments, center).unwrap())
}

fn motion(top: &HeavyTop, start: &State, times: &[f64], phi: f64) -> Motion {
    let stop = AtomicBool::new(false);
    follow(top, start, times, &MotionOptions { tolerance: DEFAULT_TOLERANCE, phi, stop: &stop }).unwrap()
}

fn grid(from: f64, to: f64, count: u32) -> Vec<f64> {
    (0..count).map(|k| from + (to - from) * f64::from(k) / f64::from(count - 1)).collect()
}

/// |a − b| with 2π forgotten.
fn apart(a: f64, b: f64) -> f64 {
    let turns = ((a - b) / std::f64::consts::TAU).round();
    (a - b - turns * std::f64::consts::TAU).abs()
}

#[test]
fn attitude_and_angle_agree_for_regular_and_chaotic_motion() {
    let top = top([2.0, 1.1, 1.0], [0.94868, 0.0, 0.61623]);
    let start = State { gamma: [0.36, 0.48, 0.8], l: [3.0, -1.2, 2.4] };
    let motion = motion(&top, &start, &grid(0.0, 60.0, 301), 0.3);
    let report = motion.report;
    assert_eq!((motion.samples.len(), report.failure, report.at_pole), (301, None, 0));
    assert!(report.attitude_difference < 1e-12 && report.vertical_error < 1e-12, "{report:?}");
}

#[test]
fn other_integrators_find_the_same_motion() {
    // Over 10 units of time nearby motions of this start part by less than a factor of 100; RK4 and the splitting are of
    // order 4.
    let top = top([2.0, 1.1, 1.0], [0.94868, 0.0, 0.61623]);
    let start = State { gamma: [0.36, 0.48, 0.8], l: [3.0, -1.2, 2.4] };
    let sample = motion(&top, &start, &[10.0], 0.0).samples[0];
    let methods = [
        (Method::Dop853 { tolerance: 1e-14 }, 1e-10),
        (Method::RungeKutta4 { step: 0.002 }, 1e-8),
        (Method::Splitting { step: 0.002 }, 1e-8),
    ];
    for (method, bound) in methods {
        let state = method.state_after(&top, &start, 10.0);
        let error = norm(sub(state.gamma, sample.gamma)).max(norm(sub(state.l, sample.l)));
        assert!(error < bound, "{method:?}: {error:e}");
    }
}

#[test]
fn the_angle_is_the_integral_of_its_rate() {
    // Simpson's rule on 4000 intervals, away from ±e₃.
    let top = top([2.0, 1.1, 1.0], [0.94868, 0.0, 0.61623]);
    let start = State { gamma: [0.6, 0.0, 0.8], l: [2.0, 0.3, 1.0] };
    let motion = motion(&top, &start, &grid(0.0, 2.0, 4001), 0.0);
    let rate = |s: &MotionSample| azimuth_rate(&top, &State { gamma: s.gamma, l: s.l });
    let horizontal = |s: &MotionSample| (s.gamma[0] * s.gamma[0] + s.gamma[1] * s.gamma[1]).sqrt();
    assert!(motion.samples.iter().all(|s| horizontal(s) > 0.05));
    let mut sum = 0.0;
    for (k, sample) in motion.samples.iter().enumerate() {
        let weight = if k == 0 || k == 4000 {
            1.0
        } else if k % 2 == 1 {
            4.0
        } else {
            2.0
        };
        sum += weight * rate(sample) * (2.0 / 4000.0) / 3.0;
    }
    let phi = motion.samples[4000].phi;
    assert!((phi - sum).abs() < 1e-9, "{phi} {sum}");
}

#[test]
fn angular_momentum_about_the_vertical_is_conserved_in_space() {
    // R l has the constant z-component ⟨γ,l⟩, and its rate is the torque R (r×γ)… in space: d(Rl)/dt = −R(γ×r).
    let top = top([1.7, 1.3, 0.8], [0.3, -0.5, 0.9]);
    let start = State { gamma: [0.48, 0.6, 0.64], l: [1.0, 2.0, -0.5] };
    let step = 1e-3;
    let motion = motion(&top, &start, &grid(0.0, 4.0, 4001), 1.0);
    let in_space: Vec<[f64; 3]> = motion.samples.iter().map(|s| s.attitude.rotate(s.l)).collect();
    for k in 2..in_space.len() - 2 {
        // Central differences of order 4: error step⁴.
        let difference = sub(scale(8.0, sub(in_space[k + 1], in_space[k - 1])), sub(in_space[k + 2], in_space[k - 2]));
        let rate = scale(1.0 / (12.0 * step), difference);
        let sample = &motion.samples[k];
        let torque = sample.attitude.rotate(cross(top.center(), sample.gamma));
        assert!(norm(sub(rate, torque)) < 1e-9, "{k}: {rate:?} {torque:?}");
        assert!((in_space[k][2] - dot(start.gamma, start.l)).abs() < 1e-12);
    }
}

#[test]
fn a_steady_rotation_turns_as_it_should() {
    // γ = e₁ upright (Kovalevskaya's top): turns about e₁ with ω = l/2; φ̇ = ω since ϑ = π/2.
    let top = top([2.0, 2.0, 1.0], [1.0, 0.0, 0.0]);
    let start = State { gamma: [1.0, 0.0, 0.0], l: [3.0, 0.0, 0.0] };
    let motion = motion(&top, &start, &grid(-50.0, 50.0, 201), 0.25);
    for sample in &motion.samples {
        assert!((sample.phi - (0.25 + 1.5 * sample.time)).abs() < 1e-12, "{sample:?}");
    }
    assert!(motion.report.attitude_difference < 1e-12);
}

#[test]
fn regular_precession_of_lagranges_top_is_steady() {
    // A1 cosϑ Ω² − l₃Ω + … = 0: the condition of tests/section.rs; then φ̇ = Ω and ψ̇ = ω₃ − Ω cosϑ.
    let top = top([1.0, 1.0, 0.6], [0.0, 0.0, 1.0]);
    let (sin, cos, l3) = (0.6, 0.8, 1.0_f64);
    let precession = (l3 + (l3 * l3 + 4.0 * cos).sqrt()) / (2.0 * cos);
    let start = State { gamma: [sin, 0.0, cos], l: [precession * sin, 0.0, l3] };
    let spin = l3 / 0.6 - precession * cos;
    let motion = motion(&top, &start, &grid(0.0, 30.0, 61), 0.0);
    let psi_start = motion.samples[0].psi;
    for sample in &motion.samples {
        assert!((sample.phi - precession * sample.time).abs() < 1e-11, "{sample:?}");
        assert!(apart(sample.psi, psi_start + spin * sample.time) < 1e-11);
        assert!((sample.theta - libm::atan2(sin, cos)).abs() < 1e-13);
    }
}

#[test]
fn the_attitude_is_continuous_through_the_pole() {
    // A pendulum about e₁ that goes over the top: γ passes e₃ and −e₃ exactly, and q = (cos α/2, sin α/2, 0, 0).
    let top = top([2.0, 1.5, 1.0], [0.0, 0.0, 1.0]);
    let start = State { gamma: [0.0, 0.6, 0.8], l: [7.0, 0.0, 0.0] };
    let motion = motion(&top, &start, &grid(0.0, 20.0, 2001), 0.0);
    assert!(motion.report.at_pole >= 4, "{:?}", motion.report);
    assert!(motion.report.attitude_difference < 1e-11, "{:?}", motion.report);
    for pair in motion.samples.windows(2) {
        let [p, q] = [pair[0].attitude, pair[1].attitude];
        // ω ≤ √(2(h + r)/A1) < 4 turns the quaternion by half of 4·0.01.
        assert!((0..4).all(|i| (p.components()[i] - q.components()[i]).abs() < 0.02), "{pair:?}");
        assert!(q.v[1].abs() < 1e-13 && q.v[2].abs() < 1e-13, "{q:?}");
    }
}

#[test]
fn near_passages_of_the_pole_keep_both_ways_together() {
    // The same pendulum pushed aside a little: φ and ψ jump by almost π within a time of 1e-3 … 1e-12.
    let top = top([2.0, 1.5, 1.0], [0.0, 0.0, 1.0]);
    for aside in [1e-2, 1e-4, 1e-6, 1e-8, 1e-10] {
        let start = State { gamma: [0.0, 0.6, 0.8], l: [7.0, aside, 0.0] };
        let motion = motion(&top, &start, &grid(0.0, 20.0, 41), 0.0);
        // Near the pole ψ is as good as γ's rounding over its distance, but φ ± ψ is not concerned.
        assert!(motion.report.attitude_difference < 1e-11, "{aside:e} {:?}", motion.report);
    }
}

#[test]
fn a_sleeping_top_turns_about_its_axis() {
    let top = top([1.0, 1.0, 0.6], [0.0, 0.0, 1.0]);
    let start = State { gamma: [0.0, 0.0, 1.0], l: [0.0, 0.0, 3.0] };
    let motion = motion(&top, &start, &grid(0.0, 10.0, 11), 0.0);
    for sample in &motion.samples {
        let expected = Quaternion::of_angles(0.0, 0.0, 5.0 * sample.time);
        assert!(sample.attitude.distance(expected) < 1e-12);
        assert!((sample.phi - 5.0 * sample.time).abs() < 1e-12);
    }
}

#[test]
fn without_weight_the_momentum_stands_still_in_space() {
    let top = top([2.0, 1.1, 1.0], [0.0; 3]);
    let start = State { gamma: [0.0, 0.6, 0.8], l: [0.3, 2.0, -1.0] };
    let motion = motion(&top, &start, &grid(0.0, 40.0, 81), 0.0);
    let at_start = motion.samples[0].attitude.rotate(start.l);
    for sample in &motion.samples {
        assert!(norm(sub(sample.attitude.rotate(sample.l), at_start)) < 1e-12, "{sample:?}");
    }
}

#[test]
fn backwards_in_time_leads_where_forwards_came_from() {
    let top = top([2.0, 1.1, 1.0], [0.94868, 0.0, 0.61623]);
    let start = State { gamma: [0.6, 0.0, 0.8], l: [2.0, 0.3, 1.0] };
    let there = motion(&top, &start, &[0.0, 3.0], 0.7).samples[1];
    let end = State { gamma: there.gamma, l: there.l };
    let back = motion(&top, &end, &[-3.0, 0.0], there.phi).samples[0];
    assert!(norm(sub(back.gamma, start.gamma)) < 1e-12 && norm(sub(back.l, start.l)) < 1e-12);
    assert!((back.phi - 0.7).abs() < 1e-12, "{}", back.phi);
}

#[test]
fn times_that_cannot_be_used_are_named() {
    let top = top([2.0, 1.1, 1.0], [1.0, 0.0, 0.0]);
    let start = State { gamma: [1.0, 0.0, 0.0], l: [1.0, 0.0, 0.0] };
    let stop = AtomicBool::new(false);
    let options = MotionOptions { tolerance: DEFAULT_TOLERANCE, phi: 0.0, stop: &stop };
    let falling = follow(&top, &start, &[0.0, 2.0, 1.0], &options).unwrap_err();
    assert_eq!(falling, MotionError::Falling { number: 3, time: 1.0, before: 2.0 });
    let infinite = follow(&top, &start, &[f64::INFINITY], &options).unwrap_err();
    assert!(matches!(infinite, MotionError::NotFinite { number: 1, .. }));
    stop.store(true, std::sync::atomic::Ordering::Relaxed);
    let stopped = follow(&top, &start, &[0.0, 1.0], &options).unwrap();
    assert!(stopped.report.interrupted && stopped.samples.len() == 1);
}
