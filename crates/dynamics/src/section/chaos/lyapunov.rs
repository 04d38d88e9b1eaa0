//! The largest Lyapunov exponent of finite-time orbits, from the variational equations.

use std::sync::atomic::Ordering;

use pulp::{Simd, WithSimd};

use super::direction::{momentum_unit, tangent_vector};
use super::growth::{Course, Growth, Lyapunov};
use super::passed::Passed;
use super::stretching::Stretching;
use crate::field::{Dimension, HeavyTop, State};
use crate::integrator::taylor::{InstructionSet, Lanes, Moments, Tangent, lane_values};
use crate::integrator::{DEFAULT_TOLERANCE, check_tolerance};
use crate::section::error::SectionError;
use crate::section::workers::{Monitor, Turns, run_workers};

/// How the variational equations are integrated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChaosOptions {
    /// Truncation error of a step of the orbit, as of a [sweep](crate::section::SweepOptions).
    pub tolerance: f64,
    /// SIMD instructions; they do not change the results.
    pub instructions: InstructionSet,
}

impl Default for ChaosOptions {
    fn default() -> Self {
        Self { tolerance: DEFAULT_TOLERANCE, instructions: InstructionSet::Best }
    }
}

/// The exponents of the orbits that begin at these states, each over its own time: [`growths`] without more.
///
/// # Errors
/// Those of [`growths`].
pub fn lyapunov_exponents(
    top: &HeavyTop,
    starts: &[(State, f64)],
    options: &ChaosOptions,
    monitor: &Monitor,
) -> Result<Vec<Option<Lyapunov>>, SectionError> {
    let courses: Vec<Course> =
        starts.iter().map(|&(start, time)| Course { start, time, ..Course::default() }).collect();
    Ok(growths(top, courses, options, monitor)?.into_iter().map(|growth| growth.lyapunov).collect())
}

/// The growth of a tangent vector along each course.
///
/// The orbits are those of [`sweep`](crate::section::sweep) with the same tolerance, step by
/// step and bit for bit; the result does not depend on threads or instructions either.
///
/// # Errors
/// [`SectionError::Tolerance`] for a tolerance out of range, [`SectionError::InstructionSet`] if this processor lacks the
/// instructions, [`SectionError::Parameter`] for 2³² orbits or more.
pub fn growths(
    top: &HeavyTop,
    mut courses: Vec<Course>,
    options: &ChaosOptions,
    monitor: &Monitor,
) -> Result<Vec<Growth>, SectionError> {
    check_tolerance(options.tolerance)?;
    if u32::try_from(courses.len()).is_err() {
        let (value, expected) = (courses.len() as f64, "fewer than 2^32 are possible");
        return Err(SectionError::Parameter { name: "orbits", value, expected });
    }
    let arch = options.instructions.arch().ok_or(SectionError::InstructionSet(options.instructions))?;
    let units = top.units();
    for course in &mut courses {
        course.start = course.start.reduced(units);
        course.time = units.reduce(course.time, Dimension::TIME);
        course.unit = units.reduce(course.unit, Dimension::TIME);
        course.at.iter_mut().for_each(|time| *time = units.reduce(*time, Dimension::TIME));
    }
    let (top, courses) = (&top.reduced(), &courses[..]);
    let turns = Turns::new(monitor);
    let tolerance = options.tolerance;
    let found = run_workers(|| arch.dispatch(Worker { top, courses, turns: &turns, tolerance }));
    let mut growths = vec![Growth::default(); courses.len()];
    for (orbit, growth) in found {
        growths[orbit as usize] = growth.restored(units);
    }
    Ok(growths)
}

/// One thread's share: fills its lanes from the list until that is empty.
struct Worker<'a> {
    top: &'a HeavyTop,
    courses: &'a [Course],
    turns: &'a Turns<'a>,
    tolerance: f64,
}

impl Worker<'_> {
    fn pop(&self) -> Option<Stretching> {
        let (orbit, course) = self.turns.next(self.courses)?;
        Some(Stretching::new(orbit, course))
    }

    /// Puts an orbit into a lane. An idle lane keeps what it has; nobody looks at it.
    #[inline(always)]
    fn load<S: Simd>(&self, lanes: &mut Lanes<S>, tangent: &mut Tangent<S>, lane: usize, orbit: u32) {
        let start = &self.courses[orbit as usize].start;
        let momentum_scale = self.top.momentum_scale(self.top.energy(start)).max(f64::MIN_POSITIVE.sqrt());
        lanes.load(lane, start, momentum_scale);
        let unit = momentum_unit(self.top, start);
        tangent.load(lane, &tangent_vector(self.top, start, unit), unit);
    }
}

