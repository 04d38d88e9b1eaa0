//! Once around a closed orbit: its crossings of P, its action, and the reversors that it is symmetric under.

use bifdiag_dynamics::field::{HeavyTop, Integrals, State, dot};
use bifdiag_dynamics::integrator::{DEFAULT_TOLERANCE, StepError, Taylor, TaylorStep};
use bifdiag_dynamics::section::SectionCondition;

use crate::flow::{Phase, Space};
use crate::reversor::Reversor;

/// What is seen on the way around.
#[derive(Clone, Debug)]
pub struct Walk {
    /// Zeros of S = ⟨ω, r×γ⟩ in a period.
    pub crossings: u32,
    /// The first maximum of ⟨γ,r⟩: where S falls through 0.
    pub maximum: Option<State>,
    /// ∮⟨l, ω⟩ dt.
    pub action: f64,
    /// Every reversor with a fixed point on the orbit takes it to itself.
    pub symmetric: bool,
    /// For each of the places that were asked for, how near the orbit comes to it.
    pub nearest: Vec<f64>,
}

/// Places in a step at which signs are looked at.
const LOOKS: u32 = 8;
/// A state that a reversor moves no further is one of its fixed points.
const FIXED: f64 = 1e-8;
/// |S| that is 0 all the way around, in its unit: the orbit lies in P.
const FLAT: f64 = 1e-9;

/// Goes once around from a state, for a period.
///
/// # Errors
/// [`StepError`] where the motion leaves the range of `f64`.
pub fn walk(
    space: &Space,
    start: &Phase,
    period: f64,
    reversors: &[Reversor],
    places: &[Phase],
) -> Result<Walk, StepError> {
    let top = &space.top;
    let begin = space.state(start);
    let Ok(mut stepper) = Taylor::new(top, &begin, DEFAULT_TOLERANCE) else {
        return Err(StepError { time: 0.0 });
    };
    let scale = SectionCondition::Height.scale(top, Integrals::of(top, &begin).energy);
    let mut found =
        Walk { crossings: 0, maximum: None, action: 0.0, symmetric: false, nearest: vec![f64::INFINITY; places.len()] };
    let mut largest = 0.0_f64;
    // It ends as it began: a zero there is seen once, whatever its sign is rounded to.
    let closing = SectionCondition::Height.value(top, &begin);
    loop {
        let step = stepper.step()?;
        let left = ((period - step.start().seconds()) - step.start().remainder()) / step.length();
        let to = left.min(1.0);
        found.action += action(top, &step, to);
        for k in 0..LOOKS {
            let ends = [k, k + 1].map(|k| to * f64::from(k) / f64::from(LOOKS));
            let states = ends.map(|x| step.state(x));
            let height = |x: f64| SectionCondition::Height.value(top, &step.state(x));
            let rate = |x: f64| SectionCondition::Height.rate(top, &step.state(x));
            let mut values = states.map(|state| SectionCondition::Height.value(top, &state));
            if left <= 1.0 && k == LOOKS - 1 {
                values[1] = closing;
            }
            let rates = states.map(|state| SectionCondition::Height.rate(top, &state));
            largest = largest.max(values[0].abs());
            // Between two looks S may go to 0 and back.
            let turning = is_change(rates) && !is_change(values);
            let middle = if turning { Some(zero(rate, ends, rates)) } else { None };
            let pieces = match middle {
                Some(x) if is_change([values[0], height(x)]) => {
                    vec![([ends[0], x], [values[0], height(x)]), ([x, ends[1]], [height(x), values[1]])]
                }
                _ if is_change(values) => vec![(ends, values)],
                _ => Vec::new(),
            };
            for (ends, values) in pieces {
                found.crossings += 1;
                if values[1] < values[0] && found.maximum.is_none() {
                    found.maximum = Some(step.state(zero(height, ends, values)));
                }
            }
            if !found.symmetric {
                let fixed = |reversor: &Reversor| {
                    let from = |state: &State| reversor.distance(space, state);
                    let moved = states.each_ref().map(|state| from(state).0);
                    is_change(moved) && from(&step.state(zero(|x| from(&step.state(x)).0, ends, moved))).1 < FIXED
                };
                found.symmetric = reversors.iter().any(fixed);
            }
            let here = space.point(&states[0]);
            for (nearest, place) in found.nearest.iter_mut().zip(places) {
                *nearest = nearest.min((here - place).norm());
            }
        }
        if left <= 1.0 {
            break;
        }
    }
    if largest <= FLAT * scale {
        (found.crossings, found.maximum) = (0, None);
    }
    Ok(found)
}

/// Zero belongs to the positive side, so that a zero at a look is seen once.
fn is_change(values: [f64; 2]) -> bool {
    (values[0] < 0.0) != (values[1] < 0.0)
}

/// The zero between two ends with values of different sign, by regula falsi with halved weights.
fn zero(value: impl Fn(f64) -> f64, mut ends: [f64; 2], mut values: [f64; 2]) -> f64 {
    for _ in 0..60 {
        let middle = ends[0] - values[0] * (ends[1] - ends[0]) / (values[1] - values[0]);
        let found = value(middle);
        let side = usize::from(is_change([values[0], found]));
        if !(ends[0] < middle && middle < ends[1]) || found == 0.0 {
            return middle;
        }
        (ends[side], values[side]) = (middle, found);
        values[1 - side] *= 0.5;
        if is_change([values[0], 0.0]) == is_change([values[1], 0.0]) {
            return middle;
        }
    }
    0.5 * (ends[0] + ends[1])
}

/// ∫⟨l, ω⟩ dt over a part of a step, of its polynomials.
fn action(top: &HeavyTop, step: &TaylorStep, to: f64) -> f64 {
    let momenta = step.coefficients();
    let velocities: Vec<[f64; 3]> = momenta.iter().map(|c| top.inverse_inertia(c.l)).collect();
    let mut sum = 0.0;
    let mut power = to;
    for order in 0..2 * momenta.len() - 1 {
        let least = (order + 1).saturating_sub(momenta.len());
        let products = (least..=order.min(momenta.len() - 1)).map(|j| dot(momenta[j].l, velocities[order - j]));
        sum += products.sum::<f64>() * power / (order + 1) as f64;
        power *= to;
    }
    sum * step.length()
}
