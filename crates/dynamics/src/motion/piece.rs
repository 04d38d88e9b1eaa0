//! A piece of a step with its polynomials in its own time y ∈ [0, 1].

use crate::field::{HeavyTop, State};
use crate::integrator::TaylorStep;

/// The part a ≤ x ≤ b of a step, short enough that the body turns by no more than about a radian.
#[derive(Clone, Debug)]
pub(super) struct StepPiece<'a> {
    pub step: &'a TaylorStep,
    /// Where in the step it begins and ends.
    pub ends: [f64; 2],
}

impl<'a> StepPiece<'a> {
    /// Cuts the part a ≤ x ≤ b of a step into equal pieces.
    pub fn cut(top: &HeavyTop, step: &'a TaylorStep, [a, b]: [f64; 2]) -> impl Iterator<Item = Self> + use<'a> {
        let largest = |v: [f64; 3]| v.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        let speeds = step.coefficients().iter().map(|c| largest(top.angular_velocity(c.l)));
        let turn = speeds.fold(0.0, |sum, speed| sum + speed) * step.length() * (b - a);
        let count = turn.ceil().clamp(1.0, f64::from(u32::MAX));
        let at = move |k: f64| if k == count { b } else { a + (b - a) * (k / count) };
        let numbers = std::iter::successors(Some(0.0), move |k| Some(k + 1.0)).take_while(move |k| *k < count);
        numbers.map(move |k| Self { step, ends: [at(k), at(k + 1.0)] })
    }

    /// Its length in time.
    pub fn duration(&self) -> f64 {
        self.step.length() * (self.ends[1] - self.ends[0])
    }

    /// The state at y ∈ [0, 1].
    pub fn state(&self, y: f64) -> State {
        let [a, b] = self.ends;
        self.step.state(a + (b - a) * y)
    }

    /// Coefficients in powers of y.
    pub fn coefficients(&self) -> Vec<State> {
        let mut c = self.step.coefficients().to_vec();
        let [a, b] = self.ends;
        if a != 0.0 {
            // p(x + a) by repeated synthetic division.
            for i in 0..c.len() {
                for j in (i..c.len() - 1).rev() {
                    for m in 0..3 {
                        c[j].gamma[m] += a * c[j + 1].gamma[m];
                        c[j].l[m] += a * c[j + 1].l[m];
                    }
                }
            }
        }
        if b - a != 1.0 {
            let mut power = 1.0;
            for x in &mut c {
                x.gamma = x.gamma.map(|x| power * x);
                x.l = x.l.map(|x| power * x);
                power *= b - a;
            }
        }
        c
    }
}
