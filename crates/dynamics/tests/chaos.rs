//! Lyapunov exponents and rotation numbers: integrable tops, the paper's chaos, quadrature, the same bits everywhere.

use std::f64::consts::{PI, TAU};

use bifdiag_body::Body;
use bifdiag_dynamics::field::{HeavyTop, State, norm, sub};
use bifdiag_dynamics::integrator::taylor::InstructionSet;
use bifdiag_dynamics::integrator::{Taylor, ToleranceError};
use bifdiag_dynamics::section::chaos::{
    ChaosMeasure, ChaosOptions, Lyapunov, RotationAngle, RotationUndefined, chaos_measures, lyapunov_exponents,
};
use bifdiag_dynamics::section::{
    Monitor, OrbitSection, PpTorus, SectionError, StartOptions, SweepOptions, TorusPoint, spread_starts, sweep,
};

fn top(moments: [f64; 3], center: [f64; 3]) -> HeavyTop {
    HeavyTop::new(&Body::from_f64(moments, center).unwrap())
}

fn torus(moments: [f64; 3], center: [f64; 3]) -> PpTorus {
    PpTorus::new(&top(moments, center)).unwrap()
}

fn paper() -> PpTorus {
    torus([2.0, 1.1, 1.0], [0.94868, 0.0, 0.61623])
}

fn starts(torus: &PpTorus, h: f64, l: f64, count: usize) -> Vec<State> {
    let points = spread_starts(torus, h, l, &StartOptions { count, ..StartOptions::default() }).unwrap();
    points.iter().map(|&p| torus.state(p, h, l).unwrap()).collect()
}

fn measured(torus: &PpTorus, starts: &[State], crossings: usize) -> (Vec<OrbitSection>, Vec<ChaosMeasure>) {
    let options = SweepOptions { crossings, ..SweepOptions::default() };
    let orbits = sweep(torus, starts, &options, &Monitor::default()).unwrap();
    let measures = chaos_measures(torus, &orbits, &ChaosOptions::default(), &Monitor::default()).unwrap();
    (orbits, measures)
}

fn exponents(top: &HeavyTop, starts: &[State], time: f64) -> Vec<Lyapunov> {
    let starts: Vec<(State, f64)> = starts.iter().map(|s| (*s, time)).collect();
    let found = lyapunov_exponents(top, &starts, &ChaosOptions::default(), &Monitor::default()).unwrap();
    found.into_iter().map(Option::unwrap).collect()
}

#[test]
fn exponents_of_integrable_tops_vanish_like_the_inverse_of_time() {
    // |δ| grows like t: λ(T) = ln(cT)/T, and the weighted mean of 1/t is 2.21/T, with some room for what c and the
    // quasiperiodic part of |δ| do.
    let kovalevskaya = torus([2.0, 2.0, 1.0], [1.0, 0.0, 0.0]);
    let lagrange = torus([1.0, 1.0, 0.6], [0.0, 0.0, 1.0]);
    let euler = top([2.0, 1.1, 1.0], [0.0; 3]);
    let free = |k: u32| {
        let x = f64::from(k);
        State { gamma: [0.6, 0.0, 0.8], l: [1.0 + 0.1 * x, 0.3 * x - 0.7, 0.4] }
    };
    let cases = [
        ("Kovalevskaya", kovalevskaya.top(), starts(&kovalevskaya, 3.4, 2.87, 16)),
        ("Lagrange", lagrange.top(), starts(&lagrange, 2.0, 1.3, 16)),
        ("Euler", &euler, (0..6).map(free).collect()),
    ];
    for (name, top, starts) in cases {
        for time in [1e3, 1e4] {
            for found in exponents(top, &starts, time) {
                let room = 6.0;
                assert!(found.exponent.abs() * time < libm::log(time) + room, "{name} {found:?}");
                assert!(found.mean_rate.abs() * time < 4.0, "{name} {found:?}");
                assert!(found.time >= time && found.time < time + 10.0);
            }
        }
    }
}

