//! Members of families of periodic orbits that are closed in a second of processor time, and how long the proof of an orbit
//! with a given number of crossings takes.
//!
//! ```text
//! cargo run --release --example rate [families]
//! ```
//! The families of every equilibrium of two bodies, the paper's and one without a mirror, at six momenta, up to 200 members each;
//! the orbits at three points, each proved ten times, unless only families are asked for.

use std::time::Duration;

use bifdiag_body::Body;
use bifdiag_dynamics::poincare::SectionSetting;
use bifdiag_dynamics::section::Monitor;
use bifdiag_equilibria::critical::critical;
use bifdiag_periodic::family::{FamilyOptions, Held, families};
use bifdiag_periodic::list::{ListOptions, list};
use bifdiag_periodic::proof::prove;
use rustix::time::{ClockId, clock_gettime};

const MOMENTA: [&str; 6] = ["0", "0.4", "0.9", "1.5", "2.5", "4"];

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let bodies = [
        Body::parse(&["2", "11/10", "1"], &["0.94868", "0", "0.61623"])?,
        Body::parse(&["3", "2.2", "1.7"], &["0.3", "-0.5", "0.8"])?,
    ];
    let monitor = Monitor::default();
    let options = FamilyOptions { held: Held::Momentum, members: 200, branches: false, monitor: &monitor };
    let (mut members, mut events, mut largest, mut time) = (0, 0, 0.0_f64, Duration::ZERO);
    for body in &bodies {
        for l in MOMENTA {
            for equilibrium in &critical(body, &l.parse()?)?.list {
                let begun = processor_time();
                let found = families(body, equilibrium, &options)?;
                time += processor_time().saturating_sub(begun);
                for family in found {
                    let orbits = &family.stretch.members;
                    members += orbits.len();
                    events += family.stretch.events.len();
                    largest = orbits.iter().fold(largest, |most, orbit| most.max(orbit.residual));
                    println!(
                        "l = {l}, ω = {:.6}: {} members, {} events, {:?} {:?}",
                        family.frequency,
                        orbits.len(),
                        family.stretch.events.len(),
                        family.stretch.end.kind,
                        family.stretch.end.curves,
                    );
                }
            }
        }
    }
    let rate = f64::from(u32::try_from(members)?) / time.as_secs_f64();
    println!(
        "{members} members and {events} events in {time:?}: {rate:.0} members a second; residuals up to {largest:.1e}"
    );
    if std::env::args().nth(1).is_some_and(|only| only == "families") { Ok(()) } else { proofs() }
}

/// The proofs of all orbits at three points that succeed.
fn proofs() -> Result<(), Box<dyn std::error::Error>> {
    const ROUNDS: u32 = 10;
    let paper = (["2", "11/10", "1"], ["0.94868", "0", "0.61623"]);
    let skew = (["2", "1.5", "1"], ["0.3", "0.5", "0.8"]);
    let mut times = Vec::new();
    for ((moments, center), h, l, crossings) in
        [(paper, "6.5", "3.25", 2), (skew, "0.2", "0.5", 4), (skew, "1.3", "0.5", 4)]
    {
        let setting = SectionSetting::new(&Body::parse(&moments, &center)?, &h.parse()?, &l.parse()?)?;
        let options = ListOptions { crossings, ..ListOptions::default() };
        for listed in list(&setting, &options, &Monitor::default())?.orbits {
            let orbit = &listed.orbit;
            let ([g1, g2, g3], [w1, w2, w3]) =
                (orbit.start.gamma, setting.torus().top().inverse_inertia(orbit.start.l));
            let begun = processor_time();
            let mut is_proved = true;
            for _ in 0..ROUNDS {
                let turns = orbit.crossings as usize / 2;
                let proof = prove(setting.body(), setting.point(), [g1, g2, g3, w1, w2, w3], turns, 5.0 * orbit.period);
                is_proved &= proof.is_ok();
            }
            let time = processor_time().saturating_sub(begun) / ROUNDS;
            println!(
                "h = {h}, l = {l}: {} crossings, period {:.3}, trace {:.3}: {} in {time:?}",
                orbit.crossings,
                orbit.period,
                orbit.trace,
                if is_proved { "proved" } else { "not proved" }
            );
            if is_proved {
                times.push(time);
            }
        }
    }
    times.sort();
    let middle = times.get(times.len() / 2).copied().unwrap_or_default();
    println!("{} proofs: median {middle:?}, longest {:?}", times.len(), times.last());
    Ok(())
}

fn processor_time() -> Duration {
    let time = clock_gettime(ClockId::ProcessCPUTime);
    Duration::new(time.tv_sec.unsigned_abs(), u32::try_from(time.tv_nsec).unwrap_or(0))
}
