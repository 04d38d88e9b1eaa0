//! What verdicts on orbits cost, by kind and against the crossings of the same orbits without a verdict, and whether they last.
//!
//! ```text
//! cargo run --release --example chaos_effort -- 200 32
//! cargo run --release --example chaos_effort -- 50 16 3
//! cargo run --release --example chaos_effort -- 300 16 2 50
//! ```
//! Arguments: number of points (h, l), orbits in each component there, how many times as long as any of them was followed all
//! are followed for what they turn out to be (0: not at all), read off the tangent vector alone: *chaotic* if ln|δ| has gained
//! more than 60 in all and 25 in the second half of the time; and the first of the points, which are spread evenly over the diagram
//! of the paper's body. An orbit that was called regular and turns out to be chaotic has a line of its own.

use std::collections::BTreeMap;
use std::hint::black_box;
use std::time::Duration;

use bifdiag::dynamics::field::{HeavyTop, State};
use bifdiag::dynamics::section::chaos::{
    ChaosOptions, Decision, DecisionOptions, Lyapunov, OrbitVerdict, TangentCourse, decisions, growths,
};
use bifdiag::dynamics::section::{Monitor, PpTorus, SectionError, SweepOptions, sweep};
use bifdiag::{Accuracy, Body, Solver};
use bifdiag_chaos::EnergySurface;
use bifdiag_diagram::atlas::Spot;
use bifdiag_numbers::sequence;
use rustix::time::{ClockId, clock_gettime};

/// The window of the points, in h and in l.
const WINDOW: [[f64; 2]; 2] = [[-2.0, 12.0], [0.0, 6.0]];
/// Steps of an early verdict.
const EARLY: u32 = 2560;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1).filter_map(|text| text.parse::<usize>().ok());
    let mut next = |default| arguments.next().unwrap_or(default);
    let [points, orbits, longer, first] = [next(100), next(32), next(0), next(0)];
    let body = Body::from_f64([2.0, 1.1, 1.0], [0.94868, 0.0, 0.61623])?;
    let solver = Solver::new(body.clone(), Accuracy::Exact);
    let mut groups: Vec<Vec<State>> = Vec::new();
    for n in (first..first + points).map(|n| n as u64) {
        let place = sequence::point(n, 2, 0);
        let [h, l] = std::array::from_fn(|k| WINDOW[k][0] + (WINDOW[k][1] - WINDOW[k][0]) * place[k]);
        let Some(Spot::Region(region)) = solver.row(l, &[h]).transpose()?.and_then(|row| row.first().copied()) else {
            continue;
        };
        let count = solver.atlas().and_then(|atlas| atlas.components(region).ok()).map_or(0, <[_]>::len);
        let surface = EnergySurface::new(&body, h, l, count)?;
        for component in 0..count {
            groups.extend(surface.states(component, orbits, 0).ok());
        }
    }
    let top = HeavyTop::new(&body);
    let all = groups.concat();
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build()?;
    let options = DecisionOptions::default();
    let judged = || decisions(&top, &all, &options, &Monitor::default());
    let (time, found) = pool.install(|| timed(|| black_box(judged())));
    let found = found?;
    table(&found, time);
    let plain = plain(&pool, &top, &groups, &found)?;
    let ratio = time.as_secs_f64() / plain.as_secs_f64();
    println!("{plain:?} without verdicts for the same crossings: verdicts take {ratio:.2} times as long");
    if longer > 0 {
        pool.install(|| audit(&top, &all, &found, longer as f64))?;
    }
    Ok(())
}

