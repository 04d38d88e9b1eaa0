//! One turn around a closed orbit: its crossings of P, its action, and whether reversors map it to itself.

use bifdiag_dynamics::field::{Integrals, State, dot};
use bifdiag_dynamics::integrator::TaylorStep;
use bifdiag_dynamics::integrator::taylor::MAX_ORDER;
use bifdiag_dynamics::section::SectionCondition;

use crate::flow::{Phase, Space};
use crate::reversor::{Reversor, all_are_symmetric};
use crate::shooting::{RESIDUAL, Shot};

/// What one turn around an orbit shows.
#[derive(Clone, Debug)]
pub struct Walk {
    /// Zeros of S = ⟨ω, r×γ⟩ in a period.
    pub crossings: u32,
    /// The first maximum of ⟨γ,r⟩: where S falls through 0.
    pub maximum: Option<State>,
    /// ∮⟨l, ω⟩ dt.
    pub action: f64,
    /// A reversor has a fixed point on the orbit, and so maps it to itself.
    pub symmetric: bool,
}

/// Intervals of a step at whose ends signs are compared.
const INTERVALS: usize = 8;
/// Their ends, as fractions of the step.
const PLACES: [f64; INTERVALS + 1] = {
    let mut places = [0.0; INTERVALS + 1];
    let mut k = 1;
    while k <= INTERVALS {
        places[k] = k as f64 / INTERVALS as f64;
        k += 1;
    }
    places
};
/// A state that a reversor moves by less counts as a fixed point. Where the trace is nearly 2, neighbouring orbits
/// close almost as well, and an orbit is known only to its defect over the distance of the trace from 2; the second
/// value limits the tolerance.
const FIXED: [f64; 2] = [1e-6, 1e-4];
/// An orbit whose |S| stays below this, in the unit of S, lies in P. The second value is for bodies with regular
/// precessions, which are known up to their defect; the orbits of all other bodies leave P, and near equilibria only
/// rounding hides it.
const FLAT: [f64; 2] = [1e-13, 1e-9];

