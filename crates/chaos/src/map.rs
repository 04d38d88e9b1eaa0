//! The chaotic share over a window of the (h, l) plane, cell by cell.
//!
//! A tile without a curve is measured as one block; where its quarters differ by more than the error that is wanted, they are
//! measured apart, down to single cells, and what was found of the block counts for them. A cell through which a curve goes has a
//! row for each region in it.

use std::collections::BTreeMap;
use std::ops::Range;
use std::rc::Rc;

use bifdiag_diagram::arrangement::RegionId;
use bifdiag_diagram::atlas::Spot;
use bifdiag_dynamics::section::{Monitor, SectionError};
use bifdiag_exact::{AnswerError, Solver};
use thiserror::Error;

use crate::block::{CellShare, Known, Measured, measure};
use crate::cells::{Block, Cells, POINTS, TILE};
use crate::liouville::EnergySurface;
use crate::share::ShareOptions;

/// Why there is no map.
#[derive(Debug, Error)]
pub enum MapError {
    /// The diagram is not finished at once.
    #[error("the diagram of this body is not known, and with it the regions of the cells")]
    NoAtlas,
    /// A point of the window has no region.
    #[error(transparent)]
    Answer(#[from] AnswerError),
    /// Orbits cannot be followed.
    #[error(transparent)]
    Section(#[from] SectionError),
}

/// A block that is to be measured, and what is known from the larger block that contains it.
struct Task {
    block: Block,
    known: Rc<[Known]>,
    /// Where the sequence of states continues.
    next: u64,
}

impl Task {
    fn quarters(&self, cells: &Cells, known: &Rc<[Known]>, next: u64) -> impl Iterator<Item = Self> + use<> {
        let known = Rc::clone(known);
        self.block.quarters(cells).map(move |block| Self { block, known: Rc::clone(&known), next })
    }
}

/// Measures tiles, all their orbits together; the rows of each tile, in its order of cells.
///
/// # Errors
/// [`MapError`].
pub fn map_tiles(
    solver: &Solver,
    cells: &Cells,
    tiles: Range<u64>,
    options: &ShareOptions,
    monitor: &Monitor,
) -> Result<Vec<CellShare>, MapError> {
    let mut rows = Vec::new();
    let first = |number| Task { block: cells.tile(number), known: Rc::new([]), next: 0 };
    let mut tasks: Vec<Task> = tiles.map(first).collect();
    while !tasks.is_empty() && !monitor.is_stopped() {
        let mut next = Vec::new();
        let mut whole = Vec::new();
        let mut measured = Vec::new();
        for task in tasks {
            let groups = regions(solver, cells, task.block)?;
            if task.block.side > 1 && is_crossed(solver, cells, task.block, &groups)? {
                next.extend(task.quarters(cells, &task.known, task.next));
                continue;
            }
            for (region, points) in groups {
                measured.extend(components(solver, cells, &task, region, &points)?);
            }
            whole.push(task);
        }
        measure(&mut measured, options, monitor)?;
        for task in whole {
            let own: Vec<&Measured> = measured.iter().filter(|one| one.block == task.block).collect();
            let is_uneven = |one: &&Measured| !one.is_empty && one.error() > options.error;
            if task.block.side > 1 && own.iter().any(is_uneven) {
                let known: Rc<[Known]> = own.iter().flat_map(|one| one.known.iter().copied()).collect();
                let last = own.iter().map(|one| one.next).max().unwrap_or(task.next);
                next.extend(task.quarters(cells, &known, last));
            } else {
                rows.extend(own.iter().flat_map(|one| one.rows()));
            }
        }
        tasks = next;
    }
    let tile = |row: &CellShare| row.cell.map(|k| k / TILE);
    rows.sort_by_key(|row| (tile(row), row.cell, row.region, row.component));
    Ok(rows)
}

/// The points of a block by regions, in cells from the corner of the window.
type Places = BTreeMap<RegionId, Vec<[f64; 2]>>;

fn regions(solver: &Solver, cells: &Cells, block: Block) -> Result<Places, MapError> {
    let mut groups = Places::new();
    for point in block.points(cells) {
        let [h, l] = cells.place(point[0], point[1]);
        if let Spot::Region(region) = spots(solver, l, &[h])?[0] {
            groups.entry(region).or_default().push(point);
        }
    }
    Ok(groups)
}

fn spots(solver: &Solver, l: f64, h: &[f64]) -> Result<Vec<Spot>, MapError> {
    Ok(solver.row(l, h).ok_or(MapError::NoAtlas)??)
}

/// The places at the corners and centres of a block's cells.
fn lattice(solver: &Solver, cells: &Cells, block: Block) -> Result<Vec<Spot>, MapError> {
    let [along_h, along_l] = block.cells(cells);
    let halves = |range: Range<u64>| (2 * range.start..=2 * range.end).map(|k| 0.5 * k as f64);
    let mut found = Vec::new();
    for l in halves(along_l) {
        let h: Vec<f64> = halves(along_h.clone()).map(|h| cells.place(h, l)[0]).collect();
        found.extend(spots(solver, cells.place(0.0, l)[1], &h)?);
    }
    Ok(found)
}

/// A curve is seen in the block: its points and its lattice are not all in one region, nor all in none.
fn is_crossed(solver: &Solver, cells: &Cells, block: Block, groups: &Places) -> Result<bool, MapError> {
    if groups.len() > 1 || groups.values().any(|points| points.len() < POINTS) {
        return Ok(true);
    }
    let own = groups.keys().next();
    let is_other = |spot: &Spot| match spot {
        Spot::Region(region) => Some(region) != own,
        Spot::Forbidden | Spot::Critical | Spot::Undecided => own.is_some(),
    };
    Ok(lattice(solver, cells, block)?.iter().any(is_other))
}

/// The components of a region in a block.
fn components(
    solver: &Solver,
    cells: &Cells,
    task: &Task,
    region: RegionId,
    points: &[[f64; 2]],
) -> Result<Vec<Measured>, MapError> {
    let atlas = solver.atlas().ok_or(MapError::NoAtlas)?;
    let count = atlas.components(region).map_or(0, <[_]>::len);
    let surface = |point: &[f64; 2]| {
        let [h, l] = cells.place(point[0], point[1]);
        EnergySurface::new(solver.body(), h, l, count).ok().map(|surface| (*point, surface))
    };
    let surfaces: Vec<([f64; 2], EnergySurface)> = points.iter().filter_map(surface).collect();
    let of = |component| Measured::new(cells, task.block, (region, component), &surfaces, &task.known, task.next);
    Ok((0..count).map(of).collect())
}
