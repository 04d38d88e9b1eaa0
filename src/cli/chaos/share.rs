//! The chaotic share at one point.

use std::sync::Arc;
use std::sync::atomic::Ordering;

use bifdiag_chaos::{PointError, point_shares};
use bifdiag_documents::Subject;
use bifdiag_documents::words::counted;
use bifdiag_dynamics::section::Monitor;
use bifdiag_exact::Solver;
use bifdiag_schema::{Accuracy, ChaosPointDocument};

use super::arguments::ShareArguments;
use crate::cli::classify::unanswered;
use crate::cli::export::answer;
use crate::cli::failure::Failure;
use crate::cli::input::{head, integrable};
use crate::cli::terminal::interrupt::stoppable;
use crate::cli::terminal::{Report, Table, Timings};

pub fn run(arguments: &ShareArguments, timings: &Timings) -> Result<(), Failure> {
    let subject = arguments.body.subject()?;
    let h = arguments.point.energy.as_ref().ok_or_else(|| missing("--h", "energy, such as --h 5.3"))?;
    let l = arguments.point.momentum.as_ref().ok_or_else(|| missing("--l", "momentum, such as --l 3.25"))?;
    let solver = Solver::new(subject.body.clone(), Accuracy::Exact);
    let monitor = Arc::new(Monitor::default());
    let stop = Arc::clone(&monitor);
    let interruptible = stoppable(move || stop.stop.store(true, Ordering::Relaxed));
    let options = arguments.options();
    let found = timings.stage("orbits", || point_shares(&solver, [h, l], &options, &monitor)).map_err(unmeasured)?;
    if !interruptible.over() {
        return Err(Failure::work("interrupted"));
    }
    let document = bifdiag_documents::chaos_point(&subject, [h, l], &found, &options);
    answer(arguments.json, &document, || report(&subject, &document))
}

/// A point with a number missing.
fn missing(option: &str, what: &str) -> Failure {
    Failure::input(format!("{option} is missing; give the {what}"))
}

/// What another point mends is wrong input.
fn unmeasured(error: PointError) -> Failure {
    let message = error.to_string();
    match error {
        PointError::Nowhere(_) | PointError::TooNear => Failure::input(error),
        PointError::Answer(error) => unanswered(error),
        PointError::Range(cause) => Failure::work(message).because(cause),
        PointError::Share(cause) => Failure::work(message).because(cause),
    }
}

/// What the terminal shows.
fn report(subject: &Subject, document: &ChaosPointDocument) -> String {
    let mut report = Report::default();
    head(subject, &mut report);
    integrable(&subject.body, &mut report);
    report.line(format!("h = {}", document.h));
    report.line(format!("l = {}", document.l));
    report.line("");
    if let Some(region) = &document.region {
        report.line(format!("region {region}"));
    }
    let mut table = Table::new(&["U", "E", "chaotic", "error", "open", "orbits", "crossings"]);
    for share in &document.components {
        table.row([
            share.accessible_region.clone(),
            share.energy_surface.clone(),
            format!("{:.3}", share.fraction),
            format!("{:.3}", share.error),
            format!("{:.3}", share.open),
            share.orbits.to_string(),
            share.crossings.to_string(),
        ]);
    }
    report.line(table.text());
    let all: u64 = document.components.iter().map(|share| share.orbits).sum();
    report.line(format!(
        "shares of the Liouville measure of each component, from {}; error: one standard deviation",
        counted(all, "orbit", "orbits")
    ));
    report.line(
        "open: no verdict; apart from this error, the chaotic share lies between `chaotic` and `chaotic` + `open`",
    );
    report.text()
}
