//! Point location: the region of a point on a prepared body, without tracing anything.

use thiserror::Error;

use super::Atlas;
use crate::body::Frame;
use crate::equilibria::Point;
use crate::numerics::UNIT_ROUNDOFF;

/// Where a point (h, l) lies.
#[derive(Clone, Debug, PartialEq)]
pub struct Location {
    /// In a region, below all, or too near to a curve.
    pub place: Place,
    /// Distance in h to the nearest curve at this l, in the body's units.
    pub distance: f64,
    /// The nearest curve.
    pub nearest: usize,
    /// Bound on the error of `distance`, the rounding of h and l included.
    pub error_bound: f64,
    /// Points of curves that were computed.
    pub curve_points: usize,
}

/// What a location says.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Place {
    /// Inside this region.
    Region(usize),
    /// Below the lowest critical value.
    Forbidden,
    /// Closer to a curve than the error bound: one of these regions (`None`: forbidden).
    Undecided(Vec<Option<usize>>),
}

/// An angular momentum at which `f64` cannot compute.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error("l = {l:e} is too {} for this body in f64; |l| between {smallest:e} and {largest:e}, or 0, is possible", if *.l < *.smallest { "small" } else { "large" })]
pub struct MomentumError {
    /// |l| as asked for.
    pub l: f64,
    /// Smallest |l| > 0.
    pub smallest: f64,
    /// Largest |l|.
    pub largest: f64,
}

/// Roundings of x = l²/2 relative to its exact value: l itself, the square.
pub(crate) const X_ROUNDINGS: f64 = 4.0;

/// x = l²/2 in the frame's units.
///
/// # Errors
/// [`MomentumError`] when squares and cubes of x would leave the range of `f64`.
pub(crate) fn abscissa(frame: &Frame, l: f64) -> Result<f64, MomentumError> {
    const LIMIT: f64 = 1e45;
    let scaled = l.abs() / frame.momentum_unit;
    if scaled == 0.0 || (1.0 / LIMIT..=LIMIT).contains(&scaled) {
        Ok(0.5 * scaled * scaled)
    } else {
        let unit = frame.momentum_unit;
        Err(MomentumError { l: l.abs(), smallest: unit / LIMIT, largest: unit * LIMIT })
    }
}

/// Bound on the error of h − h_curve: of the curve, of x and of h.
pub(crate) fn comparison_error(point: &Point, h: f64) -> f64 {
    point.h_error() + UNIT_ROUNDOFF * (2.0 * X_ROUNDINGS * point.x * point.slope() + 4.0 * h.abs())
}

impl Atlas {
    /// Locates a point (h, l), l ≠ 0: a binary search over events, then over the curves of one slab.
    ///
    /// # Errors
    /// [`MomentumError`] when |l| is out of range; l = 0 is answered by [`crate::classify`].
    pub fn locate(&self, h: f64, l: f64) -> Result<Location, MomentumError> {
        let frame = &self.arrangement.set.frame;
        let x = abscissa(frame, l)?;
        let mut location = self.locate_scaled(h / frame.energy_unit, x);
        location.distance *= frame.energy_unit;
        location.error_bound *= frame.energy_unit;
        Ok(location)
    }

    fn locate_scaled(&self, h: f64, x: f64) -> Location {
        let slabs = &self.arrangement.slabs;
        let number = slabs.partition_point(|slab| slab.x[1] < x).min(slabs.len() - 1);
        let point = |c: usize| self.arrangement.set.curves[c].point(&self.arrangement.set.frame, x);
        let order = &slabs[number].order;
        // Curves order[..low] lie below h, order[high..] above.
        let (mut low, mut high) = (0, order.len());
        let (mut below, mut above): (Option<Point>, Option<Point>) = (None, None);
        let mut curve_points = 0;
        while low < high {
            let middle = usize::midpoint(low, high);
            let candidate = point(order[middle]);
            curve_points += 1;
            if candidate.h() <= h {
                low = middle + 1;
                below = Some(candidate);
            } else {
                high = middle;
                above = Some(candidate);
            }
        }
        let side = |p: &Option<Point>| p.map_or((f64::INFINITY, 0.0), |p| ((h - p.h()).abs(), comparison_error(&p, h)));
        let (under, over) = (side(&below), side(&above));
        let (distance, nearest) =
            if under.0 <= over.0 { (under.0, order[low - 1]) } else { (over.0, order[low.min(order.len() - 1)]) };
        let error_bound = under.1.max(over.1);
        let place = if distance <= error_bound {
            Place::Undecided(self.candidates(h, x, number))
        } else if low == 0 {
            Place::Forbidden
        } else {
            Place::Region(slabs[number].face_above[low - 1])
        };
        Location { place, distance, nearest, error_bound, curve_points }
    }

    /// Every region that meets the box of rounding around a point: in its slab, and in the neighbouring slabs when an
    /// event is that near.
    fn candidates(&self, h: f64, x: f64, number: usize) -> Vec<Option<usize>> {
        let slabs = &self.arrangement.slabs;
        let mut found = Vec::new();
        let near = |event: usize| {
            let event = &self.arrangement.events[event];
            (event.x - x).abs() <= 4.0 * event.x_error + 4.0 * X_ROUNDINGS * UNIT_ROUNDOFF * x
        };
        let mut first = number;
        while first > 0 && near(first - 1) {
            first -= 1;
        }
        let mut last = number;
        while last + 1 < slabs.len() && near(last) {
            last += 1;
        }
        for slab in &slabs[first..=last] {
            let at = x.clamp(slab.x[0].max(f64::MIN_POSITIVE), slab.x[1]);
            let points: Vec<Point> = slab
                .order
                .iter()
                .map(|&c| self.arrangement.set.curves[c].point(&self.arrangement.set.frame, at))
                .collect();
            let reaches = |p: &Point| {
                let error = 2.0 * comparison_error(p, h);
                (p.h() - error <= h, p.h() + error >= h)
            };
            for gap in 0..=points.len() {
                let above_lower = gap == 0 || reaches(&points[gap - 1]).0;
                let below_upper = gap == points.len() || reaches(&points[gap]).1;
                let face = gap.checked_sub(1).map(|position| slab.face_above[position]);
                if above_lower && below_upper && !found.contains(&face) {
                    found.push(face);
                }
            }
        }
        found
    }
}
