//! `bifdiag section`: Poincaré sections, their data and their pictures.

mod arguments;
mod crossings;
mod outputs;
mod picture;
mod plan;
mod report;
mod sites;
mod stream;
mod table;
mod work;

use std::sync::Arc;
use std::sync::atomic::Ordering;

use bifdiag_dynamics::section::Monitor;

use super::failure::Failure;
use super::terminal::interrupt::stoppable;
use super::terminal::{Progress, Timings, counted};
use plan::Plan;

pub use arguments::{EXAMPLES, SectionArguments};
pub use sites::poincare_failure;

pub fn run(arguments: &SectionArguments, timings: &Timings, quiet: bool) -> Result<(), Failure> {
    let plan = Plan::new(arguments)?;
    let monitor = Arc::new(Monitor::default());
    let stop = Arc::clone(&monitor);
    let interruptible = stoppable(move || stop.stop.store(true, Ordering::Relaxed));
    let wanted = plan.sites.list.len() * plan.starts.count();
    let progress = Progress::new(0, wanted as u64 * u64::from(arguments.crossings.get()), "crossings", quiet);
    let sections =
        progress.watching(&monitor.crossings, || timings.stage("orbits", || work::compute(&plan, &monitor)))?;
    let complete = interruptible.over() && sections.complete;
    let finished: usize = sections.done.iter().map(|section| section.whole_orbits).sum();
    let journal = sections.done.last().and_then(|section| section.journal.as_ref().map(|kept| kept.path().to_owned()));
    if complete || plan.streamed().is_none() {
        outputs::write(&plan, sections, complete, timings)?;
    }
    drop(interruptible);
    if complete {
        return Ok(());
    }
    let interrupted = format!("interrupted: {finished} of {} complete", counted(wanted, "orbit", "orbits"));
    Err(Failure::work(match journal {
        Some(journal) => {
            let journal = journal.display();
            format!("{interrupted}; {journal} holds what was found; run the same command again to resume from there")
        }
        None => format!("{interrupted}; no file was written"),
    }))
}
