//! Once around a closed orbit: its crossings of P, its action, and the reversors that it is symmetric under.

use bifdiag_dynamics::field::{Integrals, State, dot};
use bifdiag_dynamics::integrator::TaylorStep;
use bifdiag_dynamics::integrator::taylor::MAX_ORDER;
use bifdiag_dynamics::section::SectionCondition;

use crate::flow::{Phase, Space};
use crate::reversor::{Reversor, all_are_symmetric};
use crate::shooting::{RESIDUAL, Shot};

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
}

/// Places in a step at which signs are looked at.
const LOOKS: usize = 8;
/// Where they lie: at the ends of as many parts.
const PLACES: [f64; LOOKS + 1] = {
    let mut places = [0.0; LOOKS + 1];
    let mut k = 1;
    while k <= LOOKS {
        places[k] = k as f64 / LOOKS as f64;
        k += 1;
    }
    places
};
/// A state that a reversor moves no further is one of its fixed points, and so far at most where the trace is nearly 2: the
/// orbits beside one close nearly as well there, and it is known only to its defect over what the trace is off 2.
const FIXED: [f64; 2] = [1e-6, 1e-4];
/// |S| that is 0 all the way around, in its unit: the orbit lies in P, as regular precessions do, which are known to a
/// defect; of other bodies all orbits leave P, and near equilibria only rounding hides it.
const FLAT: [f64; 2] = [1e-13, 1e-9];

/// Goes once around along the steps of the motion, which begin anew at each node, so that errors do not grow on the way.
#[must_use]
pub fn walk(space: &Space, shot: &Shot, reversors: &[Reversor]) -> Walk {
    let top = &space.top;
    let begin = space.state(&shot.ring.nodes[0]);
    let energy = Integrals::of(top, &begin).energy;
    let known = RESIDUAL / (shot.reduced().trace() - 2.0).abs();
    let mut walker = Walker {
        space,
        fixed: known.clamp(FIXED[0], FIXED[1]),
        reversors,
        covectors: reversors.iter().map(|reversor| reversor.covector(space)).collect(),
        largest: 0.0,
        found: Walk {
            crossings: 0,
            maximum: None,
            // Twice the kinetic energy is 2(H + ⟨γ,r⟩).
            action: 2.0 * energy * shot.ring.period,
            symmetric: false,
        },
    };
    let first = Seen {
        height: SectionCondition::Height.value(top, &begin),
        rate: SectionCondition::Height.rate(top, &begin),
        moved: reversors.iter().map(|reversor| reversor.distance(space, &begin).0).collect(),
    };
    let mut last = first.clone();
    let count = shot.steps.len();
    for (number, steps) in shot.steps.iter().enumerate() {
        for (k, step) in steps.iter().enumerate() {
            // It ends as it began: a zero there is seen once, whatever its sign is rounded to.
            let closing = (number + 1 == count && k + 1 == steps.len()).then_some(&first);
            walker.step(step, &mut last, closing);
        }
    }
    let Walker { mut found, largest, .. } = walker;
    let flat = FLAT[usize::from(all_are_symmetric(top))];
    if largest <= flat * SectionCondition::Height.scale(top, energy) {
        (found.crossings, found.maximum) = (0, None);
    }
    found
}

/// For each of some places, how near a closed orbit comes to it.
#[must_use]
pub fn nearest(space: &Space, shot: &Shot, places: &[Phase]) -> Vec<f64> {
    let mut nearest = vec![f64::INFINITY; places.len()];
    for state in shot.steps.iter().flatten().flat_map(looks) {
        let here = space.point(&state);
        for (nearest, place) in nearest.iter_mut().zip(places) {
            *nearest = nearest.min((here - place).norm());
        }
    }
    nearest
}

/// On the way.
struct Walker<'a> {
    space: &'a Space,
    /// What a reversor may move its fixed points.
    fixed: f64,
    reversors: &'a [Reversor],
    /// What makes of a state how far each reversor moves it, signed.
    covectors: Vec<State>,
    /// The largest |S| so far.
    largest: f64,
    found: Walk,
}

/// What is seen at a place.
#[derive(Clone)]
struct Seen {
    /// S.
    height: f64,
    /// Ṡ.
    rate: f64,
    /// How far each reversor moves it, signed.
    moved: Vec<f64>,
}

