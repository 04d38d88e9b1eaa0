//! How accurate orbits are: `orbit_accuracy tolerances`, `orbit_accuracy tradeoff` and `orbit_accuracy growth [DECADES]`
//! write the tables of `data/accuracy/` and `data/tradeoff/orbits.csv` as CSV to stdout.
//!
//! `tolerances`: for each integrator and tolerance or step, the steps per crossing, the largest drift of the three first
//! integrals over 64 orbits of 1000 crossings at the paper's (4.45, 3.25), and how far crossing 200 of 16 regular orbits
//! at (2.6, 3.25) is from that of the finest Taylor run.
//!
//! `tradeoff`: error against CPU time for `data/tradeoff/`. Crossing 100 of the four regular and four chaotic orbits of
//! `data/oracles/orbit_reference.csv` (30 digits) against that of each integrator; the largest error of γ and l, and of the
//! time; the largest drifts over these crossings; the steps and the CPU time of the process for a crossing.
//!
//! `growth`: the largest drift of each first integral up to the times 10², 10³, … (10⁶ by default), four orbits each at
//! (2.6, 3.25) and (4.45, 3.25); root mean square over the orbits. Needs 1 GB of memory for 10⁶.

use bifdiag_body::{Body, Number};
use bifdiag_dynamics::field::{HeavyTop, Integrals, State};
use bifdiag_dynamics::section::{
    Monitor, OrbitSection, PpTorus, SectionCondition, SectionError, SectionPoint, StartOptions, SweepOptions,
    spread_starts, sweep,
};
use dashu_ratio::RBig;
use rustix::time::{ClockId, clock_gettime};
use support::peers::{Crossing, Crossings, Method};

type Failure = Box<dyn std::error::Error>;

/// The program's Taylor series, or a peer.
#[derive(Clone, Copy)]
enum Integrator {
    Taylor { tolerance: f64 },
    Peer(Method),
}

/// The crossings of one orbit by either.
struct Orbit {
    /// Times as unevaluated sums, and states; the start is none of them.
    crossings: Vec<([f64; 2], State)>,
    steps: u64,
    drift: Integrals,
}

impl Integrator {
    fn describe(self) -> (&'static str, f64) {
        match self {
            Self::Taylor { tolerance } => ("taylor", tolerance),
            Self::Peer(Method::Dop853 { tolerance }) => ("dop853", tolerance),
            Self::Peer(Method::RungeKutta4 { step }) => ("rk4", step),
            Self::Peer(Method::Splitting { step }) => ("splitting", step),
        }
    }

    /// The Taylor series and its peers at these tolerances and steps.
    fn all(taylor: &[f64], dop853: &[f64], steps: &[f64]) -> Vec<Self> {
        let taylor = taylor.iter().map(|&tolerance| Self::Taylor { tolerance });
        let dop853 = dop853.iter().map(|&tolerance| Self::Peer(Method::Dop853 { tolerance }));
        let runge_kutta = steps.iter().map(|&step| Self::Peer(Method::RungeKutta4 { step }));
        let splitting = steps.iter().map(|&step| Self::Peer(Method::Splitting { step }));
        taylor.chain(dop853).chain(runge_kutta).chain(splitting).collect()
    }

    fn run(self, torus: &PpTorus, starts: &[State], crossings: usize) -> Result<Vec<Orbit>, SectionError> {
        match self {
            Self::Taylor { tolerance } => {
                let options = SweepOptions { crossings, tolerance, ..SweepOptions::default() };
                let orbits = sweep(torus, starts, &options, &Monitor::default())?;
                Ok(orbits.iter().map(Orbit::of_sweep).collect())
            }
            Self::Peer(method) => {
                let orbit = |start| method.crossings(torus.top(), start, SectionCondition::Height, crossings);
                Ok(starts.iter().map(orbit).map(|orbit| Orbit::of_peer(&orbit)).collect())
            }
        }
    }
}

impl Orbit {
    fn of_sweep(orbit: &OrbitSection) -> Self {
        let points = orbit.points.iter().filter(|point| point.index > 0);
        let crossing = |p: &SectionPoint| ([p.time, p.time_low], State { gamma: p.gamma, l: p.l });
        Self { crossings: points.map(crossing).collect(), steps: orbit.report.steps, drift: orbit.report.drift }
    }

    fn of_peer(orbit: &Crossings) -> Self {
        let crossing = |c: &Crossing| ([c.time.seconds(), c.time.remainder()], c.state);
        Self { crossings: orbit.found.iter().map(crossing).collect(), steps: orbit.steps, drift: orbit.drift }
    }
}

