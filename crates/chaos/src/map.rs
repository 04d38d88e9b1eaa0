//! The chaotic share over a window of the (h, l) plane, cell by cell.
//!
//! Cells are measured in tiles of 8 × 8, each for itself, so that a map can be cut into shards and taken up again. A tile
//! without a curve is measured as one block; where its quarters differ by more than the error that is wanted, they are measured
//! in its place, down to single cells. A cell through which a curve goes has a row for each region in it.

use std::collections::BTreeMap;
use std::ops::Range;

use bifdiag_diagram::arrangement::RegionId;
use bifdiag_diagram::atlas::Spot;
use bifdiag_dynamics::field::State;
use bifdiag_dynamics::section::chaos::decisions;
use bifdiag_dynamics::section::{Monitor, SectionError};
use bifdiag_exact::{AnswerError, Solver};
use bifdiag_numbers::sequence;
use thiserror::Error;

use crate::liouville::EnergySurface;
use crate::share::{Share, ShareOptions};

/// Cells along a side of a tile.
const TILE: u64 = 8;
/// Points of a block at which orbits begin: four in each quarter.
const POINTS: usize = 16;
/// Quarters of a block that differ by more than so many times the wanted error are measured apart at once.
const FAR: f64 = 2.0;

/// The cells of a map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cells {
    /// From and to, in h.
    pub h: [f64; 2],
    /// From and to, in l.
    pub l: [f64; 2],
    /// How many cells, along h and along l.
    pub counts: [u64; 2],
}

/// A row of a map: one component of one region, in one cell.
#[derive(Clone, Debug, PartialEq)]
pub struct CellShare {
    /// The cell, along h and along l.
    pub cell: [u64; 2],
    /// Its centre.
    pub h: f64,
    /// Its centre.
    pub l: f64,
    /// The region.
    pub region: RegionId,
    /// The component of E there, in the order of the region's.
    pub component: usize,
    /// Which part of the cell belongs to the region, of 16 points.
    pub part: f64,
    /// Cells along a side of the block that was measured.
    pub block: u64,
    /// What was found.
    pub share: Share,
    /// One standard deviation: that of the share, and how far the quarters of the block differ beyond it.
    pub error: f64,
}

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

impl Cells {
    /// How many tiles there are.
    #[must_use]
    pub fn tiles(&self) -> u64 {
        self.counts[0].div_ceil(TILE) * self.counts[1].div_ceil(TILE)
    }

    /// A place (h, l) of the plane, given in cells along h and along l from the corner of the window.
    #[must_use]
    pub fn place(&self, h: f64, l: f64) -> [f64; 2] {
        let along = |[from, to]: [f64; 2], count: u64, cells: f64| from + (to - from) * cells / count as f64;
        [along(self.h, self.counts[0], h), along(self.l, self.counts[1], l)]
    }

    /// The block of a tile; l goes fastest.
    fn tile(&self, number: u64) -> Block {
        let along_l = self.counts[1].div_ceil(TILE);
        Block { from: [number / along_l * TILE, number % along_l * TILE], side: TILE }
    }
}

/// A square of cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Block {
    from: [u64; 2],
    side: u64,
}

impl Block {
    /// The cells in it along h and along l, at the edge of the window fewer.
    fn cells(&self, cells: &Cells) -> [Range<u64>; 2] {
        std::array::from_fn(|k| self.from[k]..(self.from[k] + self.side).min(cells.counts[k]))
    }

    fn is_empty(&self, cells: &Cells) -> bool {
        self.cells(cells).iter().any(Range::is_empty)
    }

    fn quarters(self, cells: &Cells) -> impl Iterator<Item = Self> + use<> {
        let cells = *cells;
        let half = self.side / 2;
        let quarter =
            move |k: u64| Self { from: [self.from[0] + k / 2 * half, self.from[1] + k % 2 * half], side: half };
        (0..4).map(quarter).filter(move |quarter| !quarter.is_empty(&cells))
    }

