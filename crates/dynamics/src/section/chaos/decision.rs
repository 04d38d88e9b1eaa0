//! Verdicts on many orbits for as little work as each of them needs, from any start and without a section.
//!
//! The averages over the orbit come first, and decide most regular orbits alone. A tangent vector is followed only along orbits
//! whose averages do not settle, from their start, until it decides.

use std::sync::atomic::Ordering;

use pulp::{Simd, WithSimd};

use super::averages::INTEGRAL;
use super::lyapunov::{load_orbit, load_tangent};
use super::verdict::{AGREE, Evidence, LINEAR, OpenReason, OrbitVerdict, verdict};
use crate::field::{Dimension, HeavyTop, State, norm, sub};
use crate::integrator::taylor::{InstructionSet, LaneVector, Lanes, Moments, TangentLanes, lane_values, state_of};
use crate::integrator::{DEFAULT_TOLERANCE, check_tolerance};
use crate::section::condition::SectionCondition;
use crate::section::error::{SectionError, check_count};
use crate::section::workers::{Monitor, Turns, run_workers};

/// Steps at the first look; each further look is at √2 times as many.
const FIRST_LOOK: usize = 160;
/// Where the two windows of a look begin and end, as parts of the time until then: those of other verdicts.
const PARTS: [f64; 3] = [0.25, 0.625, 1.0];
/// Moments of γ over a step that are kept: what is left out of an average is of the third order in step/window.
const KEPT: usize = 3;
/// Order of the tangent vector's series. A step is about e⁻² of the radius of convergence, so that order p leaves out e^(−2p) of
/// a vector, which matters for its last digits and not for its growth.
const TANGENT_ORDER: usize = 8;
/// Averages apart by no more than this part of the spread at [`SETTLED_LOOKS`] looks in a row are those of a regular orbit,
/// whatever a tangent vector does.
const SETTLED: f64 = 1e-4;
const SETTLED_LOOKS: usize = 2;
/// Growth within this of a linear one, at [`LINEAR_LOOKS`] looks in a row, is that of a regular orbit, however slowly its averages
/// settle.
const NEARLY_LINEAR: f64 = 0.2;
const LINEAR_LOOKS: usize = 4;
/// Averages further apart than this at two looks in a row, of which the second is at least the look [`RESTLESS_LOOK`], do not
/// settle soon: a tangent vector is asked.
const RESTLESS: f64 = 1e-2;
const RESTLESS_LOOK: usize = 4;

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
        Self { steps: 20_480, tolerance: DEFAULT_TOLERANCE, instructions: InstructionSet::Best }
    }
}

/// What an orbit is, and what showed it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Decision {
    /// Regular, chaotic or open.
    pub verdict: OrbitVerdict,
    /// For how long the orbit was followed.
    pub time: f64,
    /// How often S = ⟨ω, r×γ⟩ changed its sign from one step to the next.
    pub crossings: u32,
}

