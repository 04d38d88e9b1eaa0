//! How accurate orbits are: `orbit_accuracy tolerances` and `orbit_accuracy growth [DECADES]` write the tables of
//! `data/accuracy/` as CSV to stdout.
//!
//! `tolerances`: for each integrator and tolerance or step, the steps per crossing, the largest drift of the three first
//! integrals over 64 orbits of 1000 crossings at the paper's (4.45, 3.25), and how far crossing 200 of 16 regular orbits
//! at (2.6, 3.25) is from that of the finest Taylor run.
//!
//! `growth`: the largest drift of each first integral up to the times 10², 10³, … (10⁶ by default), four orbits each at
//! (2.6, 3.25) and (4.45, 3.25); root mean square over the orbits. Needs 1 GB of memory for 10⁶.

use bifdiag::body::Body;
use bifdiag::dynamics::{HeavyTop, Integrals, State};
use bifdiag::integrator::Method;
use bifdiag::section::{
    Monitor, OrbitSection, PpTorus, SectionError, SectionPoint, StartOptions, SweepOptions, spread_starts, sweep,
};

type Failure = Box<dyn std::error::Error>;

fn starts(torus: &PpTorus, h: f64, count: usize) -> Result<Vec<State>, SectionError> {
    let points = spread_starts(torus, h, 3.25, &StartOptions { count, ..StartOptions::default() })?;
    points.iter().map(|&point| torus.state(point, h, 3.25)).collect()
}

fn largest_drift(orbits: &[OrbitSection]) -> Integrals {
    orbits.iter().fold(Integrals::default(), |m, orbit| m.max(&orbit.report.drift))
}

fn distance(p: &SectionPoint, q: &SectionPoint) -> f64 {
    let both = p.gamma.iter().zip(q.gamma).chain(p.l.iter().zip(q.l));
    both.map(|(a, b)| (a - b).abs()).fold((p.time - q.time).abs(), f64::max)
}

fn tolerances(torus: &PpTorus) -> Result<(), Failure> {
    let (chaotic, regular) = (starts(torus, 4.45, 64)?, starts(torus, 2.6, 16)?);
    let run = |starts: &[State], method, crossings| {
        let options = SweepOptions { crossings, method, ..SweepOptions::default() };
        sweep(torus, starts, &options, &Monitor::default())
    };
    let finest = run(&regular, Method::Taylor { tolerance: 1e-18 }, 200)?;
    let taylor = [1e-18, 1e-15, 1e-12, 1e-9, 1e-6].map(|tolerance| Method::Taylor { tolerance });
    let dop853 = [1e-15, 1e-12, 1e-9, 1e-6].map(|tolerance| Method::Dop853 { tolerance });
    let runge_kutta = [0.002, 0.01, 0.05].map(|step| Method::RungeKutta4 { step });
    let splitting = [0.002, 0.01, 0.05].map(|step| Method::Splitting { step });
    println!("method,parameter,steps_per_crossing,drift_energy,drift_vertical_momentum,drift_gamma_squared,error_200");
    for method in [&taylor[..], &dop853, &runge_kutta, &splitting].concat() {
        let (name, parameter) = match method {
            Method::Taylor { tolerance } => ("taylor", tolerance),
            Method::Dop853 { tolerance } => ("dop853", tolerance),
            Method::RungeKutta4 { step } => ("rk4", step),
            Method::Splitting { step } => ("splitting", step),
        };
        let orbits = run(&chaotic, method, 1000)?;
        let (steps, crossings) =
            orbits.iter().fold((0, 0), |(s, c), orbit| (s + orbit.report.steps, c + orbit.points.len() - 1));
        let drift = largest_drift(&orbits);
        let found = run(&regular, method, 200)?;
        let last = |orbit: &OrbitSection| orbit.points.get(200).copied();
        let pairs = found.iter().zip(&finest).map(|(a, b)| last(a).zip(last(b)));
        let error = pairs.fold(0.0_f64, |m, pair| m.max(pair.map_or(f64::INFINITY, |(p, q)| distance(&p, &q))));
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

fn growth(torus: &PpTorus, decades: u32) -> Result<(), Failure> {
    println!("tolerance,h,time,steps,rms_energy,rms_vertical_momentum,rms_gamma_squared");
    for tolerance in [1e-18, 1e-15] {
        for h in [2.6, 4.45] {
            let starts = starts(torus, h, 4)?;
            for max_time in (2..=decades).map(|k| (0..k).fold(1.0, |t, _| t * 10.0)) {
                let method = Method::Taylor { tolerance };
                let options = SweepOptions { crossings: usize::MAX, max_time, method, ..SweepOptions::default() };
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
        ["growth"] => growth(&torus, 6),
        ["growth", decades] => growth(&torus, decades.parse()?),
        _ => Err("orbit_accuracy tolerances, or orbit_accuracy growth [DECADES]".into()),
    }
}