    /// Points of it, the quarters in turn, each a point of a sequence of low discrepancy in its quarter.
    fn points(&self, cells: &Cells) -> Vec<[f64; 2]> {
        let size = self.cells(cells).map(|range| (range.end - range.start) as f64);
        let point = |n: usize| {
            let place = sequence::point((n / 4) as u64, 2, 0);
            let quarter = [(n % 4 / 2) as f64, (n % 2) as f64];
            let of = |k: usize| self.from[k] as f64 + size[k] * 0.5 * (quarter[k] + place[k]);
            cells.place(of(0), of(1))
        };
        (0..POINTS).map(point).collect()
    }
}

/// One component of one region in a block, while it is measured.
struct Measured {
    block: Block,
    region: RegionId,
    component: usize,
    /// Surfaces at the points in the region, and the quarters of these.
    surfaces: Vec<(usize, EnergySurface)>,
    /// Where the sequence of states goes on.
    next: u64,
    quarters: [Share; 4],
    /// It has no states that could be found.
    is_empty: bool,
}

impl Measured {
    fn share(&self) -> Share {
        self.quarters.iter().fold(Share::default(), |share, quarter| share.and(*quarter))
    }

    /// The variance of the quarters' shares beyond that of their orbits.
    fn spread(&self) -> f64 {
        if self.block.side == 1 {
            return 0.0;
        }
        let whole = self.share();
        let parts: Vec<Share> = self.quarters.into_iter().filter(|quarter| quarter.orbits > 0).collect();
        if parts.len() < 2 {
            return 0.0;
        }
        let variance = whole.variance();
        let excess = |part: &Share| {
            let difference = part.fraction() - whole.fraction();
            difference * difference - variance / part.orbits as f64 * (1.0 - part.orbits as f64 / whole.orbits as f64)
        };
        (parts.iter().map(excess).sum::<f64>() / (parts.len() - 1) as f64).max(0.0)
    }

    fn error(&self) -> f64 {
        let error = self.share().error();
        (error * error + self.spread()).sqrt()
    }

