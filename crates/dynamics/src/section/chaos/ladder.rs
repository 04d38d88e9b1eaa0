//! The times at which an orbit is tested.

use std::collections::VecDeque;
use std::f64::consts::SQRT_2;

use super::averages::MeanWindow;
use super::averages::TangentStep;
use super::verdict::{Evidence, first_decision};
use crate::field::{norm, sub};

/// A spread of γ below this is taken as this.
pub(super) const NARROW: f64 = 1e-5;
/// Where the two windows of a look begin and end, as parts of the time until then. The beginning of the orbit is left out, so that
/// few looks are in progress at one time.
const PARTS: [f64; 3] = [0.25, 0.625, 1.0];
/// Looks at an orbit.
const LOOKS: u32 = 24;

/// Looks at the times `unit` · 2^{k/2}, k = 0, 1, …, [`LOOKS`] − 1: they depend on nothing that comes after them.
#[derive(Clone, Debug, Default)]
pub(super) struct Ladder {
    unit: f64,
    /// Looks that were begun.
    begun: u32,
    open: VecDeque<Look>,
    /// Looks that are over.
    pub seen: Vec<Evidence>,
    decided: bool,
}

/// A look in progress.
#[derive(Clone, Copy, Debug)]
struct Look {
    time: f64,
    windows: [MeanWindow; 2],
}

impl Ladder {
    /// Without a positive unit there is no look.
    pub fn new(unit: f64) -> Self {
        Self { unit, begun: if unit > 0.0 { 0 } else { LOOKS }, ..Self::default() }
    }

    /// True when there is nothing more to see.
    pub fn is_over(&self) -> bool {
        self.decided || self.begun == LOOKS && self.open.is_empty()
    }

    /// Goes over a step, on which ln|δ| grew by `growth` to `log`.
    #[inline]
    pub fn take(&mut self, step: &TangentStep, growth: f64, log: f64) {
        while self.begun < LOOKS && PARTS[0] * self.time_of(self.begun) < step.time {
            self.open.push_back(Look::new(self.time_of(self.begun)));
            self.begun += 1;
        }
        for look in &mut self.open {
            look.windows.iter_mut().for_each(|window| window.take(step, growth));
        }
        while let Some(look) = self.open.front().filter(|look| look.time <= step.time) {
            self.seen.push(look.evidence(log));
            self.open.pop_front();
            self.decided |= first_decision(&self.seen).is_some();
        }
    }

    /// The time of look k.
    fn time_of(&self, k: u32) -> f64 {
        let whole = self.unit * f64::from(1_u32 << (k / 2));
        if k.is_multiple_of(2) { whole } else { whole * SQRT_2 }
    }
}

impl Look {
    fn new(time: f64) -> Self {
        let [begin, middle, end] = PARTS.map(|part| part * time);
        Self { time, windows: [MeanWindow::new(begin, middle), MeanWindow::new(middle, end)] }
    }

    fn evidence(&self, log: f64) -> Evidence {
        let [first, second] = self.windows.map(|window| window.gamma());
        let mean: [f64; 3] = std::array::from_fn(|i| 0.5 * (first[i] + second[i]));
        // The mean square of γ − its mean, where |γ| = 1.
        let spread = (1.0 - norm(mean) * norm(mean)).max(0.0).sqrt().max(NARROW);
        Evidence {
            time: self.time,
            apart: norm(sub(first, second)) / spread,
            growth: self.windows.map(|window| window.growth()),
            log,
        }
    }
}
