//! What the terminal shows of a section.

use bifdiag_schema::{ChaosDocument, ConditionName, EndName, SectionDocument, VerdictName, VerdictsName};

use super::table as data;
use crate::cli::input::add_integrals;
use crate::cli::terminal::{Report, Table, counted, significant};

/// Orbits that are listed; the others are in the data.
const LISTED: usize = 48;

pub fn add(report: &mut Report, document: &SectionDocument) {
    report.line("");
    add_surfaces(report, document);
    report.line("");
    report.line(orbits(document).text());
    if document.orbits.len() > LISTED {
        report.line(format!("… and {} more", document.orbits.len() - LISTED));
    }
    report.line("");
    add_summary(report, document);
    for note in &document.notes {
        report.line(format!("note: {note}"));
    }
}

/// The point, U and, of the condition `height`, P.
fn add_surfaces(report: &mut Report, document: &SectionDocument) {
    let region = document.region.as_ref().map_or_else(String::new, |region| format!("{region}: "));
    report.line(format!("{region}h = {}, l = {}", document.h, document.l));
    let names = |name: &dyn Fn(&bifdiag_schema::ComponentDocument) -> String| {
        document.components.iter().map(name).collect::<Vec<_>>().join(" + ")
    };
    report.line(format!("U = {}", names(&|component| component.accessible_region.clone())));
    if document.condition == ConditionName::AngularMomentum {
        // The types of P are those of the other section.
        report.line("section S = <l, gamma x r> = 0");
    } else {
        report.line(format!("P = {}", names(&|component| component.section.clone().unwrap_or_default())));
    }
}

/// The orbits, the first of them.
fn orbits(document: &SectionDocument) -> Table {
    let measured = document.orbits.iter().any(|orbit| orbit.chaos.is_some());
    let judged = document.verdicts != VerdictsName::None;
    let mut heading = vec!["orbit", "component", "theta", "psi", "sheet", "crossings", "end", "time"];
    if measured {
        // The deviations are below, too; a line has no room for all.
        heading.extend(["Lyapunov", "rotation", "verdict"]);
    } else if judged {
        heading.push("verdict");
    } else {
        heading.push("drift");
    }
    let mut table = Table::new(&heading);
    for orbit in document.orbits.iter().take(LISTED) {
        let mut row = vec![
            orbit.orbit.to_string(),
            orbit.component.map_or_else(|| "?".to_owned(), |component| component.to_string()),
            format!("{:.5}", orbit.theta),
            format!("{:.5}", orbit.psi),
            if orbit.sheet > 0 { "+" } else { "-" }.to_owned(),
            orbit.crossings.to_string(),
            end_name(orbit.end).to_owned(),
            significant(orbit.time, 6),
        ];
        if measured {
            let cell = |value: fn(&ChaosDocument) -> Option<f64>| {
                orbit.chaos.as_ref().and_then(value).map_or_else(|| "-".to_owned(), |value| significant(value, 4))
            };
            row.extend([cell(data::lyapunov), cell(data::rotation)]);
        }
        if judged {
            row.push(verdict_name(orbit.verdict).to_owned());
        } else {
            row.push(significant(orbit.drift.h.max(orbit.drift.l).max(orbit.drift.gamma), 2));
        }
        table.row(row);
    }
    table
}

/// How far the orbits were followed, how well, and what they turned out to be.
fn add_summary(report: &mut Report, document: &SectionDocument) {
    let summary = &document.summary;
    report.line(format!(
        "{} of {}",
        counted(summary.crossings, "crossing", "crossings"),
        counted(summary.orbits, "orbit", "orbits")
    ));
    report.line(format!(
        "largest deviations: {} of H, {} of <gamma,l>, {} of <gamma,gamma>; |S| <= {}",
        significant(summary.drift.h, 2),
        significant(summary.drift.l, 2),
        significant(summary.drift.gamma, 2),
        significant(summary.residual, 2),
    ));
    add_integrals(report, &document.integrals);
    if document.verdicts != VerdictsName::None {
        let counted = |name| document.orbits.iter().filter(|orbit| orbit.verdict == name).count();
        let [regular, chaotic, open] = [VerdictName::Regular, VerdictName::Chaotic, VerdictName::Open].map(counted);
        report.line(format!("verdicts: {regular} regular, {chaotic} chaotic, {open} open"));
        report.line("chaotic does not mean unstable: an unstable periodic orbit is not chaotic");
    }
}

fn end_name(end: EndName) -> &'static str {
    match end {
        EndName::Crossings => "crossings",
        EndName::Time => "time",
        EndName::Decided => "decided",
        EndName::StaysOnSection => "stays on S = 0",
        EndName::Failed => "failed",
        EndName::Interrupted => "interrupted",
    }
}

fn verdict_name(verdict: VerdictName) -> &'static str {
    match verdict {
        VerdictName::Regular => "regular",
        VerdictName::Chaotic => "chaotic",
        VerdictName::Open => "open",
    }
}
