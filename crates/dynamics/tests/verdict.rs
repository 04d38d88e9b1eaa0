//! Verdicts: integrable orbits are never called chaotic, the paper's chaos is, islands and unstable periodic orbits are
//! not.

use bifdiag_body::{Body, Number};
use bifdiag_dynamics::field::{HeavyTop, State, dot, norm, sub};
use bifdiag_dynamics::poincare::SectionSetting;
use bifdiag_dynamics::section::chaos::{
    ChaosMeasure, ChaosOptions, Judgement, OpenReason, OrbitVerdict, RotationAngle, TangentCourse, UNIT,
    chaos_measures, growths,
};
use bifdiag_dynamics::section::{
    Monitor, OrbitEnd, OrbitSection, PpTorus, StartOptions, SweepOptions, TorusPoint, spread_starts, sweep,
};
use support::peers::Method;

const PAPER: ([f64; 3], [f64; 3]) = ([2.0, 1.1, 1.0], [0.94868, 0.0, 0.61623]);

fn torus((moments, center): ([f64; 3], [f64; 3])) -> PpTorus {
    PpTorus::new(&HeavyTop::new(&Body::from_f64(moments, center).unwrap())).unwrap()
}

fn starts(torus: &PpTorus, h: f64, l: f64, count: usize) -> Vec<State> {
    let points = spread_starts(torus, h, l, &StartOptions { count, ..StartOptions::default() }).unwrap();
    points.iter().map(|&point| torus.state(point, h, l).unwrap()).collect()
}

fn judged(torus: &PpTorus, starts: &[State], crossings: usize) -> Vec<ChaosMeasure> {
    let options = SweepOptions { crossings, ..SweepOptions::default() };
    let orbits = sweep(torus, starts, &options, &Monitor::default()).unwrap();
    chaos_measures(torus, &orbits, &ChaosOptions::default(), &Monitor::default()).unwrap()
}

fn counted(measures: &[ChaosMeasure], verdict: fn(&OrbitVerdict) -> bool) -> usize {
    measures.iter().filter(|measure| verdict(&measure.judgement.verdict)).count()
}

#[test]
fn integrable_orbits_are_regular_or_open_never_chaotic() {
    let kovalevskaya = ([2.0, 2.0, 1.0], [1.0, 0.0, 0.0]);
    let lagrange = ([1.0, 1.0, 0.6], [0.0, 0.0, 1.0]);
    // A1 = A2 = 4 A3: integrable at l = 0.
    let goryachev_chaplygin = ([4.0, 4.0, 1.0], [1.0, 0.0, 0.0]);
    let cases: [(_, &[(f64, f64)]); 3] = [
        (kovalevskaya, &[(3.4, 2.87), (2.79, 2.449), (1.5, 1.0), (0.5, 0.3), (5.0, 1.0), (2.2, 1.9), (4.0, 3.1)]),
        (lagrange, &[(2.0, 1.3), (1.0, 0.4), (5.0, 2.0)]),
        (goryachev_chaplygin, &[(0.5, 0.0), (0.9, 0.0), (1.05, 0.0), (1.5, 0.0), (3.0, 0.0)]),
    ];
    let (mut regular, mut all) = (0, 0);
    for (body, places) in cases {
        let torus = torus(body);
        for &(h, l) in places {
            let measures = judged(&torus, &starts(&torus, h, l, 64), 2000);
            for measure in &measures {
                assert_ne!(measure.judgement.verdict, OrbitVerdict::Chaotic, "{body:?} ({h}, {l}): {measure:?}");
            }
            regular += counted(&measures, |verdict| *verdict == OrbitVerdict::Regular);
            all += measures.len();
        }
    }
    println!("{regular} of {all} integrable orbits are seen to be regular");
    // The others turn so slowly that their averages have not settled.
    assert!(20 * regular > 18 * all);
}

