//! Verdicts on orbits whose crossings lie in a journal.

use std::io;

use bifdiag_dynamics::field::State;
use bifdiag_dynamics::poincare::{PoincareError, SectionSetting};
use bifdiag_dynamics::section::chaos::{ChaosOptions, Judgement, OpenReason, TangentCourse, UNIT, growths};
use bifdiag_dynamics::section::{Monitor, OrbitEnd, OrbitSection};

use super::journal::Journal;
use crate::cli::section::error::SectionFailure;

/// The verdicts that the same orbits have in memory. Only the beginning of each orbit is integrated once more, until its verdict is
/// found; where `monitor` stops that, they are open.
///
/// # Errors
/// When the journal cannot be read.
pub fn verdicts(
    setting: &SectionSetting,
    orbits: &[OrbitSection],
    journal: &mut Journal,
    options: &ChaosOptions,
    monitor: &Monitor,
) -> Result<Vec<Judgement>, SectionFailure> {
    let path = journal.path().to_owned();
    let unreadable = |source: io::Error| SectionFailure::Journal { path: path.clone(), source };
    journal.sort();
    let mut courses = Vec::with_capacity(orbits.len());
    for orbit in orbits {
        courses.push(course(journal, orbit).map_err(unreadable)?);
    }
    let growths = growths(setting.torus().top(), courses, options, monitor).map_err(PoincareError::from)?;
    let stopped = monitor.is_stopped();
    let mut judgements = Vec::with_capacity(orbits.len());
    for (orbit, growth) in orbits.iter().zip(&growths) {
        judgements.push(match orbit.report.end {
            OrbitEnd::StaysOnSection => Judgement::open(OpenReason::StaysOnSection),
            _ if stopped || !growth.finite => Judgement::open(OpenReason::Unfinished),
            _ => {
                let crossings = orbit.report.crossings as usize;
                let crossing_at = |time: f64| crossing_at(journal, orbit.orbit, time);
                Judgement::try_new(&growth.evidence, crossings, crossing_at).map_err(unreadable)?
            }
        });
    }
    Ok(judgements)
}

/// An orbit from its first point until its end, or until its verdict is found.
fn course(journal: &mut Journal, orbit: &OrbitSection) -> io::Result<TangentCourse> {
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
fn crossing_at(journal: &mut Journal, orbit: u32, until: f64) -> io::Result<u32> {
    let Some(first) = journal.first(orbit)? else { return Ok(0) };
    let mut passed: u32 = 0;
    journal.times(orbit, &mut |time| {
        let before = time - first.time <= until;
        passed += u32::from(before);
        before
    })?;
    Ok(first.index + passed.saturating_sub(1))
}
