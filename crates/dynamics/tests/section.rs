//! Poincaré sections: conservation, integrable tops, reversal, the same bits everywhere, and heyoka's crossings.

use bifdiag_body::{Body, BodyAxis, IntegrableCase};
use bifdiag_dynamics::field::{HeavyTop, Integrals, State, dot, further_integral};
use bifdiag_dynamics::integrator::taylor::InstructionSet;
use bifdiag_dynamics::integrator::{DEFAULT_TOLERANCE, Taylor, ToleranceError};
use bifdiag_dynamics::section::{
    Monitor, OrbitCheckpoint, OrbitEnd, OrbitSection, OrbitTask, PpTorus, SectionCondition, SectionError, SectionPoint,
    StartOptions, SweepOptions, TorusPoint, spread_starts, sweep, sweep_on,
};
use support::peers::Method;

fn torus(moments: [f64; 3], center: [f64; 3]) -> PpTorus {
    PpTorus::new(&HeavyTop::new(&Body::from_f64(moments, center).unwrap())).unwrap()
}

fn paper() -> PpTorus {
    torus([2.0, 1.1, 1.0], [0.94868, 0.0, 0.61623])
}

fn starts(torus: &PpTorus, h: f64, l: f64, count: usize) -> Vec<State> {
    let points = spread_starts(torus, h, l, &StartOptions { count, ..StartOptions::default() }).unwrap();
    points.iter().map(|&p| torus.state(p, h, l).unwrap()).collect()
}

fn run(torus: &PpTorus, starts: &[State], crossings: usize) -> Vec<OrbitSection> {
    let options = SweepOptions { crossings, ..SweepOptions::default() };
    sweep(torus, starts, &options, &Monitor::default()).unwrap()
}

fn state_of(point: &SectionPoint) -> State {
    State { gamma: point.gamma, l: point.l }
}

fn reversed(state: State) -> State {
    State { gamma: state.gamma, l: state.l.map(|x| -x) }
}

