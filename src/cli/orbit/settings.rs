//! What the options ask for.

use bifdiag_dynamics::field::{HeavyTop, State};
use bifdiag_dynamics::integrator::DEFAULT_TOLERANCE;

use super::arguments::OrbitArguments;
use super::error::OrbitInput;
use super::start;
use super::target::AnimationTarget;
use super::times::Times;
use crate::cli::export::DataTarget;
use crate::cli::failure::Failure;
use bifdiag_documents::Subject;

pub struct Settings<'a> {
    pub subject: Subject,
    pub top: HeavyTop,
    pub start: State,
    /// Euler's angle φ at the start.
    pub phi: f64,
    pub times: Vec<f64>,
    /// The times as the option says them.
    pub given_times: &'a Times,
    pub tolerance: f64,
    pub data: Option<&'a DataTarget>,
    pub animation: Option<&'a AnimationTarget>,
    pub json: bool,
}

impl<'a> Settings<'a> {
    pub fn new(arguments: &'a OrbitArguments) -> Result<Self, Failure> {
        let (data, json) = (arguments.data.as_ref(), arguments.json);
        if json && data == Some(&DataTarget::Stdout) {
            return Err(OrbitInput::TwoOnStdout.into());
        }
        let subject = arguments.body.subject()?;
        let top = HeavyTop::new(&subject.body);
        let start = start::of(arguments, &top)?;
        let times = arguments.times.list()?;
        let (phi, given_times) = (arguments.phi, &arguments.times);
        Ok(Self {
            subject,
            top,
            start,
            phi,
            times,
            given_times,
            tolerance: arguments.tol.unwrap_or(DEFAULT_TOLERANCE),
            data,
            animation: arguments.animate.as_ref(),
            json,
        })
    }
}
