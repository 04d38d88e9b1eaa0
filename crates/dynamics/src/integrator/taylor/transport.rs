//! The flow over a time, of an orbit in each lane, with tangent vectors beside it.

use pulp::{Simd, WithSimd};

use super::lanes::{Lanes, state_of};
use super::series::lane_values;
use super::tangent::TangentLanes;
use super::{DEFAULT_TOLERANCE, InstructionSet};
use crate::field::{HeavyTop, State};
use crate::integrator::step::{StepError, TaylorStep};

/// Where the flow takes a state and `N` directions at it in a time.
#[derive(Clone, Debug, PartialEq)]
pub struct Transport<const N: usize> {
    /// γ and l at the end.
    pub end: State,
    /// The derivative of the end in the directions.
    pub directions: [State; N],
    /// The steps of the orbit; the last one ends at the time. They are kept if there are directions.
    pub steps: Vec<TaylorStep>,
}

/// The flow of a [reduced](HeavyTop::reduced) top over a time ≥ 0, for every start and the directions at it, by the Taylor series
/// of [`Taylor`](super::Taylor) with the default tolerance, in steps that keep it for the derivative too.
///
/// Every lane has an orbit of its own, with its own steps, so that what is found depends neither on the number of lanes nor on the
/// other starts.
///
/// # Errors
/// [`StepError`] where a state leaves the range of `f64`, or time is no such number.
pub fn transport<const N: usize>(
    top: &HeavyTop,
    starts: &[(State, [State; N])],
    time: f64,
) -> Result<Vec<Transport<N>>, StepError> {
    transport_with(top, starts, time, InstructionSet::Best)
}

fn transport_with<const N: usize>(
    top: &HeavyTop,
    starts: &[(State, [State; N])],
    time: f64,
    instructions: InstructionSet,
) -> Result<Vec<Transport<N>>, StepError> {
    if !(0.0..=f64::MAX).contains(&time) {
        return Err(StepError { time: 0.0 });
    }
    debug_assert!(top.units().are_one());
    instructions.arch().unwrap_or(pulp::Arch::Scalar).dispatch(Task { top, starts, time })
}

struct Task<'a, const N: usize> {
    top: &'a HeavyTop,
    starts: &'a [(State, [State; N])],
    time: f64,
}

impl<const N: usize> WithSimd for Task<'_, N> {
    type Output = Result<Vec<Transport<N>>, StepError>;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> Self::Output {
        let mut lanes = Lanes::<S>::new(simd, self.top, DEFAULT_TOLERANCE);
        let mut tangents = Vec::with_capacity(N);
        for _ in 0..N {
            tangents.push(TangentLanes::<S>::new(simd));
        }
        let mut found = Vec::with_capacity(self.starts.len());
        for starts in self.starts.chunks(S::F64_LANES) {
            self.load(&mut lanes, &mut tangents, starts);
            self.follow(simd, &mut lanes, &mut tangents, starts.len(), &mut found)?;
        }
        Ok(found)
    }
}

