//! How regular an orbit is: a finite-time Lyapunov exponent and a rotation number, each with its convergence.

mod average;
mod curve;
mod lyapunov;
mod plane;
mod rotation;

pub use lyapunov::{Lyapunov, lyapunov_exponents};
pub use rotation::{Rotation, RotationAngle, RotationUndefined, rotation_number};

use super::error::SectionError;
use super::sweep::{Monitor, OrbitSection};
use super::torus::PpTorus;
use crate::field::State;
use crate::integrator::taylor::InstructionSet;

/// How the variational equations are integrated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChaosOptions {
    /// Truncation error of a step of the orbit, as of [`Method::Taylor`](crate::integrator::Method::Taylor).
    pub tolerance: f64,
    /// SIMD instructions; they do not change the results.
    pub instructions: InstructionSet,
}

impl Default for ChaosOptions {
    fn default() -> Self {
        Self { tolerance: 1e-15, instructions: InstructionSet::Best }
    }
}

/// How regular an orbit is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChaosMeasure {
    /// Number of the orbit.
    pub orbit: u32,
    /// Of the orbit from its first point to its last; None for an orbit of no duration or one that was not finished.
    pub lyapunov: Option<Lyapunov>,
    /// Of its incoming crossings, or why there is none.
    pub rotation: Result<Rotation, RotationUndefined>,
}

/// The measures of orbits found by [`sweep`](super::sweep), in their order.
///
/// The orbits are integrated once more, with the Taylor integrator whatever the sweep's method was, from the first
/// point of each over the time that the sweep took it. This takes about three times as long as the sweep.
///
/// `monitor` counts orbits and can stop the work; what was not finished then has no exponent.
///
/// # Errors
/// Those of [`lyapunov_exponents`].
pub fn chaos_measures(
    torus: &PpTorus,
    orbits: &[OrbitSection],
    options: &ChaosOptions,
    monitor: &Monitor,
) -> Result<Vec<ChaosMeasure>, SectionError> {
    let course = |orbit: &OrbitSection| match orbit.points.first() {
        Some(first) => (State { gamma: first.gamma, l: first.l }, orbit.report.time - first.time),
        None => (State::default(), 0.0),
    };
    let courses: Vec<(State, f64)> = orbits.iter().map(course).collect();
    let exponents = lyapunov_exponents(torus.top(), &courses, options, monitor)?;
    let measure = |(orbit, lyapunov): (&OrbitSection, Option<Lyapunov>)| ChaosMeasure {
        orbit: orbit.orbit,
        lyapunov,
        rotation: rotation_number(&orbit.points),
    };
    Ok(orbits.iter().zip(exponents).map(measure).collect())
}