/// What the orbits turn out to be.
fn audit(top: &HeavyTop, all: &[State], found: &[Decision], longer: f64) -> Result<(), SectionError> {
    let time = longer * found.iter().map(|one| one.time).fold(0.0, f64::max);
    let courses = all.iter().map(|&start| TangentCourse { start, time, ..TangentCourse::default() });
    let grown = growths(top, courses.collect(), &ChaosOptions::default(), &Monitor::default())?;
    let mut kinds: BTreeMap<&str, [u32; 2]> = BTreeMap::new();
    for (one, growth) in found.iter().zip(grown) {
        let Some(Lyapunov { exponent, exponent_half, time, .. }) = growth.lyapunov else { continue };
        let (whole, half) = (exponent * time, exponent_half * 0.5 * time);
        let counts = kinds.entry(kind(one)).or_default();
        counts[0] += 1;
        let is_chaotic = whole > 60.0 && whole - half > 25.0;
        counts[1] += u32::from(is_chaotic);
        if is_chaotic && one.verdict == OrbitVerdict::Regular {
            println!(
                "regular after {} steps at {:.0}: ln|δ| = {half:.0}, {whole:.0} at {:.0}, {time:.0}",
                one.steps,
                one.time,
                0.5 * time
            );
        }
    }
    for (kind, [orbits, chaotic]) in kinds {
        println!("{kind}: {chaotic} of {orbits} turned out to be chaotic until the time {time:.0}");
    }
    Ok(())
}

/// What an orbit is, and whether that was found early.
fn kind(one: &Decision) -> &'static str {
    match one.verdict {
        OrbitVerdict::Regular if one.steps <= EARLY => "regular within 2560 steps",
        OrbitVerdict::Regular => "regular later",
        OrbitVerdict::Chaotic => "chaotic",
        OrbitVerdict::Open(_) => "open",
    }
}

/// The processor time of this thread that a job takes, and its result.
fn timed<R>(job: impl FnOnce() -> R) -> (Duration, R) {
    let now = || {
        let time = clock_gettime(ClockId::ThreadCPUTime);
        Duration::from_secs_f64(time.tv_sec as f64 + 1e-9 * time.tv_nsec as f64)
    };
    let begin = now();
    let result = job();
    (now().saturating_sub(begin), result)
}

/// The time of the crossings alone: of each orbit the mean number of those of its component.
fn plain(
    pool: &rayon::ThreadPool,
    top: &HeavyTop,
    groups: &[Vec<State>],
    found: &[Decision],
) -> Result<Duration, Box<dyn std::error::Error>> {
    let torus = PpTorus::new(top)?;
    let mut next = 0;
    let mut whole = Duration::ZERO;
    for group in groups {
        let own = &found[next..next + group.len()];
        next += group.len();
        let crossings = own.iter().map(|one| one.crossings as usize).sum::<usize>() / own.len().max(1);
        let options = SweepOptions { crossings, ..SweepOptions::default() };
        let (time, orbits) = pool.install(|| timed(|| black_box(sweep(&torus, group, &options, &Monitor::default()))));
        orbits?;
        whole += time;
    }
    Ok(whole)
}

/// Orbits and steps by what they are and whether that was found early.
fn table(found: &[Decision], time: Duration) {
    let mut kinds: BTreeMap<&str, [u64; 3]> = BTreeMap::new();
    for one in found {
        let sums = kinds.entry(kind(one)).or_default();
        let of = [1, u64::from(one.steps), u64::from(one.crossings)];
        sums.iter_mut().zip(of).for_each(|(sum, part)| *sum += part);
    }
    let all = kinds.values().fold([0; 3], |sum: [u64; 3], part| std::array::from_fn(|k| sum[k] + part[k]));
    println!("{:<28} {:>8} {:>12} {:>12}", "", "orbits", "steps", "crossings");
    for (kind, [orbits, steps, crossings]) in kinds.into_iter().chain([("all", all)]) {
        println!("{kind:<28} {orbits:>8} {steps:>12} {crossings:>12}");
    }
    let steps = all[1] as f64;
    println!(
        "{time:?}, {:.0} ns a step, {:.0} orbits a second",
        time.as_secs_f64() * 1e9 / steps,
        all[0] as f64 / time.as_secs_f64()
    );
}
