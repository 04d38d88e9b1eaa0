//! Rotation about an axis of Staude's cone, which is steady at one spin.

use bifdiag_body::Body;
use bifdiag_numbers::vector::dot;
use bifdiag_schema::AxisEnd;
use dashu_ratio::RBig;

use super::axis::MEANT;
use super::cone::NearestAxis;
use super::steady::nearest_steady;
use crate::critical::{Equilibrium, ExactSpin};

/// The spin at which rotation about an axis is steady.
#[derive(Clone, Debug, PartialEq)]
pub struct OneSpin {
    /// Which end is up then.
    pub end: AxisEnd,
    /// Ω.
    pub omega: f64,
    /// l there.
    pub l: f64,
    /// h there.
    pub h: f64,
    /// The relative equilibrium; `None` where it was not found.
    pub equilibrium: Option<Equilibrium>,
}

impl OneSpin {
    /// For an axis on the cone, given as `exact` in the axes in which the body was given, of any length; `None` for one that is in
    /// equilibrium at rest.
    #[must_use]
    pub fn of(body: &Body, axis: &NearestAxis, exact: &[RBig; 3]) -> Option<Self> {
        let s = axis.squared_spin.filter(|s| *s != 0.0)?;
        let up = axis.axis.map(|x| s.signum() * x);
        let rational = |x: f64| RBig::try_from(x).unwrap_or_default();
        let exact_up = exact.each_ref().map(|x| x * rational(s.signum()));
        let exact_spin = ExactSpin::of_steady(body, &exact_up);
        let is_exact = exact_spin.is_some();
        let spin = exact_spin.unwrap_or_else(|| ExactSpin::rational(rational(s.abs().sqrt())));
        let omega = spin.omega.to_f64().value();
        let (a, r) = (body.moments_f64(), body.center_f64());
        let l = omega * dot(up, [0, 1, 2].map(|k| a[k] * up[k]));
        let found = nearest_steady(body, &spin, up, is_exact.then_some(&exact_up)).filter(|found| found.angle <= MEANT);
        Some(Self {
            end: AxisEnd::of_squared_spin(s),
            omega,
            l,
            h: 0.5 * omega * l + dot(up, r),
            equilibrium: found.map(|found| found.equilibrium),
        })
    }
}
