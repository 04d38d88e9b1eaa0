//! Sections that can be taken up again, and may be longer than memory: crossings go to `FILE.partial` as they are found.

use std::path::Path;
use std::sync::atomic::Ordering;

use bifdiag_documents::{SectionPlace, Subject};
use bifdiag_dynamics::field::State;
use bifdiag_dynamics::poincare::{PoincareError, PoincareSection, SectionSetting};
use bifdiag_dynamics::section::chaos::{ChaosOptions, Judgement, OpenReason, TangentCourse, UNIT, growths};
use bifdiag_dynamics::section::{
    Monitor, OrbitEnd, OrbitReport, OrbitSection, OrbitTask, SweepOptions, TorusPoint, sweep_on,
};

use super::crossings::{Crossings, Standing};
use super::sites::poincare_failure;
use crate::cli::failure::Failure;

/// Crossings in memory at one time, about.
const CROSSINGS: usize = 1 << 18;
/// Fewest orbits that are followed at one time, so that no lane is idle.
const ORBITS: usize = 128;

/// Follows the orbits of a section into the journal of a file, from where an earlier run has left them. If interrupted,
/// the section is incomplete, and the same call resumes it. If `chaos` is given, the orbits are judged once all are
/// complete. The crossings are only in the journal.
///
/// # Errors
/// When the journal cannot be read or written, or belongs to another section; with `discards` it is restarted instead.
pub fn follow(
    (out, discards): (&Path, bool),
    (subject, setting): (&Subject, &SectionSetting),
    (starts, seed): (&[TorusPoint], Option<u64>),
    options: &SweepOptions,
    chaos: Option<&ChaosOptions>,
    monitor: &Monitor,
) -> Result<(PoincareSection, Crossings), Failure> {
    let mut section = setting.begin(starts, seed, options).map_err(poincare_failure)?;
    let mut journal = Crossings::open(out, &identity(subject, &section)?, starts.len(), discards)?;
    let mut states = Vec::with_capacity(starts.len());
    for start in starts {
        states.push(setting.state(*start).map_err(section_failure)?);
    }
    let known = |standing: &Option<Standing>| standing.map_or(0, |standing| u64::from(standing.report.crossings));
    let before = journal.standings().iter().map(known).sum();
    monitor.crossings.fetch_add(before, Ordering::Relaxed);
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
        let legs = sweep_on(setting.torus(), &tasks, options, most, monitor).map_err(section_failure)?;
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

/// Which section it is: its document before any orbit is followed, and the starts.
fn identity(subject: &Subject, section: &PoincareSection) -> Result<Vec<u8>, Failure> {
    let starts: Vec<_> = section.starts.iter().map(|start| (start.theta, start.psi, start.sheet)).collect();
    Ok(serde_json::to_vec(&(bifdiag_documents::section(subject, section, SectionPlace::Point), starts))?)
}

/// The verdicts that the same orbits have in memory. Only the beginning of each orbit is integrated once more, until its verdict is
/// found; where `monitor` stops that, they are open.
///
/// # Errors
/// When the journal cannot be read.
fn verdicts(
    setting: &SectionSetting,
    orbits: &[OrbitSection],
    journal: &mut Crossings,
    options: &ChaosOptions,
    monitor: &Monitor,
) -> Result<Vec<Judgement>, Failure> {
    journal.sort();
    let mut courses = Vec::with_capacity(orbits.len());
    for orbit in orbits {
        courses.push(course(journal, orbit)?);
    }
    let growths = growths(setting.torus().top(), courses, options, monitor).map_err(section_failure)?;
    let stopped = monitor.is_stopped();
    let mut judgements = Vec::with_capacity(orbits.len());
    for (orbit, growth) in orbits.iter().zip(&growths) {
        judgements.push(match orbit.report.end {
            OrbitEnd::StaysOnSection => Judgement::open(OpenReason::StaysOnSection),
            _ if stopped || !growth.finite => Judgement::open(OpenReason::Unfinished),
            _ => {
                let crossings = orbit.report.crossings as usize;
                let crossing_at = |time: f64| crossing_at(journal, orbit.orbit, time);
                Judgement::try_new(&growth.evidence, crossings, crossing_at)?
            }
        });
    }
    Ok(judgements)
}

/// An orbit from its first point until its end, or until its verdict is found.
fn course(journal: &mut Crossings, orbit: &OrbitSection) -> Result<TangentCourse, Failure> {
    let Some(first) = journal.first(orbit.orbit)? else { return Ok(TangentCourse::default()) };
    let mut passed = 0;
    let mut unit = 0.0;
    journal.times(orbit.orbit, &mut |time| {
        if passed == UNIT {
            unit = time - first.time;
        }
        passed += 1;
        passed <= UNIT
    })?;
    Ok(TangentCourse {
        start: State { gamma: first.gamma, l: first.l },
        time: orbit.report.time - first.time,
        unit,
        until_decided: true,
        ..TangentCourse::default()
    })
}

/// The number of the last crossing until a time after the orbit's first point.
fn crossing_at(journal: &mut Crossings, orbit: u32, until: f64) -> Result<u32, Failure> {
    let Some(first) = journal.first(orbit)? else { return Ok(0) };
    let mut passed: u32 = 0;
    journal.times(orbit, &mut |time| {
        let before = time - first.time <= until;
        passed += u32::from(before);
        before
    })?;
    Ok(first.index + passed.saturating_sub(1))
}

fn section_failure(error: impl Into<PoincareError>) -> Failure {
    poincare_failure(error.into())
}
