//! The further first integrals of integrable cases, along motions.

use bifdiag_body::{BodyAxis, Holds, IntegrableCase};

use super::heavy_top::{HeavyTop, State};
use super::{dot, norm};

/// The further integral of a case at a state. The top must belong to the case.
#[must_use]
pub fn further_integral(case: IntegrableCase, top: &HeavyTop, state: &State) -> f64 {
    let (gamma, l, r) = (state.gamma, state.l, top.center());
    let omega = top.inverse_inertia(l);
    match case {
        IntegrableCase::Euler => dot(l, l),
        IntegrableCase::Lagrange(Some(k)) => omega[k],
        IntegrableCase::Lagrange(None) | IntegrableCase::HessAppelrot => dot(l, r),
        IntegrableCase::Kovalevskaya(k) => {
            let ([i, j], a) = (k.others(), top.moments()[k]);
            let real = omega[i] * omega[i] - omega[j] * omega[j] + (r[i] * gamma[i] - r[j] * gamma[j]) / a;
            let imaginary = 2.0 * omega[i] * omega[j] + (r[i] * gamma[j] + r[j] * gamma[i]) / a;
            real * real + imaginary * imaginary
        }
        IntegrableCase::GoryachevChaplygin(k) => {
            let ([i, j], a) = (k.others(), top.moments()[k]);
            let across = |u: [f64; 3], v: [f64; 3]| u[i] * v[i] + u[j] * v[j];
            omega[k] * across(omega, omega) + across(r, omega) * gamma[k] / a
        }
    }
}

/// The size of the terms of a further integral: what its rounding is measured by.
#[must_use]
pub fn further_scale(case: IntegrableCase, top: &HeavyTop, state: &State) -> f64 {
    let (l, r) = (state.l, top.center());
    let omega = top.inverse_inertia(l);
    let across = |k: BodyAxis, u: [f64; 3]| {
        let [i, j] = k.others();
        (u[i] * u[i] + u[j] * u[j]).sqrt()
    };
    match case {
        IntegrableCase::Euler => dot(l, l),
        IntegrableCase::Lagrange(Some(_)) => norm(omega),
        IntegrableCase::Lagrange(None) | IntegrableCase::HessAppelrot => norm(l) * norm(r),
        IntegrableCase::Kovalevskaya(k) => {
            let across = across(k, omega);
            let modulus = across * across + norm(r) / top.moments()[k];
            modulus * modulus
        }
        IntegrableCase::GoryachevChaplygin(k) => {
            across(k, omega) * (omega[k].abs() * across(k, omega) + norm(r) / top.moments()[k])
        }
    }
}

/// Whether a motion from this state keeps the value of the integral, within rounding of the state.
#[must_use]
pub fn keeps_further_integral(case: IntegrableCase, top: &HeavyTop, state: &State) -> bool {
    /// Roundings of a product of vectors.
    const ROUNDING: f64 = 16.0 * f64::EPSILON;
    match case.holds() {
        Holds::Always => true,
        Holds::ZeroMomentum => dot(state.gamma, state.l).abs() <= ROUNDING * norm(state.gamma) * norm(state.l),
        Holds::WhereZero => further_integral(case, top, state).abs() <= ROUNDING * further_scale(case, top, state),
    }
}
