//! A step: its ends, and the motion between them as a polynomial.

use thiserror::Error;

use super::time::Instant;
use crate::field::{Dimension, State, Units};
use crate::integrator::product::product_sum;

/// The state or the step leaves the range of `f64`.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error("the motion leaves the range of double precision after time {time}")]
pub struct StepError {
    /// Time of the last finite state.
    pub time: f64,
}

impl StepError {
    /// That of a reduced top as that of the top as given.
    #[must_use]
    pub fn restored(self, units: Units) -> Self {
        Self { time: units.restore(self.time, Dimension::TIME) }
    }
}

/// One step of the integrator.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    start: Instant,
    length: f64,
    end_state: State,
    coefficients: Vec<State>,
}

impl Step {
    /// From the polynomial's coefficients, x ∈ [0, 1].
    pub(super) fn new(
        start: Instant,
        length: f64,
        end_state: State,
        coefficients: Vec<State>,
    ) -> Result<Self, StepError> {
        let finite = |state: &State| state.gamma.iter().chain(&state.l).all(|x| x.is_finite());
        if !finite(&end_state) || !coefficients.iter().all(finite) {
            return Err(StepError { time: start.seconds() });
        }
        Ok(Self { start, length, end_state, coefficients })
    }

    /// That of a reduced top as that of the top as given.
    #[must_use]
    pub(super) fn restored(mut self, units: Units) -> Self {
        self.start = self.start.restored(units);
        self.length = units.restore(self.length, Dimension::TIME);
        self.end_state = self.end_state.restored(units);
        for coefficient in &mut self.coefficients {
            *coefficient = coefficient.restored(units);
        }
        self
    }

    /// Time at the start.
    #[must_use]
    pub fn start(&self) -> Instant {
        self.start
    }

    /// Time from start to end.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.length
    }

    /// Time at the end.
    #[must_use]
    pub fn end(&self) -> Instant {
        self.start.after(self.length)
    }

    /// The state at the end, from which the next step starts.
    #[must_use]
    pub fn end_state(&self) -> &State {
        &self.end_state
    }

    /// Coefficients of γ(x) and l(x), x = (time − start)/length.
    #[must_use]
    pub fn coefficients(&self) -> &[State] {
        &self.coefficients
    }

    /// The state at x ∈ [0, 1].
    #[must_use]
    pub fn state(&self, x: f64) -> State {
        let mut state = State::default();
        for coefficient in self.coefficients.iter().rev() {
            for i in 0..3 {
                state.gamma[i] = product_sum(state.gamma[i], x, coefficient.gamma[i]);
                state.l[i] = product_sum(state.l[i], x, coefficient.l[i]);
            }
        }
        state
    }
}
