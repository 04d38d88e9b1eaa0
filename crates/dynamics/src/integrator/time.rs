//! Times that do not lose digits late in a run.

use crate::field::{Dimension, Units};

/// s + e = a + b exactly, s the rounded sum (Knuth's TwoSum).
#[inline]
pub(crate) fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let b_part = sum - a;
    let a_part = sum - b_part;
    (sum, (a - a_part) + (b - b_part))
}

/// A time as the unevaluated sum of the nearest double and a remainder.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Instant {
    high: f64,
    low: f64,
}

impl Instant {
    /// high + low, normalised.
    #[must_use]
    #[inline]
    pub fn new(high: f64, low: f64) -> Self {
        let (high, low) = two_sum(high, low);
        Self { high, low }
    }

    /// This time plus an offset.
    #[must_use]
    #[inline]
    pub fn after(self, offset: f64) -> Self {
        let (sum, error) = two_sum(self.high, offset);
        Self::new(sum, error + self.low)
    }

    /// That of a reduced top as that of the top as given.
    #[must_use]
    pub fn restored(self, units: Units) -> Self {
        let given = |time| units.restore(time, Dimension::TIME);
        Self { high: given(self.high), low: given(self.low) }
    }

    /// The nearest double.
    #[must_use]
    #[inline]
    pub fn seconds(self) -> f64 {
        self.high
    }

    /// What [`seconds`](Self::seconds) leaves out.
    #[must_use]
    #[inline]
    pub fn remainder(self) -> f64 {
        self.low
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_million_small_steps_keep_every_digit() {
        let mut t = Instant::default();
        for _ in 0..1_000_000 {
            t = t.after(0.1);
        }
        // The double 0.1 exceeds one tenth by 5.551115123125783e-18.
        assert_eq!(t.seconds(), 100_000.0);
        assert!((t.remainder() - 5.551_115_123_125_783e-12).abs() < 1e-24);
    }
}
