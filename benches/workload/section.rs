//! What the timings of the sections share: the thread's clock and the multiply-adds that it could do.

use std::hint::black_box;
use std::time::{Duration, Instant};

use pulp::{Arch, Simd, WithSimd};

/// Processor time of this thread, in nanoseconds since it began.
fn thread_time() -> Option<u64> {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    text.split_whitespace().next()?.parse().ok()
}

/// How long something takes: processor time where the system tells it (Linux), else wall time.
pub fn timed<T>(work: impl FnOnce() -> T) -> (Duration, T) {
    let (cpu, wall) = (thread_time(), Instant::now());
    let result = work();
    let wall = wall.elapsed();
    let cpu = cpu.zip(thread_time()).map(|(begin, end)| Duration::from_nanos(end - begin));
    (cpu.unwrap_or(wall), result)
}

/// Lane-wise multiply-adds a second of one core with its best instructions, in a loop of independent ones.
pub fn multiply_add_peak() -> f64 {
    let arch = Arch::new();
    let (time, done) = timed(|| arch.dispatch(MultiplyAdds));
    done / time.as_secs_f64()
}

/// Multiply-adds of a step and lane in the nine Cauchy products alone: 9·order(order + 1)/2.
pub fn products_per_step(order: usize) -> f64 {
    (9 * order * (order + 1) / 2) as f64
}

struct MultiplyAdds;

impl WithSimd for MultiplyAdds {
    type Output = f64;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> f64 {
        const ROUNDS: u32 = 20_000_000;
        let mut sums = [simd.splat_f64s(1e-9); 10];
        let (factor, term) = (simd.splat_f64s(black_box(0.999_999)), simd.splat_f64s(black_box(1e-7)));
        for _ in 0..ROUNDS {
            for sum in &mut sums {
                *sum = simd.mul_add_f64s(*sum, factor, term);
            }
        }
        black_box(sums);
        f64::from(ROUNDS) * (sums.len() * S::F64_LANES) as f64
    }
}
