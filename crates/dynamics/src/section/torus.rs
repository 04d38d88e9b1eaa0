//! The PP-torus: (ϑ', ψ') with r̂ as polar axis, two sheets T⁺ and T⁻ by the sign of Δ, and the map γ → l
//! (Proposition 10.2 to Proposition 10.5 of docs/mathematics.md).

use pulp::Scalar;

use super::angle::angle;
use super::error::SectionError;
use crate::field::{Dimension, HeavyTop, State, add, cross, dot, norm, scale, sub, unit};

/// A point of the PP-torus.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TorusPoint {
    /// ϑ' ∈ [0, π], the angle between γ and r̂.
    pub theta: f64,
    /// ψ' ∈ [0, 2π), from e_y' towards e_x'.
    pub psi: f64,
    /// +1 on T⁺ (Δ > 0), −1 on T⁻.
    pub sheet: i8,
}

/// The torus of one top: γ = sinϑ'(sinψ' e_x' + cosψ' e_y') + cosϑ' r̂.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PpTorus {
    top: HeavyTop,
    r_hat: [f64; 3],
    e_x: [f64; 3],
    e_y: [f64; 3],
}

impl PpTorus {
    /// e_y' is the normalised projection of e₃ onto the plane ⊥ r̂ (of e₂ if r̂ ∥ e₃).
    ///
    /// # Errors
    /// [`SectionError::WeightlessBody`] when r = 0.
    pub fn new(top: &HeavyTop) -> Result<Self, SectionError> {
        let r_hat = top.r_hat().ok_or(SectionError::WeightlessBody)?;
        let axis = if r_hat[0] == 0.0 && r_hat[1] == 0.0 { [0.0, 1.0, 0.0] } else { [0.0, 0.0, 1.0] };
        // r̂×(e×r̂) = e − r̂⟨e,r̂⟩ without its cancellation.
        let e_y = unit(cross(r_hat, cross(axis, r_hat)));
        Ok(Self { top: *top, r_hat, e_x: cross(e_y, r_hat), e_y })
    }

    /// The top.
    #[must_use]
    pub fn top(&self) -> &HeavyTop {
        &self.top
    }

    /// The torus of the same top in its own units.
    pub(super) fn reduced(&self) -> Self {
        Self { top: self.top.reduced(), ..*self }
    }

    /// (e_x', e_y', r̂), right-handed.
    #[must_use]
    pub fn axes(&self) -> [[f64; 3]; 3] {
        [self.e_x, self.e_y, self.r_hat]
    }

    /// The unit vector sinψ' e_x' + cosψ' e_y'.
    fn equator(&self, psi: f64) -> [f64; 3] {
        let (sin, cos) = libm::sincos(psi);
        add(scale(sin, self.e_x), scale(cos, self.e_y))
    }

    /// γ(ϑ', ψ').
    #[must_use]
    pub fn gamma(&self, theta: f64, psi: f64) -> [f64; 3] {
        let (sin, cos) = libm::sincos(theta);
        let gamma = add(scale(sin, self.equator(psi)), scale(cos, self.r_hat));
        scale(1.0 / norm(gamma), gamma)
    }

    /// (ϑ', ψ') of γ; ψ' of a pole is 0.
    #[must_use]
    pub fn angles(&self, gamma: [f64; 3]) -> (f64, f64) {
        let (x, y) = (dot(gamma, self.e_x), dot(gamma, self.e_y));
        let theta = angle(Scalar::new(), (x * x + y * y).sqrt(), dot(gamma, self.r_hat));
        (theta, positive_angle(angle(Scalar::new(), x, y)))
    }

    /// The point of a state on the section. On a polar circle, where Δ = 0, it is the one on T⁺.
    #[must_use]
    pub fn point(&self, state: &State) -> TorusPoint {
        let (theta, psi) = self.angles(state.gamma);
        let (torus, state) = (self.reduced(), state.reduced(self.top.units()));
        torus.on_sheet(&state, torus.delta(&state), theta, psi)
    }