impl WithSimd for Worker<'_> {
    type Output = Vec<(u32, Growth)>;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> Self::Output {
        let mut done = Vec::new();
        let powers = Moments::new();
        let mut lanes = Lanes::<S>::new(simd, self.top, self.tolerance);
        let mut tangent = Tangent::<S>::new(simd);
        let mut orbits: Vec<Option<Stretching>> = Vec::new();
        for lane in 0..S::F64_LANES {
            orbits.push(self.pop());
            if let Some(orbit) = &orbits[lane] {
                self.load(&mut lanes, &mut tangent, lane, orbit.orbit);
            }
        }
        while orbits.iter().any(Option::is_some) {
            lanes.expand(simd);
            tangent.advance(simd, &lanes);
            let moments = lanes.gamma_moments(simd, &powers);
            let moments = lane_values::<S>(moments.as_flattened());
            for (lane, slot) in orbits.iter_mut().enumerate() {
                if let Some(orbit) = slot {
                    let course = &self.courses[orbit.orbit as usize];
                    let step = Passed {
                        time: lanes.end_of(lane),
                        length: lanes.step_of(lane),
                        length_squared: tangent.length_squared(lane),
                        power: tangent.renormalise(lane),
                        moments: std::array::from_fn(|j| {
                            std::array::from_fn(|i| moments[(3 * j + i) * S::F64_LANES + lane])
                        }),
                    };
                    orbit.take(course, &step);
                }
            }
            lanes.commit(simd);
            let stopped = self.turns.monitor.is_stopped();
            for (lane, slot) in orbits.iter_mut().enumerate() {
                if let Some(orbit) = slot.take_if(|orbit| orbit.is_over() || stopped) {
                    done.push((orbit.orbit, orbit.result()));
                    self.turns.monitor.orbits.fetch_add(1, Ordering::Relaxed);
                    *slot = self.pop();
                    if let Some(orbit) = slot {
                        self.load(&mut lanes, &mut tangent, lane, orbit.orbit);
                    }
                }
            }
        }
        done
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::integrator::Taylor;

    #[test]
    fn the_growth_is_that_of_a_difference_of_orbits() {
        // (x(t; x₀ + εδ) − x(t; x₀ − εδ))/2ε → δ(t) with an error of ε² times the curvature of the flow.
        let top = HeavyTop::from_f64([2.0, 1.1, 1.0], [0.94868, 0.0, 0.61623]);
        let start = State { gamma: [0.36, -0.48, -0.8], l: [0.9, -2.1, 1.7] };
        let scale_of_l = momentum_unit(&top, &start);
        let delta = tangent_vector(&top, &start, scale_of_l);
        let found = lyapunov_exponents(&top, &[(start, 30.0)], &ChaosOptions::default(), &Monitor::default());
        let found = found.unwrap()[0].unwrap();
        let epsilon = 1e-6;
        let end = |sign: f64| {
            let moved = |x: [f64; 3], d: [f64; 3]| std::array::from_fn(|i| x[i] + sign * epsilon * d[i]);
            let state = State { gamma: moved(start.gamma, delta.gamma), l: moved(start.l, delta.l) };
            let mut stepper = Taylor::new(&top, &state, DEFAULT_TOLERANCE).unwrap();
            loop {
                let step = stepper.step().unwrap();
                if step.end().seconds() >= found.time {
                    return step.state((found.time - step.start().seconds()) / step.length());
                }
            }
        };
        let (plus, minus) = (end(1.0), end(-1.0));
        let squared = |x: [f64; 3], y: [f64; 3]| (0..3).map(|i| (x[i] - y[i]) * (x[i] - y[i])).sum::<f64>();
        let size = squared(plus.gamma, minus.gamma) + squared(plus.l, minus.l) / (scale_of_l * scale_of_l);
        let growth = size.sqrt() / (2.0 * epsilon);
        assert!((libm::log(growth) - found.exponent * found.time).abs() < 1e-6, "{growth} {found:?}");
        assert!(growth > 5.0);
    }
}
