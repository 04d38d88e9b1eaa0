//! One orbit by Taylor series: the kernel of the sweeps with a single lane.

use pulp::Scalar;

use super::lanes::Lanes;
use crate::field::{HeavyTop, State};
use crate::integrator::step::{Step, StepError, Stepper};

/// Taylor series for one orbit; the same steps, bit for bit, as in a sweep.
pub struct Taylor {
    lanes: Box<Lanes<Scalar>>,
}

impl Taylor {
    /// Starts at a state and time 0.
    #[must_use]
    pub fn new(top: &HeavyTop, start: &State, tolerance: f64) -> Self {
        let mut lanes = Box::new(Lanes::new(Scalar::new(), top, tolerance));
        lanes.load(0, start, top.momentum_scale(top.energy(start)));
        Self { lanes }
    }
}

impl Stepper for Taylor {
    fn step(&mut self) -> Result<Step, StepError> {
        let lanes = &mut *self.lanes;
        lanes.expand(Scalar::new());
        let length = lanes.step_of(0);
        let mut power = 1.0;
        let mut coefficients = Vec::with_capacity(lanes.order() + 1);
        for k in 0..=lanes.order() {
            let (gamma, l) = (lanes.series.gamma[k], lanes.series.l[k]);
            coefficients.push(State { gamma: gamma.map(|x| x * power), l: l.map(|x| x * power) });
            power *= length;
        }
        let start = lanes.time(0);
        let end_state = State { gamma: lanes.next[0], l: lanes.next[1] };
        lanes.commit(Scalar::new());
        Step::new(start, length, end_state, coefficients)
    }
}
