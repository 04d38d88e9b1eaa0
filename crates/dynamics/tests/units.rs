//! Scaling a body by powers of two changes the scale of its motion and nothing else; extreme bodies are followed; work
//! that is cancelled stops.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use bifdiag_body::Body;
use bifdiag_dynamics::field::{HeavyTop, State};
use bifdiag_dynamics::integrator::DEFAULT_TOLERANCE;
use bifdiag_dynamics::motion::{MotionOptions, follow};
use bifdiag_dynamics::section::chaos::{ChaosOptions, RotationUndefined, chaos_measures, lyapunov_exponents};
use bifdiag_dynamics::section::{
    Monitor, OrbitEnd, OrbitSection, Portrait, PortraitOptions, PpTorus, SectionChart, SectionCondition, SectionError,
    SectionPoint, StartOptions, SweepOptions, spread_starts, sweep,
};

/// Powers of two by which A and r are multiplied. Times are multiplied by the root of their quotient.
const SCALES: [(i32, i32); 6] = [(100, 0), (0, 100), (-100, 0), (0, -100), (200, -300), (-300, -300)];

/// Moments, centre, h and l.
type Case = ([f64; 3], [f64; 3], f64, f64);

const CASES: [Case; 4] = [
    ([2.0, 1.1, 1.0], [0.94868, 0.0, 0.61623], 4.45, 3.25),
    ([0.3, 0.21, 0.17], [0.0, 1.0, 1.0], 0.0, 0.0),
    ([2.0, 2.0, 1.0], [1.0, 0.0, 0.0], 3.4, 2.87),
    ([5.0, 6.0, 7.0], [0.1, 0.2, 30.0], 12.0, 4.0),
];

fn power(e: i32) -> f64 {
    libm::scalbn(1.0, e)
}

/// The units of a scaled body.
#[derive(Clone, Copy)]
struct Scale {
    inertia: f64,
    energy: f64,
    time: f64,
    momentum: f64,
}

impl Scale {
    fn new((a, r): (i32, i32)) -> Self {
        let time = (a - r) / 2;
        assert_eq!(2 * time, a - r, "the scale of time is a power of two");
        Self { inertia: power(a), energy: power(r), time: power(time), momentum: power(a - time) }
    }

    fn torus(self, (a, r, ..): Case) -> PpTorus {
        let (a, r) = (a.map(|x| x * self.inertia), r.map(|x| x * self.energy));
        PpTorus::new(&HeavyTop::new(&Body::from_f64(a, r).unwrap())).unwrap()
    }

    fn body(self, (a, r, ..): Case) -> Body {
        Body::from_f64(a.map(|x| x * self.inertia), r.map(|x| x * self.energy)).unwrap()
    }

    fn state(self, state: &State) -> State {
        State { gamma: state.gamma, l: state.l.map(|x| x * self.momentum) }
    }
}

fn starts(torus: &PpTorus, h: f64, l: f64) -> Vec<State> {
    let options = StartOptions { count: 3, ..StartOptions::default() };
    let points = spread_starts(torus, h, l, &options).unwrap();
    points.into_iter().map(|point| torus.state(point, h, l).unwrap()).collect()
}

/// The orbit of a scaled body that belongs to one of the body itself.
fn scaled(orbit: &OrbitSection, scale: Scale, value: f64) -> OrbitSection {
    let mut orbit = orbit.clone();
    for point in &mut orbit.points {
        *point = SectionPoint {
            time: point.time * scale.time,
            time_low: point.time_low * scale.time,
            l: point.l.map(|x| x * scale.momentum),
            s_dot: point.s_dot * value / scale.time,
            ..*point
        };
    }
    let report = &mut orbit.report;
    report.time *= scale.time;
    report.residual *= value;
    report.drift.energy *= scale.energy;
    report.drift.vertical_momentum *= scale.momentum;
    orbit
}

