//! Why a section cannot be computed.

use std::sync::atomic::{AtomicBool, Ordering};

use thiserror::Error;

use crate::integrator::ToleranceError;
use crate::integrator::taylor::InstructionSet;

/// Why a section cannot be computed.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum SectionError {
    /// r = 0.
    #[error("r = 0: S = ⟨ω, r×γ⟩ vanishes identically, so that this section does not exist")]
    WeightlessBody,
    /// A parameter is NaN or infinite, or out of its range.
    #[error("{name} = {value} is not usable; {expected}")]
    Parameter {
        /// Its name.
        name: &'static str,
        /// Its value.
        value: f64,
        /// What would be right.
        expected: &'static str,
    },
    /// The integrator's tolerance is out of range.
    #[error(transparent)]
    Tolerance(#[from] ToleranceError),
    /// No accessible point was found.
    #[error("no accessible point: U_l > h = {h} in all of {tried} places; the lowest U_l seen is {lowest}")]
    Inaccessible {
        /// Energy.
        h: f64,
        /// Lowest value of the effective potential seen.
        lowest: f64,
        /// How many places were tried.
        tried: u64,
    },
    /// A seed lies outside the accessible region.
    #[error("(ϑ', ψ') = ({theta}, {psi}) is not accessible: U_l = {potential} > h = {h}")]
    SeedInaccessible {
        /// ϑ'.
        theta: f64,
        /// ψ'.
        psi: f64,
        /// U_l there.
        potential: f64,
        /// Energy.
        h: f64,
    },
    /// This processor lacks the instructions that were asked for.
    #[error("this processor does not have the {0:?} instructions")]
    InstructionSet(InstructionSet),
    /// The work was cancelled before it had a result.
    #[error("interrupted")]
    Interrupted,
}

/// Refuses h and l that are not numbers.
pub(super) fn check_finite(h: f64, l: f64) -> Result<(), SectionError> {
    for (name, value) in [("h", h), ("l", l)] {
        if !value.is_finite() {
            return Err(SectionError::Parameter { name, value, expected: "a finite number is needed" });
        }
    }
    Ok(())
}

/// Refuses more orbits than can be numbered.
pub(super) fn check_count(orbits: usize) -> Result<(), SectionError> {
    if u32::try_from(orbits).is_ok() {
        return Ok(());
    }
    let (value, expected) = (orbits as f64, "fewer than 2^32 are possible");
    Err(SectionError::Parameter { name: "orbits", value, expected })
}

/// Fails if the work was cancelled.
pub(super) fn check_stop(stop: Option<&AtomicBool>) -> Result<(), SectionError> {
    if stop.is_some_and(|stop| stop.load(Ordering::Relaxed)) { Err(SectionError::Interrupted) } else { Ok(()) }
}
