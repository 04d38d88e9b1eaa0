//! Once around a closed orbit: its crossings of P, its action, and the reversors that it is symmetric under.

use bifdiag_dynamics::field::{HeavyTop, Integrals, State, dot};
use bifdiag_dynamics::integrator::{DEFAULT_TOLERANCE, StepError, Taylor, TaylorStep};
use bifdiag_dynamics::section::SectionCondition;

use crate::flow::{Phase, Space};
use crate::reversor::Reversor;
use crate::shooting::Ring;

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
/// A state that a reversor moves no further is one of its fixed points: where a trace is nearly 2, the orbits beside one close
/// nearly as well, and it is not known much better.
const FIXED: f64 = 1e-6;
/// |S| that is 0 all the way around, in its unit: the orbit lies in P.
const FLAT: f64 = 1e-9;

/// Goes once around, from node to node, so that errors do not grow on the way.
///
/// # Errors
/// [`StepError`] where the motion leaves the range of `f64`.
pub fn walk(space: &Space, ring: &Ring, reversors: &[Reversor], places: &[Phase]) -> Result<Walk, StepError> {
    let top = &space.top;
    let begin = space.state(&ring.nodes[0]);
    let mut walker = Walker {
        space,
        reversors,
        places,
        largest: 0.0,
        height: SectionCondition::Height.value(top, &begin),
        found: Walk {
            crossings: 0,
            maximum: None,
            action: 0.0,
            symmetric: false,
            nearest: vec![f64::INFINITY; places.len()],
        },
    };
    let (first, count) = (walker.height, ring.nodes.len());
    for (number, node) in ring.nodes.iter().enumerate() {
        // It ends as it began: a zero there is seen once, whatever its sign is rounded to.
        walker.part(node, ring.period / count as f64, (number + 1 == count).then_some(first))?;
    }
    let Walker { mut found, largest, .. } = walker;
    if largest <= FLAT * SectionCondition::Height.scale(top, Integrals::of(top, &begin).energy) {
        (found.crossings, found.maximum) = (0, None);
    }
    Ok(found)
}

/// On the way.
struct Walker<'a> {
    space: &'a Space,
    reversors: &'a [Reversor],
    places: &'a [Phase],
    /// The largest |S| so far.
    largest: f64,
    /// S at the last look.
    height: f64,
    found: Walk,
}

impl Walker<'_> {
    /// From a node, for a time; `closing` is S at the end if that is known.
    fn part(&mut self, node: &Phase, time: f64, closing: Option<f64>) -> Result<(), StepError> {
        let top = &self.space.top;
        let Ok(mut stepper) = Taylor::new(top, &self.space.state(node), DEFAULT_TOLERANCE) else {
            return Err(StepError { time: 0.0 });
        };
        loop {
            let step = stepper.step()?;
            let left = ((time - step.start().seconds()) - step.start().remainder()) / step.length();
            let to = left.min(1.0);
            self.found.action += action(top, &step, to);
            for k in 0..LOOKS {
                let ends = [k, k + 1].map(|k| to * f64::from(k) / f64::from(LOOKS));
                let is_last = left <= 1.0 && k + 1 == LOOKS;
                self.look(&step, ends, closing.filter(|_| is_last));
            }
            if left <= 1.0 {
                return Ok(());
            }
        }
    }

    /// Between two looks.
    fn look(&mut self, step: &TaylorStep, ends: [f64; 2], closing: Option<f64>) {
        let top = &self.space.top;
        let states = ends.map(|x| at(step, x));
        let height = |x: f64| SectionCondition::Height.value(top, &at(step, x));
        let rate = |x: f64| SectionCondition::Height.rate(top, &at(step, x));
        let values = [self.height, closing.unwrap_or_else(|| SectionCondition::Height.value(top, &states[1]))];
        let rates = states.map(|state| SectionCondition::Height.rate(top, &state));
        self.largest = self.largest.max(values[1].abs());
        self.height = values[1];
        let mut pieces = vec![(ends, values)];
        // Between two looks S may go to 0 and back.
        if is_change(rates) && !is_change(values) {
            let middle = zero(rate, ends, rates);
            let value = height(middle);
            pieces = vec![([ends[0], middle], [values[0], value]), ([middle, ends[1]], [value, values[1]])];
        }
        for (ends, values) in pieces.into_iter().filter(|(_, values)| is_change(*values)) {
            self.found.crossings += 1;
            if values[1] < values[0] && self.found.maximum.is_none() {
                self.found.maximum = Some(at(step, zero(height, ends, values)));
            }
        }
        if !self.found.symmetric {
            let fixed = |reversor: &Reversor| {
                let from = |state: &State| reversor.distance(self.space, state);
                let moved = states.each_ref().map(|state| from(state).0);
                is_change(moved) && from(&at(step, zero(|x| from(&at(step, x)).0, ends, moved))).1 < FIXED
            };
            self.found.symmetric = self.reversors.iter().any(fixed);
        }
        let here = self.space.point(&states[0]);
        for (nearest, place) in self.found.nearest.iter_mut().zip(self.places) {
            *nearest = nearest.min((here - place).norm());
        }
    }
}

/// The state at x ∈ [0, 1] of a step. (Not fused: what is looked for has few digits to lose, and where the compiler may not
/// count on the instruction it is a call.)
fn at(step: &TaylorStep, x: f64) -> State {
    let mut state = State::default();
    for coefficient in step.coefficients().iter().rev() {
        for i in 0..3 {
            state.gamma[i] = state.gamma[i] * x + coefficient.gamma[i];
            state.l[i] = state.l[i] * x + coefficient.l[i];
        }
    }
    state
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
