//! What the terminal shows of a point.

use bifdiag_schema::{ClassificationDocument, ComponentDocument, Status};

use crate::cli::input::head;
use crate::cli::terminal::{Report, Table, bound, significant};
use bifdiag_documents::Subject;

pub fn text(subject: &Subject, document: &ClassificationDocument) -> String {
    let mut report = Report::default();
    head(subject, &mut report);
    report.line(format!("h = {}", document.h));
    report.line(format!("l = {}", document.l));
    report.line("");
    if let Some(region) = &document.region {
        report.line(format!("region {region}"));
    }
    report.line(match document.status {
        Status::Regular => "regular",
        Status::Forbidden => "forbidden: h is below the minimum of the effective potential, U is empty",
        Status::Critical => "critical: exactly on a curve; there meet",
        Status::Undecided => "undecided: closer to a curve than the error bound; possible are",
    });
    if let Some(components) = document.components.as_ref().filter(|components| !components.is_empty()) {
        report.line("");
        report.line(component_table(components));
    }
    for (i, candidate) in document.candidates.iter().enumerate() {
        report.line("");
        report.line(match (&candidate.region, candidate.status) {
            (Some(region), _) => format!("region {region}"),
            (None, Status::Forbidden) => "the forbidden region".to_owned(),
            (None, _) => format!("class {}", i + 1),
        });
        report.line(component_table(&candidate.components));
    }
    report.line("");
    let margin = &document.margin;
    report.line(format!(
        "margin: {} in h to {} (error bound {})",
        significant(margin.h, 6),
        margin.nearest,
        bound(margin.error_bound, 2),
    ));
    if let Some(note) = &document.note {
        report.line(format!("note: {note}"));
    }
    report.text()
}

/// The components of one class.
fn component_table(class: &[ComponentDocument]) -> String {
    if class.is_empty() {
        return "U is empty\n".to_owned();
    }
    let mut table = Table::new(&["U", "E", "P", "genus", "poles"]);
    let missing = || "-".to_owned();
    for component in class {
        table.row([
            component.accessible_region.clone(),
            component.energy_surface.clone(),
            component.section.clone().unwrap_or_else(missing),
            component.genus.map_or_else(missing, |genus| genus.to_string()),
            component.poles.as_ref().map_or_else(missing, |poles| poles.join(" ")),
        ]);
    }
    table.text()
}
