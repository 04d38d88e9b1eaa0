//! The flow over a time with its derivative: the same orbit in every lane, six tangent vectors beside it.

use pulp::{Simd, WithSimd};

use super::lanes::{Lanes, state_of};
use super::tangent::TangentLanes;
use super::{DEFAULT_TOLERANCE, InstructionSet};
use crate::field::{Dimension, HeavyTop, State};
use crate::integrator::step::{StepError, TaylorStep};

/// Where the flow takes a state in a time, and the derivative of that with respect to the state.
#[derive(Clone, Debug, PartialEq)]
pub struct Transport {
    /// γ and l at the end.
    pub end: State,
    /// ∂(γ, l)(time)/∂xⱼ, a column for each of γ₁ … l₃.
    pub tangent: [[f64; 6]; 6],
    /// The steps of the orbit; the last one ends at the time.
    pub steps: Vec<TaylorStep>,
}

/// The flow over a time ≥ 0, by the Taylor series of [`Taylor`](super::Taylor) with the default tolerance, in steps that keep
/// it for the derivative too; the last one ends at the time.
///
/// The six columns of the derivative lie in as many lanes, which all hold the same orbit: where a register has eight
/// lanes they cost as much as one.
///
/// # Errors
/// [`StepError`] where the state leaves the range of `f64`, or time is no such number.
pub fn transport(top: &HeavyTop, start: &State, time: f64) -> Result<Transport, StepError> {
    if !(0.0..=f64::MAX).contains(&time) {
        return Err(StepError { time: 0.0 });
    }
    let units = top.units();
    let (top, start) = (&top.reduced(), &start.reduced(units));
    let task = Task { top, start, time: units.reduce(time, Dimension::TIME) };
    let arch = InstructionSet::Best.arch().unwrap_or(pulp::Arch::Scalar);
    let mut found = arch.dispatch(task).map_err(|error| error.restored(units))?;
    found.end = found.end.restored(units);
    found.steps = found.steps.into_iter().map(|step| step.restored(units)).collect();
    for (j, column) in found.tangent.iter_mut().enumerate() {
        for (i, entry) in column.iter_mut().enumerate() {
            *entry = match (i < 3, j < 3) {
                (false, true) => units.restore(*entry, Dimension::MOMENTUM),
                (true, false) => units.reduce(*entry, Dimension::MOMENTUM),
                _ => *entry,
            };
        }
    }
    Ok(found)
}

/// A unit vector of phase space.
fn direction(j: usize) -> State {
    let at = |from: usize| std::array::from_fn(|i| if i + from == j { 1.0 } else { 0.0 });
    State { gamma: at(0), l: at(3) }
}

struct Task<'a> {
    top: &'a HeavyTop,
    start: &'a State,
    time: f64,
}

impl WithSimd for Task<'_> {
    type Output = Result<Transport, StepError>;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> Self::Output {
        let Task { top, start, time } = self;
        let mut lanes = Lanes::<S>::new(simd, top, DEFAULT_TOLERANCE);
        // Of a body nearly at rest the orbit has hardly any momentum, but its neighbours have.
        let scale = top.momentum_scale(top.energy(start).abs().max(top.center_norm())).max(f64::MIN_POSITIVE.sqrt());
        let count = 6_usize.div_ceil(S::F64_LANES);
        let mut tangents: Vec<TangentLanes<S>> = Vec::with_capacity(count);
        for lane in 0..S::F64_LANES {
            lanes.load(lane, start, scale);
        }
        for group in 0..count {
            let mut tangent = TangentLanes::<S>::new(simd);
            for lane in 0..S::F64_LANES {
                tangent.load(lane, &direction(group * S::F64_LANES + lane), scale);
            }
            tangents.push(tangent);
        }
        let mut steps = Vec::new();
        loop {
            let begun = lanes.time(0);
            let left = (time - begun.seconds()) - begun.remainder();
            lanes.expand(simd);
            let mut length = lanes.step_of(0);
            for tangent in &mut tangents {
                tangent.expand(simd, &lanes);
                length = length.min(tangent.longest_step(simd, &lanes));
            }
            let is_last = length >= left;
            let length = if is_last { left } else { length };
            lanes.shorten(simd, length);
            let end = state_of::<S>(&lanes.next, 0);
            steps.push(TaylorStep::new(begun, length, end, coefficients(&lanes, length))?);
            for tangent in &mut tangents {
                tangent.sum_series(simd, &lanes);
            }
            lanes.commit(simd);
            if is_last {
                let column = |j: usize| {
                    let State { gamma: g, l } = tangents[j / S::F64_LANES].vector(j % S::F64_LANES);
                    [g[0], g[1], g[2], l[0], l[1], l[2]]
                };
                return Ok(Transport { end, tangent: std::array::from_fn(column), steps });
            }
        }
    }
}

