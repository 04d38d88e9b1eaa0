//! The equations of curves on P_hl, in phase space, where neither ∂U nor a pole is an exception.

use super::linear::{N, PhaseVector, along, length, null_vector, solve};
use crate::field::{HeavyTop, State, add, cross, dot, sub};
use crate::section::SectionCondition;

/// Iterations of Newton's method.
const ITERATIONS: usize = 12;
/// A correction that is rounding.
const CONVERGED: f64 = 1e-13;
/// Newton's method that starts farther away than this has left its curve.
const REACH: f64 = 0.5;

/// Which curve on P_hl.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Zero {
    /// Ṡ = 0: orbits touch the section.
    Tangency,
    /// Δ = 0: the two sheets meet, over ∂U.
    Sheets,
}

/// P_hl as the zeros of (|γ|² − 1)/2, ⟨γ,l⟩ − l, H − h and S in the coordinates (γ, l/λ), λ = max |l| on H = h.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct SectionEquations {
    pub top: HeavyTop,
    pub condition: SectionCondition,
    pub h: f64,
    pub l: f64,
    lambda: f64,
}

impl SectionEquations {
    pub fn new(top: HeavyTop, condition: SectionCondition, h: f64, l: f64) -> Self {
        Self { top, condition, h, l, lambda: top.momentum_scale(h) }
    }

    pub fn vector(&self, state: &State) -> PhaseVector {
        let ([a, b, c], [d, e, f]) = (state.gamma, state.l.map(|l| l / self.lambda));
        [a, b, c, d, e, f]
    }

    pub fn state(&self, x: &PhaseVector) -> State {
        let [a, b, c, d, e, f] = *x;
        State { gamma: [a, b, c], l: [d, e, f].map(|l| l * self.lambda) }
    }

    /// det ∂(H, L_z, S)/∂l up to its sign: Eq. Delta, and its counterpart ⟨ω×γ, γ×r⟩ for S = ⟨l, γ×r⟩.
    pub fn delta(&self, state: &State) -> f64 {
        let omega = self.top.angular_velocity(state.l);
        dot(cross(omega, state.gamma), self.weighted(cross(state.gamma, self.top.center())))
    }

    /// ∂S/∂l of a vector γ×r.
    fn weighted(&self, u: [f64; 3]) -> [f64; 3] {
        match self.condition {
            SectionCondition::Height => self.top.angular_velocity(u),
            SectionCondition::AngularMomentum => u,
        }
    }

    /// Ṡ.
    pub fn rate(&self, state: &State) -> f64 {
        self.condition.rate(&self.top, state)
    }

    fn zero(&self, zero: Zero, state: &State) -> f64 {
        match zero {
            Zero::Tangency => self.rate(state),
            Zero::Sheets => self.delta(state),
        }
    }

    fn values(&self, state: &State) -> [f64; 4] {
        let (gamma, l) = (state.gamma, state.l);
        [
            0.5 * (dot(gamma, gamma) - 1.0),
            dot(gamma, l) - self.l,
            self.top.energy(state) - self.h,
            self.condition.value(&self.top, state),
        ]
    }

    /// The derivative of `values` in a direction.
    fn values_along(&self, state: &State, d: &State) -> [f64; 4] {
        let (gamma, l, r) = (state.gamma, state.l, self.top.center());
        let omega = self.top.angular_velocity(l);
        let section = match self.condition {
            SectionCondition::Height => {
                dot(self.top.angular_velocity(d.l), cross(r, gamma)) + dot(omega, cross(r, d.gamma))
            }
            SectionCondition::AngularMomentum => dot(d.l, cross(gamma, r)) + dot(l, cross(d.gamma, r)),
        };
        [dot(gamma, d.gamma), dot(gamma, d.l) + dot(d.gamma, l), dot(omega, d.l) - dot(d.gamma, r), section]
    }

    fn zero_along(&self, zero: Zero, state: &State, d: &State) -> f64 {
        let (gamma, r) = (state.gamma, self.top.center());
        let (omega, d_omega) = (self.top.angular_velocity(state.l), self.top.angular_velocity(d.l));
        match zero {
            Zero::Sheets => {
                let turned = add(cross(d_omega, gamma), cross(omega, d.gamma));
                dot(turned, self.weighted(cross(gamma, r))) + dot(cross(omega, gamma), self.weighted(cross(d.gamma, r)))
            }
            Zero::Tangency => {
                let field = self.top.vector_field(state);
                let d_field = State {
                    gamma: add(cross(d.gamma, omega), cross(gamma, d_omega)),
                    l: sub(add(cross(d.l, omega), cross(state.l, d_omega)), cross(d.gamma, r)),
                };
                match self.condition {
                    SectionCondition::Height => {
                        dot(self.top.angular_velocity(d_field.l), cross(r, gamma))
                            + dot(self.top.angular_velocity(field.l), cross(r, d.gamma))
                            + dot(d_omega, cross(r, field.gamma))
                            + dot(omega, cross(r, d_field.gamma))
                    }
                    SectionCondition::AngularMomentum => {
                        dot(d_field.l, cross(gamma, r))
                            + dot(field.l, cross(d.gamma, r))
                            + dot(d.l, cross(field.gamma, r))
                            + dot(state.l, cross(d_field.gamma, r))
                    }
                }
            }
        }
    }

