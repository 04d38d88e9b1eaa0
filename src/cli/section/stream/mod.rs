//! Sections that can be taken up again, and may be longer than memory: crossings go to `FILE.partial` as they are found.

mod journal;
mod judge;

use std::path::Path;

use bifdiag_dynamics::poincare::{PoincareSection, SectionSetting};
use bifdiag_dynamics::section::chaos::ChaosOptions;
use bifdiag_dynamics::section::{Monitor, OrbitReport, OrbitSection, OrbitTask, SweepOptions, TorusPoint, sweep_on};

use self::journal::Standing;
use self::judge::verdicts;
use super::error::SectionFailure;

pub use self::journal::Journal;

/// Crossings in memory at one time, about.
const CROSSINGS: usize = 1 << 18;
/// Fewest orbits that are followed at one time, so that no lane is idle.
const ORBITS: usize = 128;

/// Follows the orbits of a section into the journal of a file, from where an earlier run has left them. Interrupted, it
/// is not complete, and the same again goes on. Where `chaos` is given, the orbits are judged when all are there. The
/// crossings are in the journal alone.
///
/// # Errors
/// When the journal cannot be read or written, or belongs to another section; with `discards` it is begun anew instead.
pub fn follow(
    (out, discards): (&Path, bool),
    setting: &SectionSetting,
    (starts, seed): (&[TorusPoint], Option<u64>),
    options: &SweepOptions,
    chaos: Option<&ChaosOptions>,
    monitor: &Monitor,
) -> Result<(PoincareSection, Journal), SectionFailure> {
    let mut section = setting.begin(starts, seed, options)?;
    let mut journal = Journal::open(out, &identity(&section), starts.len(), discards)?;
    let mut states = Vec::with_capacity(starts.len());
    for start in starts {
        states.push(setting.state(*start).map_err(bifdiag_dynamics::poincare::PoincareError::from)?);
    }
    let known = |standing: &Option<Standing>| standing.map_or(0, |standing| u64::from(standing.report.crossings));
    let before = journal.standings().iter().map(known).sum();
    monitor.crossings.fetch_add(before, std::sync::atomic::Ordering::Relaxed);
    let at_once = (CROSSINGS / options.crossings.saturating_add(1)).max(ORBITS);
    while !monitor.is_stopped() {
        let goes_on = |standing: &Option<Standing>| standing.is_none_or(|standing| standing.halt.is_some());
        let pending =
            journal.standings().iter().zip(&states).zip(0_u32..).filter(|((standing, _), _)| goes_on(standing));
        let tasks: Vec<OrbitTask> = pending
            .take(at_once)
            .map(|((standing, start), orbit)| OrbitTask {
                orbit,
                start: *start,
                halt: standing.and_then(|known| known.halt),
            })
            .collect();
        if tasks.is_empty() {
            break;
        }
        let most = (CROSSINGS / tasks.len()).max(1);
        let legs = sweep_on(setting.torus(), &tasks, options, most, monitor)
            .map_err(bifdiag_dynamics::poincare::PoincareError::from)?;
        for (orbit, halt) in legs {
            journal.append(&orbit, halt)?;
        }
    }
    let report = |(standing, orbit): (&Option<Standing>, u32)| -> Option<OrbitSection> {
        let report: OrbitReport = standing.as_ref()?.report;
        Some(OrbitSection { points: Vec::new(), report, orbit })
    };
    section.orbits = journal.standings().iter().zip(0_u32..).filter_map(report).collect();
    if let Some(chaos) = chaos.filter(|_| section.complete()) {
        section.verdicts = verdicts(setting, &section.orbits, &mut journal, chaos, monitor)?;
        section.chaos_interrupted = monitor.is_stopped();
    }
    journal.sort();
    Ok((section, journal))
}

/// Which section it is: the starts, and all that is asked of them.
fn identity(section: &PoincareSection) -> String {
    let PoincareSection { body, h, l, starts, options, .. } = section;
    let [moments, center] = [body.moments(), body.center()].map(|numbers| bifdiag_documents::texts(numbers).join(","));
    let starts: Vec<String> =
        starts.iter().map(|start| format!("{:?} {:?} {}", start.theta, start.psi, start.sheet)).collect();
    format!(
        "bifdiag {} section A={moments} r={center} h={} l={} crossings={} max_time={:?} tolerance={:?} condition={:?} starts={}",
        env!("CARGO_PKG_VERSION"),
        h.text(),
        l.text(),
        options.crossings,
        options.max_time,
        options.tolerance,
        options.condition,
        starts.join(";"),
    )
}