impl<const N: usize> Task<'_, N> {
    /// Puts an orbit into each lane; into those that are left over, the last one.
    #[inline(always)]
    fn load<S: Simd>(&self, lanes: &mut Lanes<S>, tangents: &mut [TangentLanes<S>], starts: &[(State, [State; N])]) {
        for lane in 0..S::F64_LANES {
            let (start, directions) = &starts[lane.min(starts.len() - 1)];
            // For a body nearly at rest the orbit has hardly any momentum, but its neighbours have.
            let energy = self.top.energy(start).abs().max(self.top.center_norm());
            let scale = self.top.momentum_scale(energy);
            lanes.load(lane, start, scale);
            for (tangent, direction) in tangents.iter_mut().zip(directions) {
                tangent.load(lane, direction, scale);
            }
        }
    }

    /// Follows the first `count` lanes to the time. A lane that has arrived waits for the others in steps of length 0.
    #[inline(always)]
    fn follow<S: Simd>(
        &self,
        simd: S,
        lanes: &mut Lanes<S>,
        tangents: &mut [TangentLanes<S>],
        count: usize,
        found: &mut Vec<Transport<N>>,
    ) -> Result<(), StepError> {
        let first = found.len();
        let begin = Transport { end: State::default(), directions: [State::default(); N], steps: Vec::new() };
        found.resize(first + count, begin);
        let mut ended = 0_u64;
        while (0..count).any(|lane| ended >> lane & 1 == 0) {
            lanes.expand_only(simd);
            TangentLanes::expand_all(tangents, simd, lanes, lanes.order());
            for tangent in tangents.iter() {
                tangent.shorten_steps(simd, lanes);
            }
            let waits = ended;
            for lane in 0..S::F64_LANES {
                let begun = lanes.time(lane);
                let left = (self.time - begun.seconds()) - begun.remainder();
                let is_there = waits >> lane & 1 == 1;
                lanes.shorten_step(lane, if is_there { 0.0 } else { left });
                if lanes.step_of(lane) == left && lane < count {
                    ended |= 1 << lane;
                }
            }
            lanes.sum_series(simd);
            if !lane_values::<S>(lanes.next.as_flattened()).iter().all(|x| x.is_finite()) {
                return Err(StepError { time: lanes.time(0).seconds() });
            }
            for tangent in tangents.iter_mut() {
                tangent.sum_series(simd, lanes);
            }
            for (lane, transport) in found[first..].iter_mut().enumerate() {
                if waits >> lane & 1 == 1 {
                    continue;
                }
                let end = state_of::<S>(&lanes.next, lane);
                if N > 0 {
                    let length = lanes.step_of(lane);
                    let coefficients = coefficients(lanes, lane, length);
                    transport.steps.push(TaylorStep::new(lanes.time(lane), length, end, coefficients)?);
                }
                if ended >> lane & 1 == 1 {
                    transport.end = end;
                    for (direction, tangent) in transport.directions.iter_mut().zip(tangents.iter()) {
                        *direction = tangent.vector(lane);
                    }
                }
            }
            lanes.commit(simd);
        }
        Ok(())
    }
}

