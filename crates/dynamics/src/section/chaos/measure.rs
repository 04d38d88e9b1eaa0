//! Both measures of the orbits of a section.

use super::lyapunov::{ChaosOptions, Lyapunov, lyapunov_exponents};
use super::rotation::{Rotation, RotationUndefined, rotation_number};
use crate::field::State;
use crate::section::error::SectionError;
use crate::section::orbit::OrbitSection;
use crate::section::torus::PpTorus;
use crate::section::workers::Monitor;

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

/// The measures of orbits found by [`sweep`](crate::section::sweep), in their order.
///
/// The orbits are integrated once more, with the Taylor integrator whatever the sweep's method was, from the first
/// point of each over the time that the sweep took it. This takes about three times as long as the sweep.
///
/// `monitor` counts orbits and can stop the work; what was not finished then has no exponent and no rotation number.
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
        rotation: if monitor.is_stopped() {
            Err(RotationUndefined::Interrupted)
        } else {
            rotation_number(&orbit.points)
        },
    };
    Ok(orbits.iter().zip(exponents).map(measure).collect())
}