impl Walker<'_> {
    /// A step, from what was last seen on; `closing` is what is seen at its end if that is known.
    fn step(&mut self, step: &TaylorStep, last: &mut Seen, closing: Option<&Seen>) {
        let center = self.space.top.center();
        // S is the derivative of ⟨γ,r⟩ by time.
        let way = Polynomial::of(step, |state| dot(state.gamma, center));
        self.found.action += 2.0 * way.integral() * step.length();
        let slope = way.derivative(step.length());
        let bend = slope.derivative(step.length());
        let (mut heights, rates) = (slope.looks(last.height), bend.looks(last.rate));
        if let Some(closing) = closing {
            heights[LOOKS] = closing.height;
        }
        (last.height, last.rate) = (heights[LOOKS], rates[LOOKS]);
        for k in 0..LOOKS {
            let ends = [PLACES[k], PLACES[k + 1]];
            let (values, rates) = ([heights[k], heights[k + 1]], [rates[k], rates[k + 1]]);
            self.largest = self.largest.max(values[1].abs());
            if is_change(values) {
                self.crossing(step, ends, values);
            } else if is_change(rates) {
                // Between two looks S may go to 0 and back.
                let middle = zero(|x| bend.at(x), ends, rates);
                let value = slope.at(middle);
                self.crossing(step, [ends[0], middle], [values[0], value]);
                self.crossing(step, [middle, ends[1]], [value, values[1]]);
            }
        }
        self.reverse(step, last, closing);
    }

    /// Looks for fixed points of reversors in a step. Where the orbit is known to be symmetric nobody asks any more.
    fn reverse(&mut self, step: &TaylorStep, last: &mut Seen, closing: Option<&Seen>) {
        for (number, reversor) in self.reversors.iter().enumerate() {
            if self.found.symmetric {
                return;
            }
            let covector = self.covectors[number];
            let from = Polynomial::of(step, |state| dot(covector.gamma, state.gamma) + dot(covector.l, state.l));
            let mut moved = from.looks(last.moved[number]);
            if let Some(closing) = closing {
                moved[LOOKS] = closing.moved[number];
            }
            last.moved[number] = moved[LOOKS];
            self.found.symmetric = (0..LOOKS).any(|k| {
                let (ends, values) = ([PLACES[k], PLACES[k + 1]], [moved[k], moved[k + 1]]);
                is_change(values) && {
                    let there = at(step, zero(|x| from.at(x), ends, values));
                    reversor.distance(self.space, &there).1 < self.fixed
                }
            });
        }
    }

    /// Counts a zero of S, if there is one between the ends.
    fn crossing(&mut self, step: &TaylorStep, ends: [f64; 2], values: [f64; 2]) {
        if is_change(values) {
            self.found.crossings += 1;
            if values[1] < values[0] && self.found.maximum.is_none() {
                let height = |x: f64| SectionCondition::Height.value(&self.space.top, &at(step, x));
                self.found.maximum = Some(at(step, zero(height, ends, values)));
            }
        }
    }
}

/// What depends linearly on the state, along a step: a polynomial in parts of it.
struct Polynomial {
    coefficients: [f64; MAX_ORDER + 1],
    order: usize,
}

impl Polynomial {
    fn of(step: &TaylorStep, functional: impl Fn(&State) -> f64) -> Self {
        let mut found = Self { coefficients: [0.0; MAX_ORDER + 1], order: step.coefficients().len() - 1 };
        for (coefficient, state) in found.coefficients.iter_mut().zip(step.coefficients()) {
            *coefficient = functional(state);
        }
        found
    }

    fn terms(&self) -> &[f64] {
        &self.coefficients[..=self.order]
    }

    /// The derivative by time, of a step so long.
    fn derivative(&self, length: f64) -> Self {
        let mut found = Self { coefficients: [0.0; MAX_ORDER + 1], order: self.order.saturating_sub(1) };
        for k in 1..=self.order {
            found.coefficients[k - 1] = self.coefficients[k] * (k as f64 / length);
        }
        found
    }

    /// Over the whole step.
    fn integral(&self) -> f64 {
        self.terms().iter().enumerate().map(|(k, c)| c / (k + 1) as f64).sum()
    }

    fn at(&self, x: f64) -> f64 {
        self.terms().iter().rev().fold(0.0, |sum, c| sum * x + c)
    }

    /// At the places where signs are looked at; at the first one it is known.
    fn looks(&self, first: f64) -> [f64; LOOKS + 1] {
        let mut values = [0.0; LOOKS + 1];
        for c in self.terms().iter().rev() {
            for (value, place) in values.iter_mut().zip(&PLACES) {
                *value = *value * place + c;
            }
        }
        values[0] = first;
        values
    }
}

/// The states at the places where signs are looked at: what [`at`] gives, all at once.
fn looks(step: &TaylorStep) -> [State; LOOKS] {
    let mut states = [State::default(); LOOKS];
    for i in 0..3 {
        let (mut gamma, mut l) = ([0.0; LOOKS], [0.0; LOOKS]);
        for coefficient in step.coefficients().iter().rev() {
            for (k, place) in PLACES[1..].iter().enumerate() {
                gamma[k] = gamma[k] * place + coefficient.gamma[i];
                l[k] = l[k] * place + coefficient.l[i];
            }
        }
        for k in 0..LOOKS {
            (states[k].gamma[i], states[k].l[i]) = (gamma[k], l[k]);
        }
    }
    states
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
