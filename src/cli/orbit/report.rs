//! What the terminal shows of a motion.

use std::path::PathBuf;

use bifdiag_dynamics::motion::MotionSample;
use bifdiag_schema::MotionDocument;

use crate::cli::input::head;
use crate::cli::terminal::{Report, Table, bound, significant};
use bifdiag_documents::Subject;

/// Samples that are listed; those beyond, and all where they are written, are in the data.
const LISTED: usize = 40;

pub fn text(subject: &Subject, document: &MotionDocument, samples: &[MotionSample], written: &[PathBuf]) -> String {
    let mut report = Report::default();
    head(subject, &mut report);
    report.line(format!("h = {}, l = {}", significant(document.h, 10), significant(document.l, 10)));
    report.line("");
    if written.is_empty() {
        report.line(table(samples));
        if samples.len() > LISTED {
            report.line(format!("… and {} more; --data FILE.csv writes all", samples.len() - LISTED));
        }
        report.line("");
    }
    let summary = &document.summary;
    report.line(format!(
        "largest deviations: {} of H, {} of <gamma,l>, {} of <gamma,gamma>",
        significant(summary.drift.h, 2),
        significant(summary.drift.l, 2),
        significant(summary.drift.gamma, 2),
    ));
    report.line(format!(
        "attitude: vertical to {}, against the angles {}",
        bound(summary.vertical_error, 2),
        significant(summary.attitude_difference, 2),
    ));
    for note in &document.notes {
        report.line(format!("note: {note}"));
    }
    report.written(written);
    report.text()
}

fn table(samples: &[MotionSample]) -> String {
    let vector = |v: [f64; 3]| format!("({:>8.5}, {:>8.5}, {:>8.5})", v[0], v[1], v[2]);
    let mut table = Table::new(&["time", "gamma", "omega", "theta", "psi", "phi"]);
    for sample in samples.iter().take(LISTED) {
        table.row([
            significant(sample.time, 6),
            vector(sample.gamma),
            vector(sample.omega),
            format!("{:.5}", sample.theta),
            format!("{:>8.5}", sample.psi),
            format!("{:>9.5}", sample.phi),
        ]);
    }
    table.text()
}
