//! The equilibria at one l by Newton continuation along their curves.

use super::{CriticalError, Equilibria, RelativeEquilibria};
use crate::continuation::{Start, follow};
use crate::curves::abscissa;
use crate::curves::{Branch, CurveId, CurveName, End, Orbit, Point, Shape};
use crate::stability::Hessian;
use bifdiag_body::Number;

/// Largest difference of γ from the closed form, and of h in units of its terms: continuation loses half the digits beside
/// a cusp or a pitchfork, where γ goes with a root of l.
const AGREEMENT: f64 = 1e-6;

impl RelativeEquilibria<'_> {
    /// The equilibria at l, each found by Newton continuation along its curve from the curve's end at smaller l: l = 0, a cusp
    /// or a pitchfork. γ, h, Ω and the Morse index are those found; names, multiplicities, eigenvalues and verdicts are those
    /// of [`at`](Self::at), and `error_bound` covers the difference in h as well. At l = 0 there is nothing to follow.
    ///
    /// # Errors
    /// Those of [`at`](Self::at); [`CriticalError::Lost`] when a curve cannot be followed to l (as within rounding of a cusp
    /// or a pitchfork) or leads elsewhere.
    pub fn continued(&self, l: &Number) -> Result<Equilibria, CriticalError> {
        let mut found = self.at(l)?;
        if l.to_f64() == 0.0 {
            return Ok(found);
        }
        let frame = &self.set.frame;
        let momentum = (2.0 * abscissa(frame, l.to_f64())?).sqrt();
        let mut difference = 0.0_f64;
        for equilibrium in &mut found.list {
            let lost = || CriticalError::Lost { curve: equilibrium.curve };
            let named = |id: &CurveId| Some(CurveName::of(&self.set, *id)) == equilibrium.curve;
            let id = self.set.curves.ids().find(named).ok_or_else(lost)?;
            let start = self.start(id).ok_or_else(lost)?;
            let mut point = follow(frame, &start, momentum).ok_or_else(lost)?;
            let orbit = self.set.curves[id].orbit;
            let index = match orbit {
                Orbit::Circle(_) | Orbit::Sphere => equilibrium.index,
                _ => Hessian::new(frame, &point).index().ok_or_else(lost)?,
            };
            let off = |gamma: [f64; 3]| {
                let gamma = frame.vector_to_body(gamma);
                (0..3).map(|k| (gamma[k] - equilibrium.gamma[k]).abs()).fold(0.0, f64::max)
            };
            if let Orbit::Pair(axis) = orbit {
                let mut image = point.gamma;
                image[axis] = -image[axis];
                if off(image) < off(point.gamma) {
                    point.gamma = image;
                }
            }
            let h = point.h(frame) * frame.energy_unit;
            let size = (point.omega * momentum + frame.r_norm) * frame.energy_unit;
            let apart = (h - equilibrium.h).abs();
            if off(point.gamma) > AGREEMENT || apart > AGREEMENT * size || index != equilibrium.index {
                return Err(lost());
            }
            difference = difference.max(apart);
            equilibrium.omega = l.to_f64().signum() * point.omega * frame.frequency_unit;
            (equilibrium.h, equilibrium.gamma, equilibrium.index) = (h, frame.vector_to_body(point.gamma), index);
        }
        found.list = super::sorted(found.list);
        found.error_bound += difference;
        found.by_continuation = true;
        Ok(found)
    }

    /// The end of a curve at its smallest l.
    fn start(&self, id: CurveId) -> Option<Start> {
        let curve = &self.set.curves[id];
        let pair = if let Branch::Symmetric(axis) = curve.branch { Some(axis) } else { None };
        let from = |point: &Point, rising| {
            let Point { x, gamma, j, .. } = *point;
            Start { gamma, omega: (2.0 * x).sqrt() / j, pair, rising }
        };
        match curve.ends[0] {
            End::Origin => {
                let gamma = match &curve.arcs[0].shape {
                    Shape::Generic(segments) => self.set.frame.r_hat().map(|component| segments[0].sign * component),
                    Shape::Straight { gamma, .. } => *gamma,
                    Shape::Symmetric { .. } => return None,
                };
                Some(Start { gamma, omega: 0.0, pair, rising: None })
            }
            // The two curves of a cusp stand in the order of the branch's parameter.
            End::Cusp(number) => {
                let cusp = &self.set.cusps[number];
                Some(from(&cusp.point, Some(cusp.curves[1] == id)))
            }
            End::Pitchfork(number) => Some(from(&self.set.pitchforks[number].point, None)),
            End::Infinity => None,
        }
    }
}