#[test]
fn sections_of_scaled_bodies_are_the_same_bit_for_bit() {
    for case in CASES {
        let (_, _, h, l) = case;
        let one = Scale::new((0, 0));
        let torus = one.torus(case);
        let states = starts(&torus, h, l);
        for exponents in SCALES {
            let scale = Scale::new(exponents);
            let big = scale.torus(case);
            let big_states = starts(&big, h * scale.energy, l * scale.momentum);
            assert_eq!(big_states, states.iter().map(|state| scale.state(state)).collect::<Vec<_>>());
            for condition in [SectionCondition::Height, SectionCondition::AngularMomentum] {
                let options = |time: f64| SweepOptions {
                    crossings: 12,
                    max_time: 10.0 * time,
                    condition,
                    ..SweepOptions::default()
                };
                let monitor = Monitor::default();
                let expected = sweep(&torus, &states, &options(1.0), &monitor).unwrap();
                let found = sweep(&big, &big_states, &options(scale.time), &monitor).unwrap();
                let value = match condition {
                    SectionCondition::Height => scale.energy / scale.time,
                    SectionCondition::AngularMomentum => scale.momentum * scale.energy,
                };
                let expected: Vec<_> = expected.iter().map(|orbit| scaled(orbit, scale, value)).collect();
                assert!(expected.iter().all(|orbit| orbit.points.len() > 1));
                assert_eq!(found, expected, "{case:?} {exponents:?} {condition:?}");
            }
        }
    }
}

#[test]
fn exponents_motions_and_portraits_of_scaled_bodies_are_the_same_bit_for_bit() {
    for case in CASES {
        let (_, _, h, l) = case;
        let one = Scale::new((0, 0));
        let torus = one.torus(case);
        let states = starts(&torus, h, l);
        let options = PortraitOptions { rows: 24, ..PortraitOptions::default() };
        let portrait = Portrait::new(&one.body(case), h, l, &options).unwrap();
        for exponents in SCALES {
            let scale = Scale::new(exponents);
            let big = scale.torus(case);
            let chaos = |torus: &PpTorus, state: State, time: f64| {
                let found =
                    lyapunov_exponents(torus.top(), &[(state, time)], &ChaosOptions::default(), &Monitor::default());
                found.unwrap()[0].unwrap()
            };
            let (small, large) =
                (chaos(&torus, states[0], 20.0), chaos(&big, scale.state(&states[0]), 20.0 * scale.time));
            assert_eq!(large.exponent, small.exponent / scale.time);
            assert_eq!(large.mean_rate_half, small.mean_rate_half / scale.time);
            assert_eq!(large.time, small.time * scale.time);

            let stop = AtomicBool::new(false);
            let times = [-1.5, 0.0, 0.25, 3.0];
            let motion = |torus: &PpTorus, state: State, time: f64| {
                let options = MotionOptions { tolerance: DEFAULT_TOLERANCE, phi: 0.3, stop: &stop };
                follow(torus.top(), &state, &times.map(|t| t * time), &options).unwrap()
            };
            let (small, large) = (motion(&torus, states[1], 1.0), motion(&big, scale.state(&states[1]), scale.time));
            assert_eq!((large.samples.len(), large.report.steps), (4, small.report.steps));
            for (a, b) in small.samples.iter().zip(&large.samples) {
                assert_eq!((a.gamma, a.theta, a.psi, a.phi, a.attitude), (b.gamma, b.theta, b.psi, b.phi, b.attitude));
                assert_eq!(a.l.map(|x| x * scale.momentum), b.l);
                assert_eq!(a.omega.map(|x| x / scale.time), b.omega);
            }

            let large = Portrait::new(&scale.body(case), h * scale.energy, l * scale.momentum, &options).unwrap();
            assert_eq!((large.report(), large.boundary()), (portrait.report(), portrait.boundary()));
            assert_eq!((large.tangency(-1), large.tangency(1)), (portrait.tangency(-1), portrait.tangency(1)));
            assert_eq!(large.energy_momentum(), (h * scale.energy, l * scale.momentum));
            let place = large.position(SectionChart::Torus, states[2].gamma);
            let rates = portrait
                .rates(SectionChart::Torus, place)
                .map(|rates| rates.map(|x| x * scale.energy / scale.time / scale.time));
            assert!(rates.is_some());
            assert_eq!(large.rates(SectionChart::Torus, place), rates);
        }
    }
}

/// The body of an attack, with its weight multiplied by 10⁶⁰ and by 10⁻⁶⁰: its section ran for ever, and was said to
/// vanish identically. Times are those of the body itself, divided by the root of the weight.
#[test]
fn a_body_of_any_weight_has_its_section() {
    let section = |weight: f64, h: f64| {
        let torus = Scale::new((0, 0)).torus(([0.3, 0.21, 0.17], [0.0, weight, weight], h, 0.0));
        let states = starts(&torus, h, 0.0);
        let options = SweepOptions { crossings: 10, ..SweepOptions::default() };
        sweep(&torus, &states, &options, &Monitor::default()).unwrap()
    };
    for (weight, h) in [(1e60, 0.0), (1e-60, 1e-60), (1e-60, 0.0), (1e140, 1e140), (1e-140, 1e-140)] {
        let expected = section(1.0, h / weight);
        for (orbit, expected) in section(weight, h).iter().zip(&expected) {
            assert_eq!(orbit.report.end, OrbitEnd::Crossings, "{weight:e} {h:e}");
            assert_eq!((orbit.points.len(), orbit.report.tangencies), (11, 0));
            for (point, expected) in orbit.points.iter().zip(&expected.points) {
                let time = point.time * weight.sqrt();
                assert!((time - expected.time).abs() < 1e-10, "{weight:e} {h:e}: {time} {}", expected.time);
            }
        }
    }
}

