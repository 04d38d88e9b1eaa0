//! `bifdiag orbit`: the body's motion in space.

mod animate;
mod arguments;
mod document;
mod error;
mod report;
mod settings;
mod start;
mod table;
mod target;
mod times;

use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use bifdiag_dynamics::motion::{Motion, MotionOptions, follow};

use super::export::{DataFormat, DataTarget, ExportError, Exporter, FileSet, answer};
use super::failure::Failure;
use super::terminal::interrupt::stoppable;
use super::terminal::{Timings, print};
use error::OrbitFailure;
use settings::Settings;

pub use arguments::{EXAMPLES, OrbitArguments};

pub fn run(arguments: &OrbitArguments, timings: &Timings) -> Result<(), Failure> {
    let settings = Settings::new(arguments)?;
    let stop = Arc::new(AtomicBool::new(false));
    let stopping = Arc::clone(&stop);
    let work = stoppable(move || stopping.store(true, Ordering::Relaxed));
    let options = MotionOptions { tolerance: settings.tolerance, phi: settings.phi, stop: &stop };
    let motion = timings
        .stage("motion", || follow(&settings.top, &settings.start, &settings.times, &options))
        .map_err(OrbitFailure::from)?;
    let interrupted = !work.over();
    output(&settings, &motion, interrupted, timings)?;
    drop(work);
    let (done, wanted) = (motion.samples.len(), settings.times.len());
    match motion.report.failure {
        Some(source) => Err(OrbitFailure::Motion { done, wanted, source }.into()),
        None if interrupted => Err(OrbitFailure::Interrupted { done, wanted }.into()),
        None => Ok(()),
    }
}

/// Writes the files, and then prints. An interrupted run only prints: no file is replaced by one with less in it.
fn output(settings: &Settings, motion: &Motion, interrupted: bool, timings: &Timings) -> Result<(), Failure> {
    let mut document = document::of(settings, motion)?;
    let mut files = FileSet::new(Path::new("."));
    let columns = || table::of(&document, &motion.samples).map_err(ExportError::from);
    if let Some(target) = settings.animation.filter(|_| !interrupted) {
        files.add_at(target.path(), timings.stage("animation", || animate::text(settings, target))?);
    }
    match settings.data {
        Some(DataTarget::Stdout) => {
            let csv = DataFormat::Csv.bytes(&columns()?)?;
            timings.stage("files", || files.write())?;
            return Ok(print(csv)?);
        }
        Some(DataTarget::File { .. }) if interrupted => {}
        Some(DataTarget::File { path, format }) => files.add_at(path, format.bytes(&columns()?)?),
        None => document.samples = Some(document::samples(motion)),
    }
    let written = timings.stage("files", || files.write())?;
    Ok(answer(settings.json, &document, || report::text(&settings.subject, &document, &motion.samples, &written))?)
}
