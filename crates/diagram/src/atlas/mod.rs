//! The atlas of a body: every region of the (h, l) half-plane with its topology, ready to answer further points.

mod drawing;
mod edges;
mod locate;
mod places;
mod region;
mod way;

use crate::arrangement::{Arrangement, RegionId, SlabId};
use crate::topology::Component;
use crate::topology::merge::MergeError;
use bifdiag_body::Body;
use bifdiag_equilibria::curves::{CurveId, Orbit};
use bifdiag_numbers::table::Table;

pub use drawing::{Outline, PolylineOptions, SamplePoint, Tail, View, Window};
pub(crate) use locate::comparison_error;
pub use locate::{Location, Place};
pub use places::{CellError, Sides, Spot, StraightCurve, compare_with_r, straight_curve_at};
pub use region::{Region, Sample};
pub(crate) use region::{components_below, partition_below, regions};
pub use way::Passage;

/// Everything that is constant on the regions of one body.
#[derive(Clone, Debug)]
pub struct Atlas {
    body: Body,
    arrangement: Arrangement,
    regions: Table<RegionId, Region>,
    /// Where the slabs do not tell it.
    critical_points_max: Option<usize>,
}

impl Atlas {
    /// An atlas of parts.
    #[must_use]
    pub fn of_parts(body: Body, arrangement: Arrangement, regions: Table<RegionId, Region>) -> Self {
        Self { body, arrangement, regions, critical_points_max: None }
    }

    /// The body.
    #[must_use]
    pub fn body(&self) -> &Body {
        &self.body
    }

    /// Curves, events and slabs.
    #[must_use]
    pub fn arrangement(&self) -> &Arrangement {
        &self.arrangement
    }

    /// The regions, numbered by their first appearance as l, then h rise.
    #[must_use]
    pub fn regions(&self) -> &Table<RegionId, Region> {
        &self.regions
    }

    /// The largest number of relative equilibria at one l; a critical circle or sphere counts once.
    #[must_use]
    pub fn critical_points_max(&self) -> usize {
        self.critical_points_max.unwrap_or_else(|| self.largest_count(|_| true))
    }

    /// False where that number is reached only between events that lie within their errors of each other: if they are at one l,
    /// it is never reached.
    #[must_use]
    pub fn is_maximum_certain(&self) -> bool {
        let events = &self.arrangement.events;
        let is_wide = |slab: SlabId| {
            let [from, to] = [slab.before(), Some(slab)].map(|slab| {
                slab.and_then(|slab| self.arrangement.events_after(slab).next()).map(|event| &events[event])
            });
            from.zip(to).is_none_or(|(from, to)| to.x - from.x > from.x_error + to.x_error)
        };
        self.critical_points_max.is_some() || self.largest_count(is_wide) == self.critical_points_max()
    }

    /// The same atlas with the largest number of relative equilibria that is proved.
    #[must_use]
    pub fn with_critical_points_max(self, most: usize) -> Self {
        Self { critical_points_max: Some(most), ..self }
    }

    /// The largest number of relative equilibria over those slabs.
    fn largest_count(&self, counts: impl Fn(SlabId) -> bool) -> usize {
        let points = |c: CurveId| match self.arrangement.set.curves[c].orbit {
            Orbit::Pair(_) => 2,
            Orbit::Pole(_) => 0,
            _ => 1,
        };
        let slabs = self.arrangement.slabs.pairs().filter(|(slab, _)| counts(*slab));
        slabs.map(|(_, slab)| slab.order.iter().map(|&c| points(c)).sum()).max().unwrap_or(0)
    }

    /// l of x = l²/2, in the body's units.
    #[must_use]
    pub fn momentum(&self, x: f64) -> f64 {
        (2.0 * x).sqrt() * self.arrangement.set.frame.momentum_unit
    }

    /// h in the body's units.
    #[must_use]
    pub fn energy(&self, h: f64) -> f64 {
        h * self.arrangement.set.frame.energy_unit
    }

    /// The components of U_hl in a region.
    ///
    /// # Errors
    /// The [`MergeError`] that left them undecided.
    pub fn components(&self, region: RegionId) -> Result<&[Component], MergeError> {
        self.regions[region].components.as_deref().map_err(|error| *error)
    }
}
