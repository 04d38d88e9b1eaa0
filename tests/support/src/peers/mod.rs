//! Other methods of integration, by which tests and measurements judge the program's Taylor series.
//!
//! - [`Method::Dop853`]: Dormand and Prince's method of order 8 with adaptive step.
//! - [`Method::RungeKutta4`]: the classical method of order 4 with a fixed step.
//! - [`Method::Splitting`]: a composition of exact flows of order 4 with a fixed step; ⟨γ,γ⟩ and ⟨γ,l⟩ to rounding.
//!
//! They share nothing with the Taylor series but the vector field. Crossings of a section are seen by the sign of S at the
//! ends of each step and found by Newton's method with shorter steps of the same method.

mod dop853;
mod runge_kutta;
mod splitting;

use std::collections::VecDeque;

use bifdiag_dynamics::field::{HeavyTop, Integrals, State};
use bifdiag_dynamics::integrator::Instant;
use bifdiag_dynamics::section::SectionCondition;

/// Newton steps to a crossing: each doubles the digits of a first guess that has at least one.
const NEWTON: usize = 8;

/// Which method, and how fine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Method {
    /// Dormand–Prince 8(5,3).
    Dop853 {
        /// Relative and absolute tolerance.
        tolerance: f64,
    },
    /// Runge–Kutta 4.
    RungeKutta4 {
        /// Length of a step.
        step: f64,
    },
    /// Splitting into exact Poisson flows.
    Splitting {
        /// Length of a step.
        step: f64,
    },
}

/// A crossing of the section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// Time since the start.
    pub time: Instant,
    /// The state.
    pub state: State,
}

/// The crossings of one orbit.
#[derive(Clone, Debug, PartialEq)]
pub struct Crossings {
    /// In the order of time; the start is none.
    pub found: Vec<Crossing>,
    /// Steps of the method.
    pub steps: u64,
    /// The largest |deviation| of each first integral from its value at the start, over the crossings.
    pub drift: Integrals,
}

impl Method {
    /// The next steps from a state, at least one: lengths and states at their ends.
    fn steps(self, top: &HeavyTop, state: &State) -> VecDeque<(f64, State)> {
        match self {
            Self::Dop853 { tolerance } => dop853::steps(top, state, dop853::stretch(top, state), tolerance),
            Self::RungeKutta4 { step } => VecDeque::from([(step, runge_kutta::step(top, state, step))]),
            Self::Splitting { step } => VecDeque::from([(step, splitting::step(top, state, step))]),
        }
    }

    /// The state after a time no longer than a step.
    fn within_step(self, top: &HeavyTop, state: &State, time: f64) -> State {
        match self {
            Self::Dop853 { tolerance } => {
                dop853::steps(top, state, time, tolerance).back().map_or(*state, |(_, end)| *end)
            }
            Self::RungeKutta4 { .. } => runge_kutta::step(top, state, time),
            Self::Splitting { .. } => splitting::step(top, state, time),
        }
    }

    /// The state after a time.
    #[must_use]
    pub fn state_after(self, top: &HeavyTop, start: &State, time: f64) -> State {
        let (mut state, mut now) = (*start, Instant::default());
        loop {
            for (length, next) in self.steps(top, &state) {
                let left = (time - now.seconds()) - now.remainder();
                if left <= length {
                    return self.within_step(top, &state, left);
                }
                (state, now) = (next, now.after(length));
            }
        }
    }

    /// The first crossings of an orbit that starts on the section or beside it.
    #[must_use]
    pub fn crossings(self, top: &HeavyTop, start: &State, condition: SectionCondition, count: usize) -> Crossings {
        let integrals = Integrals::of(top, start);
        let mut orbit = Crossings { found: Vec::with_capacity(count), steps: 0, drift: Integrals::default() };
        let (mut state, mut now) = (*start, Instant::default());
        // Just after a start on the section, S has the sign of Ṡ.
        let value = condition.value(top, start);
        let on_section = value.abs() <= 1e-12 * condition.scale(top, integrals.energy);
        let mut positive = if on_section { condition.rate(top, start) > 0.0 } else { value > 0.0 };
        loop {
            for (length, next) in self.steps(top, &state) {
                orbit.steps += 1;
                let after = condition.value(top, &next) > 0.0;
                if after != positive {
                    let crossing = self.crossing(top, &state, now, length, condition);
                    orbit.drift = orbit.drift.max(&Integrals::of(top, &crossing.state).distance(&integrals));
                    orbit.found.push(crossing);
                    if orbit.found.len() == count {
                        return orbit;
                    }
                }
                (state, now, positive) = (next, now.after(length), after);
            }
        }
    }

    /// The crossing in a step, from where a chord of S meets zero.
    fn crossing(
        self,
        top: &HeavyTop,
        state: &State,
        now: Instant,
        length: f64,
        condition: SectionCondition,
    ) -> Crossing {
        let [start, end] = [*state, self.within_step(top, state, length)].map(|state| condition.value(top, &state));
        let mut time = length * (start / (start - end)).clamp(0.0, 1.0);
        let mut at = self.within_step(top, state, time);
        for _ in 0..NEWTON {
            let change = condition.value(top, &at) / condition.rate(top, &at);
            let next = (time - change).clamp(0.0, length);
            if next == time {
                break;
            }
            time = next;
            at = self.within_step(top, state, time);
        }
        Crossing { time: now.after(time), state: at }
    }
}