    /// Likewise with Δ and the angles of γ.
    #[inline(always)]
    pub(super) fn on_sheet(&self, state: &State, delta: f64, theta: f64, psi: f64) -> TorusPoint {
        if delta != 0.0 || cross(state.gamma, self.r_hat) != [0.0; 3] {
            return TorusPoint { theta, psi, sheet: if delta < 0.0 { -1 } else { 1 } };
        }
        TorusPoint { theta, psi: self.polar_angle(state), sheet: 1 }
    }

    /// Δ = ⟨ω×γ, A⁻¹(γ×r)⟩ (Eq. Delta).
    #[must_use]
    #[inline(always)]
    pub fn delta(&self, state: &State) -> f64 {
        let omega = self.top.angular_velocity(state.l);
        dot(cross(omega, state.gamma), self.top.angular_velocity(cross(state.gamma, self.top.center())))
    }

    /// ψ' on T⁺ of a state on a polar circle: the inverse of the limit in [`state`](Self::state).
    fn polar_angle(&self, state: &State) -> f64 {
        let gamma = state.gamma;
        let inertia_gamma = self.top.inertia(gamma);
        let j = dot(gamma, inertia_gamma);
        let v = sub(state.l, scale(dot(state.l, gamma) / j, inertia_gamma));
        // v = u×γ and ⟨γ, Au⟩ = 0 give u; Au ∝ r̂×τ gives the direction τ.
        let turned = cross(gamma, v);
        let u = sub(turned, scale(dot(gamma, self.top.inertia(turned)) / j, gamma));
        let tau = cross(self.top.inertia(u), self.r_hat);
        positive_angle(angle(Scalar::new(), dot(tau, self.e_x), dot(tau, self.e_y)))
    }

    /// The state over a point of the torus at (h, l), Eq. lofgamma: l = l Aγ/J ± v √(2(h−U)/⟨v,A⁻¹v⟩), + on T⁺.
    ///
    /// v depends on the direction of r×γ only, so that the polar circles, where r×γ = 0, are no exception.
    ///
    /// # Errors
    /// [`SectionError::SeedInaccessible`] when U_l(γ) > h; [`SectionError::Parameter`] for angles that are not
    /// finite.
    pub fn state(&self, point: TorusPoint, h: f64, l: f64) -> Result<State, SectionError> {
        for (name, value) in [("theta", point.theta), ("psi", point.psi)] {
            if !value.is_finite() {
                return Err(SectionError::Parameter { name, value, expected: "an angle in radians is needed" });
            }
        }
        if self.top.units().are_one() { self.plain_state(point, h, l) } else { self.extreme_state(point, h, l) }
    }

    #[cold]
    fn extreme_state(&self, point: TorusPoint, h: f64, l: f64) -> Result<State, SectionError> {
        let units = self.top.units();
        let (reduced_h, reduced_l) = (units.reduce(h, Dimension::ENERGY), units.reduce(l, Dimension::MOMENTUM));
        match self.reduced().plain_state(point, reduced_h, reduced_l) {
            Ok(state) => Ok(state.restored(units)),
            Err(SectionError::SeedInaccessible { theta, psi, potential, .. }) => {
                let potential = units.restore(potential, Dimension::ENERGY);
                Err(SectionError::SeedInaccessible { theta, psi, potential, h })
            }
            Err(error) => Err(error),
        }
    }

    #[inline]
    fn plain_state(&self, point: TorusPoint, h: f64, l: f64) -> Result<State, SectionError> {
        let gamma = self.gamma(point.theta, point.psi);
        let potential = self.top.effective_potential(gamma, l);
        if potential.is_nan() || potential > h {
            return Err(SectionError::SeedInaccessible { theta: point.theta, psi: point.psi, potential, h });
        }
        let inertia_gamma = self.top.inertia(gamma);
        let u = self.top.inverse_inertia(cross(self.r_hat, self.equator(point.psi)));
        let v = cross(u, gamma);
        let length = (2.0 * (h - potential) / dot(v, self.top.inverse_inertia(v))).sqrt();
        let signed = if point.sheet < 0 { -length } else { length };
        let momentum = add(scale(l / dot(gamma, inertia_gamma), inertia_gamma), scale(signed, v));
        Ok(State { gamma, l: momentum })
    }
}