/// The verdict on each orbit, in their order. All are of one top; their energies and momenta may differ.
///
/// Regular: the averages settle; or a tangent vector grows linearly; or both, less closely. Chaotic: as
/// [`verdicts`](super::verdicts) have it. The result does not depend on threads or instructions.
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
    let unfinished = Decision { verdict: OrbitVerdict::Open(OpenReason::Unfinished), time: 0.0, crossings: 0 };
    let mut decisions = vec![unfinished; starts.len()];
    let all: Vec<(usize, State)> = starts.iter().map(|start| start.reduced(units)).enumerate().collect();
    let tolerance = options.tolerance;
    let turns = Turns::new(monitor);
    let orbits = &all[..];
    let averaged = run_workers(|| arch.dispatch(Worker::<false> { top, orbits, looks, tolerance, turns: &turns }));
    let mut left = Vec::new();
    for (number, decision) in averaged {
        match decision {
            Some(decision) => decisions[number] = decision,
            None => left.push(all[number]),
        }
    }
    left.sort_by_key(|(number, _)| *number);
    let turns = Turns::new(monitor);
    let orbits = &left[..];
    let stretched = run_workers(|| arch.dispatch(Worker::<true> { top, orbits, looks, tolerance, turns: &turns }));
    for (number, decision) in stretched {
        decisions[number] = decision.unwrap_or(unfinished);
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

/// A step as it is kept.
#[derive(Clone, Copy, Debug)]
struct Kept {
    /// Time in its middle.
    middle: f64,
    length: f64,
    /// ∫ (ξ − 1/2)ʲ γ dt over it, ξ from 0 to 1.
    moments: [[f64; 3]; KEPT],
    /// By how much ln|δ| grew.
    growth: f64,
}

/// An orbit in a lane.
struct Course {
    number: usize,
    kept: Vec<Kept>,
    seen: Vec<Evidence>,
    time: f64,
    /// ln|δ|, and of what was taken out of δ.
    log: f64,
    removed: f64,
    is_positive: bool,
    crossings: u32,
}

impl Course {
    fn new(number: usize, top: &HeavyTop, start: &State) -> Self {
        Self {
            number,
            kept: Vec::new(),
            seen: Vec::new(),
            time: 0.0,
            log: 0.0,
            removed: 0.0,
            is_positive: SectionCondition::Height.value(top, start) >= 0.0,
            crossings: 0,
        }
    }

    /// Looks at the orbit where it is now.
    fn look(&self) -> Evidence {
        let [begin, middle, end] = PARTS.map(|part| part * self.time);
        let ((first, early), (second, late)) = (self.means(begin, middle), self.means(middle, end));
        let mean: [f64; 3] = std::array::from_fn(|i| 0.5 * (first[i] + second[i]));
        // The mean square of γ − its mean, where |γ| = 1.
        let spread = (1.0 - norm(mean) * norm(mean)).max(0.0).sqrt().max(super::ladder::NARROW);
        let apart = norm(sub(first, second)) / spread;
        Evidence { time: self.time, apart, growth: [early, late], log: self.log }
    }

    /// ∫ w γ dt / ∫ w dt over a window, with the weight w = (u(1 − u))⁸ of its part u, and ∫ w d ln|δ| likewise.
    fn means(&self, begin: f64, end: f64) -> ([f64; 3], f64) {
        let length = end - begin;
        let from = self.kept.partition_point(|step| step.middle <= begin);
        let steps = self.kept[from..].iter().take_while(|step| step.middle < end);
        let (mut sum, mut log) = ([0.0; 3], 0.0);
        for step in steps {
            let u = (step.middle - begin) / length;
            // w at u + ε to the second order in ε, with v = u(1 − u): 8v⁷v′ ε + (28 v⁶v′² − 8v⁷) ε².
            let (v, slope) = (u * (1.0 - u), 1.0 - 2.0 * u);
            let v2 = v * v;
            let v6 = v2 * v2 * v2;
            let ratio = step.length / length;
            let weight = v6 * v2;
            let first = 8.0 * v6 * v * slope * ratio;
            let second = (28.0 * v6 * slope * slope - 8.0 * v6 * v) * ratio * ratio;
            for (i, sum) in sum.iter_mut().enumerate() {
                *sum += weight * step.moments[0][i] + first * step.moments[1][i] + second * step.moments[2][i];
            }
            log += weight * step.growth;
        }
        (sum.map(|sum| sum / (length * INTEGRAL)), log / INTEGRAL)
    }

    /// The last looks, so many of them, all saw this.
    fn saw(&self, looks: usize, what: impl FnMut(&Evidence) -> bool) -> bool {
        self.seen.len() >= looks && self.seen.iter().rev().take(looks).all(what)
    }

    /// The averages do not settle soon.
    fn is_restless(&self) -> bool {
        self.seen.len() > RESTLESS_LOOK && self.saw(2, |seen| seen.apart > RESTLESS)
    }

    /// What the looks at it say.
    fn verdict(&self, with_tangent: bool) -> OrbitVerdict {
        let is_linear = |seen: &Evidence| {
            seen.growth.iter().zip(LINEAR).all(|(growth, linear)| (growth - linear).abs() <= NEARLY_LINEAR)
        };
        if self.saw(SETTLED_LOOKS, |seen| seen.apart <= SETTLED) || with_tangent && self.saw(LINEAR_LOOKS, is_linear) {
            return OrbitVerdict::Regular;
        }
        match self.seen.last_chunk::<AGREE>() {
            Some(looks) if with_tangent => verdict(looks),
            _ => OrbitVerdict::Open(OpenReason::TooShort { crossings: self.crossings as usize }),
        }
    }

    /// The end of its way, if this is it.
    fn end(&self, with_tangent: bool, is_last: bool) -> Option<Ending> {
        let verdict = self.verdict(with_tangent);
        let decision = Decision { verdict, time: self.time, crossings: self.crossings };
        if !verdict.is_open() || with_tangent && is_last {
            return Some(Ending::Decided(decision));
        }
        (!with_tangent && (is_last || self.is_restless())).then_some(Ending::Asks)
    }

    fn failed(&self) -> Ending {
        let verdict = OrbitVerdict::Open(OpenReason::Unfinished);
        Ending::Decided(Decision { verdict, time: self.time, crossings: self.crossings })
    }
}

/// How the way of an orbit ends.
#[derive(Clone, Copy, Debug)]
enum Ending {
    Decided(Decision),
    /// It asks for a tangent vector.
    Asks,
}

/// One thread's share: fills its lanes from the list until that is empty.
struct Worker<'a, const TANGENT: bool> {
    top: &'a HeavyTop,
    orbits: &'a [(usize, State)],
    looks: &'a [usize],
    tolerance: f64,
    turns: &'a Turns<'a>,
}

