//! The chaotic shares of the energy surface at one point.

use bifdiag_diagram::arrangement::RegionId;
use bifdiag_diagram::atlas::Spot;
use bifdiag_diagram::topology::{Answer, Component};
use bifdiag_dynamics::poincare::{PoincareError, components_at};
use bifdiag_dynamics::section::Monitor;
use bifdiag_exact::{AnswerError, Solver};
use bifdiag_numbers::Number;
use thiserror::Error;

use crate::liouville::{EnergySurface, SampleError};
use crate::share::{Share, ShareError, ShareOptions, shares};

/// The shares at a point.
#[derive(Clone, Debug, PartialEq)]
pub struct PointShares {
    /// The region in which it lies; `None` without an atlas.
    pub region: Option<RegionId>,
    /// The components there.
    pub components: Vec<Component>,
    /// The share of each.
    pub shares: Vec<Share>,
}

/// Why a point has no shares.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum PointError {
    /// Nothing moves there, or the energy surface is singular: in the words that sections have for it.
    #[error(transparent)]
    Nowhere(PoincareError),
    /// The point cannot be distinguished from a curve in doubles, or l from an event.
    #[error(
        "(h, l) is too near to a curve or an event of the bifurcation diagram for orbits in double precision; choose h \
         farther from the curve, or another l"
    )]
    TooNear,
    /// The point was not classified.
    #[error("the point could not be classified")]
    Answer(#[from] AnswerError),
    /// There is no energy surface in doubles.
    #[error("the energy surface leaves the range of double precision")]
    Range(#[source] SampleError),
    /// Orbits were not found or not followed.
    #[error("the share could not be measured")]
    Share(#[from] ShareError),
}

/// The chaotic share of each component at a point. Where `monitor` stops the work, all that was begun is open.
///
/// # Errors
/// [`PointError`].
pub fn point_shares(
    solver: &Solver,
    [h, l]: [&Number; 2],
    options: &ShareOptions,
    monitor: &Monitor,
) -> Result<PointShares, PointError> {
    let found = solver.classify(h, l)?;
    if let Answer::Undecided(_) = found.answer {
        return Err(PointError::TooNear);
    }
    let components = components_at(solver.body(), [h, l], &found).map_err(PointError::Nowhere)?;
    let region = match solver.spot(h, l, &found.answer) {
        Spot::Region(region) => Some(region),
        _ if solver.atlas().is_none() => None,
        _ => return Err(PointError::TooNear),
    };
    let surface = EnergySurface::new(solver.body(), h.to_f64(), l.to_f64(), components.len());
    let shares = shares(&surface.map_err(PointError::Range)?, options, monitor)?;
    Ok(PointShares { region, components, shares })
}
