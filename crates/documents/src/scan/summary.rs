//! Summaries of scans.

use crate::body::head;
use crate::classification::accuracy_option;
use crate::scan::command;
use bifdiag_diagram::class::ClassName;
use bifdiag_schema::{
    Accuracy, BodyRecordDocument, ClassRecordDocument, DesignDocument, RecordDocument, ScanSummaryDocument,
};
use bifdiag_survey::scan::{BodyRecord, ClassRecord, Record, Summary, class_text};

/// The file with the rows of a scan.
#[derive(Clone, Debug, PartialEq)]
pub struct ScanFile {
    /// Version of the program that made it.
    pub program: String,
    /// What the answers are worth.
    pub accuracy: Accuracy,
    /// Which bodies the scan looks at.
    pub design: DesignDocument,
    /// The numbers of the bodies: from this one on, up to but without that one.
    pub range: [u64; 2],
    /// Format of the file.
    pub format: String,
    /// Its SHA-256.
    pub sha256: String,
}

/// The summary of a scan. The texts of the classes are made again from the first body of each.
#[must_use]
pub fn scan_summary(summary: &Summary, file: ScanFile) -> ScanSummaryDocument {
    let ScanFile { program, accuracy, design, range, format, sha256 } = file;
    let by_number = |(key, of): (&u32, &Record)| (*key, record(of));
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
        format,
        sha256,
        critical_points: summary.critical_points.iter().map(by_number).collect(),
        regions: summary.regions.iter().map(by_number).collect(),
        types: summary.types.iter().map(|(key, of)| (key.to_string(), record(of))).collect(),
        signatures: summary.signatures.iter().map(|(key, of)| (key.to_string(), record(of))).collect(),
        classes: summary.by_frequency().into_iter().map(|(name, of)| class(name, of, accuracy)).collect(),
    }
}

fn body(record: &BodyRecord) -> BodyRecordDocument {
    let [moments, center] = record.values;
    BodyRecordDocument { index: record.index, moments, center }
}

fn record(record: &Record) -> RecordDocument {
    RecordDocument { bodies: record.bodies, first: body(&record.first) }
}

fn class(name: &ClassName, of: &ClassRecord, accuracy: Accuracy) -> ClassRecordDocument {
    let Record { bodies, first } = &of.record;
    let text = class_text(first, accuracy).unwrap_or_default();
    ClassRecordDocument {
        class: name.to_string(),
        bodies: *bodies,
        regions: of.regions,
        events: of.events,
        first: body(first),
        text: text.lines().map(str::to_owned).collect(),
    }
}
