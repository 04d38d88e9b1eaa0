//! The motion at given times.

use std::sync::atomic::{AtomicBool, Ordering};

use thiserror::Error;

use super::attitude::Quaternion;
use super::piece::StepPiece;
use super::{attitude, azimuth};
use crate::field::{HeavyTop, Integrals, State, norm, sub};
use crate::integrator::{Instant, StepError, Taylor, TaylorStep, ToleranceError, check_tolerance};

/// What to compute.
#[derive(Clone, Copy, Debug)]
pub struct MotionOptions<'a> {
    /// Truncation error of a step of γ and l, relative to the size of the energy surface; 1e-18 to 1e-2.
    pub tolerance: f64,
    /// φ at the start.
    pub phi: f64,
    /// Cancellation: once it is set, the motion ends.
    pub stop: &'a AtomicBool,
}

/// The motion at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotionSample {
    /// Time since the start.
    pub time: f64,
    /// The vertical, in the body's axes.
    pub gamma: [f64; 3],
    /// Angular momentum, in the body's axes.
    pub l: [f64; 3],
    /// Angular velocity, in the body's axes.
    pub omega: [f64; 3],
    /// ϑ ∈ [0, π] between γ and e₃.
    pub theta: f64,
    /// ψ ∈ (−π, π].
    pub psi: f64,
    /// φ, continuous in time.
    pub phi: f64,
    /// The attitude, continuous in time: takes vectors of the body to space.
    pub attitude: Quaternion,
}

/// How well it went.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MotionReport {
    /// Steps of the integrator.
    pub steps: u64,
    /// The largest |deviation| of each first integral from its value at the start, over the samples.
    pub drift: Integrals,
    /// The largest |Rᵀe_z − γ| over the samples: the attitude's vertical against the integrated one.
    pub vertical_error: f64,
    /// The largest angle over the samples between the attitude and that of the angles (ϑ, ψ, φ).
    pub attitude_difference: f64,
    /// Pieces of the motion in which γ was at ±e₃ within rounding: ψ and φ are not determined there, and beyond it
    /// are one possible continuation; the attitude is not concerned.
    pub at_pole: u64,
    /// What stopped the integrator; samples beyond are missing.
    pub failure: Option<StepError>,
    /// The motion was stopped from outside; samples are missing.
    pub interrupted: bool,
}

/// The motion at the times that were asked for.
#[derive(Clone, Debug, PartialEq)]
pub struct Motion {
    /// In the order of time.
    pub samples: Vec<MotionSample>,
    /// How well it went.
    pub report: MotionReport,
}

/// Why nothing was computed.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum MotionError {
    /// The integrator's tolerance is out of range.
    #[error(transparent)]
    Tolerance(#[from] ToleranceError),
    /// A time is not a number, or infinite.
    #[error("time {number} is {time}; a finite time is needed")]
    NotFinite {
        /// Its number, from 1.
        number: usize,
        /// The time.
        time: f64,
    },
    /// The times do not rise.
    #[error("time {number} = {time} is below the one before, {before}; times must rise")]
    Falling {
        /// Its number, from 1.
        number: usize,
        /// The time.
        time: f64,
        /// The one before.
        before: f64,
    },
}

/// Follows the motion from `start` at time 0 to the times, which must not fall; times below 0 are reached backwards.
///
/// # Errors
/// [`MotionError`] for times or a tolerance that cannot be used.
pub fn follow(
    top: &HeavyTop,
    start: &State,
    times: &[f64],
    options: &MotionOptions<'_>,
) -> Result<Motion, MotionError> {
    check_tolerance(options.tolerance)?;
    for (i, &time) in times.iter().enumerate() {
        if !time.is_finite() {
            return Err(MotionError::NotFinite { number: i + 1, time });
        }
        if i > 0 && time < times[i - 1] {
            return Err(MotionError::Falling { number: i + 1, time, before: times[i - 1] });
        }
    }
    let (past, future) = times.split_at(times.partition_point(|&time| time < 0.0));
    let mut report = MotionReport::default();
    // (γ, −l, −t) solves the equations if (γ, l, t) does.
    let reversed = State { gamma: start.gamma, l: start.l.map(|x| -x) };
    let back: Vec<f64> = past.iter().rev().map(|time| -time).collect();
    let mut samples = MotionFollower::new(top, &reversed, options).run(&back, &mut report)?;
    samples.reverse();
    for sample in &mut samples {
        sample.time = -sample.time;
        sample.l = sample.l.map(|x| -x);
        sample.omega = sample.omega.map(|x| -x);
    }
    if !report.interrupted {
        samples.extend(MotionFollower::new(top, start, options).run(future, &mut report)?);
    }
    Ok(Motion { samples, report })
}

