//! The cells of a map, and blocks of them.
//!
//! Cells are measured in tiles of 8 × 8, each for itself, so that a map can be cut into shards and taken up again.

use std::ops::Range;

use bifdiag_numbers::sequence;

/// Cells along a side of a tile.
pub(crate) const TILE: u64 = 8;
/// Points of a block at which orbits begin: four in each quarter.
pub(crate) const POINTS: usize = 16;

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

impl Cells {
    /// How many tiles there are.
    #[must_use]
    pub fn tiles(&self) -> u64 {
        self.counts[0].div_ceil(TILE) * self.counts[1].div_ceil(TILE)
    }

    /// How many cells some tiles have.
    #[must_use]
    pub fn within(&self, tiles: Range<u64>) -> u64 {
        let size = |number| self.tile(number).cells(self).map(|range| range.end - range.start);
        tiles.map(size).map(|[along_h, along_l]| along_h * along_l).sum()
    }

    /// A place (h, l) of the plane, given in cells along h and along l from the corner of the window.
    #[must_use]
    pub fn place(&self, h: f64, l: f64) -> [f64; 2] {
        let along = |[from, to]: [f64; 2], count: u64, cells: f64| from + (to - from) * cells / count as f64;
        [along(self.h, self.counts[0], h), along(self.l, self.counts[1], l)]
    }

    /// The block of a tile; l goes fastest.
    pub(crate) fn tile(&self, number: u64) -> Block {
        let along_l = self.counts[1].div_ceil(TILE);
        Block { from: [number / along_l * TILE, number % along_l * TILE], side: TILE }
    }
}

/// A square of cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Block {
    pub from: [u64; 2],
    pub side: u64,
}

impl Block {
    /// The cells in it along h and along l, at the edge of the window fewer.
    pub fn cells(&self, cells: &Cells) -> [Range<u64>; 2] {
        std::array::from_fn(|k| self.from[k]..(self.from[k] + self.side).min(cells.counts[k]))
    }

    fn is_empty(&self, cells: &Cells) -> bool {
        self.cells(cells).iter().any(Range::is_empty)
    }

    pub fn quarters(self, cells: &Cells) -> impl Iterator<Item = Self> + use<> {
        let cells = *cells;
        let half = self.side / 2;
        let quarter =
            move |k: u64| Self { from: [self.from[0] + k / 2 * half, self.from[1] + k % 2 * half], side: half };
        (0..4).map(quarter).filter(move |quarter| !quarter.is_empty(&cells))
    }

    /// Points of it, in cells from the corner of the window: cycling through the quarters, each a point of a
    /// low-discrepancy sequence in its quarter.
    pub fn points(&self, cells: &Cells) -> Vec<[f64; 2]> {
        let size = self.cells(cells).map(|range| (range.end - range.start) as f64);
        let point = |n: usize| {
            let place = sequence::point((n / 4) as u64, 2, 0);
            let quarter = [(n % 4 / 2) as f64, (n % 2) as f64];
            std::array::from_fn(|k| self.from[k] as f64 + size[k] * 0.5 * (quarter[k] + place[k]))
        };
        (0..POINTS).map(point).collect()
    }

    /// A point, in cells from the corner of the window, lies in it.
    pub fn contains(&self, point: [f64; 2]) -> bool {
        (0..2).all(|k| point[k] >= self.from[k] as f64 && point[k] < (self.from[k] + self.side) as f64)
    }

    /// In which quarter of the cells that it has a point lies.
    pub fn quarter_of(&self, cells: &Cells, point: [f64; 2]) -> usize {
        let far = |k: usize| {
            let Range { start, end } = self.cells(cells)[k];
            usize::from(point[k] - start as f64 >= 0.5 * (end - start) as f64)
        };
        2 * far(0) + far(1)
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
        assert_eq!((cells.within(0..cells.tiles()), cells.within(2..3)), (13 * 21, 8 * 5));
    }

    #[test]
    fn points_lie_in_their_quarters_also_at_the_edge_of_the_window() {
        let cells = Cells { h: [0.0, 8.0], l: [0.0, 8.0], counts: [13, 8] };
        for tile in 0..cells.tiles() {
            let block = cells.tile(tile);
            for (number, point) in block.points(&cells).into_iter().enumerate() {
                assert!(block.contains(point));
                assert_eq!(block.quarter_of(&cells, point), number % 4);
                assert_eq!(block.quarters(&cells).filter(|quarter| quarter.contains(point)).count(), 1);
            }
        }
    }
}
