//! The atlas of a body: every region of the (h, l) half-plane with its topology, ready to answer further points.

mod course;
mod exact;
mod locate;
mod margin;
mod outline;
mod places;
mod polyline;
mod region;
mod rows;
mod sanity;
mod view;
mod way;
mod width;
mod window;

use thiserror::Error;

use crate::arrangement::{Arrangement, RegionId, Undecided};
use crate::topology::Component;
use crate::topology::merge::MergeError;
use bifdiag_body::Body;
use bifdiag_equilibria::curves::{CriticalSet, CurveId, EquilibriaError, Orbit};
use bifdiag_numbers::table::Table;

pub use course::{CourseOptions, Tail};
pub use exact::{compare_with_r, on_straight_curve};
pub(crate) use locate::comparison_error;
pub use locate::{Location, Place};
pub use margin::Margin;
pub use outline::Outline;
pub use places::{NoCell, Sides};
pub use region::{Region, Sample};
pub(crate) use region::{components_below, partition_below};
pub use rows::Spot;
pub use sanity::{Contradiction, Counts};
pub use view::View;
pub use way::Passage;
pub use window::{SamplePoint, Window};

pub use crate::topology::whole_sphere;

/// Everything that is constant on the regions of one body.
#[derive(Clone, Debug)]
pub struct Atlas {
    body: Body,
    arrangement: Arrangement,
    regions: Table<RegionId, Region>,
}

/// Why there is no atlas.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum AtlasError {
    /// The critical points cannot be computed.
    #[error(transparent)]
    Equilibria(#[from] EquilibriaError),
    /// The regions could not be put together: events of this body are closer than `f64` resolves.
    #[error(
        "the regions of this body cannot be told apart in f64: the order of the curves near l = {l:e} is not decided"
    )]
    Unresolved {
        /// Near this l, in the body's units.
        l: f64,
    },
}

impl Atlas {
    /// Computes curves, events, regions and their topology; no polylines, no stability.
    ///
    /// # Errors
    /// [`AtlasError::Equilibria`] when the body's data leave the range of `f64`; [`AtlasError::Unresolved`] when the
    /// order of the curves contradicts itself, which happens only when events coincide to within rounding.
    pub fn new(body: &Body) -> Result<Self, AtlasError> {
        let arrangement = Arrangement::new(CriticalSet::new(body.frame())?);
        if arrangement.slabs.is_empty() {
            let at = arrangement.undecided.iter().find_map(|undecided| match undecided {
                Undecided::Order { event } => Some(arrangement.events[*event].x),
                _ => None,
            });
            let x = at.unwrap_or(0.0);
            return Err(AtlasError::Unresolved { l: (2.0 * x).sqrt() * arrangement.set.frame.momentum_unit });
        }
        let regions = region::classify_regions(&arrangement);
        Ok(Self { body: body.clone(), arrangement, regions })
    }

    /// An atlas of parts that were found otherwise.
    #[must_use]
    pub fn of_parts(body: Body, arrangement: Arrangement, regions: Table<RegionId, Region>) -> Self {
        Self { body, arrangement, regions }
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
        let count = |c: CurveId| match self.arrangement.set.curves[c].orbit {
            Orbit::Pair(_) => 2,
            Orbit::Pole(_) => 0,
            _ => 1,
        };
        self.arrangement.slabs.iter().map(|slab| slab.order.iter().map(|&c| count(c)).sum()).max().unwrap_or(0)
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