impl<const TANGENT: bool> Worker<'_, TANGENT> {
    /// Puts the next orbit into a lane. An idle lane keeps what it has; nobody looks at it.
    #[inline(always)]
    fn load<S: Simd>(&self, lanes: &mut Lanes<S>, tangent: &mut TangentLanes<S>, lane: usize) -> Option<Course> {
        let (_, (number, start)) = self.turns.next(self.orbits)?;
        load_orbit(lanes, self.top, lane, start);
        if TANGENT {
            load_tangent(tangent, self.top, lane, start);
        }
        Some(Course::new(*number, self.top, start))
    }
}

impl<const TANGENT: bool> WithSimd for Worker<'_, TANGENT> {
    type Output = Vec<(usize, Option<Decision>)>;

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
            if TANGENT {
                tangent.advance_roughly(simd, &lanes, TANGENT_ORDER);
            }
            let moments: [LaneVector<S>; KEPT] = lanes.gamma_moments(simd, &powers);
            let moments = lane_values::<S>(moments.as_flattened());
            let stopped = self.turns.monitor.is_stopped();
            for (lane, slot) in courses.iter_mut().enumerate() {
                let Some(course) = slot else { continue };
                let (time, length) = (lanes.end_of(lane), lanes.step_of(lane));
                let mut growth = 0.0;
                if TANGENT {
                    let log = course.removed + 0.5 * libm::log(tangent.length_squared(lane));
                    growth = log - course.log;
                    course.log = log;
                    course.removed += f64::from(tangent.renormalise(lane)) * std::f64::consts::LN_2;
                }
                let of = |j: usize, i: usize| moments[(3 * j + i) * S::F64_LANES + lane];
                let moments = std::array::from_fn(|j| std::array::from_fn(|i| of(j, i)));
                course.kept.push(Kept { middle: time - 0.5 * length, length, moments, growth });
                course.time = time;
                let value = SectionCondition::Height.value(self.top, &state_of::<S>(&lanes.next, lane));
                course.crossings += u32::from((value >= 0.0) != course.is_positive);
                course.is_positive = value >= 0.0;
                let is_finite = time.is_finite() && value.is_finite() && course.log.is_finite();
                let mut end = (stopped || !is_finite).then(|| course.failed());
                if end.is_none() && self.looks.get(course.seen.len()) == Some(&course.kept.len()) {
                    course.seen.push(course.look());
                    end = course.end(TANGENT, course.seen.len() == self.looks.len());
                }
                if let Some(ending) = end {
                    let decision = match ending {
                        Ending::Decided(decision) => Some(decision),
                        Ending::Asks => None,
                    };
                    self.turns.monitor.orbits.fetch_add(decision.is_some().into(), Ordering::Relaxed);
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
