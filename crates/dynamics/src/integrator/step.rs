//! A step: its ends, and the motion between them as a polynomial; times that do not lose digits late in a run.

use thiserror::Error;

use crate::field::{Dimension, State, TopUnits};
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
    pub fn restored(self, units: TopUnits) -> Self {
        Self { time: units.restore(self.time, Dimension::TIME) }
    }
}

/// One step of the integrator.
#[derive(Clone, Debug, PartialEq)]
pub struct TaylorStep {
    start: Instant,
    length: f64,
    end_state: State,
    coefficients: Vec<State>,
}

impl TaylorStep {
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
    pub(super) fn restored(mut self, units: TopUnits) -> Self {
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

/// s + e = a + b exactly, s the rounded sum (Knuth's TwoSum).
#[inline]
pub(crate) fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let b_part = sum - a;
    let a_part = sum - b_part;
    (sum, (a - a_part) + (b - b_part))
}

/// A time as the unevaluated sum of the nearest double and a remainder.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Instant {
    high: f64,
    low: f64,
}

impl Instant {
    /// high + low, normalised.
    #[must_use]
    #[inline]
    pub fn new(high: f64, low: f64) -> Self {
        let (high, low) = two_sum(high, low);
        Self { high, low }
    }

    /// This time plus an offset.
    #[must_use]
    #[inline]
    pub fn after(self, offset: f64) -> Self {
        let (sum, error) = two_sum(self.high, offset);
        Self::new(sum, error + self.low)
    }

    /// That of a reduced top as that of the top as given.
    #[must_use]
    pub fn restored(self, units: TopUnits) -> Self {
        let given = |time| units.restore(time, Dimension::TIME);
        Self { high: given(self.high), low: given(self.low) }
    }

    /// The nearest double.
    #[must_use]
    #[inline]
    pub fn seconds(self) -> f64 {
        self.high
    }

    /// What [`seconds`](Self::seconds) leaves out.
    #[must_use]
    #[inline]
    pub fn remainder(self) -> f64 {
        self.low
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_million_small_steps_keep_every_digit() {
        let mut t = Instant::default();
        for _ in 0..1_000_000 {
            t = t.after(0.1);
        }
        // The double 0.1 exceeds one tenth by 5.551115123125783e-18.
        assert_eq!(t.seconds(), 100_000.0);
        assert!((t.remainder() - 5.551_115_123_125_783e-12).abs() < 1e-24);
    }
}