fn distance(x: &State, y: &State) -> f64 {
    let both = x.gamma.iter().zip(y.gamma).chain(x.l.iter().zip(y.l));
    both.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// Largest deviation of a first integral over all crossings.
fn drift_of(orbits: &[OrbitSection], integral: impl Fn(&State) -> f64) -> f64 {
    let mut worst = 0.0_f64;
    for orbit in orbits {
        let first = integral(&state_of(&orbit.points[0]));
        for point in &orbit.points {
            worst = worst.max((integral(&state_of(point)) - first).abs());
        }
    }
    worst
}

#[test]
fn integrals_hold_to_1e13_over_a_thousand_crossings() {
    let torus = paper();
    let options = SweepOptions { crossings: 1000, ..SweepOptions::default() };
    let monitor = Monitor::default();
    let orbits = sweep(&torus, &starts(&torus, 4.45, 3.25, 64), &options, &monitor).unwrap();
    assert_eq!(orbits.len(), 64);
    assert_eq!(monitor.orbits.into_inner(), 64);
    assert_eq!(monitor.crossings.into_inner(), 64_000);
    for orbit in &orbits {
        assert_eq!((orbit.report.end, orbit.points.len()), (OrbitEnd::Crossings, 1001));
        assert!(orbit.report.drift.largest() <= 1e-13, "{:?}", orbit.report);
        // S is a sum of terms |ω||r||γ| of about 3.
        assert!(orbit.report.residual <= 1e-14, "{:?}", orbit.report);
    }
    let worst = orbits.iter().fold(Integrals::default(), |m, orbit| m.max(&orbit.report.drift));
    println!("worst drift {worst:?}");
    println!("steps per crossing {}", orbits.iter().map(|o| o.report.steps).sum::<u64>() as f64 / 64_000.0);
    println!("worst residual {:e}", orbits.iter().fold(0.0, |m: f64, o| m.max(o.report.residual)));
}

#[test]
fn drift_over_a_million_units_of_time_is_a_random_walk() {
    // Five million steps whose roundings change the energy by about 5e-17 each: a random walk of 1.3e-13 with a largest
    // deviation of about 1.9e-13 (data/accuracy/growth.csv). A linear drift of 1e-19 a step would show as 5e-13.
    let torus = paper();
    let options = SweepOptions { crossings: usize::MAX, max_time: 1e6, tolerance: 1e-18, ..SweepOptions::default() };
    let starts = [starts(&torus, 2.6, 3.25, 1), starts(&torus, 4.45, 3.25, 1)].concat();
    for orbit in sweep(&torus, &starts, &options, &Monitor::default()).unwrap() {
        assert_eq!(orbit.report.end, OrbitEnd::Time);
        assert!(orbit.report.steps > 4_000_000);
        assert!(orbit.report.drift.largest() < 4e-13, "{:?}", orbit.report);
    }
}

#[test]
fn moments_that_are_no_binary_fractions_cause_no_drift() {
    // With 1/A rounded to one double, the energy of these tops drifted by 2.5e-18 a unit of time: the rounding of a
    // constant is the same in every step, and centres of few digits leave no room in which a product could keep it.
    let torus = torus([2.0, 1.25, 1.0], [0.9375, 0.0, 0.625]);
    let options = SweepOptions { crossings: usize::MAX, max_time: 1e5, tolerance: 1e-18, ..SweepOptions::default() };
    for orbit in sweep(&torus, &starts(&torus, 2.6, 3.25, 8), &options, &Monitor::default()).unwrap() {
        assert!(orbit.report.drift.largest() < 1.2e-13, "{:?}", orbit.report);
    }
}

#[test]
fn crossings_alternate_between_incoming_and_outgoing() {
    let torus = paper();
    for orbit in run(&torus, &starts(&torus, 5.3, 3.25, 40), 500) {
        for (k, pair) in orbit.points.windows(2).enumerate() {
            assert!(pair[0].time < pair[1].time);
            assert!(pair[0].s_dot * pair[1].s_dot < 0.0, "orbit {} crossing {k}: {pair:?}", orbit.orbit);
            assert_eq!(pair[1].index, pair[0].index + 1);
        }
    }
}

#[test]
fn the_same_bits_on_every_instruction_set_and_in_every_lane() {
    for condition in [SectionCondition::Height, SectionCondition::AngularMomentum] {
        let torus = paper();
        let starts = starts(&torus, 4.45, 3.25, 19);
        let mut runs = Vec::new();
        for instructions in InstructionSet::available() {
            let options = SweepOptions { crossings: 40, instructions, condition, ..SweepOptions::default() };
            runs.push(sweep(&torus, &starts, &options, &Monitor::default()).unwrap());
        }
        let options = SweepOptions { crossings: 40, condition, ..SweepOptions::default() };
        let alone: Vec<OrbitSection> =
            starts.iter().flat_map(|s| sweep(&torus, &[*s], &options, &Monitor::default()).unwrap()).collect();
        for run in &runs {
            assert_eq!(run, &runs[0]);
        }
        for (one, all) in alone.iter().zip(&runs[0]) {
            assert_eq!(one.report, all.report);
            for (p, q) in one.points.iter().zip(&all.points) {
                assert_eq!(SectionPoint { orbit: 0, ..*q }, *p);
            }
        }
    }
}

#[test]
fn kovalevskayas_integral_holds() {
    let torus = torus([2.0, 2.0, 1.0], [1.0, 0.0, 0.0]);
    let orbits = run(&torus, &starts(&torus, 3.4, 2.87, 32), 1000);
    let case = IntegrableCase::Kovalevskaya(BodyAxis::ALL[2]);
    let drift = drift_of(&orbits, |state| further_integral(case, torus.top(), state));
    assert!(drift <= 1e-12, "{drift:e}");
}

#[test]
fn lagranges_integral_holds() {
    let torus = torus([1.0, 1.0, 0.6], [0.0, 0.0, 1.0]);
    let orbits = run(&torus, &starts(&torus, 2.0, 1.3, 32), 1000);
    assert!(drift_of(&orbits, |state| state.l[2]) <= 1e-12);
}

#[test]
fn eulers_integral_holds_for_a_body_of_almost_no_weight() {
    // r = 0 has no section; |r| = 1e-15 over a time of 300 moves ⟨l,l⟩ by less than 1e-12.
    let torus = torus([2.0, 1.1, 1.0], [1e-15, 0.0, 0.5e-15]);
    let starts = starts(&torus, 1.2, 1.5, 16);
    let options = SweepOptions { crossings: 200, max_time: 300.0, ..SweepOptions::default() };
    let orbits = sweep(&torus, &starts, &options, &Monitor::default()).unwrap();
    assert!(orbits.iter().all(|orbit| orbit.points.len() > 20));
    assert!(drift_of(&orbits, |state| dot(state.l, state.l)) <= 1e-12);
}

#[test]
fn time_reversal_leads_back() {
    // Regular motion, so that rounding does not grow fast.
    let torus = paper();
    let there = run(&torus, &starts(&torus, 2.6, 3.25, 16), 60);
    let ends: Vec<State> = there.iter().map(|o| reversed(state_of(&o.points[60]))).collect();
    for (out, back) in there.iter().zip(run(&torus, &ends, 60)) {
        for (p, q) in out.points.iter().zip(back.points.iter().rev()) {
            let error = distance(&state_of(p), &reversed(state_of(q)));
            assert!(error < 1e-11, "{error:e} orbit {} {p:?} {q:?}", out.orbit);
            assert!((p.time - (out.points[60].time - q.time)).abs() < 1e-11);
        }
    }
}

struct Row {
    case: String,
    orbit: usize,
    index: usize,
    time: f64,
    state: State,
}

fn oracle() -> Vec<Row> {
    let row = |line: &str| {
        let cells: Vec<&str> = line.split(',').collect();
        let x = |k: usize| cells[k].parse::<f64>().unwrap();
        Row {
            case: cells[0].to_owned(),
            orbit: cells[1].parse().unwrap(),
            index: cells[2].parse().unwrap(),
            time: x(3),
            state: State { gamma: [x(4), x(5), x(6)], l: [x(7), x(8), x(9)] },
        }
    };
    support::data("oracles/heyoka/crossings.csv").lines().skip(1).map(row).collect()
}

#[test]
fn crossings_agree_with_heyoka() {
    let bodies = [
        ("paper", [2.0, 1.1, 1.0], [0.94868, 0.0, 0.61623]),
        ("paper-low", [2.0, 1.1, 1.0], [0.94868, 0.0, 0.61623]),
        ("kovalevskaya", [2.0, 2.0, 1.0], [1.0, 0.0, 0.0]),
        ("katok", [2.0, 1.5, 1.0], [1.0, 0.0, 0.0]),
        ("lagrange", [1.0, 1.0, 0.6], [0.0, 0.0, 1.0]),
        ("general", [1.7, 1.3, 0.8], [0.3, -0.5, 0.9]),
    ];
    let rows = oracle();
    let mut compared = 0;
    let mut worst = 0.0_f64;
    for (name, moments, center) in bodies {
        let torus = torus(moments, center);
        let rows: Vec<&Row> = rows.iter().filter(|row| row.case == name).collect();
        let first = rows.iter().filter(|row| row.index == 0);
        let starts: Vec<State> = first.map(|row| row.state).collect();
        let orbits = run(&torus, &starts, 200);
        for row in rows {
            let point = &orbits[row.orbit].points[row.index];
            let difference = distance(&state_of(point), &row.state).max((point.time - row.time).abs());
            assert!(difference < 1e-9, "{name} orbit {} crossing {}: {difference:e}", row.orbit, row.index);
            worst = worst.max(difference);
            compared += 1;
        }
    }
    println!("worst difference from heyoka {worst:e} over {compared} crossings");
    assert_eq!(compared, rows.len());
}

#[test]
fn random_orbits_of_random_bodies_all_return() {
    let mut returned = 0;
    for k in 0..110_u32 {
        // Weyl sequences instead of a random generator.
        let weyl = |step: f64| (f64::from(k) + 0.5) * step % 1.0;
        let moments = [0.5 + 1.5 * weyl(0.414_2), 0.5 + 1.5 * weyl(0.732_1), 0.5 + 1.5 * weyl(0.236_1)];
        let center = [2.0 * weyl(0.645_8) - 1.0, 2.0 * weyl(0.316_6) - 1.0, 2.0 * weyl(0.605_6) - 1.0];
        let torus = torus(moments, center);
        let (h, l) = (6.0 * weyl(0.123_1), 2.0 * weyl(0.358_9));
        let options = StartOptions { count: 100, seed: u64::from(k), ..StartOptions::default() };
        let Ok(points) = spread_starts(&torus, h, l, &options) else { continue };
        let starts: Vec<State> = points.iter().map(|&p| torus.state(p, h, l).unwrap()).collect();
        for orbit in run(&torus, &starts, 4) {
            assert_eq!(orbit.report.end, OrbitEnd::Crossings, "body {k} orbit {}", orbit.orbit);
            returned += 1;
        }
    }
    assert!(returned >= 10_000, "{returned}");
}

#[test]
fn regular_precession_stays_on_the_section() {
    // Lagrange's top with A1 = 1, r = e₃: ω = Ωγ + σe₃ is steady when A1 cosϑ Ω² − l₃Ω − r = 0.
    let torus = torus([1.0, 1.0, 0.6], [0.0, 0.0, 1.0]);
    let (sin, cos, l3) = (0.6, 0.8, 1.0_f64);
    let precession = (l3 + (l3 * l3 + 4.0 * cos).sqrt()) / (2.0 * cos);
    let state = State { gamma: [sin, 0.0, cos], l: [precession * sin, 0.0, l3] };
    assert!(SectionCondition::Height.rate(torus.top(), &state).abs() < 1e-14);
    let orbits = run(&torus, &[state], 10);
    assert_eq!(orbits[0].report.end, OrbitEnd::StaysOnSection);
    assert_eq!(orbits[0].points.len(), 1);
}

#[test]
fn relative_equilibria_stay_on_the_section() {
    // Kovalevskaya's top upright: γ = e₁, l = l e₁.
    let torus = torus([2.0, 2.0, 1.0], [1.0, 0.0, 0.0]);
    let state = State { gamma: [1.0, 0.0, 0.0], l: [1.3, 0.0, 0.0] };
    let orbits = run(&torus, &[state], 10);
    assert_eq!(orbits[0].report.end, OrbitEnd::StaysOnSection);
}

#[test]
fn a_stopped_run_begins_nothing_new() {
    let torus = paper();
    let monitor = Monitor::default();
    monitor.stop.store(true, std::sync::atomic::Ordering::Relaxed);
    let orbits = sweep(&torus, &starts(&torus, 4.45, 3.25, 4), &SweepOptions::default(), &monitor).unwrap();
    assert!(orbits.is_empty());
}

#[test]
fn time_ends_an_orbit() {
    let torus = paper();
    let options = SweepOptions { max_time: 10.0, ..SweepOptions::default() };
    for orbit in sweep(&torus, &starts(&torus, 4.45, 3.25, 9), &options, &Monitor::default()).unwrap() {
        assert_eq!(orbit.report.end, OrbitEnd::Time);
        assert!(orbit.points.len() > 5 && orbit.report.time >= 10.0);
        assert!(orbit.points.iter().all(|point| point.time <= 10.0));
    }
}

#[test]
fn unusable_input_is_named() {
    let torus = paper();
    let options = SweepOptions { tolerance: f64::NAN, ..SweepOptions::default() };
    let error = sweep(&torus, &[], &options, &Monitor::default());
    assert!(matches!(error, Err(SectionError::Tolerance(ToleranceError { .. }))));
    let outside = TorusPoint { theta: 3.0, psi: 0.0, sheet: 1 };
    assert!(matches!(torus.state(outside, 2.0, 3.25), Err(SectionError::SeedInaccessible { .. })));
    let weightless = HeavyTop::new(&Body::from_f64([2.0, 1.0, 1.0], [0.0; 3]).unwrap());
    assert_eq!(PpTorus::new(&weightless), Err(SectionError::WeightlessBody));
}

#[test]
fn other_integrators_find_the_same_crossings() {
    // Regular motion; RK4 and the splitting are of order 4: (0.01)⁴ over 20 crossings.
    let torus = paper();
    let starts = starts(&torus, 2.6, 3.25, 6);
    let methods = [
        (Method::Dop853 { tolerance: 1e-14 }, 200, 1e-9),
        (Method::RungeKutta4 { step: 0.005 }, 20, 1e-6),
        (Method::Splitting { step: 0.005 }, 20, 1e-6),
    ];
    for condition in [SectionCondition::Height, SectionCondition::AngularMomentum] {
        let run = |tolerance| {
            let options = SweepOptions { crossings: 200, tolerance, condition, ..SweepOptions::default() };
            sweep(&torus, &starts, &options, &Monitor::default()).unwrap()
        };
        let expected = run(DEFAULT_TOLERANCE);
        for (coarser, fine) in run(1e-12).iter().zip(&expected) {
            assert_eq!((coarser.report.end, coarser.points.len()), (OrbitEnd::Crossings, fine.points.len()));
            assert!(coarser.report.residual < 1e-14, "{:?}", coarser.report);
            for (p, q) in coarser.points.iter().zip(&fine.points) {
                let error = distance(&state_of(p), &state_of(q)).max((p.time - q.time).abs());
                assert!(error < 1e-10, "{condition:?} crossing {}: {error:e}", p.index);
            }
        }
        for (method, crossings, tolerance) in methods {
            for (start, orbit) in starts.iter().zip(&expected) {
                let found = method.crossings(torus.top(), start, condition, crossings).found;
                let points = orbit.points.iter().filter(|point| point.index > 0).take(crossings);
                assert_eq!((found.len(), points.clone().count()), (crossings, crossings));
                for (a, b) in found.iter().zip(points) {
                    let error = distance(&a.state, &state_of(b)).max((a.time.seconds() - b.time).abs());
                    assert!(error < tolerance, "{method:?} {condition:?} crossing {}: {error:e}", b.index);
                }
            }
        }
    }
}

#[test]
fn the_splitting_keeps_the_casimirs_to_rounding() {
    let torus = paper();
    for start in starts(&torus, 4.45, 3.25, 4) {
        let orbit = Method::Splitting { step: 0.02 }.crossings(torus.top(), &start, SectionCondition::Height, 500);
        let drift = orbit.drift;
        // A random walk of the roundings of 25 rotations a step, of γ (1) and of l (5), and six of its deviations.
        let walk = 6.0 * f64::EPSILON * (25.0 * orbit.steps as f64).sqrt();
        assert!(drift.gamma_squared < walk && drift.vertical_momentum < 5.0 * walk, "{drift:?} {walk:e}");
        assert!(drift.energy < 1e-4, "{drift:?}");
    }
}

#[test]
fn one_orbit_by_the_stepper_is_the_orbit_of_the_sweep() {
    let torus = paper();
    let start = starts(&torus, 4.45, 3.25, 1)[0];
    let options = SweepOptions { max_time: 40.0, crossings: usize::MAX, ..SweepOptions::default() };
    let orbit = &sweep(&torus, &[start], &options, &Monitor::default()).unwrap()[0];
    let mut stepper = Taylor::new(torus.top(), &start, DEFAULT_TOLERANCE).unwrap();
    let mut points = orbit.points.iter().skip(1);
    let mut next = points.next();
    for _ in 0..orbit.report.steps {
        let step = stepper.step().unwrap();
        while let Some(point) = next.filter(|point| point.time < step.end().seconds()) {
            let x = ((point.time - step.start().seconds()) + point.time_low) / step.length();
            assert!(distance(&step.state(x), &state_of(point)) < 1e-14 * 10.0);
            next = points.next();
        }
    }
    assert!(next.is_none());
}

#[test]
fn no_crossing_is_missed() {
    // S sampled densely along the steps: between two samples of different sign lies an odd number of the crossings
    // found, between two of the same sign an even number (pairs closer than the samples: rare, but there).
    let torus = paper();
    let (mut brackets, mut pairs) = (0, 0);
    for h in [4.45, 6.5] {
        let options = SweepOptions { max_time: 400.0, crossings: usize::MAX, ..SweepOptions::default() };
        let starts = starts(&torus, h, 3.25, 12);
        for (orbit, start) in sweep(&torus, &starts, &options, &Monitor::default()).unwrap().iter().zip(&starts) {
            let mut stepper = Taylor::new(torus.top(), start, DEFAULT_TOLERANCE).unwrap();
            let mut crossings = orbit.points.iter().skip(1).map(|p| p.time).peekable();
            // Just after the start, S has the sign of Ṡ.
            let mut positive = orbit.points[0].s_dot > 0.0;
            let mut last_time = 0.0;
            while last_time < 399.0 {
                let step = stepper.step().unwrap();
                for k in 1..=100 {
                    let x = f64::from(k) / 100.0;
                    let time = step.start().after(x * step.length()).seconds();
                    let value = SectionCondition::Height.value(torus.top(), &step.state(x));
                    if value.abs() < 1e-12 {
                        continue;
                    }
                    let mut found = 0;
                    while crossings.next_if(|&t| t < time).is_some() {
                        found += 1;
                    }
                    assert_eq!(found % 2 == 1, positive != (value > 0.0), "orbit {} near {time}", orbit.orbit);
                    brackets += usize::from(found == 1);
                    pairs += usize::from(found == 2);
                    positive = value > 0.0;
                    last_time = time;
                }
            }
        }
    }
    println!("{brackets} crossings, {pairs} pairs between samples");
    assert!(brackets > 8000 && pairs < 20);
}

#[test]
fn orbits_that_are_halted_go_on_bit_for_bit() {
    // Also in units that are not the body's own, on the other section, and from starts on and off the section.
    let bodies = [([2.0, 1.1, 1.0], [0.94868, 0.0, 0.61623]), ([2e40, 1.1e40, 1e40], [0.94868, 0.0, 0.61623])];
    for (moments, center) in bodies {
        for condition in [SectionCondition::Height, SectionCondition::AngularMomentum] {
            let torus = PpTorus::new(&HeavyTop::new(&Body::from_f64(moments, center).unwrap())).unwrap();
            let l = 3.25 * (moments[2]).sqrt();
            let points =
                spread_starts(&torus, 4.45, l, &StartOptions { count: 11, ..StartOptions::default() }).unwrap();
            let starts: Vec<State> = points.iter().map(|&point| torus.state(point, 4.45, l).unwrap()).collect();
            let options = SweepOptions { crossings: 150, condition, ..SweepOptions::default() };
            let whole = sweep(&torus, &starts, &options, &Monitor::default()).unwrap();
            let mut tasks: Vec<OrbitTask> =
                starts.iter().zip(0..).map(|(&start, orbit)| OrbitTask { orbit, start, halt: None }).collect();
            let mut pieces: Vec<Vec<_>> = vec![Vec::new(); starts.len()];
            let mut rounds = 0;
            while !tasks.is_empty() {
                rounds += 1;
                let legs = sweep_on(&torus, &tasks, &options, 40, &Monitor::default()).unwrap();
                for (leg, halt) in legs {
                    let orbit = leg.orbit as usize;
                    pieces[orbit].extend(leg.points);
                    let task = tasks.iter().position(|task| task.orbit == leg.orbit).unwrap();
                    if let Some(halt) = halt {
                        tasks[task].halt = Some(OrbitCheckpoint::from_words(halt.words()));
                    } else {
                        tasks.remove(task);
                        assert_eq!(leg.report, whole[orbit].report);
                    }
                }
            }
            assert_eq!(rounds, 4);
            for (points, whole) in pieces.iter().zip(&whole) {
                assert_eq!(points, &whole.points);
            }
        }
    }
}
