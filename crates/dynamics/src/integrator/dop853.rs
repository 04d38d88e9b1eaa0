//! Dormand and Prince's method of order 8, by the crate `ode_solvers`.

use std::collections::VecDeque;

use ode_solvers::dop_shared::IntegrationError;
use ode_solvers::{OutputType, System, Vector6};

use super::step::{Step, StepError, Stepper};
use super::time::Instant;
use crate::field::{HeavyTop, State};

/// Derivatives that the interpolation takes at each end: its error is then below that of the steps.
const SMOOTHNESS: usize = 7;
/// Time that is integrated at once, in units of A_max/|l|_max.
const STRETCH: f64 = 50.0;
/// Steps that are made at once, so that a caller can stop between: a few tenths of a second.
const STEPS: u32 = 100_000;

/// DOP853 with adaptive step. (Its step-size control uses the platform's `pow`: unlike the others, it need not
/// give the same bits on every machine.)
#[derive(Clone, Debug)]
pub struct Dop853 {
    top: HeavyTop,
    state: State,
    time: Instant,
    tolerance: f64,
    stretch: f64,
    /// Accepted steps not yet handed out: lengths and states at their ends.
    steps: VecDeque<(f64, State)>,
}

impl Dop853 {
    /// Starts at a state and time 0.
    #[must_use]
    pub fn new(top: &HeavyTop, start: &State, tolerance: f64) -> Self {
        let largest = top.moments().iter().fold(0.0, |m: f64, &a| m.max(a));
        let stretch = STRETCH * (largest / top.momentum_scale(top.energy(start)).max(f64::MIN_POSITIVE)).min(1e6);
        Self { top: *top, state: *start, time: Instant::default(), tolerance, stretch, steps: VecDeque::new() }
    }

    /// Integrates the next stretch of time, or as much of it as [`STEPS`] reach.
    fn integrate(&mut self) -> Result<(), StepError> {
        let State { gamma, l } = self.state;
        let start = Vector6::new(gamma[0], gamma[1], gamma[2], l[0], l[1], l[2]);
        let (tolerance, stretch) = (self.tolerance, self.stretch);
        // Hairer's default parameters; the initial step is estimated.
        let mut solver = ode_solvers::Dop853::from_param(
            EulerPoisson { top: self.top },
            0.0,
            stretch,
            stretch,
            start,
            tolerance,
            tolerance,
            0.9,
            0.0,
            0.333,
            6.0,
            stretch,
            0.0,
            STEPS,
            1000,
            OutputType::Sparse,
        );
        match solver.integrate() {
            Ok(_) => {}
            // The next call goes on from the last of these steps.
            Err(IntegrationError::MaxNumStepReached { .. }) if solver.x_out().len() > 1 => {}
            Err(error) => return Err(self.step_error(&error)),
        }
        let (times, states) = (solver.x_out(), solver.y_out());
        for (pair, y) in times.windows(2).zip(&states[1..]) {
            let state = State { gamma: [y[0], y[1], y[2]], l: [y[3], y[4], y[5]] };
            if pair[1] > pair[0] {
                self.steps.push_back((pair[1] - pair[0], state));
            }
        }
        Ok(())
    }

    fn step_error(&self, error: &IntegrationError) -> StepError {
        let time = |x: &f64| self.time.after(*x).seconds();
        match error {
            IntegrationError::MaxNumStepReached { x, n_step } => {
                StepError::TooManySteps { time: time(x), steps: *n_step }
            }
            IntegrationError::StepSizeUnderflow { x } => StepError::Underflow { time: time(x) },
            IntegrationError::StiffnessDetected { x } => StepError::Stiff { time: time(x) },
        }
    }
}

/// The equations as `ode_solvers` wants them.
struct EulerPoisson {
    top: HeavyTop,
}

impl System<f64, Vector6<f64>> for EulerPoisson {
    fn system(&self, _: f64, y: &Vector6<f64>, dy: &mut Vector6<f64>) {
        let field = self.top.vector_field(&State { gamma: [y[0], y[1], y[2]], l: [y[3], y[4], y[5]] });
        *dy = Vector6::new(field.gamma[0], field.gamma[1], field.gamma[2], field.l[0], field.l[1], field.l[2]);
    }
}

impl Stepper for Dop853 {
    fn step(&mut self) -> Result<Step, StepError> {
        if self.steps.is_empty() {
            self.integrate()?;
        }
        let (length, next) = self.steps.pop_front().ok_or(StepError::Underflow { time: self.time.seconds() })?;
        let step = Step::between(&self.top, self.time, length, [&self.state, &next], SMOOTHNESS)?;
        self.time = step.end();
        self.state = next;
        Ok(step)
    }
}