/// The motion in one direction of time.
struct MotionFollower<'a> {
    top: &'a HeavyTop,
    options: &'a MotionOptions<'a>,
    start: State,
    integrals: Integrals,
    attitude: Quaternion,
    /// φ as a sum that loses no digits.
    phi: Instant,
    psi: f64,
}

impl<'a> MotionFollower<'a> {
    fn new(top: &'a HeavyTop, start: &State, options: &'a MotionOptions<'a>) -> Self {
        let psi = azimuth::longitude(start.gamma);
        Self {
            top,
            options,
            start: *start,
            integrals: Integrals::of(top, start),
            attitude: Quaternion::of_angles(polar_angle(start.gamma), psi, options.phi),
            phi: Instant::new(options.phi, 0.0),
            psi,
        }
    }

    /// To rising times ≥ 0.
    fn run(mut self, times: &[f64], report: &mut MotionReport) -> Result<Vec<MotionSample>, ToleranceError> {
        let mut samples = Vec::with_capacity(times.len());
        let mut left = times.iter().copied().peekable();
        while let Some(time) = left.next_if(|&time| time == 0.0) {
            samples.push(self.sample(time, &self.start, report));
        }
        let mut stepper = Taylor::new(self.top, &self.start, self.options.tolerance)?;
        while left.peek().is_some() {
            if self.is_stopped(report) {
                break;
            }
            let step = match stepper.step() {
                Ok(step) => step,
                Err(failure) => {
                    report.failure = Some(failure);
                    break;
                }
            };
            report.steps += 1;
            let mut from = 0.0;
            while let Some(time) = left.next_if(|&time| time <= step.end().seconds()) {
                let to =
                    (((time - step.start().seconds()) - step.start().remainder()) / step.length()).clamp(from, 1.0);
                let state = self.advance(&step, [from, to], report);
                if report.interrupted {
                    return Ok(samples);
                }
                samples.push(self.sample(time, &state, report));
                from = to;
            }
            // What lies beyond the last time is of no use.
            if left.peek().is_some() {
                self.advance(&step, [from, 1.0], report);
            }
        }
        Ok(samples)
    }

    fn is_stopped(&self, report: &mut MotionReport) -> bool {
        report.interrupted |= self.options.stop.load(Ordering::Relaxed);
        report.interrupted
    }

    /// Carries attitude and φ over a part of a step; the state at its end, which means nothing after an interrupt.
    fn advance(&mut self, step: &TaylorStep, ends: [f64; 2], report: &mut MotionReport) -> State {
        let at = |x: f64| if x == 1.0 { *step.end_state() } else { step.state(x) };
        if ends[1] > ends[0] {
            for piece in StepPiece::cut(self.top, step, ends) {
                if self.is_stopped(report) {
                    break;
                }
                let coefficients = piece.coefficients();
                self.attitude = attitude::advance(self.top, &piece, &coefficients, self.attitude);
                let psi = azimuth::longitude(at(piece.ends[1]).gamma);
                let (phi, at_pole) = azimuth::advance(self.top, &piece, &coefficients, [self.psi, psi]);
                self.phi = self.phi.after(phi);
                self.psi = psi;
                report.at_pole += u64::from(at_pole);
            }
        }
        at(ends[1])
    }

    fn sample(&self, time: f64, state: &State, report: &mut MotionReport) -> MotionSample {
        let (theta, psi, phi) = (polar_angle(state.gamma), azimuth::longitude(state.gamma), self.phi.seconds());
        report.drift = report.drift.max(&Integrals::of(self.top, state).distance(&self.integrals));
        report.vertical_error = report.vertical_error.max(norm(sub(self.attitude.vertical(), state.gamma)));
        let difference = self.attitude.distance(Quaternion::of_angles(theta, psi, phi));
        report.attitude_difference = report.attitude_difference.max(difference);
        MotionSample {
            time,
            gamma: state.gamma,
            l: state.l,
            omega: self.top.angular_velocity(state.l),
            theta,
            psi,
            phi,
            attitude: self.attitude,
        }
    }
}

/// ϑ of γ.
fn polar_angle(gamma: [f64; 3]) -> f64 {
    libm::atan2((gamma[0] * gamma[0] + gamma[1] * gamma[1]).sqrt(), gamma[2])
}
