//! What rotation about an axis is, and which permanent axes lie near it.

use bifdiag_body::Body;
use bifdiag_numbers::Sign;
use bifdiag_numbers::vector::{dot, norm};
use dashu_ratio::RBig;

use super::cone::{NearestAxis, PermanentAxis, angle_between, nearest_permanent, permanent_axis};
use super::rotation::AxisRotation;
use crate::critical::{Multiplicity, SteadyFamily, is_principal};

/// An axis nearer to a permanent one than this, in radians, is that axis: directions are given with some digits.
pub const MEANT: f64 = 1e-6;

/// Half a degree, in radians: an axis that misses a permanent one by less is replaced by it where changes over the spin
/// are requested, since only a permanent axis has them.
pub const FOLLOWED: f64 = std::f64::consts::PI / 360.0;

/// What an axis is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum AxisKind {
    /// Permanent at every spin.
    Permanent {
        /// The axis.
        axis: PermanentAxis,
        /// Its angle to the given direction, in radians.
        angle: f64,
    },
    /// Permanent at one spin, or with the other end up.
    AtOneSpin(NearestAxis),
    /// Principal, but the centre of mass does not lie on it: permanent at no spin.
    Principal,
    /// Permanent at no spin; the nearest one that is.
    Other(NearestAxis),
    /// Not found within the range of `f64`.
    Unknown,
}

impl AxisKind {
    /// For the axis along `up` in principal axes, which points up; `exact` is the same in the axes in which the body was given,
    /// of any length.
    #[must_use]
    pub fn of(body: &Body, up: [f64; 3], exact: &[RBig; 3]) -> Self {
        if let Some(found) = Self::permanent(body, up, MEANT) {
            return found;
        }
        match nearest_permanent(body, up) {
            None => Self::Unknown,
            Some(axis) if axis.angle.is_nan() || axis.squared_spin.is_some_and(|s| !s.is_finite()) => Self::Unknown,
            Some(axis) if axis.angle > MEANT => Self::Other(axis),
            // Turned into principal axes, a principal axis may miss its own by rounding.
            Some(axis) if axis.squared_spin.is_some() && !is_principal(body, exact) => Self::AtOneSpin(axis),
            Some(_) => Self::Principal,
        }
    }

    /// The same, where a permanent axis within half a degree is followed in place of the one given.
    #[must_use]
    pub fn followed(body: &Body, up: [f64; 3], exact: &[RBig; 3]) -> Self {
        Self::permanent(body, up, FOLLOWED).unwrap_or_else(|| Self::of(body, up, exact))
    }

    /// The axis that is permanent at every spin, if one is as near as `within` to a direction.
    fn permanent(body: &Body, up: [f64; 3], within: f64) -> Option<Self> {
        let axis = permanent_axis(body, up)?;
        let angle = angle_between(axis.direction, up);
        (angle <= within).then_some(Self::Permanent { axis, angle })
    }
}

/// How many axes like the permanent one nearest to a direction there are: one, or a circle or sphere of them.
#[must_use]
pub fn permanent_multiplicity(body: &Body, up: [f64; 3]) -> Option<Multiplicity> {
    let axis = permanent_axis(body, up)?;
    Some(AxisRotation::about(body, axis, Sign::Negative)?.multiplicity())
}

/// The axes that are permanent at every spin: of each end-to-end pair the end on the side of the centre of mass, and of a
/// circle one.
#[must_use]
pub fn permanent_axes(body: &Body, families: &[SteadyFamily]) -> Vec<PermanentAxis> {
    let (mut axes, center): (Vec<PermanentAxis>, _) = (Vec::new(), body.center_f64());
    for family in families.iter().filter(|family| family.is_permanent) {
        let Some(found) = permanent_axis(body, family.fast) else { continue };
        let direction = found.direction;
        let side = if norm(center) > 0.0 { dot(direction, center) } else { direction.iter().sum() };
        let direction = if side < 0.0 { direction.map(|x| 0.0 - x) } else { direction };
        if axes.iter().all(|known| known.direction != direction) {
            axes.push(PermanentAxis { direction, ..found });
        }
    }
    axes
}

/// Without weight: the permanent axes at an angle in radians from a direction, of each circle of them the one nearest to it.
#[must_use]
pub fn principal_at(body: &Body, direction: [f64; 3], angle: f64) -> Vec<[f64; 3]> {
    /// Angles that differ by less are the same.
    const TIE: f64 = 1e-11;
    let moments = body.moments();
    let firsts = (0..3).filter(|&i| moments.iter().position(|moment| moment == &moments[i]) == Some(i));
    let nearest = firsts.filter_map(|i| {
        let part: [f64; 3] = std::array::from_fn(|k| if moments[k] == moments[i] { direction[k] } else { 0.0 });
        let length = norm(part);
        (length > 0.0).then(|| part.map(|x| x / length))
    });
    let between = |axis: &[f64; 3]| {
        let between = angle_between(*axis, direction);
        between.min(std::f64::consts::PI - between)
    };
    nearest.filter(|axis| (between(axis) - angle).abs() < TIE).collect()
}
