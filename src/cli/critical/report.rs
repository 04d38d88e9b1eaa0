//! What the terminal shows of relative equilibria.

use schema::{CriticalDocument, Multiplicity, Stability};

use crate::cli::input::Subject;
use crate::cli::terminal::{Report, Table, fixed, significant};

/// Significant digits of the table.
const DIGITS: usize = 10;

pub fn text(subject: &Subject, document: &CriticalDocument) -> String {
    let mut table = Table::new(&["h", "gamma", "omega", "index", "mult", "stability", "branch"]);
    for point in &document.critical {
        let [x, y, z] = point.gamma.map(|x| fixed(x, 6));
        table.row([
            significant(point.h, DIGITS),
            format!("({x:>9}, {y:>9}, {z:>9})"),
            significant(point.omega, 6),
            point.index.to_string(),
            match point.multiplicity {
                Multiplicity::Points(count) => count.to_string(),
                Multiplicity::Circle => "circle".to_owned(),
                Multiplicity::Sphere => "sphere".to_owned(),
            },
            stability_name(point.stability).to_owned(),
            point.branch.clone(),
        ]);
    }
    let mut report = Report::default();
    subject.head(&mut report);
    report.line(format!("l = {}", document.l));
    report.line("");
    report.line(table.text());
    report.line("");
    report.line(format!("error bound of h: {}", significant(document.error_bound, 2)));
    if !document.complete {
        report.line("there may be more: l is within rounding of a cusp or beyond what f64 can decide");
    }
    if let Some(note) = &document.note {
        report.line(format!("note: {note}"));
    }
    report.text()
}

fn stability_name(stability: Stability) -> &'static str {
    match stability {
        Stability::Elliptic => "elliptic",
        Stability::SaddleCentre => "saddle-centre",
        Stability::Saddle => "saddle",
        Stability::Complex => "complex",
        Stability::Degenerate => "degenerate",
    }
}
