//! How a tangent vector grows along an orbit, and what the orbit averages to.

use std::f64::consts::LN_2;

use super::average::bump;
use super::growth::{Course, Growth, Lyapunov};
use super::ladder::Ladder;
use super::passed::Passed;

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
    pub fn new(orbit: u32, course: &Course) -> Self {
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
    pub fn take(&mut self, course: &Course, step: &Passed) {
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

    /// Has it the time asked for, or what is to be found in it, or is there none to be had?
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
