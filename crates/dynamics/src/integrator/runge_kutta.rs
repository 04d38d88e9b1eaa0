//! The classical Runge–Kutta method of order 4.

use super::step::{Step, StepError, Stepper};
use super::time::Instant;
use crate::field::{HeavyTop, State, add, scale};

/// Order of the series inside a step: (step/radius of convergence)¹² is far below the method's own error.
const SERIES_ORDER: usize = 12;

/// Runge–Kutta 4 with a fixed step.
#[derive(Clone, Debug)]
pub struct RungeKutta4 {
    top: HeavyTop,
    state: State,
    time: Instant,
    length: f64,
}

impl RungeKutta4 {
    /// Starts at a state and time 0.
    #[must_use]
    pub fn new(top: &HeavyTop, start: &State, length: f64) -> Self {
        Self { top: *top, state: *start, time: Instant::default(), length }
    }
}

/// x + c k.
fn shifted(x: &State, c: f64, k: &State) -> State {
    State { gamma: add(x.gamma, scale(c, k.gamma)), l: add(x.l, scale(c, k.l)) }
}

impl Stepper for RungeKutta4 {
    fn step(&mut self) -> Result<Step, StepError> {
        let h = self.length;
        let k1 = self.top.vector_field(&self.state);
        let k2 = self.top.vector_field(&shifted(&self.state, 0.5 * h, &k1));
        let k3 = self.top.vector_field(&shifted(&self.state, 0.5 * h, &k2));
        let k4 = self.top.vector_field(&shifted(&self.state, h, &k3));
        let mut next = shifted(&self.state, h / 6.0, &k1);
        next = shifted(&next, h / 3.0, &k2);
        next = shifted(&next, h / 3.0, &k3);
        next = shifted(&next, h / 6.0, &k4);
        let step = Step::expanded(&self.top, self.time, h, [&self.state, &next], SERIES_ORDER)?;
        self.time = step.end();
        self.state = next;
        Ok(step)
    }
}