#[test]
fn the_papers_chaos_is_seen_and_its_islands_are_regular() {
    let torus = torus(PAPER);
    let measures = judged(&torus, &starts(&torus, 5.3, 3.25, 192), 6000);
    let islands =
        measures.iter().filter(|one| matches!(one.rotation, Ok(r) if matches!(r.angle, RotationAngle::Islands(_))));
    let (mut chains, mut calm) = (0, 0);
    for island in islands {
        assert_ne!(island.judgement.verdict, OrbitVerdict::Chaotic, "{island:?}");
        chains += 1;
        calm += u32::from(island.judgement.verdict == OrbitVerdict::Regular);
    }
    assert!(chains > 0 && calm > 0, "{calm} of {chains}");
    for measure in &measures {
        let (lyapunov, judgement) = (measure.lyapunov.unwrap(), &measure.judgement);
        match judgement.verdict {
            OrbitVerdict::Chaotic => assert!(lyapunov.mean_rate * lyapunov.time > 16.0, "{measure:?}"),
            OrbitVerdict::Regular => assert!(lyapunov.mean_rate * lyapunov.time < 8.0, "{measure:?}"),
            OrbitVerdict::Open(_) => assert_eq!(judgement.decided, None),
        }
        let length = |&(time, crossing): &(f64, u32)| time <= lyapunov.time && (70..=6000).contains(&crossing);
        assert!(judgement.decided.iter().all(length), "{judgement:?}");
        assert!(!judgement.to_string().is_empty());
    }
    let [chaotic, open] = [
        |verdict: &OrbitVerdict| *verdict == OrbitVerdict::Chaotic,
        |verdict: &OrbitVerdict| matches!(verdict, OrbitVerdict::Open(_)),
    ]
    .map(|kind| counted(&measures, kind));
    println!("{chaotic} of {} chaotic, {open} open", measures.len());
    assert!(chaotic > 48 && open < 16);
    // Chaos is seen long before the end.
    let early = measures.iter().filter_map(|one| Some((one.judgement.verdict, one.judgement.decided?.1)));
    assert!(early.filter(|(verdict, crossing)| *verdict == OrbitVerdict::Chaotic && *crossing <= 1000).count() > 24);
}

#[test]
fn an_unstable_periodic_orbit_is_not_chaotic() {
    // A pendulum that turns over about the middle axis, which is unstable. γ₂ = ω₁ = ω₃ = 0 remain exactly 0, so that the
    // computed motion stays on the periodic orbit, too.
    let torus = torus(([2.0, 1.5, 1.0], [0.8, 0.0, 0.6]));
    let start = State { gamma: [0.8, 0.0, 0.6], l: [0.0, 9.0, 0.0] };
    for crossings in [100, 500, 2000] {
        let measure = &judged(&torus, &[start], crossings)[0];
        assert_eq!(measure.judgement.verdict, OrbitVerdict::Open(OpenReason::GrowsButSettles), "{measure:?}");
        assert!(measure.lyapunov.unwrap().exponent > 0.1);
    }
}

#[test]
fn what_cannot_be_judged_is_open_and_says_why() {
    let torus = torus(PAPER);
    let starts = starts(&torus, 4.45, 3.25, 2);
    assert_eq!(
        judged(&torus, &starts, 40)[0].judgement.verdict,
        OrbitVerdict::Open(OpenReason::TooShort { crossings: 40 })
    );
    // A relative equilibrium: uniform rotation about r̂ of Lagrange's top.
    let lagrange = self::torus(([1.0, 1.0, 0.6], [0.0, 0.0, 1.0]));
    let sleeping = State { gamma: [0.0, 0.0, 1.0], l: [0.0, 0.0, 3.0] };
    assert_eq!(judged(&lagrange, &[sleeping], 40)[0].judgement.verdict, OrbitVerdict::Open(OpenReason::StaysOnSection));
    let stopped = Monitor::default();
    let orbits = sweep(&torus, &starts, &SweepOptions::default(), &stopped).unwrap();
    stopped.stop.store(true, std::sync::atomic::Ordering::Relaxed);
    let measures = chaos_measures(&torus, &orbits, &ChaosOptions::default(), &stopped).unwrap();
    assert_eq!(measures[0].judgement.verdict, OrbitVerdict::Open(OpenReason::Unfinished));
}

