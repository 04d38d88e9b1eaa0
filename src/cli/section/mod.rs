//! `bifdiag section`: Poincaré sections, their data and their pictures.

mod arguments;
mod error;
mod outputs;
mod picture;
mod report;
mod seeds;
mod settings;
mod sites;
mod stream;
mod table;
mod work;

use std::sync::Arc;
use std::sync::atomic::Ordering;

use bifdiag_dynamics::section::Monitor;

use super::failure::Failure;
use super::terminal::interrupt::stoppable;
use super::terminal::{Progress, Timings};
use error::SectionFailure;
use settings::Settings;

pub use arguments::{EXAMPLES, SectionArguments};

pub fn run(arguments: &SectionArguments, timings: &Timings, quiet: bool) -> Result<(), Failure> {
    let settings = Settings::new(arguments)?;
    let monitor = Arc::new(Monitor::default());
    let stop = Arc::clone(&monitor);
    let interruptible = stoppable(move || stop.stop.store(true, Ordering::Relaxed));
    let wanted = settings.sites.list.len() * settings.starts.count();
    let progress = Progress::new(0, wanted as u64 * settings.crossings as u64, "crossings", quiet);
    let sections =
        progress.watching(&monitor.crossings, || timings.stage("orbits", || work::compute(&settings, &monitor)))?;
    let complete = interruptible.over() && sections.complete;
    let finished = sections.done.iter().map(|section| section.whole_orbits).sum();
    let journal = sections.done.last().and_then(|section| section.journal.as_ref().map(|kept| kept.path().to_owned()));
    if complete || settings.streamed().is_none() {
        outputs::write(&settings, sections, complete, timings)?;
    }
    drop(interruptible);
    if complete {
        return Ok(());
    }
    Err(match journal {
        Some(journal) => SectionFailure::Halted { finished, wanted, journal },
        None => SectionFailure::Interrupted { finished, wanted },
    }
    .into())
}
