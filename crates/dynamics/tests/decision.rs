//! Decisions: never chaotic where a top is integrable, as long verdicts have it elsewhere, the same on every machine.

use bifdiag_body::Body;
use bifdiag_dynamics::field::{HeavyTop, State};
use bifdiag_dynamics::integrator::taylor::InstructionSet;
use bifdiag_dynamics::section::chaos::{ChaosOptions, DecisionOptions, OrbitVerdict, decisions, verdicts};
use bifdiag_dynamics::section::{Monitor, PpTorus, StartOptions, SweepOptions, spread_starts, sweep};

fn torus(moments: [f64; 3], center: [f64; 3]) -> PpTorus {
    PpTorus::new(&HeavyTop::new(&Body::from_f64(moments, center).unwrap())).unwrap()
}

fn starts(torus: &PpTorus, h: f64, l: f64, count: usize) -> Vec<State> {
    let points = spread_starts(torus, h, l, &StartOptions { count, ..StartOptions::default() }).unwrap();
    points.iter().map(|&point| torus.state(point, h, l).unwrap()).collect()
}

fn decided(top: &HeavyTop, starts: &[State], options: &DecisionOptions) -> Vec<OrbitVerdict> {
    let found = decisions(top, starts, options, &Monitor::default()).unwrap();
    found.iter().map(|decision| decision.verdict).collect()
}

#[test]
fn integrable_orbits_are_never_chaotic_and_few_stay_open() {
    let cases = [
        ([2.0, 2.0, 1.0], [1.0, 0.0, 0.0], [(3.4, 2.87), (2.79, 2.449), (1.5, 1.0), (0.5, 0.3), (5.0, 1.0)]),
        ([1.0, 1.0, 0.6], [0.0, 0.0, 1.0], [(2.0, 1.3), (1.0, 0.4), (5.0, 2.0), (0.2, 0.3), (9.0, 0.1)]),
        ([4.0, 4.0, 1.0], [1.0, 0.0, 0.0], [(0.5, 0.0), (0.9, 0.0), (1.05, 0.0), (1.5, 0.0), (3.0, 0.0)]),
    ];
    let options = DecisionOptions::default();
    for (moments, center, places) in cases {
        let (mut open, mut all) = (0, 0);
        for (h, l) in places {
            let torus = torus(moments, center);
            let found = decided(torus.top(), &starts(&torus, h, l, 200), &options);
            assert!(!found.contains(&OrbitVerdict::Chaotic), "{moments:?} ({h}, {l})");
            open += found.iter().filter(|verdict| verdict.is_open()).count();
            all += found.len();
        }
        println!("{moments:?}: {open} of {all} open");
        assert!(20 * open < all, "{moments:?}: {open} of {all}");
    }
}

/// A top without weight has no section, and is decided all the same.
#[test]
fn a_weightless_top_is_regular() {
    let top = HeavyTop::new(&Body::from_f64([2.0, 1.5, 1.0], [0.0; 3]).unwrap());
    let state = |k: u32| {
        let x = |step: f64| 2.0 * (f64::from(k) * step % 1.0) - 1.0;
        let gamma = [x(0.41), x(0.73), x(0.27)];
        let size = bifdiag_dynamics::field::norm(gamma);
        State { gamma: gamma.map(|g| g / size), l: [3.0 * x(0.13), 3.0 * x(0.59), 3.0 * x(0.87)] }
    };
    let found = decided(&top, &(1..200).map(state).collect::<Vec<_>>(), &DecisionOptions::default());
    assert!(!found.contains(&OrbitVerdict::Chaotic));
    let open = found.iter().filter(|verdict| verdict.is_open()).count();
    println!("{open} of {} open", found.len());
    assert!(open < 10);
}

/// What was decided early is what eight times as many crossings show, but for orbits that stick to islands.
#[test]
fn decisions_are_those_of_long_verdicts() {
    let torus = torus([2.0, 1.1, 1.0], [0.94868, 0.0, 0.61623]);
    let (mut compared, mut wrong, mut chaotic) = (0, 0, 0);
    for (h, l) in [(5.3, 3.25), (6.0, 2.0), (3.8, 1.0)] {
        let starts = starts(&torus, h, l, 96);
        let found = decided(torus.top(), &starts, &DecisionOptions::default());
        let long = SweepOptions { crossings: 8000, ..SweepOptions::default() };
        let orbits = sweep(&torus, &starts, &long, &Monitor::default()).unwrap();
        let truth = verdicts(&torus, &orbits, &ChaosOptions::default(), &Monitor::default()).unwrap();
        for (early, late) in found.iter().zip(truth) {
            if !early.is_open() && !late.verdict.is_open() {
                compared += 1;
                wrong += u32::from(*early != late.verdict);
                chaotic += u32::from(*early == OrbitVerdict::Chaotic);
            }
        }
    }
    println!("{compared} compared, {chaotic} chaotic, {wrong} otherwise");
    assert!(compared > 200 && chaotic > 40);
    assert!(100 * wrong <= compared, "{wrong} of {compared}");
}

#[test]
fn decisions_do_not_depend_on_instructions_or_neighbours() {
    let torus = torus([2.0, 1.1, 1.0], [0.94868, 0.0, 0.61623]);
    let starts = starts(&torus, 5.3, 3.25, 24);
    let of = |starts: &[State], instructions| {
        let options = DecisionOptions { steps: 640, instructions, ..DecisionOptions::default() };
        decisions(torus.top(), starts, &options, &Monitor::default()).unwrap()
    };
    let best = of(&starts, InstructionSet::Best);
    for set in InstructionSet::available() {
        assert_eq!(of(&starts, set), best, "{set:?}");
    }
    assert_eq!(of(&starts[7..13], InstructionSet::Best), best[7..13]);
}
