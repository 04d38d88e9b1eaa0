//! Crossings a second of the Poincaré section on one core, for `benches/section_peers.py` and for profilers.
//!
//! `section_rate crossings|time VALUE RUNS`: each orbit to VALUE crossings, or all crossings of each up to time VALUE. The
//! starts are lines of γ and l on stdin, on S = 0 of the paper's body. Writes one JSON object: the crossings, the
//! integrator's steps and order, the seconds of processor time of each run, the largest drift of the first integrals and
//! |S|, and the multiply-adds a second of the products alone and of a loop that does nothing else.

use std::hint::black_box;

use bifdiag_body::Body;
use bifdiag_dynamics::field::{HeavyTop, Integrals, State};
use bifdiag_dynamics::integrator::taylor::order_for;
use bifdiag_dynamics::section::{Monitor, PpTorus, SweepOptions, sweep};

#[path = "../benches/workload/section.rs"]
mod workload;

use workload::{multiply_add_peak, products_per_step, timed};

fn starts() -> Result<Vec<State>, Box<dyn std::error::Error>> {
    let row = |line: std::io::Result<String>| {
        let numbers: Result<Vec<f64>, _> = line?.split_whitespace().map(str::parse).collect();
        match numbers?[..] {
            [a, b, c, d, e, f] => Ok(State { gamma: [a, b, c], l: [d, e, f] }),
            _ => Err("a start is six numbers: gamma and l".into()),
        }
    };
    std::io::stdin().lines().map(row).collect()
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [mode, value, runs] = &arguments[..] else { return Err("section_rate crossings|time VALUE RUNS".into()) };
    let options = match mode.as_str() {
        "crossings" => SweepOptions { crossings: value.parse()?, ..SweepOptions::default() },
        "time" => SweepOptions { crossings: usize::MAX, max_time: value.parse()?, ..SweepOptions::default() },
        _ => return Err("the mode is crossings or time".into()),
    };
    let runs: u32 = runs.parse()?;
    let body = Body::from_f64([2.0, 1.1, 1.0], [0.94868, 0.0, 0.61623])?;
    let torus = PpTorus::new(&HeavyTop::new(&body))?;
    let starts = starts()?;
    // The sweep takes the threads of the pool in which it is called.
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build()?;
    let run = || sweep(&torus, &starts, &options, &Monitor::default());
    let orbits = run()?;
    let mut seconds = Vec::new();
    for _ in 0..runs {
        seconds.push(pool.install(|| timed(|| black_box(run()))).0.as_secs_f64());
    }
    let fastest = seconds.iter().fold(f64::INFINITY, |m: f64, &t| m.min(t));
    let order = order_for(1e-15);
    let steps: u64 = orbits.iter().map(|orbit| orbit.report.steps).sum();
    // The points without the start.
    let crossings: usize = orbits.iter().map(|orbit| orbit.points.len() - 1).sum();
    let drift = orbits.iter().fold(Integrals::default(), |m, orbit| m.max(&orbit.report.drift));
    let report = serde_json::json!({
        "crossings": crossings,
        "steps": steps,
        "order": order,
        "seconds": seconds,
        "drift": [drift.energy, drift.vertical_momentum, drift.gamma_squared],
        "residual": orbits.iter().fold(0.0, |m: f64, orbit| m.max(orbit.report.residual)),
        "products_per_second": steps as f64 * products_per_step(order) / fastest,
        "peak_per_second": multiply_add_peak(),
    });
    println!("{report}");
    Ok(())
}
