//! How a tangent vector grows along an orbit, and what the orbit averages to.

use std::f64::consts::LN_2;

use super::averages::TangentStep;
use super::averages::bump;
use super::ladder::Ladder;
use super::verdict::Evidence;
use crate::field::{Dimension, State, TopUnits};

/// The largest Lyapunov exponent of an orbit over a finite time, per unit of time.
///
/// A tangent vector δ = (δγ, δl) is taken along by the variational equations. It starts tangent to the energy surface
/// and to ⟨γ,γ⟩ = 1, ⟨γ,l⟩ = l and so remains. The flow on that surface has the exponents λ, 0, −λ, so that one vector
/// shows all of them. Lengths are |δ|² = |δγ|² + |δl|²/(2 A_max (h + 2|r|)), without units.
///
/// Regular orbits shear: |δ| grows like t, and `exponent` falls like ln(T)/T, `mean_rate` like 2/T. An exponent that
/// does not exceed a few times that is not chaos that this time can show.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lyapunov {
    /// λ(T) = ln(|δ(T)|/|δ(0)|)/T.
    pub exponent: f64,
    /// λ(T/2).
    pub exponent_half: f64,
    /// The mean of d ln|δ|/dt over [0, T] with the weight exp(−1/(u(1−u))), u = t/T. It forgets the choice of δ(0) and
    /// the phase at T, so that for regular orbits it is the sharper of the two.
    pub mean_rate: f64,
    /// The same over [0, T/2].
    pub mean_rate_half: f64,
    /// T: the end of the first step that reaches the time asked for.
    pub time: f64,
}

impl Lyapunov {
    /// |λ(T) − λ(T/2)|: how far `exponent` has converged.
    #[must_use]
    pub fn error(&self) -> f64 {
        (self.exponent - self.exponent_half).abs()
    }

    /// That of a reduced top as that of the top as given.
    fn restored(self, units: TopUnits) -> Self {
        let rate = |x| units.restore(x, Dimension::FREQUENCY);
        Self {
            exponent: rate(self.exponent),
            exponent_half: rate(self.exponent_half),
            mean_rate: rate(self.mean_rate),
            mean_rate_half: rate(self.mean_rate_half),
            time: units.restore(self.time, Dimension::TIME),
        }
    }
}

/// An orbit along which a tangent vector is taken.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TangentCourse {
    /// Its state at time 0.
    pub start: State,
    /// For how long it is followed.
    pub time: f64,
    /// Times at which ln|δ| is wanted, ascending.
    pub at: Vec<f64>,
    /// The unit of the times at which evidence is taken; without a positive unit there is no evidence.
    pub unit: f64,
    /// Stop as soon as the evidence decides whether the orbit is regular, or when there is no more to come; there is then no exponent.
    pub until_decided: bool,
}

/// How a tangent vector has grown along a course.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Growth {
    /// None where the time is not a positive number, where the motion did not remain finite, and where the run was
    /// stopped.
    pub lyapunov: Option<Lyapunov>,
    /// ln(|δ(t)|/|δ(0)|) at the requested times that the orbit reached.
    pub logs: Vec<f64>,
    /// What was seen at the times `unit` · 2^{k/2} that were passed.
    pub evidence: Vec<Evidence>,
    /// The motion and the tangent vector remained finite while they were followed.
    pub finite: bool,
}

impl Growth {
    /// That of a reduced top as that of the top as given.
    pub(super) fn restored(self, units: TopUnits) -> Self {
        Self {
            lyapunov: self.lyapunov.map(|exponent| exponent.restored(units)),
            evidence: self.evidence.into_iter().map(|seen| seen.restored(units)).collect(),
            ..self
        }
    }
}

/// How a tangent vector of length 1 has grown.
pub(super) struct Stretching {
    pub orbit: u32,
    whole: WeightedRate,
    half: WeightedRate,
    /// Time and ln|δ| at the last step's end.
    time: f64,
    log: f64,
    /// ln of what was taken out of δ.
    removed: f64,
    exponent_half: Option<f64>,
    /// ln|δ| at the times of the course that were passed.
    logs: Vec<f64>,
    ladder: Ladder,
    until_decided: bool,
}

impl Stretching {
    pub fn new(orbit: u32, course: &TangentCourse) -> Self {
        let rate = |span| WeightedRate { span, sum: 0.0, weights: 0.0 };
        Self {
            orbit,
            whole: rate(course.time),
            half: rate(0.5 * course.time),
            time: 0.0,
            log: 0.0,
            removed: 0.0,
            exponent_half: None,
            logs: Vec::with_capacity(course.at.len()),
            ladder: Ladder::new(course.unit),
            until_decided: course.until_decided,
        }
    }

    /// Goes over a step.
    #[inline(always)]
    pub fn take(&mut self, course: &TangentCourse, step: &TangentStep) {
        let time = step.time;
        let log = self.removed + 0.5 * libm::log(step.length_squared);
        for rate in [&mut self.whole, &mut self.half] {
            rate.take(self.time, time, log - self.log);
        }
        // Within a step, linear is good enough: the errors do not add up.
        while let Some(&at) = course.at.get(self.logs.len()).filter(|&&at| at <= time) {
            self.logs.push(self.log + (log - self.log) * (at - self.time) / (time - self.time));
        }
        self.ladder.take(step, log - self.log, log);
        (self.time, self.log) = (time, log);
        self.removed += f64::from(step.power) * LN_2;
        if self.exponent_half.is_none() && time >= self.half.span {
            self.exponent_half = Some(log / time);
        }
    }

    /// True at the end of the time asked for, once everything is decided, and where there is no such time.
    pub fn is_over(&self) -> bool {
        if self.until_decided && self.ladder.is_over() {
            return true;
        }
        let goes_on = self.time < self.whole.span && self.log.is_finite();
        !goes_on || !self.whole.span.is_finite()
    }

    /// The exponent, unless the orbit was not finished, and the samples.
    pub fn result(self) -> Growth {
        let complete = self.whole.span > 0.0 && self.time >= self.whole.span && self.log.is_finite();
        let lyapunov = complete.then(|| Lyapunov {
            exponent: self.log / self.time,
            exponent_half: self.exponent_half.unwrap_or(f64::NAN),
            mean_rate: self.whole.mean(),
            mean_rate_half: self.half.mean(),
            time: self.time,
        });
        Growth { lyapunov, logs: self.logs, evidence: self.ladder.seen, finite: self.log.is_finite() }
    }
}

/// ∫ w(t/T) d ln|δ| / ∫ w(t/T) dt with w at the middle of each step.
struct WeightedRate {
    /// T.
    span: f64,
    sum: f64,
    weights: f64,
}

impl WeightedRate {
    #[inline(always)]
    fn take(&mut self, start: f64, end: f64, growth: f64) {
        let weight = bump(f64::midpoint(start, end) / self.span);
        self.sum += weight * growth;
        self.weights += weight * (end - start);
    }

    /// NaN if no step has its middle in the span.
    fn mean(&self) -> f64 {
        self.sum / self.weights
    }
}
