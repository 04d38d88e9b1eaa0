//! `bifdiag orbit`: the body's motion in space.

mod animate;
mod arguments;
mod proved;
mod report;
mod times;

use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use bifdiag_dynamics::motion::Motion;

use super::export::{DataFormat, DataTarget, FileSet, answer};
use super::failure::Failure;
use super::terminal::interrupt::stoppable;
use super::terminal::{Timings, counted, print};
use arguments::Problem;

pub use arguments::{EXAMPLES, OrbitArguments};

pub fn run(arguments: &OrbitArguments, timings: &Timings, quiet: bool) -> Result<(), Failure> {
    let problem = Problem::new(arguments)?;
    if arguments.proved {
        return proved::run(&problem, timings, quiet);
    }
    let stop = Arc::new(AtomicBool::new(false));
    let stopping = Arc::clone(&stop);
    let work = stoppable(move || stopping.store(true, Ordering::Relaxed));
    let motion = timings.stage("motion", || problem.follow(&problem.times, &stop))?;
    let interrupted = !work.over();
    output(&problem, &motion, interrupted, timings)?;
    drop(work);
    let computed =
        format!("{} of {} computed", motion.samples.len(), counted(problem.times.len(), "sample", "samples"));
    match motion.report.failure {
        Some(cause) => Err(Failure::work(computed).because(cause)),
        None if interrupted => Err(Failure::work(format!("interrupted: {computed}; no file was written"))),
        None => Ok(()),
    }
}

/// Writes the files, and then prints. An interrupted run only prints: no file is replaced by one with less in it.
fn output(problem: &Problem<'_>, motion: &Motion, interrupted: bool, timings: &Timings) -> Result<(), Failure> {
    let arguments = problem.arguments;
    let mut document = report::document(problem, motion)?;
    let mut files = FileSet::new(Path::new("."));
    let columns = || report::columns(&document, &motion.samples);
    if let Some(file) = arguments.animate.as_ref().filter(|_| !interrupted) {
        let (file, contents) = timings.stage("animation", || animate::file(problem, file))?;
        files.add_at(&file, contents);
    }
    match &arguments.data {
        Some(DataTarget::Stdout) => {
            let csv = DataFormat::Csv.bytes(&columns()?)?;
            timings.stage("files", || files.write())?;
            return print(csv);
        }
        Some(DataTarget::File { .. }) if interrupted => {}
        Some(DataTarget::File { path, format }) => files.add_at(path, format.bytes(&columns()?)?),
        None => document.samples = Some(report::samples(motion)),
    }
    let written = timings.stage("files", || files.write())?;
    answer(arguments.json, &document, || report::text(&problem.subject, &document, &motion.samples, &written))
}
