//! What the terminal shows of relative equilibria.

use std::path::PathBuf;

use bifdiag_schema::{CriticalDocument, Multiplicity, Verdict, small_motions};

use crate::cli::input::head;
use crate::cli::terminal::{Report, Table, bound, fixed, significant};
use bifdiag_documents::Subject;

/// Significant digits of the table.
const DIGITS: usize = 10;

pub fn text(subject: &Subject, document: &CriticalDocument) -> String {
    let mut places = Table::new(&["h", "gamma", "omega", "index", "mult", "curve", "branch"]);
    let mut motions = Table::new(&["curve", "type", "stable", "small motions"]);
    for point in &document.critical {
        let [x, y, z] = point.gamma.map(|x| fixed(x, 6));
        places.row([
            significant(point.h, DIGITS),
            format!("({x:>9}, {y:>9}, {z:>9})"),
            significant(point.omega, 6),
            point.index.to_string(),
            match point.multiplicity {
                Multiplicity::Points(count) => count.to_string(),
                Multiplicity::Circle => "circle".to_owned(),
                Multiplicity::Sphere => "sphere".to_owned(),
            },
            point.branch.clone(),
            point.branch_name.clone(),
        ]);
        motions.row([
            point.branch.clone(),
            point.stability.word().to_owned(),
            point.stable.word().to_owned(),
            small_motions(&[point.eigenvalues], |time| significant(time, 6)),
        ]);
    }
    let mut report = Report::default();
    head(subject, &mut report);
    report.line(format!("l = {}", document.l));
    report.line("");
    report.line(places.text());
    report.line("");
    report.line(motions.text());
    report.line("");
    let unit = document.part.as_ref().map_or_else(String::new, |part| format!(", in {}", part.time_unit()));
    report.line(format!(
        "period: of a small oscillation; growth: the time in which a small deviation grows by the factor e{unit}"
    ));
    if document.critical.iter().any(|point| point.stable == Verdict::Spectrum) {
        report.line("spectrally stable is not stable: all eigenvalues are imaginary, and nothing more is known");
    }
    if let Some(all) = document.critical.iter().find(|point| point.multiplicity == Multiplicity::Sphere) {
        report.line(if all.omega == 0.0 {
            "sphere: at rest every orientation is an equilibrium"
        } else {
            "sphere: rotation about every axis is a relative equilibrium"
        });
    }
    report.line(format!("error bound of h: {}", bound(document.error_bound, 2)));
    if !document.complete {
        report.line("there may be more: l lies beside cusps closer than 2^-4000");
    }
    if let Some(note) = &document.note {
        report.line(format!("note: {note}"));
    }
    report.text()
}

/// What was written of a table.
pub fn written(rows: usize, files: &[PathBuf]) -> String {
    let mut report = Report::default();
    report.line(format!("{rows} relative equilibria"));
    for path in files {
        report.line(format!("written: {}", path.display()));
    }
    report.text()
}