fn starts(torus: &PpTorus, h: f64, count: usize) -> Result<Vec<State>, SectionError> {
    let points = spread_starts(torus, h, 3.25, &StartOptions { count, ..StartOptions::default() })?;
    points.iter().map(|&point| torus.state(point, h, 3.25)).collect()
}

fn largest_drift(orbits: &[Orbit]) -> Integrals {
    orbits.iter().fold(Integrals::default(), |m, orbit| m.max(&orbit.drift))
}

fn distance((s, p): &([f64; 2], State), (t, q): &([f64; 2], State)) -> f64 {
    let both = p.gamma.iter().zip(q.gamma).chain(p.l.iter().zip(q.l));
    both.map(|(a, b)| (a - b).abs()).fold((s[0] - t[0]).abs(), f64::max)
}

fn tolerances(torus: &PpTorus) -> Result<(), Failure> {
    let (chaotic, regular) = (starts(torus, 4.45, 64)?, starts(torus, 2.6, 16)?);
    let finest = Integrator::Taylor { tolerance: 1e-18 }.run(torus, &regular, 200)?;
    println!("method,parameter,steps_per_crossing,drift_energy,drift_vertical_momentum,drift_gamma_squared,error_200");
    let integrators =
        Integrator::all(&[1e-18, 1e-15, 1e-12, 1e-9, 1e-6], &[1e-15, 1e-12, 1e-9, 1e-6], &[0.002, 0.01, 0.05]);
    for integrator in integrators {
        let (name, parameter) = integrator.describe();
        let orbits = integrator.run(torus, &chaotic, 1000)?;
        let (steps, crossings) =
            orbits.iter().fold((0, 0), |(s, c), orbit| (s + orbit.steps, c + orbit.crossings.len()));
        let drift = largest_drift(&orbits);
        let found = integrator.run(torus, &regular, 200)?;
        let pairs = found.iter().zip(&finest).map(|(a, b)| a.crossings.get(199).zip(b.crossings.get(199)));
        let error = pairs.fold(0.0_f64, |m, pair| m.max(pair.map_or(f64::INFINITY, |(p, q)| distance(p, q))));
        println!(
            "{name},{parameter:e},{:.2},{:.1e},{:.1e},{:.1e},{error:.1e}",
            steps as f64 / crossings as f64,
            drift.energy,
            drift.vertical_momentum,
            drift.gamma_squared
        );
    }
    Ok(())
}

/// An orbit whose crossing 100 is known to 30 digits.
struct Reference {
    h: f64,
    start: State,
    time: RBig,
    /// γ, then l.
    state: [RBig; 6],
}

fn references() -> Result<Vec<Reference>, Failure> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/data/oracles/orbit_reference.csv");
    let text = std::fs::read_to_string(path)?;
    let exact = |text: &str| text.parse::<Number>().map(|number| number.value().clone());
    text.lines()
        .skip(1)
        .map(|line| {
            let columns: Vec<&str> = line.split(',').collect();
            let numbers = columns.iter().map(|text| exact(text)).collect::<Result<Vec<RBig>, _>>()?;
            let double = |k: usize| columns[k].parse::<f64>();
            let start = State { gamma: [double(1)?, double(2)?, double(3)?], l: [double(4)?, double(5)?, double(6)?] };
            let state = std::array::from_fn(|k| numbers[8 + k].clone());
            Ok(Reference { h: double(0)?, start, time: numbers[7].clone(), state })
        })
        .collect()
}

/// Errors of the state and of the time.
fn errors(reference: &Reference, ([time, low], state): &([f64; 2], State)) -> Result<[f64; 2], Failure> {
    let exact = |x: f64| RBig::try_from(x).map_err(|_| "a crossing is not finite");
    let off = |x: f64, y: &RBig| Ok::<f64, Failure>((exact(x)? - y).to_f64().value().abs());
    let mut largest = 0.0_f64;
    for (x, y) in state.gamma.iter().chain(&state.l).zip(&reference.state) {
        largest = largest.max(off(*x, y)?);
    }
    let time = exact(*time)? + exact(*low)? - &reference.time;
    Ok([largest, time.to_f64().value().abs()])
}

/// CPU time of this process in microseconds.
fn cpu_time() -> f64 {
    let time = clock_gettime(ClockId::ProcessCPUTime);
    time.tv_sec as f64 * 1e6 + time.tv_nsec as f64 * 1e-3
}