#[test]
fn the_running_exponent_ends_at_the_exponent() {
    let torus = torus(PAPER);
    for measure in judged(&torus, &starts(&torus, 4.45, 3.25, 4), 300) {
        let (lyapunov, running) = (measure.lyapunov.unwrap(), measure.running);
        assert_eq!(running.len(), 301);
        assert!(running[0].is_nan() && running[1..].iter().all(|x| x.is_finite()));
        // The last step ends a little after the last crossing.
        assert!((running[300] - lyapunov.exponent).abs() < 0.02 * lyapunov.exponent.abs().max(0.05));
    }
}

#[test]
fn a_look_is_what_a_fine_sum_over_the_motion_sees() {
    let torus = torus(PAPER);
    let start = starts(&torus, 4.45, 3.25, 1)[0];
    let course = TangentCourse { start, time: 60.0, unit: 40.0, ..TangentCourse::default() };
    let options = ChaosOptions::default();
    let found = &growths(torus.top(), vec![course], &options, &Monitor::default()).unwrap()[0].evidence;
    assert_eq!(found.len(), 2);
    for look in found {
        let (mut sums, mut weights) = ([[0.0; 3]; 2], [0.0; 2]);
        let half_step = |state: &State| Method::RungeKutta4 { step: 5e-4 }.state_after(torus.top(), state, 5e-4);
        let mut state = start;
        for step in 0.. {
            let middle = half_step(&state);
            state = half_step(&middle);
            let part = (f64::from(step) * 1e-3 + 5e-4) / look.time;
            if part > 1.0 {
                break;
            }
            let window = usize::from(part > 0.625);
            let u = (part - [0.25, 0.625][window]) / 0.375;
            let squared = |x: f64| x * x;
            let weight = if u > 0.0 { squared(squared(squared(u * (1.0 - u)))) } else { 0.0 };
            weights[window] += weight;
            for (sum, gamma) in sums[window].iter_mut().zip(middle.gamma) {
                *sum += weight * gamma;
            }
        }
        let [first, second] = [0, 1].map(|window| sums[window].map(|sum| sum / weights[window]));
        let mean: [f64; 3] = std::array::from_fn(|i| 0.5 * (first[i] + second[i]));
        let apart = norm(sub(first, second)) / (1.0 - dot(mean, mean)).sqrt();
        assert!((apart - look.apart).abs() < 1e-6, "{apart} {look:?}");
    }
}

/// A look depends on nothing that comes after it, so that an orbit that is followed further keeps its verdict.
#[test]
fn a_verdict_is_never_withdrawn() {
    // Once called regular after 500 and 1000 crossings, open after 2000, chaotic after 20000.
    let named = torus(([1.7, 1.2, 0.9], [0.3, 0.2, 0.8]));
    let paper = torus(PAPER);
    for (torus, starts) in [
        (&named, starts(&named, 1.3, 2.07, 8)),
        (&paper, starts(&paper, 5.3, 3.25, 24)),
        (&paper, starts(&paper, 3.8, 3.25, 16)),
    ] {
        let whole = judged(torus, &starts, 20_000);
        for crossings in [80, 500, 1000, 2000, 6000] {
            for (shorter, longer) in judged(torus, &starts, crossings).iter().zip(&whole) {
                let (shorter, longer) = (&shorter.judgement, &longer.judgement);
                match shorter.decided {
                    Some(_) => assert_eq!(shorter, longer),
                    None => {
                        assert!(
                            longer.decided.is_none_or(|(_, crossing)| crossing as usize >= crossings),
                            "{longer:?}"
                        );
                    }
                }
            }
        }
    }
}

