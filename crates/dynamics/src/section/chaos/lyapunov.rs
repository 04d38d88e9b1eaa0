//! The largest Lyapunov exponent of finite-time orbits, from the variational equations and their first tangent vector.

use std::sync::atomic::Ordering;

use pulp::{Simd, WithSimd};

use super::averages::TangentStep;
use super::growth::Stretching;
use super::growth::{Growth, Lyapunov, TangentCourse};
use crate::field::{Dimension, HeavyTop, State, dot};
use crate::integrator::taylor::{InstructionSet, Lanes, MOMENTS, Moments, TangentLanes, lane_values};
use crate::integrator::{DEFAULT_TOLERANCE, check_tolerance};
use crate::section::error::{SectionError, check_count};
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
    let courses: Vec<TangentCourse> =
        starts.iter().map(|&(start, time)| TangentCourse { start, time, ..TangentCourse::default() }).collect();
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
    mut courses: Vec<TangentCourse>,
    options: &ChaosOptions,
    monitor: &Monitor,
) -> Result<Vec<Growth>, SectionError> {
    check_tolerance(options.tolerance)?;
    check_count(courses.len())?;
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
    let found = run_workers(|| arch.dispatch(GrowthWorker { top, courses, turns: &turns, tolerance }));
    let mut growths = vec![Growth::default(); courses.len()];
    for (orbit, growth) in found {
        growths[orbit as usize] = growth.restored(units);
    }
    Ok(growths)
}

/// One thread's share: fills its lanes from the list until that is empty.
struct GrowthWorker<'a> {
    top: &'a HeavyTop,
    courses: &'a [TangentCourse],
    turns: &'a Turns<'a>,
    tolerance: f64,
}

impl GrowthWorker<'_> {
    fn pop(&self) -> Option<Stretching> {
        let (orbit, course) = self.turns.next(self.courses)?;
        Some(Stretching::new(orbit, course))
    }

    /// Puts an orbit into a lane. An idle lane keeps its contents, which are never read.
    #[inline(always)]
    fn load<S: Simd>(&self, lanes: &mut Lanes<S>, tangent: &mut TangentLanes<S>, lane: usize, orbit: u32) {
        let start = &self.courses[orbit as usize].start;
        load_orbit(lanes, self.top, lane, start);
        load_tangent(tangent, self.top, lane, start);
    }
}

impl WithSimd for GrowthWorker<'_> {
    type Output = Vec<(u32, Growth)>;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> Self::Output {
        let mut done = Vec::new();
        let powers = Moments::new();
        let mut lanes = Lanes::<S>::new(simd, self.top, self.tolerance);
        let mut tangent = TangentLanes::<S>::new(simd);
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
            let moments = lanes.gamma_moments::<MOMENTS>(simd, &powers);
            let moments = lane_values::<S>(moments.as_flattened());
            for (lane, slot) in orbits.iter_mut().enumerate() {
                if let Some(orbit) = slot {
                    let course = &self.courses[orbit.orbit as usize];
                    let step = TangentStep {
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

/// Puts an orbit into a lane.
#[inline(always)]
pub(super) fn load_orbit<S: Simd>(lanes: &mut Lanes<S>, top: &HeavyTop, lane: usize, start: &State) {
    lanes.load(lane, start, top.momentum_scale(top.energy(start)));
}

/// Puts its first tangent vector into a lane.
#[inline(always)]
pub(super) fn load_tangent<S: Simd>(tangent: &mut TangentLanes<S>, top: &HeavyTop, lane: usize, start: &State) {
    let unit = momentum_unit(top, start);
    tangent.load(lane, &tangent_vector(top, start, unit), unit);
}

/// √(2 A_max (h + 2|r|)): the unit of δl. (Unlike the largest |l| it does not vanish where the top is at rest.)
pub(super) fn momentum_unit(top: &HeavyTop, state: &State) -> f64 {
    top.momentum_scale(top.energy(state) + top.center_norm())
}

/// A vector of length 1 tangent to the surface of constant H, ⟨γ,γ⟩ and ⟨γ,l⟩, with l in units of `momentum_unit`.
///
/// It is the projection of one fixed vector, chosen with no symmetry, so that it has a share of every direction.
pub(super) fn tangent_vector(top: &HeavyTop, state: &State, momentum_unit: f64) -> State {
    const DIRECTION: [f64; 6] = [0.57, -0.31, 0.43, 0.37, 0.29, -0.41];
    let State { gamma, l } = *state;
    let omega = top.angular_velocity(l);
    let r = top.center();
    // The gradients in (γ, l/unit).
    let mut normals: [[f64; 6]; 3] = [[0.0; 6]; 3];
    for i in 0..3 {
        (normals[0][i], normals[1][i], normals[2][i]) = (gamma[i], l[i], -r[i]);
        (normals[1][i + 3], normals[2][i + 3]) = (momentum_unit * gamma[i], momentum_unit * omega[i]);
    }
    let mut vector = DIRECTION;
    for k in 0..3 {
        let size = length(&normals[k]);
        for j in 0..k {
            normals[k] = without(normals[k], &normals[j]);
        }
        // At a relative equilibrium the gradients are dependent.
        let rest = length(&normals[k]);
        let factor = if rest > size * 1e-12 { 1.0 / rest } else { 0.0 };
        normals[k] = normals[k].map(|x| x * factor);
    }
    // Twice: once would leave the rounding of the cancelled part.
    for normal in normals.iter().chain(&normals) {
        vector = without(vector, normal);
    }
    let [a, b, c, d, e, f] = vector.map(|x| x / length(&vector));
    State { gamma: [a, b, c], l: [d, e, f].map(|x| x * momentum_unit) }
}

/// v − n⟨n,v⟩.
fn without(mut v: [f64; 6], n: &[f64; 6]) -> [f64; 6] {
    let share: f64 = v.iter().zip(n).map(|(a, b)| a * b).sum();
    for (a, b) in v.iter_mut().zip(n) {
        *a -= share * b;
    }
    v
}

fn length(v: &[f64; 6]) -> f64 {
    let [a, b, c, d, e, f] = *v;
    (dot([a, b, c], [a, b, c]) + dot([d, e, f], [d, e, f])).sqrt()
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

    #[test]
    fn tangent_vectors_keep_the_integrals_and_have_length_1() {
        let top = HeavyTop::from_f64([2.0, 1.1, 1.0], [0.94868, 0.0, 0.61623]);
        for k in 0..50 {
            let x = |step: f64| 2.0 * (f64::from(k) * step % 1.0) - 1.0;
            let gamma = [x(0.41), x(0.73), x(0.27)];
            let size = dot(gamma, gamma).sqrt();
            let state = State { gamma: gamma.map(|g| g / size), l: [3.0 * x(0.13), 3.0 * x(0.59), 3.0 * x(0.87)] };
            let scale = top.momentum_scale(top.energy(&state));
            let vector = tangent_vector(&top, &state, scale);
            let momentum = vector.l.map(|x| x / scale);
            assert!((dot(vector.gamma, vector.gamma) + dot(momentum, momentum) - 1.0).abs() < 1e-14);
            assert!(dot(state.gamma, vector.gamma).abs() < 1e-14);
            assert!((dot(state.gamma, vector.l) + dot(state.l, vector.gamma)).abs() < 1e-13 * scale);
            let energy = dot(top.angular_velocity(state.l), vector.l) - dot(top.center(), vector.gamma);
            assert!(energy.abs() < 1e-13 * scale * scale, "{energy:e}");
        }
    }
}
