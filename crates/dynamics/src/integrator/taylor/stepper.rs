//! One orbit by Taylor series: the kernel of the sweeps with a single lane.

use pulp::Scalar;
use thiserror::Error;

use super::lanes::Lanes;
use crate::field::{HeavyTop, State, TopUnits};
use crate::integrator::step::{StepError, TaylorStep};

/// The tolerance that is taken unless another is asked for.
pub const DEFAULT_TOLERANCE: f64 = 1e-15;

/// A tolerance is out of range.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error("tol = {tolerance} is not usable; 1e-18 to 1e-2 is possible")]
pub struct ToleranceError {
    /// The tolerance.
    pub tolerance: f64,
}

/// Checks a tolerance, the truncation error of a step relative to the size of the energy surface: 1e-18 to 1e-2.
///
/// # Errors
/// [`ToleranceError`] if it is not.
pub fn check_tolerance(tolerance: f64) -> Result<(), ToleranceError> {
    if (1e-18..=1e-2).contains(&tolerance) { Ok(()) } else { Err(ToleranceError { tolerance }) }
}

/// Taylor series for one orbit; the same steps, bit for bit, as in a sweep.
pub struct Taylor {
    lanes: Box<Lanes<Scalar>>,
    /// In the units of the given top; the lanes use the top's own.
    units: TopUnits,
}

impl Taylor {
    /// Starts at a state and time 0.
    ///
    /// # Errors
    /// [`ToleranceError`] for a tolerance out of range.
    pub fn new(top: &HeavyTop, start: &State, tolerance: f64) -> Result<Self, ToleranceError> {
        check_tolerance(tolerance)?;
        let (top, start, units) = top.reduced_beside(start);
        let mut lanes = Box::new(Lanes::new(Scalar::new(), &top, tolerance));
        lanes.load(0, &start, top.momentum_scale(top.energy(&start)));
        Ok(Self { lanes, units })
    }

    /// Makes one step.
    ///
    /// # Errors
    /// [`StepError`]; the integrator is of no use afterwards.
    pub fn step(&mut self) -> Result<TaylorStep, StepError> {
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
        let step = TaylorStep::new(start, length, end_state, coefficients);
        step.map(|step| step.restored(self.units)).map_err(|error| error.restored(self.units))
    }
}
