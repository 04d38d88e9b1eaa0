//! The document of a motion.

use std::sync::atomic::AtomicBool;

use bifdiag_dynamics::field::dot;
use bifdiag_dynamics::motion::{Motion, MotionOptions, MotionReport, MotionSample, follow};
use bifdiag_schema::{MotionDocument, MotionSampleDocument, MotionSummaryDocument};

use super::error::OrbitFailure;
use super::settings::Settings;

/// The document without its samples.
pub fn of(settings: &Settings, motion: &Motion) -> Result<MotionDocument, OrbitFailure> {
    let Settings { subject, top, start, phi, tolerance, times, .. } = settings;
    let report = &motion.report;
    let at_start = {
        let stop = AtomicBool::new(false);
        let options = MotionOptions { tolerance: *tolerance, phi: *phi, stop: &stop };
        follow(top, start, &[0.0], &options)?.samples
    };
    let [start_sample] = at_start[..] else { unreachable!("time 0 is the start itself") };
    Ok(MotionDocument {
        head: bifdiag_documents::head(command(settings)),
        body: bifdiag_documents::given(&subject.body),
        h: top.energy(start),
        l: dot(start.gamma, start.l),
        start: sample_document(&start_sample),
        integrator: bifdiag_documents::integrator(*tolerance),
        complete: motion.samples.len() == times.len(),
        summary: MotionSummaryDocument {
            samples: motion.samples.len(),
            steps: report.steps,
            drift: bifdiag_documents::drift(report.drift),
            vertical_error: report.vertical_error,
            attitude_difference: report.attitude_difference,
            at_pole: report.at_pole,
        },
        samples: None,
        notes: notes(report),
        part: subject.part.clone(),
    })
}

/// The motion from its start γ, l.
fn command(settings: &Settings) -> String {
    let Settings { subject, start, phi, tolerance, given_times, .. } = settings;
    let list = |v: [f64; 3]| v.map(|x| x.to_string()).join(",");
    let line = subject.command("orbit").option("gamma", list(start.gamma)).option("l-vector", list(start.l));
    let line = line.option_if("phi", (*phi != 0.0).then_some(phi)).option("times", given_times);
    bifdiag_documents::tolerance_option(line, *tolerance).json()
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
