//! Integrators of the Euler–Poisson equations.
//!
//! - [`taylor`]: the default. Taylor series of adaptive order and step, several orbits a SIMD register.
//! - [`Dop853`]: Dormand and Prince's method of order 8 with adaptive step.
//! - [`RungeKutta4`]: the classical method of order 4 with a fixed step.
//! - [`Splitting`]: a composition of exact flows of order 4 with a fixed step; ⟨γ,γ⟩ and ⟨γ,l⟩ to rounding.
//!
//! All of them are [`Stepper`]s and give, for each [`Step`], the motion as a polynomial in x ∈ [0, 1].
//! Nothing here knows of sections.

mod dop853;
mod runge_kutta;
mod splitting;
mod step;
pub mod taylor;
mod time;

pub use dop853::Dop853;
pub use runge_kutta::RungeKutta4;
pub use splitting::Splitting;
pub use step::Step;
pub use taylor::Taylor;
pub use time::Instant;

use thiserror::Error;

use crate::field::{HeavyTop, State};

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

/// An integrator under way.
pub trait Stepper {
    /// Makes one step.
    ///
    /// # Errors
    /// [`StepError`]; the stepper is of no use afterwards.
    fn step(&mut self) -> Result<Step, StepError>;
}

impl Method {
    /// Are the parameters usable?
    ///
    /// # Errors
    /// [`MethodError`] names the parameter.
    pub fn check(self) -> Result<(), MethodError> {
        let (name, value, range, expected) = match self {
            Self::Taylor { tolerance } => ("tol", tolerance, 1e-18..=1e-2, "1e-18 to 1e-2 is possible"),
            Self::Dop853 { tolerance } => ("tol", tolerance, 1e-15..=1e-2, "1e-15 to 1e-2 is possible"),
            Self::RungeKutta4 { step } | Self::Splitting { step } => {
                ("step", step, 1e-9..=1e9, "a time between 1e-9 and 1e9 is needed")
            }
        };
        if range.contains(&value) { Ok(()) } else { Err(MethodError { name, value, expected }) }
    }

    /// Starts the method at a state and time 0.
    ///
    /// # Errors
    /// [`MethodError`] for parameters out of range.
    pub fn stepper(self, top: &HeavyTop, start: &State) -> Result<Box<dyn Stepper>, MethodError> {
        self.check()?;
        Ok(match self {
            Self::Taylor { tolerance } => Box::new(Taylor::new(top, start, tolerance)),
            Self::Dop853 { tolerance } => Box::new(Dop853::new(top, start, tolerance)),
            Self::RungeKutta4 { step } => Box::new(RungeKutta4::new(top, start, step)),
            Self::Splitting { step } => Box::new(Splitting::new(top, start, step)),
        })
    }
}
