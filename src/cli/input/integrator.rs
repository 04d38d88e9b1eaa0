//! The integrator that the options ask for.

use clap::{Args, ValueEnum};
use dynamics::field::HeavyTop;
use dynamics::integrator::{Method, MethodError};
use thiserror::Error;

use super::values;
use crate::cli::failure::{CommandError, Exit};

/// Integrators.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Integrator {
    /// Taylor series of adaptive order and step, several orbits at once
    Taylor,
    /// Dormand and Prince's method of order 8, adaptive
    Dop853,
    /// The classical Runge-Kutta method of order 4, fixed step
    Rk4,
    /// Exact Poisson flows composed to order 4, fixed step; keeps the Casimirs to rounding
    Splitting,
}

/// Integrator options of `section` and `orbit`.
#[derive(Debug, Args)]
#[command(next_help_heading = "Integrator")]
pub struct IntegratorArguments {
    /// How to integrate
    #[arg(long, value_enum, default_value = "taylor", hide_short_help = true)]
    pub integrator: Integrator,
    /// Error of a step relative to the size of the motion, for taylor (default: 1e-15) and dop853 (1e-13)
    #[arg(long, value_name = "TOL", allow_hyphen_values = true, value_parser = values::float, hide_short_help = true)]
    pub tol: Option<f64>,
    /// Length of a step in time, for rk4 and splitting (default: a 200th of the fastest turn)
    #[arg(long, value_name = "DT", allow_hyphen_values = true, value_parser = values::float, hide_short_help = true)]
    pub step: Option<f64>,
}

/// The options do not describe an integrator.
#[derive(Debug, Error)]
pub enum IntegratorInput {
    #[error("--{name} {value} is not usable; {expected}", name = .0.name, value = .0.value, expected = .0.expected)]
    Fineness(MethodError),
    #[error("{option} is for {owners}; {integrator} takes {instead}")]
    WrongFineness { option: &'static str, owners: &'static str, integrator: String, instead: &'static str },
}

impl CommandError for IntegratorInput {
    fn exit(&self) -> Exit {
        Exit::WrongInput
    }
}

/// Default tolerances.
const TAYLOR: f64 = 1e-15;
const DOP853: f64 = 1e-13;
/// Default number of fixed steps in a turn with the largest possible angular velocity.
const STEPS_A_TURN: f64 = 200.0;

impl IntegratorArguments {
    /// The method for the motion of a top with energy h.
    pub fn method(&self, top: &HeavyTop, h: f64) -> Result<Method, IntegratorInput> {
        let misplaced = match self.integrator {
            Integrator::Taylor | Integrator::Dop853 => {
                self.step.map(|_| ("--step", "rk4 and splitting", "--tol 1e-12"))
            }
            Integrator::Rk4 | Integrator::Splitting => self.tol.map(|_| ("--tol", "taylor and dop853", "--step 0.01")),
        };
        if let Some((option, owners, instead)) = misplaced {
            let name = self.integrator.to_possible_value().map(|value| value.get_name().to_owned());
            return Err(IntegratorInput::WrongFineness {
                option,
                owners,
                integrator: name.unwrap_or_default(),
                instead,
            });
        }
        let step = || self.step.unwrap_or_else(|| default_step(top, h));
        let method = match self.integrator {
            Integrator::Taylor => Method::Taylor { tolerance: self.tol.unwrap_or(TAYLOR) },
            Integrator::Dop853 => Method::Dop853 { tolerance: self.tol.unwrap_or(DOP853) },
            Integrator::Rk4 => Method::RungeKutta4 { step: step() },
            Integrator::Splitting => Method::Splitting { step: step() },
        };
        method.check(top).map_err(IntegratorInput::Fineness)?;
        Ok(method)
    }
}

/// A part of the shortest turn that the energy allows: |ω| ≤ √(2(h + r)/A_min).
fn default_step(top: &HeavyTop, h: f64) -> f64 {
    let smallest = top.moments().iter().fold(f64::INFINITY, |m: f64, &a| m.min(a));
    let fastest = (2.0 * (h + top.center_norm()) / smallest).sqrt();
    if fastest > 0.0 { std::f64::consts::TAU / fastest / STEPS_A_TURN } else { 0.01 }
}
