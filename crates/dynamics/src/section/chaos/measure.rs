//! Both measures of the orbits of a section, and the verdict.

use super::growth::{Growth, Lyapunov, TangentCourse};
use super::lyapunov::{ChaosOptions, growths};
use super::rotation::{FEWEST_RETURNS, RotationNumber, RotationUndefined, rotation_number};
use super::verdict::Judgement;
use super::verdict::{OpenReason, UNIT};
use crate::field::State;
use crate::section::error::SectionError;
use crate::section::orbit::{OrbitEnd, OrbitSection};
use crate::section::torus::PpTorus;
use crate::section::workers::Monitor;

/// How regular an orbit is.
#[derive(Clone, Debug, PartialEq)]
pub struct ChaosMeasure {
    /// Number of the orbit.
    pub orbit: u32,
    /// Of the orbit from its first point to its last; None for an orbit of no duration, for one with fewer returns than a
    /// rotation number needs, over which a rate is not a mean, and for an unfinished orbit.
    pub lyapunov: Option<Lyapunov>,
    /// From its incoming crossings, or why it is undefined.
    pub rotation: Result<RotationNumber, RotationUndefined>,
    /// Regular, chaotic or open.
    pub judgement: Judgement,
    /// λ(t) = ln(|δ(t)|/|δ(0)|)/t at each crossing; NaN at the first one, where t = 0, and where the tangent vector did
    /// not come.
    pub running: Vec<f64>,
}

/// The measures of orbits found by [`sweep`](crate::section::sweep), in their order.
///
/// The orbits are integrated once more, from the first point of each over the time that the sweep took it. This takes about
/// three times as long as the sweep.
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
    let with_times = |orbit: &OrbitSection| {
        let begin = orbit.points.first().map_or(0.0, |first| first.time);
        TangentCourse { at: orbit.points.iter().map(|point| point.time - begin).collect(), ..course(orbit) }
    };
    let growths = growths(torus.top(), orbits.iter().map(with_times).collect(), options, monitor)?;
    let stopped = monitor.is_stopped();
    let measure = |(orbit, growth): (&OrbitSection, Growth)| ChaosMeasure {
        orbit: orbit.orbit,
        // Every other crossing returns to the incoming half.
        lyapunov: growth.lyapunov.filter(|_| orbit.points.len() > 2 * FEWEST_RETURNS),
        rotation: if stopped { Err(RotationUndefined::Interrupted) } else { rotation_number(&orbit.points) },
        judgement: match (orbit.report.end, growth.lyapunov) {
            (OrbitEnd::StaysOnSection, _) => Judgement::open(OpenReason::StaysOnSection),
            (_, None) => Judgement::open(OpenReason::Unfinished),
            _ => judge(orbit, &growth),
        },
        running: running(orbit, &growth.logs),
    };
    Ok(orbits.iter().zip(growths).map(measure).collect())
}

/// The verdicts alone, in the order of the orbits: those of [`chaos_measures`], for less work. Each tangent vector is followed only
/// until the verdict is found.
///
/// # Errors
/// Those of [`growths`].
pub fn verdicts(
    torus: &PpTorus,
    orbits: &[OrbitSection],
    options: &ChaosOptions,
    monitor: &Monitor,
) -> Result<Vec<Judgement>, SectionError> {
    let until_decided = |orbit: &OrbitSection| TangentCourse { until_decided: true, ..course(orbit) };
    let growths = growths(torus.top(), orbits.iter().map(until_decided).collect(), options, monitor)?;
    let stopped = monitor.is_stopped();
    let judge = |(orbit, growth): (&OrbitSection, &Growth)| match orbit.report.end {
        OrbitEnd::StaysOnSection => Judgement::open(OpenReason::StaysOnSection),
        _ if stopped || !growth.finite => Judgement::open(OpenReason::Unfinished),
        _ => judge(orbit, growth),
    };
    Ok(orbits.iter().zip(&growths).map(judge).collect())
}

/// The course of an orbit from its first point, without times of its own.
fn course(orbit: &OrbitSection) -> TangentCourse {
    let Some(first) = orbit.points.first() else {
        return TangentCourse::default();
    };
    TangentCourse {
        start: State { gamma: first.gamma, l: first.l },
        time: orbit.report.time - first.time,
        unit: orbit.points.get(UNIT).map_or(0.0, |point| point.time - first.time),
        ..TangentCourse::default()
    }
}

/// The verdict on an orbit.
fn judge(orbit: &OrbitSection, growth: &Growth) -> Judgement {
    let points = &orbit.points;
    let begin = points.first().map_or(0.0, |first| first.time);
    let crossing_at = |time: f64| {
        let passed = points.partition_point(|point| point.time - begin <= time);
        points[passed.saturating_sub(1)].index
    };
    Judgement::new(&growth.evidence, points.len().saturating_sub(1), crossing_at)
}

/// λ(t) at each crossing.
fn running(orbit: &OrbitSection, logs: &[f64]) -> Vec<f64> {
    let begin = orbit.points.first().map_or(0.0, |first| first.time);
    let log = |i: usize| logs.get(i).copied().unwrap_or(f64::NAN);
    // At the beginning 0/0.
    orbit.points.iter().enumerate().map(|(i, point)| log(i) / (point.time - begin)).collect()
}