    /// The six directions of the coordinates.
    fn directions(&self) -> [State; N] {
        std::array::from_fn(|i| {
            let mut unit = [0.0; N];
            unit[i] = 1.0;
            self.state(&unit)
        })
    }

    fn jacobian(&self, zero: Zero, state: &State) -> [PhaseVector; N - 1] {
        let directions = self.directions();
        let columns = directions.map(|d| self.values_along(state, &d));
        let mut rows = [[0.0; N]; N - 1];
        for i in 0..N - 2 {
            rows[i] = columns.map(|column| column[i]);
        }
        rows[N - 2] = directions.map(|d| self.zero_along(zero, state, &d));
        rows
    }

    /// The unit tangent of a curve, up to its sign; `None` at a singular point.
    pub fn tangent(&self, zero: Zero, x: &PhaseVector) -> Option<PhaseVector> {
        null_vector(&self.jacobian(zero, &self.state(x)))
    }

    /// The point of a curve next to `guess` in the plane ⊥ `normal` through it; `None` if Newton's method does not
    /// converge or goes far away.
    pub fn correct(&self, zero: Zero, guess: &PhaseVector, normal: &PhaseVector) -> Option<PhaseVector> {
        self.newton(guess, |state| {
            let [a, b, c, d, e] = self.jacobian(zero, state);
            let [p, q, r, s] = self.values(state);
            ([a, b, c, d, e, *normal], [p, q, r, s, self.zero(zero, state), 0.0])
        })
    }

    /// The common point of both curves next to `guess`.
    pub fn meeting(&self, guess: &PhaseVector) -> Option<PhaseVector> {
        self.newton(guess, |state| {
            let [a, b, c, d, e] = self.jacobian(Zero::Sheets, state);
            let tangency = self.directions().map(|d| self.zero_along(Zero::Tangency, state, &d));
            let [p, q, r, s] = self.values(state);
            ([a, b, c, d, e, tangency], [p, q, r, s, self.delta(state), self.rate(state)])
        })
    }

    /// The point of a curve next to `guess`.
    pub fn polish(&self, zero: Zero, guess: &PhaseVector) -> Option<PhaseVector> {
        let normal = self.tangent(zero, guess)?;
        self.correct(zero, guess, &normal)
    }

    fn newton(
        &self,
        guess: &PhaseVector,
        system: impl Fn(&State) -> ([PhaseVector; N], PhaseVector),
    ) -> Option<PhaseVector> {
        let mut x = *guess;
        let mut previous = f64::INFINITY;
        for _ in 0..ITERATIONS {
            let (rows, values) = system(&self.state(&x));
            let step = solve(rows, values)?;
            let size = length(&step);
            x = along(&x, -1.0, &step);
            if size.is_nan() || length(&along(&x, -1.0, guess)) > REACH {
                return None;
            }
            // At rounding level, or no longer shrinking there.
            if size < CONVERGED || (size < 1e-9 && size >= 0.5 * previous) {
                return Some(x);
            }
            previous = size;
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn derivatives_are_difference_quotients() {
        let top = HeavyTop::from_f64([2.0, 1.1, 1.0], [0.94868, 0.2, 0.61623]);
        let state = State { gamma: [0.3, -0.5, 0.7], l: [1.2, -0.4, 2.1] };
        for condition in [SectionCondition::Height, SectionCondition::AngularMomentum] {
            let equations = SectionEquations::new(top, condition, 4.45, 3.25);
            let x = equations.vector(&state);
            for zero in [Zero::Tangency, Zero::Sheets] {
                let rows = equations.jacobian(zero, &state);
                for i in 0..N {
                    let step = 1e-6;
                    let at = |sign: f64| {
                        let mut moved = x;
                        moved[i] += sign * step;
                        let state = equations.state(&moved);
                        let [a, b, c, d] = equations.values(&state);
                        [a, b, c, d, equations.zero(zero, &state)]
                    };
                    let (above, below) = (at(1.0), at(-1.0));
                    for k in 0..N - 1 {
                        let quotient = (above[k] - below[k]) / (2.0 * step);
                        assert!((rows[k][i] - quotient).abs() < 1e-7, "{condition:?} {zero:?} {k} {i}");
                    }
                }
            }
        }
    }
}