#[test]
fn no_orbit_is_called_regular_that_turns_out_to_be_chaotic() {
    // Orbits that stick to islands, and thin chaos beside integrable tops. What they are shows by brute force: ln|δ| after
    // 20000 crossings.
    let cases: [(_, f64, f64); 6] = [
        (([1.7, 1.2, 0.9], [0.3, 0.2, 0.8]), 1.3, 2.07),
        (PAPER, 5.3, 3.25),
        (PAPER, 3.1486, 2.72),
        (([2.0, 2.0, 1.0], [1.0, 0.0, 0.03]), 1.5, 1.0),
        (([1.0, 1.02, 0.6], [0.05, 0.0, 1.0]), 2.0, 1.3),
        (([4.0, 3.9, 1.0], [1.0, 0.05, 0.0]), 0.9, 0.0),
    ];
    let [mut regular, mut chaotic] = [0, 0];
    for (body, h, l) in cases {
        let torus = torus(body);
        for measure in judged(&torus, &starts(&torus, h, l, 16), 20_000) {
            let lyapunov = measure.lyapunov.unwrap();
            let [log, log_half] = [lyapunov.exponent * lyapunov.time, lyapunov.exponent_half * 0.5 * lyapunov.time];
            match measure.judgement.verdict {
                OrbitVerdict::Regular => {
                    assert!(log < 25.0, "{body:?} ({h}, {l}): {measure:?}");
                    regular += 1;
                }
                OrbitVerdict::Chaotic => {
                    assert!(log > 50.0 && log > log_half + 15.0, "{body:?} ({h}, {l}): {measure:?}");
                    chaotic += 1;
                }
                OrbitVerdict::Open(_) => {}
            }
        }
    }
    println!("{regular} regular, {chaotic} chaotic");
    assert!(regular > 24 && chaotic > 24 && regular + chaotic > 80, "{regular} {chaotic}");
}

#[test]
fn the_verdict_alone_is_that_beside_the_exponents() {
    let torus = torus(PAPER);
    let starts = starts(&torus, 5.3, 3.25, 12);
    let options = SweepOptions { crossings: 3000, ..SweepOptions::default() };
    let orbits = sweep(&torus, &starts, &options, &Monitor::default()).unwrap();
    let course = |orbit: &OrbitSection| TangentCourse {
        start: State { gamma: orbit.points[0].gamma, l: orbit.points[0].l },
        time: orbit.report.time,
        unit: orbit.points[UNIT].time,
        until_decided: true,
        ..TangentCourse::default()
    };
    let courses = orbits.iter().map(course).collect();
    let alone = growths(torus.top(), courses, &ChaosOptions::default(), &Monitor::default()).unwrap();
    let beside = chaos_measures(&torus, &orbits, &ChaosOptions::default(), &Monitor::default()).unwrap();
    for ((orbit, growth), measure) in orbits.iter().zip(&alone).zip(&beside) {
        let crossing_at = |time: f64| orbit.points.iter().rfind(|point| point.time <= time).unwrap().index;
        let judgement = Judgement::new(&growth.evidence, orbit.points.len() - 1, crossing_at);
        assert_eq!(judgement, measure.judgement);
        assert!(judgement.verdict.is_open() || growth.lyapunov.is_none());
    }
}

#[test]
fn orbits_can_end_where_they_are_decided() {
    let body = Body::from_f64(PAPER.0, PAPER.1).unwrap();
    let number = |x: f64| Number::from_f64(x).unwrap();
    let setting = SectionSetting::new(&body, &number(5.3), &number(3.25)).unwrap();
    let starts: Vec<TorusPoint> = setting.spread(24, 0).unwrap();
    let (options, chaos) = (SweepOptions { crossings: 3000, ..SweepOptions::default() }, ChaosOptions::default());
    let monitor = Monitor::default();
    let early = setting.run_until_decided(&starts, Some(0), &options, &chaos, &monitor).unwrap();
    let whole = setting.run(&starts, Some(0), &options, &monitor).unwrap();
    assert!(early.complete() && early.orbits.len() == 24 && early.chaos.len() == 24);
    let mut lengths = std::collections::BTreeSet::new();
    for ((orbit, measure), whole) in early.orbits.iter().zip(&early.chaos).zip(&whole.orbits) {
        let OrbitSection { points, report, orbit } = orbit;
        assert_eq!((*orbit, measure.orbit), (whole.orbit, whole.orbit));
        assert_eq!(points[..], whole.points[..points.len()]);
        let open = matches!(measure.judgement.verdict, OrbitVerdict::Open(_));
        assert_eq!(report.end, if open || points.len() == 3001 { OrbitEnd::Crossings } else { OrbitEnd::Decided });
        lengths.insert(points.len());
    }
    assert!(lengths.len() > 2, "{lengths:?}");
}
