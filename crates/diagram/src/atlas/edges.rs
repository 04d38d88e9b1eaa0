//! Where a region ends.

use super::Atlas;
use crate::arrangement::{Cell, RegionId};
use bifdiag_equilibria::curves::CurveId;

impl Atlas {
    /// The curves around a region, each with every region beyond it (`None` below all curves), as its cells come.
    #[must_use]
    pub fn edges(&self, region: RegionId) -> Vec<(CurveId, Option<RegionId>)> {
        let mut edges = Vec::new();
        for &Cell { slab, position } in &self.regions()[region].cells {
            let strip = &self.arrangement().slabs[slab];
            let below = (strip.order[position], position.checked_sub(1).map(|p| strip.region_above[p]));
            let upper = strip.order.get(position + 1);
            let above = upper.map(|&upper| (upper, Some(strip.region_above[position + 1])));
            for edge in [below].into_iter().chain(above) {
                if !edges.contains(&edge) {
                    edges.push(edge);
                }
            }
        }
        edges
    }

    /// The curves below the cells of a region, each with the region below it (`None` below all curves).
    pub fn floors(&self, region: RegionId) -> impl Iterator<Item = (CurveId, Option<RegionId>)> {
        self.regions()[region].cells.iter().map(|&Cell { slab, position }| {
            let strip = &self.arrangement().slabs[slab];
            (strip.order[position], position.checked_sub(1).map(|below| strip.region_above[below]))
        })
    }

    /// The range of x = l²/2 of a region.
    #[must_use]
    pub fn range(&self, region: RegionId) -> [f64; 2] {
        let slabs = self.regions()[region].cells.iter().map(|cell| self.arrangement().slabs[cell.slab].x);
        slabs.fold([f64::INFINITY, 0.0], |[from, to], [low, high]| [from.min(low), to.max(high)])
    }

    /// A region lies between two values of l, and below a curve everywhere.
    #[must_use]
    pub fn is_bounded(&self, region: RegionId) -> bool {
        let has_roof = |cell: &Cell| cell.position + 1 < self.arrangement().slabs[cell.slab].order.len();
        self.range(region)[1].is_finite() && self.regions()[region].cells.iter().all(has_roof)
    }
}
