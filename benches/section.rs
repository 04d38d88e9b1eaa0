//! Crossings a second on one core, with times, states, Ṡ and angles stored.
//!
//! The work is that of the peer's benchmark: the paper's body at (h, l) = (4.45, 3.25), 64 orbits of 1000
//! crossings each. `peak` is the share of the fused multiply-add peak that the nine Cauchy products alone take:
//! order(order+1)/2 · 9 of them a lane and step, against a loop of independent multiply-adds timed beside it.

use std::hint::black_box;
use std::time::{Duration, Instant};

use bifdiag::body::Body;
use bifdiag::dynamics::{HeavyTop, State};
use bifdiag::integrator::taylor::{InstructionSet, order_for};
use bifdiag::section::{Monitor, PpTorus, StartOptions, SweepOptions, spread_starts, sweep};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use pulp::{Arch, Simd, WithSimd};

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

/// Lane-wise multiply-adds a second of one core.
struct Peak;

impl WithSimd for Peak {
    type Output = f64;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> f64 {
        const ROUNDS: u32 = 10_000_000;
        let mut sums = [simd.splat_f64s(1e-9); 10];
        let (factor, term) = (simd.splat_f64s(black_box(0.999_999)), simd.splat_f64s(black_box(1e-7)));
        let begin = Instant::now();
        for _ in 0..ROUNDS {
            for sum in &mut sums {
                *sum = simd.mul_add_f64s(*sum, factor, term);
            }
        }
        black_box(sums);
        f64::from(ROUNDS) * (sums.len() * S::F64_LANES) as f64 / begin.elapsed().as_secs_f64()
    }
}

fn crossings(c: &mut Criterion) {
    let (torus, starts) = work();
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("one thread can be had");
    let mut group = c.benchmark_group("crossings");
    group.throughput(Throughput::Elements((ORBITS * CROSSINGS) as u64));
    group.sample_size(20).measurement_time(Duration::from_secs(4));
    for instructions in InstructionSet::available() {
        if instructions == InstructionSet::Baseline {
            continue;
        }
        let options = SweepOptions { crossings: CROSSINGS, instructions, ..SweepOptions::default() };
        let run = || pool.install(|| sweep(&torus, &starts, &options, &Monitor::default()).expect("options are valid"));
        let begin = Instant::now();
        let steps: u64 = run().iter().map(|orbit| orbit.report.steps).sum();
        let order = order_for(1e-15) as u64;
        let products = (steps * 9 * order * (order + 1) / 2) as f64;
        eprintln!(
            "{instructions:?}: order {order}, {:.3} steps a crossing, Cauchy products {:.1} % of the widest peak",
            steps as f64 / (ORBITS * CROSSINGS) as f64,
            100.0 * products / begin.elapsed().as_secs_f64() / Arch::new().dispatch(Peak)
        );
        group.bench_function(format!("{instructions:?}"), |b| b.iter(run));
    }
    group.finish();
}

criterion_group!(benches, crossings);
criterion_main!(benches);