#[test]
fn chaotic_orbits_at_the_south_pole_have_one_positive_exponent() {
    // The paper: for (4.45, 3.25) the component round −r̂ "is dominated by chaotic motion". Orbits of one chaotic
    // region share its exponent, but may stick to the islands' shores for long; so the mean over points of one orbit.
    let torus = paper();
    let start = torus.state(TorusPoint { theta: 2.864, psi: 5.205, sheet: 1 }, 4.45, 3.25).unwrap();
    let options = SweepOptions { crossings: 6400, ..SweepOptions::default() };
    let orbit = &sweep(&torus, &[start], &options, &Monitor::default()).unwrap()[0];
    let of_region: Vec<State> =
        orbit.points.iter().step_by(100).map(|point| State { gamma: point.gamma, l: point.l }).collect();
    let found = exponents(torus.top(), &of_region, 4000.0);
    let mean = |part: fn(&Lyapunov) -> f64| found.iter().map(part).sum::<f64>() / found.len() as f64;
    let (whole, half, weighted) = (mean(|x| x.exponent), mean(|x| x.exponent_half), mean(|x| x.mean_rate));
    // A regular orbit shows ln(T)/T = 0.002.
    let chaotic = found.iter().filter(|one| one.exponent > 0.02).count();
    println!(
        "{chaotic} of {} chaotic; mean exponent {whole}, at half the time {half}, weighted {weighted}",
        found.len()
    );
    assert!(chaotic > 55);
    assert!((0.045..0.075).contains(&whole));
    assert!((whole - half).abs() < 0.15 * whole && (whole - weighted).abs() < 0.15 * whole);
}

#[test]
fn two_nearby_orbits_part_at_the_same_rate() {
    // Benettin's method: a second orbit at a distance of 1e-8 is put back to that distance after every unit of time.
    let torus = paper();
    let start = torus.state(TorusPoint { theta: 2.864, psi: 5.205, sheet: 1 }, 4.45, 3.25).unwrap();
    let (time, distance, unit) = (300_u32, 1e-8, torus.top().momentum_scale(4.45));
    let mut one = start;
    let mut other = start;
    other.gamma[1] += distance;
    let size = |x: &State, y: &State| {
        let (gamma, l) = (norm(sub(x.gamma, y.gamma)), norm(sub(x.l, y.l)) / unit);
        (gamma * gamma + l * l).sqrt()
    };
    let after_one = |state: &State| {
        let mut stepper = Taylor::new(torus.top(), state, 1e-15).unwrap();
        loop {
            let step = stepper.step().unwrap();
            if step.end().seconds() >= 1.0 {
                return step.state((1.0 - step.start().seconds()) / step.length());
            }
        }
    };
    let mut growth = 0.0;
    for _ in 0..time {
        let before = size(&one, &other);
        (one, other) = (after_one(&one), after_one(&other));
        let now = size(&one, &other);
        growth += libm::log(now / before);
        let back = |x: [f64; 3], y: [f64; 3]| std::array::from_fn(|i| x[i] + (y[i] - x[i]) * distance / now);
        other = State { gamma: back(one.gamma, other.gamma), l: back(one.l, other.l) };
    }
    let nearby = growth / f64::from(time);
    let variational = exponents(torus.top(), &[start], f64::from(time))[0];
    println!("two orbits {nearby}, variational {variational:?}");
    // So long both computations follow the same orbit; how much of each first vector lies in the growing direction is
    // worth a factor of a few. (The unit test beside the code compares equal vectors to 1e-6.)
    assert!(variational.exponent > 0.03);
    assert!((nearby - variational.exponent).abs() < 2.5 / f64::from(time));
}