/// Goes once around along the steps of the motion, which start afresh at each node, so that errors do not accumulate.
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
    let first = Sample {
        height: SectionCondition::Height.value(top, &begin),
        rate: SectionCondition::Height.rate(top, &begin),
        moved: reversors.iter().map(|reversor| reversor.distance(space, &begin).0).collect(),
    };
    let mut last = first.clone();
    let count = shot.steps.len();
    for (number, steps) in shot.steps.iter().enumerate() {
        for (k, step) in steps.iter().enumerate() {
            // It ends with the values it began with: a zero there is counted once, whichever way its sign is rounded.
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

/// The smallest distance of a closed orbit from each of the given places.
#[must_use]
pub fn nearest(space: &Space, shot: &Shot, places: &[Phase]) -> Vec<f64> {
    let mut nearest = vec![f64::INFINITY; places.len()];
    for state in shot.steps.iter().flatten().flat_map(samples) {
        let here = space.point(&state);
        for (nearest, place) in nearest.iter_mut().zip(places) {
            *nearest = nearest.min((here - place).norm());
        }
    }
    nearest
}

/// The state of a walk.
struct Walker<'a> {
    space: &'a Space,
    /// A reversor moves its fixed points by less than this.
    fixed: f64,
    reversors: &'a [Reversor],
    /// For each reversor, the linear form that gives the signed distance by which it moves a state.
    covectors: Vec<State>,
    /// The largest |S| so far.
    largest: f64,
    found: Walk,
}

/// The values at one place.
#[derive(Clone)]
struct Sample {
    /// S.
    height: f64,
    /// Ṡ.
    rate: f64,
    /// How far each reversor moves it, signed.
    moved: Vec<f64>,
}

impl Walker<'_> {
    /// Walks along a step, starting with the last values; `closing` holds the values at its end where they are known.
    fn step(&mut self, step: &TaylorStep, last: &mut Sample, closing: Option<&Sample>) {
        let center = self.space.top.center();
        // S is the derivative of ⟨γ,r⟩ by time.
        let way = Polynomial::of(step, |state| dot(state.gamma, center));
        self.found.action += 2.0 * way.integral() * step.length();
        let slope = way.derivative(step.length());
        let bend = slope.derivative(step.length());
        let (mut heights, rates) = (slope.samples(last.height), bend.samples(last.rate));
        if let Some(closing) = closing {
            heights[INTERVALS] = closing.height;
        }
        (last.height, last.rate) = (heights[INTERVALS], rates[INTERVALS]);
        for k in 0..INTERVALS {
            let ends = [PLACES[k], PLACES[k + 1]];
            let (values, rates) = ([heights[k], heights[k + 1]], [rates[k], rates[k + 1]]);
            self.largest = self.largest.max(values[1].abs());
            if is_change(values) {
                self.crossing(step, ends, values);
            } else if is_change(rates) {
                // Between two samples S may go to 0 and back.
                let middle = zero(|x| bend.at(x), ends, rates);
                let value = slope.at(middle);
                self.crossing(step, [ends[0], middle], [values[0], value]);
                self.crossing(step, [middle, ends[1]], [value, values[1]]);
            }
        }
        self.reverse(step, last, closing);
    }

    /// Looks for fixed points of reversors in a step, unless the orbit is already known to be symmetric.
    fn reverse(&mut self, step: &TaylorStep, last: &mut Sample, closing: Option<&Sample>) {
        for (number, reversor) in self.reversors.iter().enumerate() {
            if self.found.symmetric {
                return;
            }
            let covector = self.covectors[number];
            let from = Polynomial::of(step, |state| dot(covector.gamma, state.gamma) + dot(covector.l, state.l));
            let mut moved = from.samples(last.moved[number]);
            if let Some(closing) = closing {
                moved[INTERVALS] = closing.moved[number];
            }
            last.moved[number] = moved[INTERVALS];
            self.found.symmetric = (0..INTERVALS).any(|k| {
                let (ends, values) = ([PLACES[k], PLACES[k + 1]], [moved[k], moved[k + 1]]);
                is_change(values) && {
                    let there = at(step, zero(|x| from.at(x), ends, values));
                    reversor.distance(self.space, &there).1 < self.fixed
                }
            });
        }
    }

    /// Counts the zero of S between the ends, if there is one.
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

/// A linear function of the state along a step: a polynomial in the fraction of the step.
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

    /// The time derivative, for a step of this length.
    fn derivative(&self, length: f64) -> Self {
        let mut found = Self { coefficients: [0.0; MAX_ORDER + 1], order: self.order.saturating_sub(1) };
        for k in 1..=self.order {
            found.coefficients[k - 1] = self.coefficients[k] * (k as f64 / length);
        }
        found
    }

    /// The integral over the fraction of the step, from 0 to 1.
    fn integral(&self) -> f64 {
        self.terms().iter().enumerate().map(|(k, c)| c / (k + 1) as f64).sum()
    }

    fn at(&self, x: f64) -> f64 {
        self.terms().iter().rev().fold(0.0, |sum, c| sum * x + c)
    }

    /// The values at which signs are compared; the first one is known.
    fn samples(&self, first: f64) -> [f64; INTERVALS + 1] {
        let mut values = [0.0; INTERVALS + 1];
        for c in self.terms().iter().rev() {
            for (value, place) in values.iter_mut().zip(&PLACES) {
                *value = *value * place + c;
            }
        }
        values[0] = first;
        values
    }
}

/// The states at all places but the first: what [`at`] gives, all at once.
fn samples(step: &TaylorStep) -> [State; INTERVALS] {
    let mut states = [State::default(); INTERVALS];
    for i in 0..3 {
        let (mut gamma, mut l) = ([0.0; INTERVALS], [0.0; INTERVALS]);
        for coefficient in step.coefficients().iter().rev() {
            for (k, place) in PLACES[1..].iter().enumerate() {
                gamma[k] = gamma[k] * place + coefficient.gamma[i];
                l[k] = l[k] * place + coefficient.l[i];
            }
        }
        for k in 0..INTERVALS {
            (states[k].gamma[i], states[k].l[i]) = (gamma[k], l[k]);
        }
    }
    states
}

/// The state at x ∈ [0, 1] of a step. (Without fused multiply-add: full accuracy is not needed, and where the compiler
/// cannot assume the instruction, it would be a function call.)
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

/// Zero counts as positive, so that a zero at a sample is counted once.
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
