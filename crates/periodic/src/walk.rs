//! Once around a closed orbit: its crossings of P, its action, and the reversors that it is symmetric under.

use bifdiag_dynamics::field::{HeavyTop, Integrals, State, dot};
use bifdiag_dynamics::integrator::TaylorStep;
use bifdiag_dynamics::section::SectionCondition;

use crate::flow::{Phase, Space};
use crate::reversor::Reversor;
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
    /// For each of the places that were asked for, how near the orbit comes to it.
    pub nearest: Vec<f64>,
}

/// Places in a step at which signs are looked at.
const LOOKS: usize = 8;
/// A state that a reversor moves no further is one of its fixed points, and so far at most where the trace is nearly 2: the
/// orbits beside one close nearly as well there, and it is known only to its defect over what the trace is off 2.
const FIXED: [f64; 2] = [1e-6, 1e-4];
/// |S| that is 0 all the way around, in its unit: the orbit lies in P.
const FLAT: f64 = 1e-9;

/// Goes once around along the steps of the passages, which begin anew at each node, so that errors do not grow on the way.
#[must_use]
pub fn walk(space: &Space, shot: &Shot, reversors: &[Reversor], places: &[Phase]) -> Walk {
    let top = &space.top;
    let begin = space.state(&shot.ring.nodes[0]);
    let energy = Integrals::of(top, &begin).energy;
    let known = RESIDUAL / (shot.reduced().trace() - 2.0).abs();
    let mut walker = Walker {
        space,
        fixed: known.clamp(FIXED[0], FIXED[1]),
        reversors,
        places,
        largest: 0.0,
        found: Walk {
            crossings: 0,
            maximum: None,
            // Twice the kinetic energy is 2(H + ⟨γ,r⟩).
            action: 2.0 * energy * shot.ring.period,
            symmetric: false,
            nearest: vec![f64::INFINITY; places.len()],
        },
    };
    let first = walker.seen(begin);
    let mut last = first.clone();
    let count = shot.passages.len();
    for (number, passage) in shot.passages.iter().enumerate() {
        // It ends as it began: a zero there is seen once, whatever its sign is rounded to.
        let closing = (number + 1 == count).then_some(&first);
        last = walker.part(&passage.steps, last, closing);
    }
    let Walker { mut found, largest, .. } = walker;
    if largest <= FLAT * SectionCondition::Height.scale(top, energy) {
        (found.crossings, found.maximum) = (0, None);
    }
    found
}

/// On the way.
struct Walker<'a> {
    space: &'a Space,
    /// What a reversor may move its fixed points.
    fixed: f64,
    reversors: &'a [Reversor],
    places: &'a [Phase],
    /// The largest |S| so far.
    largest: f64,
    found: Walk,
}

/// What is seen at a place.
#[derive(Clone)]
struct Seen {
    state: State,
    /// S.
    height: f64,
    /// Ṡ.
    rate: f64,
    /// How far each reversor moves it, signed.
    moved: Vec<f64>,
}

impl Walker<'_> {
    fn seen(&self, state: State) -> Seen {
        let top = &self.space.top;
        // Where the orbit is known to be symmetric nobody asks any more.
        let asked: &[Reversor] = if self.found.symmetric { &[] } else { self.reversors };
        Seen {
            height: SectionCondition::Height.value(top, &state),
            rate: SectionCondition::Height.rate(top, &state),
            moved: asked.iter().map(|reversor| reversor.distance(self.space, &state).0).collect(),
            state,
        }
    }

    /// From a node to the next; `closing` is what is seen at the end if that is known.
    fn part(&mut self, steps: &[TaylorStep], mut last: Seen, closing: Option<&Seen>) -> Seen {
        for (number, step) in steps.iter().enumerate() {
            self.found.action += 2.0 * height_along(&self.space.top, step);
            for (k, state) in looks(step).into_iter().enumerate() {
                let ends = [k, k + 1].map(|k| k as f64 / LOOKS as f64);
                let mut next = self.seen(state);
                if let Some(closing) = closing.filter(|_| number + 1 == steps.len() && k + 1 == LOOKS) {
                    next.height = closing.height;
                    next.moved.clone_from(&closing.moved);
                }
                self.look(step, ends, [&last, &next]);
                last = next;
            }
        }
        last
    }

    /// Between two looks.
    fn look(&mut self, step: &TaylorStep, ends: [f64; 2], seen: [&Seen; 2]) {
        let top = &self.space.top;
        let height = |x: f64| SectionCondition::Height.value(top, &at(step, x));
        let rate = |x: f64| SectionCondition::Height.rate(top, &at(step, x));
        let (values, rates) = (seen.map(|seen| seen.height), seen.map(|seen| seen.rate));
        self.largest = self.largest.max(values[1].abs());
        if is_change(values) {
            self.crossing(step, ends, values, height);
        } else if is_change(rates) {
            // Between two looks S may go to 0 and back.
            let middle = zero(rate, ends, rates);
            let value = height(middle);
            self.crossing(step, [ends[0], middle], [values[0], value], height);
            self.crossing(step, [middle, ends[1]], [value, values[1]], height);
        }
        if !self.found.symmetric {
            let fixed = |(number, reversor): (usize, &Reversor)| {
                let from = |x: f64| reversor.distance(self.space, &at(step, x));
                let moved = seen.map(|seen| seen.moved[number]);
                is_change(moved) && from(zero(|x| from(x).0, ends, moved)).1 < self.fixed
            };
            self.found.symmetric = self.reversors.iter().enumerate().any(fixed);
        }
        let here = self.space.point(&seen[0].state);
        for (nearest, place) in self.found.nearest.iter_mut().zip(self.places) {
            *nearest = nearest.min((here - place).norm());
        }
    }

    /// Counts a zero of S, if there is one between the ends.
    fn crossing(&mut self, step: &TaylorStep, ends: [f64; 2], values: [f64; 2], height: impl Fn(f64) -> f64) {
        if is_change(values) {
            self.found.crossings += 1;
            if values[1] < values[0] && self.found.maximum.is_none() {
                self.found.maximum = Some(at(step, zero(height, ends, values)));
            }
        }
    }
}

/// The states at the places where signs are looked at: what [`at`] gives, all at once.
fn looks(step: &TaylorStep) -> [State; LOOKS] {
    let places: [f64; LOOKS] = std::array::from_fn(|k| (k + 1) as f64 / LOOKS as f64);
    let mut states = [State::default(); LOOKS];
    for i in 0..3 {
        let (mut gamma, mut l) = ([0.0; LOOKS], [0.0; LOOKS]);
        for coefficient in step.coefficients().iter().rev() {
            for k in 0..LOOKS {
                gamma[k] = gamma[k] * places[k] + coefficient.gamma[i];
                l[k] = l[k] * places[k] + coefficient.l[i];
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

/// ∫⟨γ, r⟩ dt over a step, of its polynomial.
fn height_along(top: &HeavyTop, step: &TaylorStep) -> f64 {
    let terms = step.coefficients().iter().enumerate();
    terms.map(|(k, c)| dot(c.gamma, top.center()) / (k + 1) as f64).sum::<f64>() * step.length()
}
