//! Both measures of the orbits of a section, and the verdict.

use super::growth::{Course, Growth, Lyapunov, Sample};
use super::lyapunov::{ChaosOptions, growths};
use super::rotation::{Rotation, RotationUndefined, rotation_number};
use super::verdict::{Judgement, Open, judge};
use crate::field::State;
use crate::section::error::SectionError;
use crate::section::orbit::{End, OrbitSection};
use crate::section::torus::PpTorus;
use crate::section::workers::Monitor;

/// How regular an orbit is.
#[derive(Clone, Debug, PartialEq)]
pub struct ChaosMeasure {
    /// Number of the orbit.
    pub orbit: u32,
    /// Of the orbit from its first point to its last; None for an orbit of no duration or one that was not finished.
    pub lyapunov: Option<Lyapunov>,
    /// Of its incoming crossings, or why there is none.
    pub rotation: Result<Rotation, RotationUndefined>,
    /// Regular, chaotic or open.
    pub judgement: Judgement,
    /// λ(t) = ln(|δ(t)|/|δ(0)|)/t at each crossing; NaN at the first one, where t = 0, and where the tangent vector did
    /// not come.
    pub running: Vec<f64>,
}

/// The measures of orbits found by [`sweep`](crate::section::sweep), in their order.
///
/// The orbits are integrated once more, with the Taylor integrator whatever the sweep's method was, from the first
/// point of each over the time that the sweep took it. This takes about three times as long as the sweep.
///
/// `monitor` counts orbits and can stop the work; what was not finished then has no exponent and no rotation number.
///
/// # Errors
/// Those of [`growths`].
pub fn chaos_measures(
    torus: &PpTorus,
    orbits: &[OrbitSection],
    options: &ChaosOptions,
    monitor: &Monitor,
) -> Result<Vec<ChaosMeasure>, SectionError> {
    let course = |orbit: &OrbitSection| match orbit.points.first() {
        Some(first) => Course {
            start: State { gamma: first.gamma, l: first.l },
            time: orbit.report.time - first.time,
            at: orbit.points.iter().map(|point| point.time - first.time).collect(),
        },
        None => Course::default(),
    };
    let growths = growths(torus.top(), orbits.iter().map(course).collect(), options, monitor)?;
    let stopped = monitor.is_stopped();
    let measure = |(orbit, growth): (&OrbitSection, Growth)| ChaosMeasure {
        orbit: orbit.orbit,
        lyapunov: growth.lyapunov,
        rotation: if stopped { Err(RotationUndefined::Interrupted) } else { rotation_number(&orbit.points) },
        judgement: match (orbit.report.end, growth.lyapunov) {
            (End::StaysOnSection, _) => Judgement::open(Open::StaysOnSection),
            (_, None) => Judgement::open(Open::Unfinished),
            _ => judge(&orbit.points, &growth.samples),
        },
        running: running(orbit, &growth.samples),
    };
    Ok(orbits.iter().zip(growths).map(measure).collect())
}

/// λ(t) at each crossing.
fn running(orbit: &OrbitSection, samples: &[Sample]) -> Vec<f64> {
    let begin = orbit.points.first().map_or(0.0, |first| first.time);
    let log = |i: usize| samples.get(i).map_or(f64::NAN, |sample| sample.log);
    // At the beginning 0/0.
    orbit.points.iter().enumerate().map(|(i, point)| log(i) / (point.time - begin)).collect()
}
