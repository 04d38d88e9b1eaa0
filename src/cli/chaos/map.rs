//! The chaotic share over a window.

use std::sync::Arc;
use std::sync::atomic::Ordering;

use bifdiag_chaos::{Cells, MapError, map_tiles};
use bifdiag_documents::words::counted;
use bifdiag_dynamics::section::Monitor;
use bifdiag_exact::Solver;
use bifdiag_schema::{Accuracy, ChaosMapDocument};

use super::arguments::ShareArguments;
use super::output;
use crate::cli::export::{Journal, unusable};
use crate::cli::failure::Failure;
use crate::cli::terminal::interrupt::stoppable;
use crate::cli::terminal::{Progress, say};

/// Tiles between two entries of the journal: what a killed map loses at most. Their orbits fill the lanes of all threads.
const GROUP: u64 = 16;

pub fn run(arguments: &ShareArguments, quiet: bool) -> Result<(), Failure> {
    let point = &arguments.point;
    for (option, given) in
        [("--h", point.energy.is_some()), ("--l", point.momentum.is_some()), ("--json", arguments.json)]
    {
        if given {
            return Err(Failure::input(format!("{option} applies to one point, not to a map; leave it out")));
        }
    }
    let target = output::format_of(arguments.out.as_deref())?;
    let subject = arguments.body.subject()?;
    let solver = Solver::new(subject.body.clone(), Accuracy::Exact);
    let atlas = solver.atlas().ok_or_else(|| unmapped(MapError::NoAtlas))?;
    let whole = || {
        let window = atlas.view().main;
        (window.h, window.l)
    };
    let (h, l) = arguments.window.map_or_else(whole, |window| (window.h, window.l));
    let cells = Cells { h, l, counts: arguments.cells };
    let options = arguments.options();
    let [from, to] = arguments.shard.map_or([0, cells.tiles()], |shard| shard.range(cells.tiles()));
    let map = bifdiag_documents::chaos_map(&subject, &cells, [from, to], &options);
    let mut journal = Journal::open(target.0, &serde_json::to_vec(&map)?, arguments.restart, |path, _| {
        Err(Failure::input(format!(
            "{} belongs to another unfinished map; finish that one with its own options, choose another --out, or \
            give --restart to discard it",
            path.display()
        )))
    })?;
    let done = |journal: &Journal| (from + GROUP * journal.blocks().len() as u64).min(to);
    if !journal.blocks().is_empty() && !quiet {
        say(&format!("resuming after {} done before", counted(done(&journal) - from, "tile", "tiles")));
    }
    let monitor = Arc::new(Monitor::default());
    let stop = Arc::clone(&monitor);
    let interruptible = stoppable(move || stop.stop.store(true, Ordering::Relaxed));
    let progress = Progress::new(cells.within(from..done(&journal)), cells.within(from..to), "cells", quiet);
    while done(&journal) < to {
        let next = done(&journal);
        let group = next..to.min(next + GROUP);
        let size = cells.within(group.clone());
        let tiles = || map_tiles(&solver, &cells, group, &options, &monitor);
        let rows = progress.beside(&monitor.orbits, "orbits followed", tiles).map_err(unmapped)?;
        if monitor.is_stopped() {
            break;
        }
        let mut block = Vec::with_capacity(256 * rows.len() + 1);
        for row in &rows {
            bifdiag_schema::write_json(&mut block, &bifdiag_documents::chaos_cell(row))?;
            block.push(b'\n');
        }
        journal.append(&block)?;
        progress.add(size);
    }
    progress.finish();
    if !interruptible.over() {
        return Err(Failure::work(format!(
            "interrupted: {} holds what was found; run the same command again to resume from there",
            journal.path().display()
        )));
    }
    finish(target, map, journal)
}

/// Writes the file; then the journal goes.
fn finish(
    target: (&std::path::Path, output::MapFormat),
    map: ChaosMapDocument,
    journal: Journal,
) -> Result<(), Failure> {
    let path = journal.path().to_owned();
    output::write(target, map, journal)?;
    std::fs::remove_file(&path).map_err(|error| unusable(&path, error))
}

fn unmapped(error: MapError) -> Failure {
    Failure::work("the map could not be made").because(error)
}