/// An angle of atan2 brought to [0, 2π).
pub(super) fn positive_angle(angle: f64) -> f64 {
    if angle >= 0.0 {
        return angle;
    }
    let turned = angle + std::f64::consts::TAU;
    if turned < std::f64::consts::TAU { turned } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::section::SectionCondition;
    use std::f64::consts::PI;

    fn paper() -> PpTorus {
        PpTorus::new(&HeavyTop::from_f64([2.0, 1.1, 1.0], [0.94868, 0.0, 0.61623])).unwrap()
    }

    #[test]
    fn states_lie_on_the_section_and_on_their_sheet() {
        let torus = paper();
        let (h, l) = (6.5, 3.25);
        for k in 0..200 {
            let point = TorusPoint {
                theta: 0.01 + 3.12 * f64::from(k) / 200.0,
                psi: f64::from(k * 37 % 200) / 200.0 * 6.2,
                sheet: if k % 2 == 0 { 1 } else { -1 },
            };
            let state = torus.state(point, h, l).unwrap();
            assert!((torus.top.energy(&state) - h).abs() < 1e-14 * 20.0);
            assert!((dot(state.gamma, state.l) - l).abs() < 1e-14 * 10.0);
            assert!(SectionCondition::Height.value(&torus.top, &state).abs() < 1e-14 * 5.0);
            let back = torus.point(&state);
            assert_eq!(back.sheet, point.sheet);
            assert!((back.theta - point.theta).abs() < 1e-14 && (back.psi - point.psi).abs() < 1e-12);
        }
    }

    #[test]
    fn polar_circles_are_glued_with_a_shift_of_pi() {
        let torus = paper();
        for theta in [0.0, PI] {
            for k in 0..12 {
                let psi = 0.1 + 0.5 * f64::from(k);
                let plus = torus.state(TorusPoint { theta, psi, sheet: 1 }, 6.5, 3.25).unwrap();
                let minus = torus.state(TorusPoint { theta, psi: psi + PI, sheet: -1 }, 6.5, 3.25).unwrap();
                let near = TorusPoint { theta: if theta == 0.0 { 1e-9 } else { PI - 1e-9 }, psi, sheet: 1 };
                let near = torus.state(near, 6.5, 3.25).unwrap();
                for i in 0..3 {
                    assert!((plus.l[i] - minus.l[i]).abs() < 1e-14 * 10.0);
                    assert!((plus.l[i] - near.l[i]).abs() < 1e-7, "continuous at the pole");
                }
                assert!((torus.polar_angle(&plus) - psi).abs() < 1e-13);
            }
        }
    }

    #[test]
    fn holes_of_the_printed_figure_lie_where_they_are_printed() {
        // Fig. Projections12: the two inaccessible holes are at (π/2, 0) and (π/2, π).
        let torus = PpTorus::new(&HeavyTop::from_f64([2.0, 1.5, 1.0], [1.0, 0.0, 0.0])).unwrap();
        for psi in [0.0, PI] {
            let refused = torus.state(TorusPoint { theta: PI / 2.0, psi, sheet: 1 }, 80.5, 12.80);
            assert!(matches!(refused, Err(SectionError::SeedInaccessible { .. })), "{refused:?}");
        }
        assert!(torus.state(TorusPoint { theta: PI / 2.0, psi: PI / 2.0, sheet: 1 }, 80.5, 12.80).is_ok());
    }

    #[test]
    fn a_weightless_body_has_no_torus() {
        assert_eq!(PpTorus::new(&HeavyTop::from_f64([2.0, 1.0, 1.0], [0.0; 3])), Err(SectionError::WeightlessBody));
    }
}