/// The series of the orbit, in parts of a step.
fn coefficients<S: Simd>(lanes: &Lanes<S>, length: f64) -> Vec<State> {
    let mut power = 1.0;
    let row = |k: usize| {
        let State { gamma, l } = state_of::<S>(&[lanes.series.gamma[k], lanes.series.l[k]], 0);
        let scaled = State { gamma: gamma.map(|x| x * power), l: l.map(|x| x * power) };
        power *= length;
        scaled
    };
    (0..=lanes.order()).map(row).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::integrator::Taylor;

    const TIME: f64 = 7.0;

    fn start() -> State {
        State { gamma: [0.36, -0.48, -0.8], l: [0.9, -2.1, 1.7] }
    }

    #[test]
    fn the_end_is_that_of_the_taylor_steps() {
        let top = HeavyTop::from_f64([2.0, 1.1, 1.0], [0.94868, 0.0, 0.61623]);
        let found = transport(&top, &start(), TIME).unwrap();
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

    /// Beside a steady rotation about a principal axis the orbit hardly moves, and steps of its own would be far too long for
    /// the derivative: its determinant is 1, since the flow keeps volumes.
    #[test]
    fn the_derivative_keeps_volumes_where_the_orbit_feels_nothing() {
        let top = HeavyTop::from_f64([3.0, 1.1, 1.0], [1.0, 0.0, 0.0]);
        let start = State { gamma: [1.0, 1e-9, 0.0], l: [30.0, 0.0, 0.0] };
        let found = transport(&top, &start, 3.0).unwrap();
        let matrix = nalgebra::SMatrix::<f64, 6, 6>::from_fn(|i, j| found.tangent[j][i]);
        assert!((matrix.determinant() - 1.0).abs() < 1e-11, "{}", matrix.determinant());
    }

    #[test]
    fn a_body_at_rest_is_followed_in_few_steps() {
        // ⟨γ,γ⟩ a little above 1: the energy is below that of the body that hangs.
        let top = HeavyTop::from_f64([2.0, 1.1, 1.0], [1.0, 0.0, 0.0]);
        let found = transport(&top, &State { gamma: [1.000_001, 0.0, 0.0], l: [0.0; 3] }, 6.0).unwrap();
        assert!((found.end.gamma[0] - 1.000_001).abs() < 1e-15);
    }

    #[test]
    fn the_derivative_is_that_of_differences_in_any_units() {
        let huge = libm::scalbn(1.0, 200);
        for unit in [1.0, huge] {
            let top = HeavyTop::from_f64([2.0, 1.1, 1.0].map(|x| x * unit), [0.94868, 0.0, 0.61623].map(|x| x * unit));
            let start = State { l: start().l.map(|x| x * unit), ..start() };
            let found = transport(&top, &start, TIME).unwrap();
            for j in 0..6 {
                let size = if j < 3 { 1.0 } else { unit };
                let moved = |sign: f64| {
                    let d = direction(j);
                    let step = sign * 1e-5 * size;
                    let by = |x: [f64; 3], d: [f64; 3]| std::array::from_fn(|i| x[i] + step * d[i]);
                    let end = transport(&top, &State { gamma: by(start.gamma, d.gamma), l: by(start.l, d.l) }, TIME);
                    let end = end.unwrap().end;
                    [end.gamma[0], end.gamma[1], end.gamma[2], end.l[0] / unit, end.l[1] / unit, end.l[2] / unit]
                };
                let (plus, minus) = (moved(1.0), moved(-1.0));
                for i in 0..6 {
                    let expected = (plus[i] - minus[i]) / 2e-5;
                    let entry = found.tangent[j][i] * size / if i < 3 { 1.0 } else { unit };
                    assert!((entry - expected).abs() < 1e-6 * (1.0 + expected.abs()), "{i} {j} {entry} {expected}");
                }
            }
        }
    }
}
