//! The chaotic share of one component of an energy surface.

use bifdiag_dynamics::section::Monitor;
use bifdiag_dynamics::section::SectionError;
use bifdiag_dynamics::section::chaos::{Decision, DecisionOptions, OrbitVerdict, decisions};
use thiserror::Error;

use crate::liouville::{EnergySurface, SampleError};

/// Orbits judged before the error is checked.
const FIRST: usize = 32;
/// The most orbits that are asked for at once, and the fewest after the first.
const MOST: f64 = 1e9;
const LEAST: usize = 8;
/// So many times the orbits that seem to be missing are asked for, since each round of few orbits leaves lanes idle.
const AMPLE: f64 = 1.05;

/// How a share is measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShareOptions {
    /// The standard deviation that is wanted.
    pub error: f64,
    /// Another choice of the orbits, equally spread.
    pub seed: u64,
    /// How they are followed.
    pub orbits: DecisionOptions,
}

impl Default for ShareOptions {
    fn default() -> Self {
        Self { error: 0.03, seed: 0, orbits: DecisionOptions::default() }
    }
}

/// Why there is no share.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum ShareError {
    /// The component has no orbits.
    #[error(transparent)]
    Sample(#[from] SampleError),
    /// They cannot be followed.
    #[error(transparent)]
    Section(#[from] SectionError),
}

/// Orbits spread evenly in Liouville measure, by their verdicts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Share {
    /// All of them.
    pub orbits: u64,
    /// Those that are chaotic.
    pub chaotic: u64,
    /// Those without a verdict.
    pub open: u64,
    /// How often they crossed the section.
    pub crossings: u64,
}

impl Share {
    /// What was found of these orbits.
    #[must_use]
    pub fn of(decisions: &[Decision]) -> Self {
        decisions.iter().fold(Self::default(), |share, decision| Self {
            orbits: share.orbits + 1,
            chaotic: share.chaotic + u64::from(decision.verdict == OrbitVerdict::Chaotic),
            open: share.open + u64::from(decision.verdict.is_open()),
            crossings: share.crossings + u64::from(decision.crossings),
        })
    }

    /// Both together.
    #[must_use]
    pub fn and(self, other: Self) -> Self {
        Self {
            orbits: self.orbits + other.orbits,
            chaotic: self.chaotic + other.chaotic,
            open: self.open + other.open,
            crossings: self.crossings + other.crossings,
        }
    }

    /// The share of the orbits that are known to be chaotic: with [`open`](Self::open_share) it brackets the whole.
    #[must_use]
    pub fn fraction(self) -> f64 {
        self.chaotic as f64 / self.orbits.max(1) as f64
    }

    /// The share of the orbits without a verdict.
    #[must_use]
    pub fn open_share(self) -> f64 {
        self.open as f64 / self.orbits.max(1) as f64
    }

    /// One standard deviation of [`fraction`](Self::fraction): that of its distribution after k chaotic orbits of n, where before
    /// any share was as likely, √(p(1 − p)/(n + 3)) with p = (k + 1)/(n + 2). It is not 0 where no orbit is chaotic. Orbits
    /// count as independent; as they are spread evenly, the true error is less.
    #[must_use]
    pub fn error(self) -> f64 {
        (self.variance() / (self.orbits as f64 + 3.0)).sqrt()
    }

    /// The variance p(1 − p) of one orbit's verdict, with p = (k + 1)/(n + 2).
    pub(crate) fn variance(self) -> f64 {
        variance(self.chaotic as f64, self.orbits as f64)
    }

    /// Orbits that are still needed to have this error, if the share remains what it is; 0 if it is reached.
    #[must_use]
    pub fn missing(self, error: f64) -> usize {
        if self.orbits == 0 {
            return FIRST;
        }
        if self.error() <= error {
            return 0;
        }
        // With the same chaotic share, the error falls with n.
        let part = self.fraction();
        let (mut few, mut enough) = (self.orbits as f64, MOST);
        while enough - few > 1.0 {
            let middle = 0.5 * (few + enough);
            if variance(part * middle, middle) / (middle + 3.0) > error * error {
                few = middle;
            } else {
                enough = middle;
            }
        }
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to `MOST`")]
        let wanted = (AMPLE * enough).min(MOST) as u64;
        usize::try_from(wanted.saturating_sub(self.orbits)).map_or(LEAST, |more| more.max(LEAST))
    }
}

/// p(1 − p) with p = (k + 1)/(n + 2).
fn variance(chaotic: f64, orbits: f64) -> f64 {
    let p = (chaotic + 1.0) / (orbits + 2.0);
    p * (1.0 - p)
}

/// The share of each component at one point, in their order. Where `monitor` stops the work, all that was begun is open.
///
/// # Errors
/// [`ShareError`].
pub fn shares(surface: &EnergySurface, options: &ShareOptions, monitor: &Monitor) -> Result<Vec<Share>, ShareError> {
    (0..surface.components()).map(|component| share(surface, component, options, monitor)).collect()
}

fn share(
    surface: &EnergySurface,
    component: usize,
    options: &ShareOptions,
    monitor: &Monitor,
) -> Result<Share, ShareError> {
    let (mut share, mut next) = (Share::default(), 0);
    loop {
        let missing = share.missing(options.error);
        if missing == 0 || monitor.is_stopped() {
            return Ok(share);
        }
        let (states, place) = surface.states_from(component, missing, options.seed, next)?;
        next = place;
        share = share.and(Share::of(&decisions(surface.top(), &states, &options.orbits, monitor)?));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_error_is_never_zero_and_falls_like_the_root() {
        let share = |orbits, chaotic| Share { orbits, chaotic, ..Share::default() };
        assert!((share(32, 0).error() - 0.0286).abs() < 1e-4);
        assert!((share(400, 200).error() - 0.0249).abs() < 1e-4);
        assert!((share(10_000, 2500).error() - 0.00433).abs() < 1e-5);
        assert_eq!(share(32, 0).missing(0.03), 0);
        assert_eq!(share(0, 0).missing(0.03), 32);
        // None of 33 more is chaotic, if none was.
        assert!((30..45).contains(&share(32, 0).missing(0.015)));
        assert!((2950..3300).contains(&share(32, 0).missing(1.0 / 3000.0)));
        let mut half = share(32, 16);
        while half.missing(0.03) > 0 {
            let more = half.missing(0.03) as u64;
            half = half.and(share(more, more / 2));
        }
        assert!((270..290).contains(&half.orbits), "{half:?}");
    }
}