#[test]
fn motions_beyond_the_range_of_numbers_fail_at_once() {
    let torus = Scale::new((0, 0)).torus(CASES[0]);
    for size in [1e30, 1e100, 1e200, 1e300] {
        let state = State { gamma: [0.6, 0.0, 0.8], l: [size, 0.5 * size, 2.0 * size] };
        let options = SweepOptions { crossings: 10, max_time: 1e3 / size, ..SweepOptions::default() };
        let orbits = sweep(&torus, &[state], &options, &Monitor::default()).unwrap();
        assert!(
            matches!(orbits[0].report.end, OrbitEnd::Failed(_) | OrbitEnd::Time | OrbitEnd::Crossings),
            "{:?}",
            orbits[0]
        );
    }
}

/// Runs work that would take hours and stops it after a moment.
fn stopped<T>(work: impl FnOnce(&Monitor) -> T + Send) -> T
where
    T: Send,
{
    let monitor = Monitor::default();
    std::thread::scope(|scope| {
        let worker = scope.spawn(|| work(&monitor));
        std::thread::sleep(Duration::from_millis(100));
        assert!(!worker.is_finished(), "the work is over before it could be stopped");
        monitor.stop.store(true, Ordering::Relaxed);
        let cancelled = Instant::now();
        let result = worker.join().unwrap();
        assert!(cancelled.elapsed() < Duration::from_secs(1), "{:?}", cancelled.elapsed());
        result
    })
}

#[test]
fn an_interrupt_ends_all_work_within_a_second() {
    let case = CASES[0];
    let (_, _, h, l) = case;
    let torus = Scale::new((0, 0)).torus(case);
    let states = starts(&torus, h, l);
    let options = SweepOptions { crossings: usize::MAX, ..SweepOptions::default() };
    let orbits = stopped(|monitor| sweep(&torus, &states, &options, monitor)).unwrap();
    assert!(orbits.iter().all(|orbit| orbit.report.end == OrbitEnd::Interrupted));
    let motion = stopped(|monitor| {
        let options = MotionOptions { tolerance: DEFAULT_TOLERANCE, phi: 0.0, stop: &monitor.stop };
        follow(torus.top(), &states[0], &[0.0, 1e9], &options).unwrap()
    });
    assert!(motion.report.interrupted && motion.samples.len() == 1);
    let exponents = stopped(|monitor| {
        lyapunov_exponents(torus.top(), &[(states[0], 1e9)], &ChaosOptions::default(), monitor).unwrap()
    });
    assert_eq!(exponents, [None]);
    let found = stopped(|monitor| {
        let options = StartOptions { count: usize::MAX, stop: Some(&monitor.stop), ..StartOptions::default() };
        spread_starts(&torus, h, l, &options)
    });
    assert_eq!(found, Err(SectionError::Interrupted));
    let body = Scale::new((0, 0)).body(case);
    let portrait = stopped(|monitor| {
        let options = PortraitOptions { rows: 4000, stop: Some(&monitor.stop), ..PortraitOptions::default() };
        Portrait::new(&body, h, l, &options).map(|_| ())
    });
    assert_eq!(portrait, Err(SectionError::Interrupted));
}

#[test]
fn what_was_not_measured_says_so() {
    let (_, _, h, l) = CASES[0];
    let torus = Scale::new((0, 0)).torus(CASES[0]);
    let options = SweepOptions { crossings: 100, ..SweepOptions::default() };
    let orbits = sweep(&torus, &starts(&torus, h, l), &options, &Monitor::default()).unwrap();
    let monitor = Monitor::default();
    monitor.stop.store(true, Ordering::Relaxed);
    for measure in chaos_measures(&torus, &orbits, &ChaosOptions::default(), &monitor).unwrap() {
        assert_eq!((measure.lyapunov, measure.rotation), (None, Err(RotationUndefined::Interrupted)));
    }
}