    /// Orbits that are to be judged next.
    fn missing(&self, wanted: f64) -> usize {
        if self.is_empty {
            return 0;
        }
        // A block needs more than its cells would, so that its quarters can be compared.
        let own = if self.block.side == 1 { wanted } else { 0.5 * wanted };
        let is_uneven = self.share().orbits > 0 && self.spread().sqrt() > FAR * wanted;
        if is_uneven { 0 } else { self.share().missing(own) }
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
    let mut blocks: Vec<Block> = tiles.map(|number| cells.tile(number)).collect();
    while !blocks.is_empty() && !monitor.is_stopped() {
        let mut next = Vec::new();
        let mut measured = Vec::new();
        for block in blocks {
            let groups = regions(solver, cells, block)?;
            if block.side > 1 && is_crossed(solver, cells, block, &groups)? {
                next.extend(block.quarters(cells));
                continue;
            }
            for (region, points) in groups {
                measured.extend(components(solver, block, region, &points)?);
            }
        }
        measure(&mut measured, options, monitor)?;
        let uneven = |one: &&Measured| one.block.side > 1 && one.error() > options.error && !one.is_empty;
        let mut split: Vec<Block> = measured.iter().filter(uneven).map(|one| one.block).collect();
        split.dedup();
        for one in &measured {
            if !split.contains(&one.block) {
                rows.extend(one.rows(cells));
            }
        }
        next.extend(split.into_iter().flat_map(|block| block.quarters(cells)));
        blocks = next;
    }
    let tile = |row: &CellShare| row.cell.map(|k| k / TILE);
    rows.sort_by_key(|row| (tile(row), row.cell, row.region, row.component));
    Ok(rows)
}

/// Points by regions, each with its quarter.
type Places = BTreeMap<RegionId, Vec<(usize, [f64; 2])>>;

/// The points of a block.
fn regions(solver: &Solver, cells: &Cells, block: Block) -> Result<Places, MapError> {
    let mut groups = Places::new();
    for (number, [h, l]) in block.points(cells).into_iter().enumerate() {
        if let Spot::Region(region) = spots(solver, l, &[h])?[0] {
            groups.entry(region).or_default().push((number % 4, [h, l]));
        }
    }
    Ok(groups)
}

fn spots(solver: &Solver, l: f64, h: &[f64]) -> Result<Vec<Spot>, MapError> {
    Ok(solver.row(l, h).ok_or(MapError::NoAtlas)??)
}

/// What stands at the corners and the centres of a block's cells.
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

/// The components of a region in a block, of which nothing is measured.
fn components(
    solver: &Solver,
    block: Block,
    region: RegionId,
    points: &[(usize, [f64; 2])],
) -> Result<Vec<Measured>, MapError> {
    let atlas = solver.atlas().ok_or(MapError::NoAtlas)?;
    let count = atlas.components(region).map_or(0, <[_]>::len);
    let surface = |&(quarter, [h, l]): &(usize, [f64; 2])| {
        EnergySurface::new(solver.body(), h, l, count).ok().map(|surface| (quarter, surface))
    };
    let surfaces: Vec<(usize, EnergySurface)> = points.iter().filter_map(surface).collect();
    let of = |component| Measured {
        block,
        region,
        component,
        surfaces: surfaces.clone(),
        next: 0,
        quarters: [Share::default(); 4],
        is_empty: surfaces.is_empty(),
    };
    Ok((0..count).map(of).collect())
}

/// Judges orbits until each has the error that is wanted.
fn measure(measured: &mut [Measured], options: &ShareOptions, monitor: &Monitor) -> Result<(), MapError> {
    loop {
        // The orbits of one round: whose they are, and their states.
        let mut owners: Vec<(usize, usize)> = Vec::new();
        let mut states: Vec<State> = Vec::new();
        for (number, one) in measured.iter_mut().enumerate() {
            let missing = one.missing(options.error);
            let count = one.surfaces.len().max(1);
            for (place, (quarter, surface)) in one.surfaces.iter().enumerate() {
                let share = missing / count + usize::from(place < missing % count);
                if share == 0 {
                    continue;
                }
                match surface.states_from(one.component, share, options.seed, one.next) {
                    Ok((found, next)) => {
                        one.next = next;
                        owners.extend(std::iter::repeat_n((number, *quarter), found.len()));
                        states.extend(found);
                    }
                    // A component that is too thin to be met stays without orbits.
                    Err(_too_small) => one.is_empty = true,
                }
            }
        }
        let Some((_, first)) = measured.iter().find_map(|one| one.surfaces.first()) else { return Ok(()) };
        if states.is_empty() {
            return Ok(());
        }
        let found = decisions(first.top(), &states, &options.orbits, monitor)?;
        if monitor.is_stopped() {
            return Ok(());
        }
        for ((number, quarter), decision) in owners.into_iter().zip(found) {
            let quarter = &mut measured[number].quarters[quarter];
            *quarter = quarter.and(Share::of(&[decision]));
        }
    }
}

impl Measured {
    /// The rows of its cells.
    fn rows(&self, cells: &Cells) -> impl Iterator<Item = CellShare> {
        let [along_h, along_l] = self.block.cells(cells);
        let of = move |cell: [u64; 2]| {
            let [h, l] = cells.place(cell[0] as f64 + 0.5, cell[1] as f64 + 0.5);
            CellShare {
                cell,
                h,
                l,
                region: self.region,
                component: self.component,
                part: self.surfaces.len() as f64 / POINTS as f64,
                block: self.block.side,
                share: self.share(),
                error: self.error(),
            }
        };
        along_h.flat_map(move |i| along_l.clone().map(move |j| [i, j])).map(of)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_cover_the_window_once() {
        let cells = Cells { h: [0.0, 1.0], l: [0.0, 1.0], counts: [13, 21] };
        let mut seen = vec![0; 13 * 21];
        for tile in 0..cells.tiles() {
            for quarter in cells.tile(tile).quarters(&cells) {
                let [along_h, along_l] = quarter.cells(&cells);
                for i in along_h {
                    for j in along_l.clone() {
                        seen[usize::try_from(i * 21 + j).unwrap()] += 1;
                    }
                }
            }
        }
        assert!(seen.iter().all(|count| *count == 1));
    }

    #[test]
    fn points_lie_in_their_quarters() {
        let cells = Cells { h: [0.0, 8.0], l: [0.0, 8.0], counts: [8, 8] };
        for (number, [h, l]) in cells.tile(0).points(&cells).into_iter().enumerate() {
            assert_eq!([h >= 4.0, l >= 4.0], [number % 4 / 2 == 1, number % 2 == 1]);
        }
    }
}
