//! The atlas of a body: every region of the (h, l) half-plane with its topology, ready to answer further points.

mod document;
mod exact;
mod locate;
mod names;
mod region;

use thiserror::Error;

use crate::arrangement::{Arrangement, Undecided};
use crate::body::Body;
use crate::equilibria::{CriticalSet, EquilibriaError};
use crate::topology::merge::MergeError;
use crate::topology::{Component, Poles};

pub use document::DocumentOptions;
pub(crate) use exact::{compare_with_r, on_straight_curve};
pub use locate::{Location, MomentumError, Place};
pub(crate) use locate::{abscissa, comparison_error};
pub use names::{branch_name, curve_name};
pub use region::{Region, Sample};
pub(crate) use region::{components_below, partition_below};

/// Everything that is constant on the regions of one body.
#[derive(Clone, Debug)]
pub struct Atlas {
    body: Body,
    arrangement: Arrangement,
    regions: Vec<Region>,
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
        let regions = region::classify_faces(&arrangement);
        Ok(Self { body: body.clone(), arrangement, regions })
    }

    /// An atlas of parts that were found otherwise, to write its document.
    pub(crate) fn of_parts(body: Body, arrangement: Arrangement, regions: Vec<Region>) -> Self {
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
    pub fn regions(&self) -> &[Region] {
        &self.regions
    }

    /// The components of U_hl in a region.
    ///
    /// # Errors
    /// The [`MergeError`] that left them undecided.
    pub fn components(&self, region: usize) -> Result<&[Component], MergeError> {
        self.regions[region].components.as_deref().map_err(|error| *error)
    }
}

/// The whole sphere with both poles (none when r = 0): U_hl above the highest critical value.
pub(crate) fn whole_sphere(has_poles: bool) -> Component {
    Component { boundary_circles: 0, poles: has_poles.then_some(Poles { plus: true, minus: true }) }
}
