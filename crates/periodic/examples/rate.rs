//! Members of families of periodic orbits that are closed in a second of processor time, and the corrections that they took.
//!
//! ```text
//! cargo run --release --example rate
//! ```
//! The families of every equilibrium of two bodies, the paper's and one without a mirror, at six momenta, up to 200 members each.

use std::time::Duration;

use bifdiag_body::Body;
use bifdiag_dynamics::section::Monitor;
use bifdiag_equilibria::critical::critical;
use bifdiag_periodic::family::{FamilyOptions, Held, families};
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
    Ok(())
}

fn processor_time() -> Duration {
    let time = clock_gettime(ClockId::ProcessCPUTime);
    Duration::new(time.tv_sec.unsigned_abs(), u32::try_from(time.tv_nsec).unwrap_or(0))
}