#[test]
fn the_exponent_of_an_unstable_equilibrium_is_its_eigenvalue() {
    // Kovalevskaya's top at rest with its centre of mass above: γ = −e₁, l = 0. Pendulums about e₂ and e₃ with the
    // rates √(r/A₂) = 1/√2 and √(r/A₃) = 1.
    let top = top([2.0, 2.0, 1.0], [1.0, 0.0, 0.0]);
    let state = State { gamma: [-1.0, 0.0, 0.0], l: [0.0; 3] };
    let found = exponents(&top, &[state], 300.0)[0];
    assert!((found.mean_rate - 1.0).abs() < 1e-6, "{found:?}");
    assert!((found.exponent - 1.0).abs() < 2.0 / 300.0, "{found:?}");
    // The centre of mass below: stable, and linear, so that nothing grows.
    let state = State { gamma: [1.0, 0.0, 0.0], l: [0.0; 3] };
    let found = exponents(&top, &[state], 300.0)[0];
    assert!(found.exponent.abs() < 1.0 / 300.0 && found.mean_rate.abs() < 1e-4, "{found:?}");
}

/// ψ' turns that Lagrange's top A = (A1, A1, A3), r = e₃ makes from one maximum of γ₃ to the next.
///
/// With u = γ₃: A1²u̇² = f(u) = (1−u²)(2A1(h+u) − (A1/A3) l₃²) − (l − l₃u)² and ψ̇ = l₃/A3 − u (l − l₃u)/(A1(1−u²)).
/// u oscillates between roots u₁ < u₂; f = 2A1(u−u₁)(u₂−u)(u−u₃), and u = (u₁+u₂)/2 + (u₂−u₁)/2 cos s makes the
/// integral of a smooth periodic function of s.
fn lagrange_turns(a1: f64, a3: f64, h: f64, l: f64, l3: f64, inside: f64) -> f64 {
    let c = 2.0 * a1 * h - a1 / a3 * l3 * l3;
    let f = |u: f64| (1.0 - u * u) * (c + 2.0 * a1 * u) - (l - l3 * u) * (l - l3 * u);
    let root = |mut positive: f64, mut negative: f64| {
        for _ in 0..200 {
            let middle = f64::midpoint(positive, negative);
            if f(middle) > 0.0 {
                positive = middle;
            } else {
                negative = middle;
            }
        }
        f64::midpoint(positive, negative)
    };
    assert!(f(inside) > 0.0);
    let (u1, u2) = (root(inside, -1.0), root(inside, 1.0));
    let u3 = -(c + l3 * l3) / (2.0 * a1) - u1 - u2;
    let rate = |u: f64| l3 / a3 - u * (l - l3 * u) / (a1 * (1.0 - u * u));
    // Orbits that pass near the axis make ψ̇ sharp.
    let nodes = 100_000;
    let sum: f64 = (0..nodes)
        .map(|k| {
            let s = PI * (f64::from(k) + 0.5) / f64::from(nodes);
            let u = f64::midpoint(u1, u2) + 0.5 * (u2 - u1) * libm::cos(s);
            rate(u) * a1 / (2.0 * a1 * (u - u3)).sqrt()
        })
        .sum();
    2.0 * sum * PI / f64::from(nodes) / TAU
}

#[test]
fn rotation_numbers_of_lagranges_top_are_its_quadratures() {
    let (a1, a3, h, l) = (1.0, 0.6, 2.0, 1.3);
    let torus = torus([a1, a1, a3], [0.0, 0.0, 1.0]);
    let (orbits, measures) = measured(&torus, &starts(&torus, h, l, 24), 1000);
    for (orbit, measure) in orbits.iter().zip(&measures) {
        let rotation = measure.rotation.unwrap();
        assert_eq!(rotation.angle, RotationAngle::Axis);
        let [low, high] = [&orbit.points[1], &orbit.points[2]].map(|p| p.gamma[2]);
        let turns = lagrange_turns(a1, a3, h, l, orbit.points[0].l[2], f64::midpoint(low, high));
        let turns = (turns - turns.round()).abs();
        // Near the axis a rounding of u₂ changes 1 − u₂², and ψ̇ with it, by so much.
        let rounding = f64::EPSILON / (1.0 - (low * low).max(high * high));
        assert!((rotation.number - turns).abs() < 1e-12 + 2.0 * rounding, "{rotation:?} {turns}");
        assert!(rotation.error < 1e-12);
    }
}

