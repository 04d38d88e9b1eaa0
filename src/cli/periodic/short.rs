//! `bifdiag periodic`: every periodic orbit with few crossings of the section at one point.

use std::sync::atomic::Ordering;
use std::sync::{Arc, Mutex, PoisonError};

use bifdiag_body::Number;
use bifdiag_documents::Subject;
use bifdiag_dynamics::poincare::SectionSetting;
use bifdiag_dynamics::section::{Monitor, SectionError};
use bifdiag_periodic::list::{ListError, ListOptions, MOST_CROSSINGS, OrbitList, Stage, list_watched};
use bifdiag_schema::{PeriodicDocument, PeriodicOrbitDocument};
use clap::Args;
use indicatif::HumanCount;

use crate::cli::export::answer;
use crate::cli::failure::{Failure, failed};
use crate::cli::input::{BodyArguments, PointArguments, head, motion_units};
use crate::cli::section::poincare_failure;
use crate::cli::terminal::interrupt::stoppable;
use crate::cli::terminal::{Progress, Report, Table, Timings, significant, wrapped};

/// The orbits at a point.
#[derive(Debug, Args)]
pub struct ShortArguments {
    #[command(flatten)]
    pub body: BodyArguments,
    #[command(flatten)]
    pub point: PointArguments,
    /// Find the orbits with at most N crossings of P in a period, inward and outward
    #[arg(long, value_name = "N", default_value_t = 2, help_heading = "Orbits")]
    pub crossings: u32,
    /// Print the orbits as JSON
    #[arg(long, help_heading = "Output")]
    pub json: bool,
}

pub fn run(arguments: &ShortArguments, timings: &Timings, quiet: bool) -> Result<(), Failure> {
    let subject = arguments.body.subject()?;
    let crossings = arguments.crossings;
    let (h, l) = point_and_crossings(&arguments.point, crossings)?;
    let setting = SectionSetting::new(&subject.body, h, l).map_err(poincare_failure)?;
    let monitor = Arc::new(Monitor::default());
    let stop = Arc::clone(&monitor);
    let interruptible = stoppable(move || stop.stop.store(true, Ordering::Relaxed));
    let found = listed(&setting, crossings, &monitor, timings, quiet);
    drop(interruptible);
    let found = found?;
    let document = bifdiag_documents::periodic(&subject, [h, l], crossings, &found);
    answer(arguments.json, &document, || text(&subject, &document))
}

/// The orbits at the point; a terminal shows how far the work has come.
pub fn listed(
    setting: &SectionSetting,
    crossings: u32,
    monitor: &Monitor,
    timings: &Timings,
    quiet: bool,
) -> Result<OrbitList, Failure> {
    let options = ListOptions { crossings, ..ListOptions::default() };
    let stage = Mutex::new(None);
    let mut watch = |now| *stage.lock().unwrap_or_else(PoisonError::into_inner) = Some(now);
    let look = || stage.lock().unwrap_or_else(PoisonError::into_inner).map(in_words);
    let search = || Progress::of_stages(quiet).telling(look, || list_watched(setting, &options, monitor, &mut watch));
    timings.stage("orbits", search).map_err(|error| match error {
        ListError::Setting(error) => poincare_failure(error),
        ListError::Section(SectionError::Interrupted) => Failure::work("interrupted"),
        error => failed("the orbits could not be found")(error),
    })
}

/// A stage of the search, in words.
fn in_words(stage: Stage) -> String {
    let count = |number: usize| HumanCount(number as u64);
    match stage {
        Stage::Cover { squares, checked } => {
            format!("covering P: {} squares, {} with the rim checked", count(squares), count(checked))
        }
        Stage::Cells { examined, open, decided } => {
            // Rounded down: all of it is decided only when no cell is open.
            let percent = (decided * 1e4).floor() / 1e2;
            let (examined, open) = (count(examined), count(open));
            format!("searching P: {examined} cells examined, {open} open, {percent:.2}% of the area decided")
        }
        Stage::Proofs { tried, found } => format!("proving the orbits found: {tried} of {found} tried"),
    }
}

/// h and l, which must be given; the number of crossings must be one that is possible.
pub fn point_and_crossings(point: &PointArguments, crossings: u32) -> Result<(&Number, &Number), Failure> {
    let missing =
        |name: &str| Failure::input(format!("{name} is missing: a point such as --h 4.45 --l 3.25 is needed"));
    let h = point.energy.as_ref().ok_or_else(|| missing("--h"))?;
    let l = point.momentum.as_ref().ok_or_else(|| missing("--l"))?;
    if !(2..=MOST_CROSSINGS).contains(&crossings) || crossings % 2 == 1 {
        return Err(Failure::input(format!(
            "--crossings {crossings}: a periodic orbit crosses P inward as often as outward; give 2, 4, … up to \
             {MOST_CROSSINGS}"
        )));
    }
    Ok((h, l))
}

/// Significant digits.
const DIGITS: usize = 6;

/// A smaller component of γ is rounding, as for an orbit in a plane of symmetry.
const ROUNDING: f64 = 1e-13;

fn text(subject: &Subject, document: &PeriodicDocument) -> String {
    let mut report = Report::default();
    head(subject, &mut report);
    report.line(format!(
        "periodic orbits at h = {}, l = {} that cross P, at most {} times in a period:",
        document.h, document.l, document.crossings
    ));
    report.line("");
    if document.orbits.is_empty() {
        report.line("none that is isolated");
    } else {
        report.line(table(&document.orbits).text());
    }
    if !document.continua.is_empty() {
        report.line("");
        report.line(if document.complete {
            "one orbit of each continuum of orbits of one period:"
        } else {
            "one orbit of each piece found of continua of orbits of one period (several pieces may belong to one \
            continuum):"
        });
        report.line(table(&document.continua).text());
    }
    motion_units(subject, &mut report);
    report.line("");
    report.line(format!("{}:", if document.complete { "complete" } else { "not complete" }));
    report.line(wrapped(&document.why));
    report.text()
}

fn table(orbits: &[PeriodicOrbitDocument]) -> Table {
    let mut table = Table::new(&["crossings", "T", "trace", "stability", "symmetric", "action", "proved", "gamma"]);
    for orbit in orbits {
        let gamma = orbit.gamma.map(|x| significant(if x.abs() < ROUNDING { 0.0 } else { x }, DIGITS)).join(" ");
        table.row([
            orbit.crossings.to_string(),
            significant(orbit.period, DIGITS),
            significant(orbit.multipliers[0][0] + orbit.multipliers[1][0], DIGITS),
            orbit.stability.word().to_owned(),
            yes(orbit.symmetric),
            significant(orbit.action, DIGITS),
            yes(orbit.proved),
            gamma,
        ]);
    }
    table
}

/// A boolean in a table.
pub fn yes(is: bool) -> String {
    if is { "yes" } else { "no" }.to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_is_decided_only_when_no_cell_is_open() {
        let stage = Stage::Cells { examined: 123_456, open: 3, decided: 0.999_999 };
        let expected = "searching P: 123,456 cells examined, 3 open, 99.99% of the area decided";
        assert_eq!(in_words(stage), expected);
        let expected = "covering P: 1,234 squares, 56 with the rim checked";
        assert_eq!(in_words(Stage::Cover { squares: 1234, checked: 56 }), expected);
    }
}
