//! A motion as a document, as columns, and as the terminal shows it.

use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

use bifdiag_documents::Subject;
use bifdiag_dynamics::field::State;
use bifdiag_dynamics::motion::{Motion, MotionReport, MotionSample};
use bifdiag_schema::{MotionDocument, MotionSampleDocument, MotionSummaryDocument};

use super::arguments::Problem;
use crate::cli::export::{Columns, Values};
use crate::cli::failure::Failure;
use crate::cli::input::{add_integrals, head, motion_units};
use crate::cli::terminal::{Report, Table, bound, significant};

/// The document without its samples.
pub fn document(problem: &Problem<'_>, motion: &Motion) -> Result<MotionDocument, Failure> {
    let Problem { subject, top, start, times, .. } = problem;
    let report = &motion.report;
    let at_start = problem.follow(&[0.0], &AtomicBool::new(false))?.samples;
    let [start_sample] = at_start[..] else { unreachable!("time 0 is the start itself") };
    Ok(MotionDocument {
        head: bifdiag_documents::head(command(problem)),
        body: bifdiag_documents::given(&subject.body),
        h: top.energy(start),
        l: problem.vertical_momentum(),
        start: sample_document(&start_sample),
        integrator: bifdiag_documents::integrator(problem.arguments.tol),
        complete: motion.samples.len() == times.len(),
        summary: MotionSummaryDocument {
            samples: motion.samples.len(),
            steps: report.steps,
            drift: bifdiag_documents::drift(report.drift),
            vertical_error: report.vertical_error,
            attitude_difference: report.attitude_difference,
            at_pole: report.at_pole,
        },
        integrals: bifdiag_documents::further_integrals(
            &subject.body,
            &std::iter::once((
                0,
                *start,
                motion.samples.iter().map(|sample| State { gamma: sample.gamma, l: sample.l }),
            )),
        ),
        samples: None,
        notes: notes(report),
        part: subject.part.clone(),
    })
}

/// The motion from its start γ, l.
fn command(Problem { arguments, subject, start, .. }: &Problem<'_>) -> String {
    let phi = arguments.start_phi();
    let list = |v: [f64; 3]| v.map(|x| x.to_string()).join(",");
    let line = subject.command("orbit").option("gamma", list(start.gamma)).option("l-vector", list(start.l));
    let line = line.option_if("phi", (phi != 0.0).then_some(phi)).option("times", &arguments.times);
    bifdiag_documents::tolerance_option(line, arguments.tol).json()
}

/// What is to be said about the samples.
fn notes(report: &MotionReport) -> Vec<String> {
    let mut notes = Vec::new();
    if report.interrupted {
        notes.push("the run was interrupted: samples are missing".to_owned());
    }
    if let Some(failure) = report.failure {
        notes.push(format!("samples are missing: {failure}"));
    }
    if report.at_pole > 0 {
        notes.push(
            "gamma passes e3 or -e3 within rounding, where psi and phi are not determined: beyond it they are one \
             possible continuation; the attitude is not concerned"
                .to_owned(),
        );
    }
    notes
}

/// The samples as documents.
pub fn samples(motion: &Motion) -> Vec<MotionSampleDocument> {
    motion.samples.iter().map(sample_document).collect()
}

fn sample_document(sample: &MotionSample) -> MotionSampleDocument {
    MotionSampleDocument {
        time: sample.time,
        gamma: sample.gamma,
        l: sample.l,
        omega: sample.omega,
        theta: sample.theta,
        psi: sample.psi,
        phi: sample.phi,
        attitude: sample.attitude.components(),
    }
}

/// One row for each sample; `meta` is the document on one line.
pub fn columns(document: &MotionDocument, samples: &[MotionSample]) -> Result<Columns, serde_json::Error> {
    let floats = |value: fn(&MotionSample) -> f64| Values::floats(samples.iter().map(value));
    let vectors = |value: fn(&MotionSample) -> [f64; 3]| Values::vectors(samples.iter().map(value));
    let columns = [
        ("time", floats(|s| s.time)),
        ("gamma", vectors(|s| s.gamma)),
        ("l", vectors(|s| s.l)),
        ("omega", vectors(|s| s.omega)),
        ("theta", floats(|s| s.theta)),
        ("psi", floats(|s| s.psi)),
        ("phi", floats(|s| s.phi)),
        ("attitude", Values::quaternions(samples.iter().map(|s| s.attitude.components()))),
    ];
    Columns::new(columns, document)
}

/// The axes of gamma, omega and the attitude.
pub const FRAME: &str =
    "gamma and omega are in principal axes; gamma and the third axis of space point down, along gravity";

/// Samples that are listed; those beyond, and all where they are written, are in the data.
const LISTED: usize = 40;

pub fn text(subject: &Subject, document: &MotionDocument, samples: &[MotionSample], written: &[PathBuf]) -> String {
    let mut report = Report::default();
    head(subject, &mut report);
    report.line(format!("h = {}, l = {}", significant(document.h, 10), significant(document.l, 10)));
    report.line("");
    if written.is_empty() {
        report.line(sample_table(samples));
        if samples.len() > LISTED {
            report.line(format!("… and {} more; --data FILE.csv writes all", samples.len() - LISTED));
        }
        report.line(FRAME);
        motion_units(subject, &mut report);
        report.line("");
    }
    let summary = &document.summary;
    report.line(format!(
        "largest deviations: {} of H, {} of <gamma,l>, {} of <gamma,gamma>",
        significant(summary.drift.h, 2),
        significant(summary.drift.l, 2),
        significant(summary.drift.gamma, 2),
    ));
    add_integrals(&mut report, &document.integrals);
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

fn sample_table(samples: &[MotionSample]) -> String {
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
