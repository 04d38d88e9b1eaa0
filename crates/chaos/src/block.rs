//! One component of one region in a block of cells, while its share is measured.

use bifdiag_diagram::arrangement::RegionId;
use bifdiag_dynamics::field::State;
use bifdiag_dynamics::section::chaos::decisions;
use bifdiag_dynamics::section::{Monitor, SectionError};

use crate::cells::{Block, Cells, POINTS};
use crate::liouville::EnergySurface;
use crate::share::{Share, ShareOptions};

/// The quarters of a block differ beyond chance if the mean square of their differences is at least this many times
/// that of chance: with equal shares, in one block out of forty.
const BEYOND_CHANCE: f64 = 3.0;

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
    /// Which part of the block belongs to the region, of 16 points.
    pub part: f64,
    /// Cells along a side of the block that was measured.
    pub block: u64,
    /// What was found.
    pub share: Share,
    /// One standard deviation: that of the share, and how far the quarters of the block differ beyond it.
    pub error: f64,
}

/// Orbits that began at one point: of one component of its region.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Known {
    pub region: RegionId,
    pub component: usize,
    /// In cells from the corner of the window.
    pub point: [f64; 2],
    pub share: Share,
}

/// One component of one region in a block.
pub(crate) struct Measured {
    pub block: Block,
    pub region: RegionId,
    pub component: usize,
    /// Where its orbits began, and their verdicts, including those of the larger block of which it is a quarter.
    pub known: Vec<Known>,
    /// Its own points in the region: their places in `known`, and their surfaces.
    pub surfaces: Vec<(usize, EnergySurface)>,
    /// Where the sequence of states continues.
    pub next: u64,
    /// It has no states that could be found.
    pub is_empty: bool,
    cells: Cells,
}

impl Measured {
    /// A component of a region at these points of a block. Orbits at points of the block that are `known` count, and
    /// the sequence of states continues after theirs.
    pub fn new(
        cells: &Cells,
        block: Block,
        (region, component): (RegionId, usize),
        surfaces: &[([f64; 2], EnergySurface)],
        known: &[Known],
        next: u64,
    ) -> Self {
        let own = |one: &&Known| (one.region, one.component) == (region, component) && block.contains(one.point);
        let mut known: Vec<Known> = known.iter().filter(own).copied().collect();
        let first = known.len();
        known.extend(surfaces.iter().map(|(point, _)| Known {
            region,
            component,
            point: *point,
            share: Share::default(),
        }));
        let surfaces: Vec<(usize, EnergySurface)> =
            surfaces.iter().enumerate().map(|(number, (_, surface))| (first + number, surface.clone())).collect();
        let is_empty = surfaces.is_empty();
        Self { block, region, component, known, surfaces, next, is_empty, cells: *cells }
    }

    pub fn share(&self) -> Share {
        self.known.iter().fold(Share::default(), |share, one| share.and(one.share))
    }

    /// The mean square of the differences between the shares of the quarters, and that expected by chance.
    fn differences(&self) -> Option<[f64; 2]> {
        if self.block.side == 1 {
            return None;
        }
        let mut quarters = [Share::default(); 4];
        for one in &self.known {
            let quarter = &mut quarters[self.block.quarter_of(&self.cells, one.point)];
            *quarter = quarter.and(one.share);
        }
        let whole = self.share();
        let parts: Vec<Share> = quarters.into_iter().filter(|quarter| quarter.orbits > 0).collect();
        if parts.len() < 2 {
            return None;
        }
        let variance = whole.variance();
        let square = |part: &Share| {
            let difference = part.fraction() - whole.fraction();
            difference * difference
        };
        let chance = |part: &Share| variance / part.orbits as f64 * (1.0 - part.orbits as f64 / whole.orbits as f64);
        let degrees = (parts.len() - 1) as f64;
        Some([parts.iter().map(square).sum::<f64>() / degrees, parts.iter().map(chance).sum::<f64>() / degrees])
    }

    /// One standard deviation of the share of a cell: that of its orbits, and how far the quarters differ beyond chance.
    pub fn error(&self) -> f64 {
        let error = self.share().error();
        let spread = self.differences().map_or(0.0, |[found, chance]| (found - chance).max(0.0));
        (error * error + spread).sqrt()
    }

    /// Orbits that are to be judged next.
    fn missing(&self, wanted: f64) -> usize {
        if self.is_empty {
            return 0;
        }
        let share = self.share();
        if self.block.side == 1 {
            return share.missing(wanted);
        }
        // Where the quarters surely differ by more than the error, they are measured apart at once.
        let is_uneven = |[found, chance]: [f64; 2]| found > BEYOND_CHANCE * chance + wanted * wanted;
        // A block needs more than its cells would, so that its quarters can be compared.
        if self.differences().is_some_and(is_uneven) { 0 } else { share.missing(0.5 * wanted) }
    }

    /// The states of its next orbits: their places in `known`, and they.
    fn states(&mut self, options: &ShareOptions) -> Vec<(usize, Vec<State>)> {
        let missing = self.missing(options.error);
        let count = self.surfaces.len().max(1);
        let mut found = Vec::new();
        for (place, (known, surface)) in self.surfaces.iter().enumerate() {
            let share = missing / count + usize::from(place < missing % count);
            if share == 0 {
                continue;
            }
            match surface.states_from(self.component, share, options.seed, self.next) {
                Ok((states, next)) => {
                    self.next = next;
                    found.push((*known, states));
                }
                // A component that is too thin to be met stays without orbits.
                Err(_too_small) => self.is_empty = true,
            }
        }
        found
    }

    /// The rows of its cells.
    pub fn rows(&self) -> impl Iterator<Item = CellShare> {
        let [along_h, along_l] = self.block.cells(&self.cells);
        let (share, error) = (self.share(), self.error());
        let of = move |cell: [u64; 2]| {
            let [h, l] = self.cells.place(cell[0] as f64 + 0.5, cell[1] as f64 + 0.5);
            CellShare {
                cell,
                h,
                l,
                region: self.region,
                component: self.component,
                part: self.surfaces.len() as f64 / POINTS as f64,
                block: self.block.side,
                share,
                error,
            }
        };
        along_h.flat_map(move |i| along_l.clone().map(move |j| [i, j])).map(of)
    }
}

/// Judges orbits of all of them together, until each has the error that is wanted.
pub(crate) fn measure(
    measured: &mut [Measured],
    options: &ShareOptions,
    monitor: &Monitor,
) -> Result<(), SectionError> {
    let Some((_, first)) = measured.iter().find_map(|one| one.surfaces.first()) else { return Ok(()) };
    let top = *first.top();
    loop {
        // The orbits of one round: whose they are, and their states.
        let mut owners: Vec<(usize, usize)> = Vec::new();
        let mut states: Vec<State> = Vec::new();
        for (number, one) in measured.iter_mut().enumerate() {
            for (known, found) in one.states(options) {
                owners.extend(std::iter::repeat_n((number, known), found.len()));
                states.extend(found);
            }
        }
        if states.is_empty() {
            return Ok(());
        }
        let found = decisions(&top, &states, &options.orbits, monitor)?;
        if monitor.is_stopped() {
            return Ok(());
        }
        for ((number, known), decision) in owners.into_iter().zip(found) {
            let share = &mut measured[number].known[known].share;
            *share = share.and(Share::of(&[decision]));
        }
    }
}
