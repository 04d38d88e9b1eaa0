//! CPU time of this thread: other work on the machine does not count.

use std::hint::black_box;

use rustix::time::{ClockId, clock_gettime};

fn now() -> f64 {
    let time = clock_gettime(ClockId::ThreadCPUTime);
    time.tv_sec as f64 * 1e6 + time.tv_nsec as f64 * 1e-3
}

/// The result of a job and its CPU time in microseconds: the least of three runs if it takes less than half a millisecond.
pub fn timed<R>(mut job: impl FnMut() -> R) -> (R, f64) {
    const SHORT: f64 = 5e2;
    let mut once = || {
        let start = now();
        let result = black_box(job());
        (result, now() - start)
    };
    let (result, mut least) = once();
    for _ in 0..2 {
        if least < SHORT {
            least = least.min(once().1);
        }
    }
    (result, least)
}

/// Median and 99th percentile.
pub fn quantiles(times: &mut [f64]) -> [f64; 2] {
    times.sort_by(f64::total_cmp);
    [times[times.len() / 2], times[times.len() * 99 / 100]]
}

/// Median, 99th percentile and the largest, as cells of a table; the first two with `digits` digits.
pub fn spread(times: &mut [f64], digits: usize) -> String {
    let [median, high] = quantiles(times);
    format!("{median:.digits$},{high:.digits$},{:.1}", times[times.len() - 1])
}
