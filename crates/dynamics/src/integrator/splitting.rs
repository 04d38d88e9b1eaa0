//! A splitting method: every substep is the exact flow of a part of H under the same Poisson bracket.
//!
//! H = l₁²/2A₁ + l₂²/2A₂ + l₃²/2A₃ − ⟨γ,r⟩. The flow of lᵢ²/2Aᵢ turns γ and l about axis i by −(lᵢ/Aᵢ)t, that of
//! −⟨γ,r⟩ adds −t γ×r to l (Proposition 12.3 of docs/mathematics.md). All of them keep ⟨γ,γ⟩ and ⟨γ,l⟩, so that their
//! composition does, to rounding.

use super::step::{Step, StepError, Stepper};
use super::time::Instant;
use crate::field::{HeavyTop, State, cross, scale, sub};

/// Suzuki's composition of five symmetric steps, of order 4: p, p, 1 − 4p, p, p with p = 1/(4 − 4^{1/3}).
const OUTER: f64 = 0.414_490_771_794_375_7;
const INNER: f64 = 1.0 - 4.0 * OUTER;
/// Order of the series inside a step: (step/radius of convergence)¹² is far below the method's own error.
const SERIES_ORDER: usize = 12;

/// The splitting method of order 4 with a fixed step.
#[derive(Clone, Debug)]
pub struct Splitting {
    top: HeavyTop,
    state: State,
    time: Instant,
    length: f64,
}

impl Splitting {
    /// Starts at a state and time 0.
    #[must_use]
    pub fn new(top: &HeavyTop, start: &State, length: f64) -> Self {
        Self { top: *top, state: *start, time: Instant::default(), length }
    }

    /// Strang's symmetric composition, of order 2.
    fn symmetric(&self, state: &mut State, t: f64) {
        let half = 0.5 * t;
        self.fall(state, half);
        self.turn(state, 0, half);
        self.turn(state, 1, half);
        self.turn(state, 2, t);
        self.turn(state, 1, half);
        self.turn(state, 0, half);
        self.fall(state, half);
    }

    /// The flow of −⟨γ,r⟩.
    fn fall(&self, state: &mut State, t: f64) {
        state.l = sub(state.l, scale(t, cross(state.gamma, self.top.center())));
    }

    /// The flow of l_axis²/2A_axis: γ̇ = γ×ω, l̇ = l×ω with ω constant along the axis.
    fn turn(&self, state: &mut State, axis: usize, t: f64) {
        let (p, q) = ((axis + 1) % 3, (axis + 2) % 3);
        let angle = state.l[axis] * self.top.inverse_moments()[axis] * t;
        let (sin, half) = (libm::sin(angle), libm::sin(0.5 * angle));
        // Increments, with cos − 1 = −2 sin²(angle/2): a rounded cosine would stretch a steady rotation a little by
        // the same factor in every step.
        let cos_less_1 = -2.0 * half * half;
        for v in [&mut state.gamma, &mut state.l] {
            let (x, y) = (v[p], v[q]);
            v[p] = x + cos_less_1.mul_add(x, sin * y);
            v[q] = y + cos_less_1.mul_add(y, -sin * x);
        }
    }
}

impl Stepper for Splitting {
    fn step(&mut self) -> Result<Step, StepError> {
        let mut next = self.state;
        for part in [OUTER, OUTER, INNER, OUTER, OUTER] {
            self.symmetric(&mut next, part * self.length);
        }
        let step = Step::expanded(&self.top, self.time, self.length, [&self.state, &next], SERIES_ORDER)?;
        self.time = step.end();
        self.state = next;
        Ok(step)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::field::Integrals;

    #[test]
    fn casimirs_stay_at_rounding_and_the_energy_bounded() {
        let top = HeavyTop::from_f64([2.0, 1.1, 1.0], [0.94868, 0.0, 0.61623]);
        let start = State { gamma: [0.6, 0.0, 0.8], l: [2.0, 1.0, 2.5] };
        let first = Integrals::of(&top, &start);
        let mut splitting = Splitting::new(&top, &start, 0.02);
        let mut worst = Integrals::default();
        for _ in 0..20_000 {
            let step = splitting.step().unwrap();
            worst = worst.max(&Integrals::of(&top, step.end_state()).distance(&first));
        }
        // 20,000 steps of 35 substeps: a random walk of 840 roundings.
        assert!(worst.gamma_squared < 5e-13 && worst.vertical_momentum < 2e-12, "{worst:?}");
        assert!(worst.energy < 1e-5 && worst.energy > 1e-12, "{worst:?}");
    }
}
