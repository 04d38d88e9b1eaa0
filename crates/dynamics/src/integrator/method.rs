//! The choice of an integrator.

use thiserror::Error;

use super::dop853::Dop853;
use super::runge_kutta::RungeKutta4;
use super::splitting::Splitting;
use super::step::{Step, StepError, Stepper};
use super::taylor::Taylor;
use crate::field::{Dimension, HeavyTop, State, Units};

/// Which integrator, and how fine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Method {
    /// Taylor series.
    Taylor {
        /// Truncation error of a step, relative to the size of the energy surface; 1e-18 to 1e-2.
        tolerance: f64,
    },
    /// Dormand–Prince 8(5,3).
    Dop853 {
        /// Relative and absolute tolerance; 1e-15 to 1e-2.
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

impl Default for Method {
    fn default() -> Self {
        Self::Taylor { tolerance: 1e-15 }
    }
}

/// A method's parameter is out of range.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error("{name} = {value} is not usable; {expected}")]
pub struct MethodError {
    /// `tol` or `step`.
    pub name: &'static str,
    /// The value.
    pub value: f64,
    /// What would be right.
    pub expected: &'static str,
}

impl Method {
    /// Are the parameters usable for a top?
    ///
    /// # Errors
    /// [`MethodError`] names the parameter.
    pub fn check(self, top: &HeavyTop) -> Result<(), MethodError> {
        let units = top.units();
        let (name, value, range, expected) = match self {
            Self::Taylor { tolerance } => ("tol", tolerance, 1e-18..=1e-2, "1e-18 to 1e-2 is possible"),
            Self::Dop853 { tolerance } => ("tol", tolerance, 1e-15..=1e-2, "1e-15 to 1e-2 is possible"),
            Self::RungeKutta4 { step } | Self::Splitting { step } => {
                let [shortest, longest] = [1e-9, 1e9].map(|time| units.restore(time, Dimension::TIME));
                let expected = if units.are_one() {
                    "a time between 1e-9 and 1e9 is needed"
                } else {
                    "a time between 1e-9 and 1e9 times that of the body, the root of A/r, is needed"
                };
                ("step", step, shortest..=longest, expected)
            }
        };
        if range.contains(&value) { Ok(()) } else { Err(MethodError { name, value, expected }) }
    }

    /// Starts the method at a state and time 0.
    ///
    /// # Errors
    /// [`MethodError`] for parameters out of range.
    pub fn stepper(self, top: &HeavyTop, start: &State) -> Result<Box<dyn Stepper>, MethodError> {
        self.check(top)?;
        let units = top.units();
        if !units.are_one() {
            let stepper = self.reduced(units).stepper(&top.reduced(), &start.reduced(units))?;
            return Ok(Box::new(Restored { stepper, units }));
        }
        Ok(match self {
            Self::Taylor { tolerance } => Box::new(Taylor::new(top, start, tolerance)),
            Self::Dop853 { tolerance } => Box::new(Dop853::new(top, start, tolerance)),
            Self::RungeKutta4 { step } => Box::new(RungeKutta4::new(top, start, step)),
            Self::Splitting { step } => Box::new(Splitting::new(top, start, step)),
        })
    }

    /// The same for a top in other units.
    #[must_use]
    pub fn reduced(self, units: Units) -> Self {
        let reduced = |step| units.reduce(step, Dimension::TIME);
        match self {
            Self::Taylor { .. } | Self::Dop853 { .. } => self,
            Self::RungeKutta4 { step } => Self::RungeKutta4 { step: reduced(step) },
            Self::Splitting { step } => Self::Splitting { step: reduced(step) },
        }
    }
}

/// The steps of a top that is integrated in its own units, as given.
struct Restored {
    stepper: Box<dyn Stepper>,
    units: Units,
}

impl Stepper for Restored {
    fn step(&mut self) -> Result<Step, StepError> {
        let step = self.stepper.step();
        step.map(|step| step.restored(self.units)).map_err(|error| error.restored(self.units))
    }
}
