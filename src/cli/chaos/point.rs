//! The chaotic share at one point.

use std::sync::Arc;
use std::sync::atomic::Ordering;

use bifdiag_chaos::{EnergySurface, ShareError, shares};
use bifdiag_diagram::atlas::Spot;
use bifdiag_diagram::topology::Answer;
use bifdiag_documents::Subject;
use bifdiag_documents::words::counted;
use bifdiag_dynamics::section::Monitor;
use bifdiag_exact::Solver;
use bifdiag_schema::{Accuracy, ChaosPointDocument};

use super::arguments::ShareArguments;
use crate::cli::classify::unanswered;
use crate::cli::export::answer;
use crate::cli::failure::{Failure, failed};
use crate::cli::input::{head, integrable};
use crate::cli::terminal::interrupt::stoppable;
use crate::cli::terminal::{Report, Table, Timings};

pub fn run(arguments: &ShareArguments, timings: &Timings) -> Result<(), Failure> {
    let subject = arguments.body.subject()?;
    let h = arguments.point.energy.as_ref().ok_or_else(|| missing("--h", "energy, such as --h 5.3"))?;
    let l = arguments.point.momentum.as_ref().ok_or_else(|| missing("--l", "momentum, such as --l 3.25"))?;
    let solver = Solver::new(subject.body.clone(), Accuracy::Exact);
    let found = timings.stage("classify", || solver.classify(h, l)).map_err(unanswered)?;
    let Answer::Regular(components) = &found.answer else { return Err(no_share(&found.answer)) };
    let Spot::Region(region) = solver.spot(h, l, &found.answer) else { return Err(too_near()) };
    let surface = EnergySurface::new(&subject.body, h.to_f64(), l.to_f64(), components.len());
    let surface = surface.map_err(failed("the energy surface leaves the range of double precision"))?;
    let monitor = Arc::new(Monitor::default());
    let stop = Arc::clone(&monitor);
    let interruptible = stoppable(move || stop.stop.store(true, Ordering::Relaxed));
    let options = arguments.options();
    let shares = timings.stage("orbits", || shares(&surface, &options, &monitor)).map_err(unmeasured)?;
    if !interruptible.over() {
        return Err(Failure::work("interrupted"));
    }
    let document = bifdiag_documents::chaos_point(&subject, [h, l], Some(region), components, &shares, &options);
    answer(arguments.json, &document, || report(&subject, &document))
}

/// A point of which a number is missing.
fn missing(option: &str, what: &str) -> Failure {
    Failure::input(format!("{option} is missing; give the {what}"))
}

/// A point that is in no region.
fn no_share(answer: &Answer) -> Failure {
    Failure::input(match answer {
        Answer::Forbidden => "(h, l) is forbidden: h is below the minimum of U_l; choose h above it",
        _ => {
            "(h, l) lies on a curve of the bifurcation diagram, where the energy surface is singular; choose h above or below"
        }
    })
}

/// A point in a region that doubles cannot tell from a curve.
fn too_near() -> Failure {
    Failure::input(
        "(h, l) is too near to a curve of the bifurcation diagram for orbits in double precision; choose h farther from it",
    )
}

fn unmeasured(error: ShareError) -> Failure {
    Failure::work("the share could not be measured").because(error)
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
    report.line("open: no verdict; the chaotic share lies between `chaotic` and `chaotic` + `open`");
    report.text()
}
