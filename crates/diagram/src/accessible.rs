//! To which component of U_hl a point of the Poisson sphere belongs.

use crate::atlas;
use crate::fast::FastError;
use crate::topology::merge::{MergeError, Partition};
use bifdiag_body::Body;
use bifdiag_equilibria::curves::{CriticalSet, CurveId, Point};

/// The accessible region U_hl of a body at one point that is not on a curve.
#[derive(Clone, Debug)]
pub struct AccessibleRegion {
    set: CriticalSet,
    x: f64,
    /// Curves below h at this l, and the relative equilibria there.
    below: Vec<(CurveId, Point)>,
}

impl AccessibleRegion {
    /// The region at (h, l), which [`classify`](crate::fast::classify) must find regular.
    ///
    /// # Errors
    /// [`FastError`] when the body or l leave the range of `f64`.
    pub fn new(body: &Body, h: f64, l: f64) -> Result<Self, FastError> {
        let set = CriticalSet::new(body.frame())?;
        let x = bifdiag_equilibria::curves::abscissa(&set.frame, l)?;
        let energy = h / set.frame.energy_unit;
        let mut below = Vec::new();
        // For l = 0 the region is a disc or the sphere, and no curve is needed.
        if x > 0.0 {
            let points = set.curves_over(x).0.into_iter().map(|c| (c, set.curves[c].point(&set.frame, x)));
            below.extend(points.filter(|(_, point)| point.h() < energy));
            below.sort_by(|p, q| p.1.h().total_cmp(&q.1.h()));
        }
        Ok(Self { set, x, below })
    }

    /// The components with the minima over which they lie; `None` if U_hl is connected for want of curves (l = 0).
    ///
    /// # Errors
    /// [`MergeError`] when rounding leaves a join open.
    pub fn partition(&self) -> Result<Option<Partition<'_>>, MergeError> {
        if self.below.is_empty() {
            return Ok(None);
        }
        let below = self.below.iter().map(|(curve, point)| (*curve, point));
        atlas::partition_below(&self.set, self.x, below).map(Some)
    }
}

/// The number of the component, in canonical order, to which γ of the body's own axes belongs; U(γ) ≤ h is needed.
/// `None` if no path to a minimum could be proved.
#[must_use]
pub fn component_of(partition: &Partition<'_>, gamma: [f64; 3]) -> Option<usize> {
    partition.component_of(partition.frame().vector_from_body(gamma))
}