#[test]
fn rotation_numbers_tell_regular_from_chaotic() {
    let torus = paper();
    let (_, measures) = measured(&torus, &starts(&torus, 4.45, 3.25, 64), 1000);
    let mut defined = 0;
    for measure in &measures {
        let lyapunov = measure.lyapunov.unwrap();
        // Twice the 2.21/T of a regular orbit.
        let chaotic = lyapunov.mean_rate * lyapunov.time > 10.0;
        match measure.rotation {
            Ok(rotation) => {
                assert!(!chaotic, "{measure:?}");
                assert!((0.0..=0.5).contains(&rotation.number) && rotation.error < 1e-3, "{rotation:?}");
                defined += 1;
            }
            Err(why) => assert_eq!(why, RotationUndefined::NoCircle),
        }
    }
    println!("{defined} of 64 orbits have a rotation number");
    assert!(defined > 32);
    // Near r̂ everything is regular.
    let north = torus.state(TorusPoint { theta: 0.3, psi: 2.4, sheet: -1 }, 4.45, 3.25).unwrap();
    let (_, measures) = measured(&torus, &[north], 4000);
    let long = measures[0].rotation.unwrap();
    let (_, measures) = measured(&torus, &[north], 1000);
    let short = measures[0].rotation.unwrap();
    assert!(long.error < 1e-12, "{long:?}");
    assert!((long.number - short.number).abs() <= short.error, "{long:?} {short:?}");
}

#[test]
fn what_has_no_measure_says_so() {
    let torus = paper();
    let (_, measures) = measured(&torus, &starts(&torus, 4.45, 3.25, 2), 20);
    assert_eq!(measures[0].rotation, Err(RotationUndefined::TooFewReturns { returns: 10 }));
    assert!(measures[0].lyapunov.is_none());
    let (_, measures) = measured(&torus, &starts(&torus, 4.45, 3.25, 2), 60);
    assert!(measures[0].lyapunov.is_some());
    let start = starts(&torus, 4.45, 3.25, 1)[0];
    let times = [(start, 0.0), (start, f64::NAN), (start, f64::INFINITY), (start, -1.0)];
    let none = lyapunov_exponents(torus.top(), &times, &ChaosOptions::default(), &Monitor::default()).unwrap();
    assert_eq!(none, [None; 4]);
    let options = ChaosOptions { tolerance: 1.0, ..ChaosOptions::default() };
    let error = lyapunov_exponents(torus.top(), &times, &options, &Monitor::default());
    assert!(matches!(error, Err(SectionError::Tolerance(ToleranceError { .. }))));
    let stopped = Monitor::default();
    stopped.stop.store(true, std::sync::atomic::Ordering::Relaxed);
    let none = lyapunov_exponents(torus.top(), &[(start, 10.0)], &ChaosOptions::default(), &stopped).unwrap();
    assert_eq!(none, [None]);
}

#[test]
fn the_same_bits_on_every_instruction_set_and_in_every_lane() {
    let torus = paper();
    let starts: Vec<(State, f64)> =
        starts(&torus, 4.45, 3.25, 19).into_iter().enumerate().map(|(k, s)| (s, 20.0 + 3.0 * k as f64)).collect();
    let run = |starts: &[(State, f64)], instructions| {
        let options = ChaosOptions { instructions, ..ChaosOptions::default() };
        lyapunov_exponents(torus.top(), starts, &options, &Monitor::default()).unwrap()
    };
    let best = run(&starts, InstructionSet::Best);
    for instructions in InstructionSet::available() {
        assert_eq!(run(&starts, instructions), best, "{instructions:?}");
    }
    for (start, one) in starts.iter().zip(&best) {
        assert_eq!(run(&[*start], InstructionSet::Best), [*one]);
    }
}
