//! Verdicts on many orbits for as little work as each of them needs, from any start and without a section.
//!
//! A tangent vector is taken along from the start. Without it a step would cost three quarters as much, but averages alone decide
//! late: those of thin chaotic layers agree to 1e-5 for thousands of steps.

use std::sync::atomic::Ordering;

use pulp::{Simd, WithSimd};

use super::course::{Course, Decision, MOMENTS, Piece};
use super::lyapunov::{load_orbit, load_tangent};
use super::verdict::{OpenReason, OrbitVerdict};
use crate::field::{Dimension, HeavyTop, State};
use crate::integrator::check_tolerance;
use crate::integrator::taylor::{InstructionSet, LaneVector, Lanes, Moments, TangentLanes, lane_values, state_of};
use crate::section::condition::SectionCondition;
use crate::section::error::{SectionError, check_count};
use crate::section::workers::{Monitor, Turns, run_workers};

/// Steps at the first look; each further look is at √2 times as many.
const FIRST_LOOK: usize = 160;
/// Order of the tangent vector's series. A step is about e⁻² of the radius of convergence, so that order p leaves out e^(−2p) of
/// a vector, which matters for its last digits and not for its growth.
const TANGENT_ORDER: usize = 8;

/// Truncation error of a step. Errors of this size take an orbit off its torus by some 1e-6 in 20,000 steps, as a perturbation
/// does that makes no chaos which could be seen, and the averages of a regular orbit still agree. The series has two thirds of
/// the terms that [`DEFAULT_TOLERANCE`](crate::integrator::DEFAULT_TOLERANCE) needs, for half the work.
const TOLERANCE: f64 = 1e-10;

/// How orbits are followed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DecisionOptions {
    /// Steps of the integrator after which an orbit stays open.
    pub steps: usize,
    /// Truncation error of a step, as of a [sweep](crate::section::SweepOptions).
    pub tolerance: f64,
    /// SIMD instructions; they do not change the results.
    pub instructions: InstructionSet,
}

impl Default for DecisionOptions {
    fn default() -> Self {
        Self { steps: 20_480, tolerance: TOLERANCE, instructions: InstructionSet::Best }
    }
}

/// The verdict on each orbit, in their order. All are of one top; their energies and momenta may differ.
///
/// Regular: the averages settle to 3e-7 of the spread; or a tangent vector grows linearly; or both, less closely.
/// Chaotic: as for [`verdicts`](super::verdicts); or a tangent vector grows steadily and by more than e⁶⁰, and the
/// averages do not settle so closely. The result does not depend on threads or instructions.
///
/// # Errors
/// [`SectionError::Tolerance`] for a tolerance out of range, [`SectionError::InstructionSet`] if this processor lacks the
/// instructions, [`SectionError::Parameter`] for 2³² orbits or more.
pub fn decisions(
    top: &HeavyTop,
    starts: &[State],
    options: &DecisionOptions,
    monitor: &Monitor,
) -> Result<Vec<Decision>, SectionError> {
    check_tolerance(options.tolerance)?;
    check_count(starts.len())?;
    let arch = options.instructions.arch().ok_or(SectionError::InstructionSet(options.instructions))?;
    let units = top.units();
    let (top, looks) = (&top.reduced(), &looks(options.steps)[..]);
    let unfinished =
        Decision { verdict: OrbitVerdict::Open(OpenReason::Unfinished), time: 0.0, crossings: 0, steps: 0 };
    let mut decisions = vec![unfinished; starts.len()];
    let orbits: Vec<(usize, State)> = starts.iter().map(|start| start.reduced(units)).enumerate().collect();
    let (orbits, tolerance, turns) = (&orbits[..], options.tolerance, &Turns::new(monitor));
    for (number, decision) in run_workers(|| arch.dispatch(Worker { top, orbits, looks, tolerance, turns })) {
        decisions[number] = decision;
    }
    for decision in &mut decisions {
        decision.time = units.restore(decision.time, Dimension::TIME);
    }
    Ok(decisions)
}

/// Steps at the looks.
fn looks(most: usize) -> Vec<usize> {
    let mut looks = Vec::new();
    let mut count = FIRST_LOOK;
    while count < most {
        looks.push(count);
        // √2 to three digits, and back to twice the number before the next time.
        let between = count * 1414 / 1000;
        looks.extend((between < most).then_some(between));
        count *= 2;
    }
    looks.push(most);
    looks
}

/// One thread's share: fills its lanes from the list until that is empty.
struct Worker<'a> {
    top: &'a HeavyTop,
    orbits: &'a [(usize, State)],
    looks: &'a [usize],
    tolerance: f64,
    turns: &'a Turns<'a>,
}

impl Worker<'_> {
    /// Puts the next orbit into a lane. An idle lane keeps its contents, which are never read.
    #[inline(always)]
    fn load<S: Simd>(&self, lanes: &mut Lanes<S>, tangent: &mut TangentLanes<S>, lane: usize) -> Option<Course> {
        let (_, (number, start)) = self.turns.next(self.orbits)?;
        load_orbit(lanes, self.top, lane, start);
        load_tangent(tangent, self.top, lane, start);
        Some(Course::new(*number, SectionCondition::Height.value(self.top, start)))
    }
}

impl WithSimd for Worker<'_> {
    type Output = Vec<(usize, Decision)>;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> Self::Output {
        let mut done = Vec::new();
        let powers = Moments::new();
        let mut lanes = Lanes::<S>::new(simd, self.top, self.tolerance);
        let mut tangent = TangentLanes::<S>::new(simd);
        let mut courses: Vec<Option<Course>> =
            (0..S::F64_LANES).map(|lane| self.load(&mut lanes, &mut tangent, lane)).collect();
        while courses.iter().any(Option::is_some) {
            lanes.expand(simd);
            tangent.advance_roughly(simd, &lanes, TANGENT_ORDER);
            let moments: [LaneVector<S>; MOMENTS] = lanes.gamma_moments(simd, &powers);
            let moments = lane_values::<S>(moments.as_flattened());
            let stopped = self.turns.monitor.is_stopped();
            for (lane, slot) in courses.iter_mut().enumerate() {
                let Some(course) = slot else { continue };
                let (time, length) = (lanes.end_of(lane), lanes.step_of(lane));
                let squared = tangent.length_squared(lane);
                let growth = course.stretched(squared, tangent.renormalise(lane));
                let of = |j: usize, i: usize| moments[(3 * j + i) * S::F64_LANES + lane];
                let moments = std::array::from_fn(|j| std::array::from_fn(|i| of(j, i)));
                let value = SectionCondition::Height.value(self.top, &state_of::<S>(&lanes.next, lane));
                course.take(Piece { begin: time - length, length, moments, growth }, value);
                let is_finite = time.is_finite() && value.is_finite() && growth.is_finite();
                let end = if stopped || !is_finite { Some(course.failed()) } else { course.look(self.looks) };
                if let Some(decision) = end {
                    self.turns.monitor.orbits.fetch_add(1, Ordering::Relaxed);
                    done.push((course.number, decision));
                    *slot = None;
                }
            }
            lanes.commit(simd);
            for (lane, slot) in courses.iter_mut().enumerate() {
                if slot.is_none() {
                    *slot = self.load(&mut lanes, &mut tangent, lane);
                }
            }
        }
        done
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn looks_are_spread_by_the_root_of_two() {
        assert_eq!(looks(700), [160, 226, 320, 452, 640, 700]);
        assert_eq!(looks(100), [100]);
        assert!(looks(1 << 20).windows(2).all(|pair| pair[0] < pair[1]));
    }
}
