//! Crossings a second on one core, with times, states, Ṡ and angles stored.
//!
//! The work is that of the peer's benchmark: the paper's body at (h, l) = (4.45, 3.25), 64 orbits of 1000
//! crossings each. Times are processor times of the one thread where the system tells them (Linux), else wall
//! times. `peak` is the share of the fused multiply-add peak, taken by a loop of independent multiply-adds timed
//! beside it, that the nine Cauchy products alone use: 9·order(order+1)/2 multiply-adds a lane and step.

use std::hint::black_box;
use std::time::Duration;

use bifdiag_body::Body;
use bifdiag_dynamics::field::{HeavyTop, State};
use bifdiag_dynamics::integrator::taylor::{InstructionSet, order_for};
use bifdiag_dynamics::section::{Monitor, OrbitSection, PpTorus, StartOptions, SweepOptions, spread_starts, sweep};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};

#[path = "workload/section.rs"]
mod workload;

use workload::{multiply_add_peak, products_per_step, timed};

const ORBITS: usize = 64;
const CROSSINGS: usize = 1000;

fn work() -> (PpTorus, Vec<State>) {
    let body = Body::from_f64([2.0, 1.1, 1.0], [0.94868, 0.0, 0.61623]).expect("the paper's body is valid");
    let torus = PpTorus::new(&HeavyTop::new(&body)).expect("r is not 0");
    let options = StartOptions { count: ORBITS, ..StartOptions::default() };
    let points = spread_starts(&torus, 4.45, 3.25, &options).expect("the region is accessible");
    let start = |p| torus.state(p, 4.45, 3.25).expect("starts are accessible");
    let starts = points.into_iter().map(start).collect();
    (torus, starts)
}

fn crossings(c: &mut Criterion) {
    let (torus, starts) = work();
    // The sweep takes the threads of the pool in which it is called: one, whose time is then the whole time.
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("one thread can be had");
    let mut group = c.benchmark_group("crossings");
    group.throughput(Throughput::Elements((ORBITS * CROSSINGS) as u64));
    group.sample_size(20).measurement_time(Duration::from_secs(4));
    for instructions in InstructionSet::available() {
        if instructions == InstructionSet::Baseline {
            continue;
        }
        let options = SweepOptions { crossings: CROSSINGS, instructions, ..SweepOptions::default() };
        let run = || sweep(&torus, &starts, &options, &Monitor::default()).expect("options are valid");
        let peak = multiply_add_peak();
        let runs: Vec<(Duration, Vec<OrbitSection>)> = (0..5).map(|_| pool.install(|| timed(run))).collect();
        let best = runs.iter().map(|run| run.0).min().unwrap_or_default().as_secs_f64();
        let steps: u64 = runs[0].1.iter().map(|orbit| orbit.report.steps).sum();
        let order = order_for(1e-15);
        let products = steps as f64 * products_per_step(order);
        eprintln!(
            "{instructions:?}: order {order}, {:.3} steps a crossing, best {:.0} crossings/s, \
             {:.1} % of the peak of {:.1} G multiply-adds/s",
            steps as f64 / (ORBITS * CROSSINGS) as f64,
            (ORBITS * CROSSINGS) as f64 / best,
            100.0 * products / best / peak,
            peak * 1e-9
        );
        group.bench_function(format!("{instructions:?}"), |b| {
            b.iter_custom(|rounds| (0..rounds).map(|_| pool.install(|| timed(|| black_box(run())).0)).sum());
        });
    }
    group.finish();
}

criterion_group!(benches, crossings);
criterion_main!(benches);
