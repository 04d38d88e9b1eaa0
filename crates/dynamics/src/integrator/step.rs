//! A step: its ends, and the motion between them as a polynomial.

use thiserror::Error;

use super::time::Instant;
use crate::field::{Dimension, HeavyTop, State, Units, scale};
use crate::integrator::product::product_sum;

/// Why a step could not be made.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum StepError {
    /// The state or the step is no longer a number.
    #[error("the motion is no longer finite after time {time}")]
    NotFinite {
        /// Time of the last finite state.
        time: f64,
    },
    /// The step became too small to move on.
    #[error("the step size underflows at time {time}")]
    Underflow {
        /// Time at which it does.
        time: f64,
    },
    /// DOP853's own limit.
    #[error("more than {steps} steps would be needed at time {time}")]
    TooManySteps {
        /// Time that was reached.
        time: f64,
        /// The limit.
        steps: u32,
    },
    /// DOP853's stiffness test.
    #[error("the motion seems to become stiff at time {time}")]
    Stiff {
        /// Time at which it does.
        time: f64,
    },
}

impl StepError {
    /// That of a reduced top as that of the top as given.
    #[must_use]
    pub fn restored(self, units: Units) -> Self {
        let given = |time| units.restore(time, Dimension::TIME);
        match self {
            Self::NotFinite { time } => Self::NotFinite { time: given(time) },
            Self::Underflow { time } => Self::Underflow { time: given(time) },
            Self::TooManySteps { time, steps } => Self::TooManySteps { time: given(time), steps },
            Self::Stiff { time } => Self::Stiff { time: given(time) },
        }
    }
}

/// An integrator under way.
pub trait Stepper {
    /// Makes one step.
    ///
    /// # Errors
    /// [`StepError`]; the stepper is of no use afterwards.
    fn step(&mut self) -> Result<Step, StepError>;
}

/// One step of an integrator.
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
            return Err(StepError::NotFinite { time: start.seconds() });
        }
        Ok(Self { start, length, end_state, coefficients })
    }

    /// Of a method whose steps are short: the Taylor series of the exact flow through the start.
    ///
    /// Inside the step the first integrals are then what they are at its start; the series misses `end_state` by
    /// the method's own local error.
    pub(super) fn expanded(
        top: &HeavyTop,
        start: Instant,
        length: f64,
        [start_state, end_state]: [&State; 2],
        order: usize,
    ) -> Result<Self, StepError> {
        Self::new(start, length, *end_state, scaled_series(top, start_state, length, order))
    }

    /// Of a method whose steps are long: Hermite interpolation of the derivatives up to `smoothness` at both ends.
    ///
    /// The vector field is quadratic, so that the derivatives are cheap, and the interpolation error
    /// O(length^(2·smoothness+2)) can be made smaller than that of any one-step method. (`ode_solvers` hands out
    /// states at given times only, no polynomial of the step.)
    pub(super) fn between(
        top: &HeavyTop,
        start: Instant,
        length: f64,
        ends: [&State; 2],
        smoothness: usize,
    ) -> Result<Self, StepError> {
        let derivatives = ends.map(|state| scaled_series(top, state, length, smoothness));
        let mut coefficients = vec![State::default(); 2 * smoothness + 2];
        for i in 0..3 {
            let gamma = hermite(&derivatives.each_ref().map(|d| d.iter().map(|x| x.gamma[i]).collect::<Vec<_>>()));
            let l = hermite(&derivatives.each_ref().map(|d| d.iter().map(|x| x.l[i]).collect::<Vec<_>>()));
            for (coefficient, (x, y)) in coefficients.iter_mut().zip(gamma.into_iter().zip(l)) {
                coefficient.gamma[i] = x;
                coefficient.l[i] = y;
            }
        }
        Self::new(start, length, *ends[1], coefficients)
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

/// The Taylor coefficients of the flow through a state, in powers of x = time/length.
fn scaled_series(top: &HeavyTop, state: &State, length: f64, order: usize) -> Vec<State> {
    let mut power = 1.0;
    let mut series = top.taylor_coefficients(state, order);
    for coefficient in &mut series {
        coefficient.gamma = scale(power, coefficient.gamma);
        coefficient.l = scale(power, coefficient.l);
        power *= length;
    }
    series
}

/// The polynomial with given Taylor coefficients f⁽ᵏ⁾/k! at 0 and at 1, in powers of x.
///
/// Divided differences with each node repeated m times, then Newton's form expanded.
fn hermite([at_0, at_1]: &[Vec<f64>; 2]) -> Vec<f64> {
    let m = at_0.len();
    let n = 2 * m;
    // column[i] = f[z_i, …, z_{i+level}], z = 0 … 0 1 … 1
    let mut column: Vec<f64> = (0..n).map(|i| if i < m { at_0[0] } else { at_1[0] }).collect();
    let mut newton = vec![column[0]];
    for level in 1..n {
        for i in 0..n - level {
            column[i] = if i + level < m {
                at_0[level]
            } else if i >= m {
                at_1[level]
            } else {
                column[i + 1] - column[i]
            };
        }
        newton.push(column[0]);
    }
    // Horner: p = p·(x − z_k) + newton_k
    let mut p = vec![0.0; n];
    for k in (0..n).rev() {
        let node = if k < m { 0.0 } else { 1.0 };
        for i in (1..n).rev() {
            p[i] = p[i - 1] - node * p[i];
        }
        p[0] = newton[k] - node * p[0];
    }
    p
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hermite_reproduces_polynomials() {
        // p = 1 − 2x + 3x² + x³ − x⁵ with its Taylor coefficients at 1.
        let p = [1.0, -2.0, 3.0, 1.0, 0.0, -1.0];
        let found = hermite(&[vec![1.0, -2.0, 3.0], vec![2.0, 2.0, -4.0]]);
        for (x, y) in found.iter().zip(p) {
            assert!((x - y).abs() < 1e-14, "{found:?}");
        }
    }
}
