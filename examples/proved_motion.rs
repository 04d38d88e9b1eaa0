//! What proofs of motions cost and how far they reach: writes data/benchmarks/proved_motion.txt to stdout.
//!
//! ```text
//! cargo run --release --example proved_motion > data/benchmarks/proved_motion.txt
//! ```
//! Regular: the four regular orbits of data/oracles/orbit_reference.csv to 1,000 crossings of the section, proved to 1e-10, and
//! the plain motion to the same time; CPU time is the least of five runs. Chaotic: one orbit in several precisions to a bound
//! of 1e-2; growth is the logarithm of the norm of the flow's derivative, λt, as it was computed. Takes three minutes, nearly
//! all for the last line.

use std::sync::atomic::{AtomicBool, AtomicU64};
use std::time::Duration;

use bifdiag_body::{Body, Number};
use bifdiag_dynamics::field::{HeavyTop, State};
use bifdiag_dynamics::motion::{MotionOptions, follow};
use bifdiag_dynamics::section::{Monitor, PpTorus, SweepOptions, sweep};
use bifdiag_enclosure::orbit::{ProofOptions, ProvedMotion, prove};
use bifdiag_enclosure::start::ExactStart;
use dashu_ratio::RBig;
use rustix::time::{ClockId, clock_gettime};

type Failure = Box<dyn std::error::Error>;

/// Crossings of a regular orbit.
const CROSSINGS: usize = 1000;
/// The body `ten`: A, r, and γ and ω of a chaotic motion.
const TEN: [[&str; 3]; 4] = [
    ["0.57847392", "0.53739099", "1"],
    ["0.00595273", "0.00176367", "-0.99998073"],
    ["0", "0.1", "1"],
    ["0.3", "0.2", "0.5"],
];
/// Digits and the time that is asked for.
const CHAOS: [(u32, &str); 4] = [(15, "300"), (19, "300"), (30, "400"), (115, "1400")];

fn main() -> Result<(), Failure> {
    let body = Body::parse(&["2", "1.1", "1"], &["0.94868", "0", "0.61623"])?;
    let torus = PpTorus::new(&HeavyTop::new(&body))?;
    println!("regular, {CROSSINGS} crossings, bound 1e-10");
    println!("time      bits   steps  width    proof s  plain s  ratio");
    for (start, state) in regular(&body)? {
        let options = SweepOptions { crossings: CROSSINGS, ..SweepOptions::default() };
        let orbits = sweep(&torus, &[state], &options, &Monitor::default())?;
        let time = orbits[0].points.last().ok_or("no crossing")?.time;
        let proof = || proved(&body, &start, &[RBig::try_from(time).unwrap_or_default()], None, 1e-10);
        let (seconds, motion) = least(5, proof);
        let stop = AtomicBool::new(false);
        let options = MotionOptions { tolerance: 1e-15, phi: 0.0, stop: &stop };
        let (plain, followed) = least(5, || follow(torus.top(), &state, &[time], &options));
        followed?;
        println!(
            "{time:<9.3} {:<6} {:<6} {:<8.1e} {seconds:<8.4} {plain:<8.5} {:.0}",
            motion.bits,
            motion.steps,
            motion.widest(),
            seconds / plain
        );
    }
    let [a, r, gamma, omega] = TEN;
    let (body, start) = (Body::parse(&a, &r)?, start(gamma, omega)?);
    println!("\nchaotic, bound 1e-2\ndigits bits   steps  proved to  growth  width    proof s");
    for (digits, time) in CHAOS {
        let asked = exact(time)?;
        let (seconds, motion) = least(1, || proved(&body, &start, std::slice::from_ref(&asked), Some(digits), 1e-2));
        let width = motion.samples.first().map_or_else(|| "> 0.01".to_owned(), |_| format!("{:.1e}", motion.widest()));
        println!(
            "{digits:<6} {:<6} {:<6} {:<10.3} {:<7.1} {width:<8} {seconds:.3}",
            motion.bits, motion.steps, motion.proved[1], motion.growth
        );
    }
    Ok(())
}

fn exact(text: &str) -> Result<RBig, Failure> {
    Ok(text.parse::<Number>()?.value().clone())
}

fn exact3([x, y, z]: [&str; 3]) -> Result<[RBig; 3], Failure> {
    Ok([exact(x)?, exact(y)?, exact(z)?])
}

fn start(gamma: [&str; 3], omega: [&str; 3]) -> Result<ExactStart, Failure> {
    Ok(ExactStart { gamma: exact3(gamma)?, omega: exact3(omega)?, phi: RBig::ZERO })
}

/// The starts at h = 2.6: γ and l, which are decimals, exactly and as doubles.
fn regular(body: &Body) -> Result<Vec<(ExactStart, State)>, Failure> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/data/oracles/orbit_reference.csv");
    let text = std::fs::read_to_string(path)?;
    let of_line = |line: &str| -> Result<(ExactStart, State), Failure> {
        let fields: Vec<&str> = line.split(',').collect();
        let [_, x, y, z, a, b, c, ..] = fields[..] else { return Err("a start is six numbers".into()) };
        let (gamma, l) = ([x, y, z], [a, b, c]);
        let double = |v: [&str; 3]| -> Result<[f64; 3], Failure> { Ok([v[0].parse()?, v[1].parse()?, v[2].parse()?]) };
        let state = State { gamma: double(gamma)?, l: double(l)? };
        let l = exact3(l)?;
        let omega = std::array::from_fn(|i| &l[i] / body.moments()[i].value());
        Ok((ExactStart { gamma: exact3(gamma)?, omega, phi: RBig::ZERO }, state))
    };
    text.lines().filter(|line| line.starts_with("2.6,")).map(of_line).collect()
}

fn proved(body: &Body, start: &ExactStart, times: &[RBig], digits: Option<u32>, bound: f64) -> ProvedMotion {
    let (stop, steps) = (AtomicBool::new(false), AtomicU64::new(0));
    prove(body, start, times, &ProofOptions { digits, bound, stop: &stop, steps: &steps })
}

/// The least CPU time in seconds of some runs, and the last answer.
fn least<T>(runs: u32, work: impl Fn() -> T) -> (f64, T) {
    let timed = || {
        let before = processor_time();
        let answer = work();
        (processor_time().saturating_sub(before).as_secs_f64(), answer)
    };
    (1..runs).fold(timed(), |(seconds, _), _| {
        let (next, answer) = timed();
        (seconds.min(next), answer)
    })
}

fn processor_time() -> Duration {
    let time = clock_gettime(ClockId::ProcessCPUTime);
    Duration::new(time.tv_sec.unsigned_abs(), u32::try_from(time.tv_nsec).unwrap_or(0))
}