fn tradeoff(torus: &PpTorus) -> Result<(), Failure> {
    const CROSSINGS: usize = 100;
    /// Copies of each start, so that the Taylor integrator's registers are full.
    const COPIES: usize = 8;
    let references = references()?;
    let taylor = [1e-18, 1e-16, 1e-15, 1e-14, 1e-13, 1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4];
    let dop853 = [1e-15, 1e-14, 1e-13, 1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5];
    let steps = [0.0005, 0.001, 0.002, 0.004, 0.008, 0.016, 0.032, 0.064];
    println!(
        "method,parameter,h,steps_per_crossing,cpu_us_per_crossing,drift_energy,drift_vertical_momentum,\
         drift_gamma_squared,error_100,time_error_100"
    );
    for integrator in Integrator::all(&taylor, &dop853, &steps) {
        let copies = if matches!(integrator, Integrator::Taylor { .. }) { COPIES } else { 1 };
        for h in [2.6, 4.45] {
            let chosen: Vec<&Reference> = references.iter().filter(|reference| reference.h == h).collect();
            let starts: Vec<State> =
                chosen.iter().flat_map(|reference| std::iter::repeat_n(reference.start, copies)).collect();
            let run = || {
                let before = cpu_time();
                let orbits = integrator.run(torus, &starts, CROSSINGS);
                orbits.map(|orbits| (orbits, cpu_time() - before))
            };
            let (orbits, first) = run()?;
            let time = first.min(run()?.1).min(run()?.1);
            let steps: u64 = orbits.iter().map(|orbit| orbit.steps).sum();
            let crossings = (orbits.len() * CROSSINGS) as f64;
            let mut worst = [0.0_f64; 2];
            for (reference, orbit) in chosen.iter().zip(orbits.iter().step_by(copies)) {
                let last = orbit.crossings.get(CROSSINGS - 1);
                let found = last.map_or(Ok([f64::INFINITY; 2]), |point| errors(reference, point))?;
                worst = [worst[0].max(found[0]), worst[1].max(found[1])];
            }
            let drift = largest_drift(&orbits);
            let (name, parameter) = integrator.describe();
            println!(
                "{name},{parameter:e},{h},{:.2},{:.3},{:.1e},{:.1e},{:.1e},{:.1e},{:.1e}",
                steps as f64 / crossings,
                time / crossings,
                drift.energy,
                drift.vertical_momentum,
                drift.gamma_squared,
                worst[0],
                worst[1]
            );
        }
    }
    Ok(())
}

fn growth(torus: &PpTorus, decades: u32) -> Result<(), Failure> {
    println!("tolerance,h,time,steps,rms_energy,rms_vertical_momentum,rms_gamma_squared");
    for tolerance in [1e-18, 1e-15] {
        for h in [2.6, 4.45] {
            let starts = starts(torus, h, 4)?;
            for max_time in (2..=decades).map(|k| (0..k).fold(1.0, |t, _| t * 10.0)) {
                let options = SweepOptions { crossings: usize::MAX, max_time, tolerance, ..SweepOptions::default() };
                let reports: Vec<_> = sweep(torus, &starts, &options, &Monitor::default())?
                    .into_iter()
                    .map(|orbit| orbit.report)
                    .collect();
                let rms = |part: fn(&Integrals) -> f64| {
                    let squares: f64 = reports.iter().map(|report| part(&report.drift) * part(&report.drift)).sum();
                    (squares / reports.len() as f64).sqrt()
                };
                println!(
                    "{tolerance:e},{h},{max_time:e},{},{:.2e},{:.2e},{:.2e}",
                    reports.iter().map(|report| report.steps).sum::<u64>() / reports.len() as u64,
                    rms(|drift| drift.energy),
                    rms(|drift| drift.vertical_momentum),
                    rms(|drift| drift.gamma_squared)
                );
            }
        }
    }
    Ok(())
}

fn main() -> Result<(), Failure> {
    let body = Body::from_f64([2.0, 1.1, 1.0], [0.94868, 0.0, 0.61623])?;
    let torus = PpTorus::new(&HeavyTop::new(&body))?;
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["tolerances"] => tolerances(&torus),
        ["tradeoff"] => tradeoff(&torus),
        ["growth"] => growth(&torus, 6),
        ["growth", decades] => growth(&torus, decades.parse()?),
        _ => Err("orbit_accuracy tolerances, orbit_accuracy tradeoff, or orbit_accuracy growth [DECADES]".into()),
    }
}
