//! `bifdiag orbit`: the body's motion in space.

mod arguments;
mod error;
mod report;
mod start;
mod table;
mod times;

pub use arguments::{EXAMPLES, OrbitArguments};
pub use error::OrbitInputError;

use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use dynamics::field::{HeavyTop, State, dot};
use dynamics::integrator::Method;
use dynamics::motion::{Motion, MotionOptions, MotionSample, follow};
use schema::{MotionDocument, MotionSampleDocument, MotionSummaryDocument, SCHEMA_VERSION};

use super::data::{DataFormat, DataTarget};
use super::failure::Failure;
use super::files::FileSet;
use super::subject::Subject;
use super::timings::Timings;
use super::{interrupt, layout, output};

pub fn run(arguments: &OrbitArguments, timings: &Timings) -> Result<(), Failure> {
    if arguments.json && arguments.data == Some(DataTarget::Stdout) {
        return Err(OrbitInputError::TwoOnStdout.into());
    }
    let subject = arguments.body.subject()?;
    let top = HeavyTop::new(&subject.body);
    let state = start::of(arguments, &top)?;
    let times = arguments.times.list()?;
    let method = arguments.integrator.method(&top, top.energy(&state))?;
    let stop = Arc::new(AtomicBool::new(false));
    let stopping = Arc::clone(&stop);
    let work = interrupt::stoppable(move || stopping.store(true, Ordering::Relaxed));
    let options = MotionOptions { method, phi: arguments.phi, stop: &stop };
    let motion = timings.stage("motion", || follow(&top, &state, &times, &options))?;
    let mut document = document(&subject, &top, &state, arguments.phi, method, &motion, times.len())?;
    let mut files = FileSet::new(Path::new("."));
    let mut csv = None;
    match &arguments.data {
        Some(DataTarget::Stdout) => csv = Some(table::of(&document, &motion.samples)?.bytes(DataFormat::Csv)?),
        Some(DataTarget::File { path, format }) => {
            files.add_at(path, table::of(&document, &motion.samples)?.bytes(*format)?);
        }
        None => document.samples = Some(motion.samples.iter().map(sample_document).collect()),
    }
    let written = timings.stage("files", || files.write())?;
    let text = match csv {
        Some(csv) => csv,
        None if arguments.json => layout::text(&document)?.into_bytes(),
        None => report::text(&subject, &document, &motion.samples, &written).into_bytes(),
    };
    output::print(&text)?;
    drop(work);
    match motion.report.failure {
        Some(failure) => Err(Failure::Motion { done: motion.samples.len(), wanted: times.len(), source: failure }),
        None if motion.report.interrupted => {
            Err(Failure::MotionInterrupted { done: motion.samples.len(), wanted: times.len() })
        }
        None => Ok(()),
    }
}

/// The document without its samples.
fn document(
    subject: &Subject,
    top: &HeavyTop,
    start: &State,
    phi: f64,
    method: Method,
    motion: &Motion,
    wanted: usize,
) -> Result<MotionDocument, Failure> {
    let report = &motion.report;
    let at_start = {
        let stop = AtomicBool::new(false);
        let options = MotionOptions { method, phi, stop: &stop };
        follow(top, start, &[0.0], &options)?.samples
    };
    let [start_sample] = at_start[..] else { unreachable!("time 0 is the start itself") };
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
    Ok(MotionDocument {
        schema_version: SCHEMA_VERSION.to_owned(),
        moments: documents::texts(subject.body.moments()),
        center: documents::texts(subject.body.center()),
        h: top.energy(start),
        l: dot(start.gamma, start.l),
        start: sample_document(&start_sample),
        integrator: documents::integrator(method),
        complete: motion.samples.len() == wanted,
        summary: MotionSummaryDocument {
            samples: motion.samples.len(),
            steps: report.steps,
            drift: documents::drift(report.drift),
            vertical_error: report.vertical_error,
            attitude_difference: report.attitude_difference,
            at_pole: report.at_pole,
        },
        samples: None,
        notes,
        inertia: subject.inertia.clone(),
    })
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
