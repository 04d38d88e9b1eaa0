//! Dormand and Prince's method of order 8, by the crate `ode_solvers`.

use std::collections::VecDeque;

use bifdiag_dynamics::field::{HeavyTop, State};
use ode_solvers::dop_shared::IntegrationError;
use ode_solvers::{OutputType, System, Vector6};

/// Time that is integrated at once, in units of A_max/|l|_max.
const STRETCH: f64 = 50.0;
/// Steps that are made at once.
const STEPS: u32 = 100_000;

/// The time that is integrated at once.
pub(super) fn stretch(top: &HeavyTop, state: &State) -> f64 {
    let largest = top.moments().iter().fold(0.0, |m: f64, &a| m.max(a));
    STRETCH * (largest / top.momentum_scale(top.energy(state)).max(f64::MIN_POSITIVE)).min(1e6)
}

/// The accepted steps over a time, or as many as [`STEPS`]: lengths and states at their ends.
pub(super) fn steps(top: &HeavyTop, start: &State, time: f64, tolerance: f64) -> VecDeque<(f64, State)> {
    if time <= 0.0 {
        return VecDeque::new();
    }
    let State { gamma, l } = *start;
    // Hairer's default parameters; the initial step is estimated.
    let mut solver = ode_solvers::Dop853::from_param(
        EulerPoisson { top: *top },
        0.0,
        time,
        time,
        Vector6::new(gamma[0], gamma[1], gamma[2], l[0], l[1], l[2]),
        tolerance,
        tolerance,
        0.9,
        0.0,
        0.333,
        6.0,
        time,
        0.0,
        STEPS,
        1000,
        OutputType::Sparse,
    );
    match solver.integrate() {
        Ok(_) => {}
        // The next call goes on from the last of these steps.
        Err(IntegrationError::MaxNumStepReached { .. }) if solver.x_out().len() > 1 => {}
        Err(error) => panic!("DOP853: {error}"),
    }
    let (times, states) = (solver.x_out(), solver.y_out());
    let pairs = times.windows(2).zip(&states[1..]).filter(|(pair, _)| pair[1] > pair[0]);
    pairs.map(|(pair, y)| (pair[1] - pair[0], state_of(y))).collect()
}

fn state_of(y: &Vector6<f64>) -> State {
    State { gamma: [y[0], y[1], y[2]], l: [y[3], y[4], y[5]] }
}

/// The equations as `ode_solvers` wants them.
struct EulerPoisson {
    top: HeavyTop,
}

impl System<f64, Vector6<f64>> for EulerPoisson {
    fn system(&self, _: f64, y: &Vector6<f64>, dy: &mut Vector6<f64>) {
        let field = self.top.vector_field(&state_of(y));
        *dy = Vector6::new(field.gamma[0], field.gamma[1], field.gamma[2], field.l[0], field.l[1], field.l[2]);
    }
}
