//! The two states over a point of the Poisson sphere.

use super::super::condition::SectionCondition;
use super::super::torus::{PpTorus, TorusPoint};
use crate::field::{State, add, dot, scale};

/// The states with Δ < 0 and Δ > 0 over γ(ϑ', ψ'); `None` where there are none.
pub(super) fn states(
    torus: &PpTorus,
    condition: SectionCondition,
    (h, l): (f64, f64),
    [psi, theta]: [f64; 2],
) -> Option<[State; 2]> {
    match condition {
        SectionCondition::Height => {
            let state = |sheet| torus.state(TorusPoint { theta, psi, sheet }, h, l).ok();
            Some([state(-1)?, state(1)?])
        }
        SectionCondition::AngularMomentum => {
            // S = ⟨l, γ×r⟩ = 0 and ⟨γ, l⟩ = l: l = lγ + t e with e = ∂γ/∂ϑ'; H = h is a quadratic equation for t.
            let [e_x, e_y, r_hat] = torus.axes();
            let ((sin_psi, cos_psi), (sin, cos)) = (libm::sincos(psi), libm::sincos(theta));
            let equator = add(scale(sin_psi, e_x), scale(cos_psi, e_y));
            let gamma = add(scale(sin, equator), scale(cos, r_hat));
            let e = add(scale(cos, equator), scale(-sin, r_hat));
            let top = torus.top();
            let (weighted_e, weighted_gamma) = (top.inverse_inertia(e), top.inverse_inertia(gamma));
            let a = dot(e, weighted_e);
            let b = l * dot(gamma, weighted_e);
            let c = l * l * dot(gamma, weighted_gamma) - 2.0 * (h + dot(gamma, top.center()));
            let discriminant = b * b - a * c;
            if discriminant.is_nan() || discriminant < 0.0 {
                return None;
            }
            // Δ = ⟨ω, e⟩ |r| sin ϑ' = ∂H/∂t |r| sin ϑ' has the sign of the root.
            let root = discriminant.sqrt();
            let state = |t: f64| State { gamma, l: add(scale(l, gamma), scale(t / a, e)) };
            Some([state(-b - root), state(-b + root)])
        }
    }
}
