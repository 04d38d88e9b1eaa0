//! The cells of all slabs, glued to faces.

use super::id::{RegionId, SlabId};
use bifdiag_numbers::table::{Id, Partition, Table};

/// A gap of one slab and a gap of the next that are in one face. Gap k lies below the k-th curve of its slab; the last one is
/// unbounded above.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Continued {
    /// The gap in the slab at smaller x.
    pub before: usize,
    /// The gap in the next one.
    pub after: usize,
}

/// The cells, while they are glued.
#[derive(Clone, Debug)]
pub struct Cells {
    /// How many curves there are in each slab, and the number of its lowest cell.
    slabs: Table<SlabId, (usize, usize)>,
    joined: Partition,
}

/// The faces, which are the diagram's regions: for each slab, the region of each gap but the lowest.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Faces {
    /// `above[slab][i]` is the region above the i-th curve of the slab.
    pub above: Table<SlabId, Vec<RegionId>>,
    /// Number of regions.
    pub count: usize,
}

impl Cells {
    /// The cells of slabs with so many curves, each by itself.
    pub fn new(curves: impl IntoIterator<Item = usize>) -> Self {
        let mut slabs = Table::new();
        let mut count = 0;
        for curves in curves {
            slabs.push((curves, count));
            count += curves + 1;
        }
        Self { slabs, joined: Partition::new(count) }
    }

    /// Glues gaps of two slabs.
    pub fn glue(&mut self, [before, after]: [SlabId; 2], continued: impl IntoIterator<Item = Continued>) {
        let first = [before, after].map(|slab| self.slabs[slab].1);
        for gaps in continued {
            self.joined.unite(first[0] + gaps.before, first[1] + gaps.after);
        }
    }

    /// The faces, numbered as they first appear: by slab, then from below. The lowest gaps, which are forbidden, have none.
    #[must_use]
    pub fn faces(mut self) -> Faces {
        let mut numbers: Vec<Option<RegionId>> = Vec::new();
        let mut count = 0;
        let mut above = Table::new();
        for &(curves, first) in &self.slabs {
            numbers.resize(first + curves + 1, None);
            let region = |gap| {
                let number = &mut numbers[self.joined.find(first + gap)];
                *number.get_or_insert_with(|| {
                    count += 1;
                    RegionId::at(count - 1)
                })
            };
            above.push((1..=curves).map(region).collect());
        }
        Faces { above, count }
    }
}
