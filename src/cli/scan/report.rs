//! What the terminal shows of a scan.

use std::path::Path;

use bifdiag_documents::words::counted;
use bifdiag_schema::ScanSummaryDocument;

use super::output::summary_path;
use crate::cli::terminal::{Report, Table};

/// The most frequent classes that are listed.
const LISTED: usize = 12;

pub fn text(document: &ScanSummaryDocument, out: &Path) -> String {
    let mut report = Report::default();
    report.line(format!(
        "{}: {} classified, {} undecided, {} failed",
        counted(document.rows, "body", "bodies"),
        document.classified,
        document.undecided,
        document.failed
    ));
    let single = document.classes.iter().filter(|class| class.bodies == 1).count();
    let classes = counted(document.classes.len(), "class", "classes");
    report.line(format!("{classes}, {single} of them met once"));
    if let Some((most, record)) = document.critical_points.last_key_value() {
        report.line(format!("at most {most} relative equilibria at one l (body {})", record.first.index));
    }
    report.line("");
    let mut table = Table::new(&["class", "bodies", "share", "regions", "cusps", "pitchforks", "crossings", "first"]);
    for class in document.classes.iter().take(LISTED) {
        let [cusps, pitchforks, crossings] = class.events;
        table.row([
            class.class.clone(),
            class.bodies.to_string(),
            format!("{:.2}%", 100.0 * class.bodies as f64 / document.rows.max(1) as f64),
            class.regions.to_string(),
            cusps.to_string(),
            pitchforks.to_string(),
            crossings.to_string(),
            class.first.index.to_string(),
        ]);
    }
    report.line(table.text());
    if document.classes.len() > LISTED {
        report.line(format!("and {} more in the summary", document.classes.len() - LISTED));
    }
    report.line("");
    report.line(format!("written: {}", out.display()));
    report.line(format!("written: {}", summary_path(out).display()));
    report.text()
}