/// The series of an orbit, in parts of a step.
#[inline(always)]
fn coefficients<S: Simd>(lanes: &Lanes<S>, lane: usize, length: f64) -> Vec<State> {
    let mut power = 1.0;
    let mut rows = Vec::with_capacity(lanes.order() + 1);
    for k in 0..=lanes.order() {
        // (Read where they lie: whole registers are not copied for one lane.)
        let (gamma, l) = (lane_values::<S>(&lanes.series.gamma[k]), lane_values::<S>(&lanes.series.l[k]));
        let mut row = State::default();
        for i in 0..3 {
            row.gamma[i] = gamma[i * S::F64_LANES + lane] * power;
            row.l[i] = l[i * S::F64_LANES + lane] * power;
        }
        rows.push(row);
        power *= length;
    }
    rows
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::integrator::Taylor;

    const TIME: f64 = 7.0;

    fn paper() -> HeavyTop {
        HeavyTop::from_f64([2.0, 1.1, 1.0], [0.94868, 0.0, 0.61623])
    }

    fn start() -> State {
        State { gamma: [0.36, -0.48, -0.8], l: [0.9, -2.1, 1.7] }
    }

    /// A unit vector of phase space.
    fn direction(j: usize) -> State {
        let at = |from: usize| std::array::from_fn(|i| if i + from == j { 1.0 } else { 0.0 });
        State { gamma: at(0), l: at(3) }
    }

    fn whole(top: &HeavyTop, start: State, time: f64) -> Transport<6> {
        transport(top, &[(start, std::array::from_fn(direction))], time).unwrap().remove(0)
    }

    #[test]
    fn the_end_is_that_of_the_taylor_steps() {
        let top = paper();
        let found = whole(&top, start(), TIME);
        let mut stepper = Taylor::new(&top, &start(), DEFAULT_TOLERANCE).unwrap();
        let expected = loop {
            let step = stepper.step().unwrap();
            if step.end().seconds() >= TIME {
                break step.state((TIME - step.start().seconds()) / step.length());
            }
        };
        let last = found.steps.last().unwrap();
        assert!((last.end().seconds() - TIME).abs() < 1e-15 && *last.end_state() == found.end);
        for end in [found.end, last.state(1.0)] {
            for i in 0..3 {
                assert!((end.gamma[i] - expected.gamma[i]).abs() < 1e-14);
                assert!((end.l[i] - expected.l[i]).abs() < 4e-14);
            }
        }
    }

    /// Orbits of different energy beside each other end at one time after different steps.
    #[test]
    fn no_lane_feels_another_and_all_instructions_agree() {
        let top = paper();
        let starts: Vec<(State, [State; 2])> = (0..11)
            .map(|k| {
                let size = f64::from(k) * 0.5;
                (State { l: start().l.map(|x| x * size), ..start() }, [direction(0), direction(4)])
            })
            .collect();
        let alone: Vec<Transport<2>> =
            starts.iter().map(|start| transport(&top, std::slice::from_ref(start), TIME).unwrap().remove(0)).collect();
        assert!(alone[0].steps.len() < alone[10].steps.len());
        for instructions in InstructionSet::available() {
            assert_eq!(transport_with(&top, &starts, TIME, instructions).unwrap(), alone, "{instructions:?}");
        }
    }

    /// Beside a steady rotation about a principal axis the orbit hardly moves, and steps of its own would be far too long for
    /// the derivative: its determinant is 1, since the flow keeps volumes.
    #[test]
    fn the_derivative_keeps_volumes_where_the_orbit_feels_nothing() {
        let top = HeavyTop::from_f64([3.0, 1.1, 1.0], [1.0, 0.0, 0.0]);
        let start = State { gamma: [1.0, 1e-9, 0.0], l: [30.0, 0.0, 0.0] };
        let found = whole(&top, start, 3.0);
        let matrix = nalgebra::SMatrix::<f64, 6, 6>::from_fn(|i, j| {
            let State { gamma, l } = found.directions[j];
            if i < 3 { gamma[i] } else { l[i - 3] }
        });
        assert!((matrix.determinant() - 1.0).abs() < 1e-11, "{}", matrix.determinant());
    }

    #[test]
    fn a_body_at_rest_is_followed_in_few_steps() {
        // ⟨γ,γ⟩ a little above 1: the energy is below that of the body that hangs.
        let top = HeavyTop::from_f64([2.0, 1.1, 1.0], [1.0, 0.0, 0.0]);
        let found = whole(&top, State { gamma: [1.000_001, 0.0, 0.0], l: [0.0; 3] }, 6.0);
        assert!((found.end.gamma[0] - 1.000_001).abs() < 1e-15);
    }

    #[test]
    fn the_derivative_is_that_of_differences() {
        let top = paper();
        let found = whole(&top, start(), TIME);
        for j in 0..6 {
            let moved = |step: f64| {
                let d = direction(j);
                let by = |x: [f64; 3], d: [f64; 3]| std::array::from_fn(|i| x[i] + step * d[i]);
                let moved = State { gamma: by(start().gamma, d.gamma), l: by(start().l, d.l) };
                transport::<0>(&top, &[(moved, [])], TIME).unwrap().remove(0).end
            };
            let (plus, minus) = (moved(1e-5), moved(-1e-5));
            let flat = |state: State| state.gamma.into_iter().chain(state.l);
            for ((plus, minus), entry) in flat(plus).zip(flat(minus)).zip(flat(found.directions[j])) {
                let expected = (plus - minus) / 2e-5;
                assert!((entry - expected).abs() < 1e-6 * (1.0 + expected.abs()), "{j} {entry} {expected}");
            }
        }
    }
}
