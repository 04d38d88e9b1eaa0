//! Summaries of scans.

use crate::body::head;
use crate::classification::accuracy_option;
use crate::scan::command;
use bifdiag_diagram::class::ClassName;
use bifdiag_schema::{Accuracy, ClassRecordDocument, RecordDocument, ScanIdentityDocument, ScanSummaryDocument};
use bifdiag_survey::scan::{ClassRecord, Summary, class_text};

/// The summary of a scan whose file with rows has this format and SHA-256. The texts of the classes are made again from the
/// first body of each.
#[must_use]
pub fn scan_summary(
    summary: &Summary,
    scan: ScanIdentityDocument,
    format: &str,
    sha256: String,
) -> ScanSummaryDocument {
    let ScanIdentityDocument { program, accuracy, design, range } = scan;
    ScanSummaryDocument {
        head: head(
            command(&design, range)
                .option_if("accuracy", accuracy_option(accuracy))
                .option("out", format!("scan.{format}"))
                .json(),
        ),
        program,
        accuracy,
        design,
        range,
        rows: summary.rows,
        classified: summary.classified(),
        undecided: summary.undecided,
        failed: summary.failed,
        work: summary.work,
        format: format.to_owned(),
        sha256,
        critical_points: summary.critical_points.clone(),
        regions: summary.regions.clone(),
        types: summary.types.iter().map(|(key, of)| (key.to_string(), of.clone())).collect(),
        signatures: summary.signatures.iter().map(|(key, of)| (key.to_string(), of.clone())).collect(),
        classes: summary.by_frequency().into_iter().map(|(name, of)| class(name, of, accuracy)).collect(),
    }
}

fn class(name: &ClassName, of: &ClassRecord, accuracy: Accuracy) -> ClassRecordDocument {
    let RecordDocument { bodies, first } = &of.record;
    let text = class_text(first, accuracy).unwrap_or_default();
    ClassRecordDocument {
        class: name.to_string(),
        bodies: *bodies,
        regions: of.regions,
        events: of.events,
        first: first.clone(),
        text: text.lines().map(str::to_owned).collect(),
    }
}
