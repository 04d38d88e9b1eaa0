//! Newton continuation of relative equilibria, the second way to them: slower than the closed form and without its
//! bounds, but it knows nothing of it beyond the point it starts from.
//!
//! A predictor–corrector method in pseudo-arclength follows the solutions of B_j γ_j = r_j (j = 1, 2, 3), |γ|² = 1, with
//! the gaps B_j = λ − sA_j and s = Ω². That is sAγ + r = λγ: γ is a critical point of U_l on S², l = ΩJ.
//!
//! Unknowns are Ω and the smallest gap b = B_i; the others are b + s(A_i − A_j), without cancellation, and γ_j = r_j/B_j.
//! On the pair over an axis i with r_i = 0 it is γ_i in place of b = 0. Distance along a branch is measured by dΩ/Ω,
//! dB_j/B_j and dγ_i. In that measure cusps, where dl = dh = 0, and the end l = 0 are ordinary points, l → ∞ is as many
//! steps away as ln l, and the sharp turn beside a pitchfork unfolded by a small r_j is a smooth stretch of length ln r_j.
//! The signs of the gaps cannot change along a branch, and two branches of one body differ in a sign: no step lands on
//! another branch unseen.

use super::{CriticalError, Equilibria, Multiplicity, RelativeEquilibria};
use crate::curves::{Branch, CurveId, CurveName, End, Orbit, Shape, abscissa};
use crate::stability::{Reduced, State};
use bifdiag_body::{Axis, Frame, Number};
use bifdiag_numbers::enclosure::Enclosure;
use bifdiag_numbers::interval::Interval;

/// Below this a step is lost in the rounding of the point that it starts from.
const SMALLEST_STEP: f64 = 1e-11;
const LARGEST_STEP: f64 = 0.5;
const MAX_STEPS: usize = 100_000;
/// Cosine of the largest angle between successive tangents.
const LARGEST_TURN: f64 = 0.9;
/// Largest difference between the change of l over a step and that by the trapezoidal rule, as a share of the larger slope:
/// a pair of cusps inside the step would show in it. Where l leaves a pitchfork with the fourth power, the share is ¼.
const LARGEST_DIP: f64 = 0.3;
/// Roundings of l: beside a pitchfork unfolded by a tiny r_j it stays the same double for many steps.
const ROUNDING: f64 = 1e-13;
/// Newton updates below this size leave an error of the order of its square: below rounding.
const CONVERGED: f64 = 2e-9;
const MAX_ITERATIONS: usize = 8;
/// Largest difference of γ from the closed form, and of h in units of its terms: continuation loses half the digits beside
/// a cusp or a pitchfork, where γ goes with a root of l.
const AGREEMENT: f64 = 1e-6;

/// What stays the same along a branch.
struct Tracker<'a> {
    frame: &'a Frame,
    /// r_i = 0 and B_i = 0 for this axis i, γ_i is free; `None`: γ_j = 0 wherever r_j = 0.
    pair: Option<Axis>,
    /// Signs of B_j on the axes with r_j ≠ 0; 0 on the others.
    sign: [f64; 3],
}

/// A point of the branch.
#[derive(Clone, Copy)]
struct Position {
    omega: f64,
    /// The axis i whose gap is an unknown; on a pair its own.
    anchor: Axis,
    gap: f64,
    /// γ_i of a pair.
    free: f64,
}

/// A direction at a position: x = δB_i/B_i of the anchor (δγ_i of a pair) and w = δΩ/scale.
type Step = [f64; 2];

/// The equations at a position to first order in a step.
struct Linear {
    /// δB_j/B_j where r_j ≠ 0.
    rates: [Step; 3],
    /// (|γ|² − 1)/2 and its derivative.
    norm: f64,
    norm_slope: Step,
    /// l and its derivative where |γ|² = 1.
    l: f64,
    l_slope: Step,
}

/// A unit tangent.
#[derive(Clone, Copy)]
struct Tangent {
    step: Step,
    rates: [f64; 3],
    scale: f64,
    /// dl.
    l: f64,
}

impl Tangent {
    fn reversed(self) -> Self {
        let Self { step, rates, scale, l } = self;
        Self { step: step.map(|x| -x), rates: rates.map(|x| -x), scale, l: -l }
    }
}

fn product(p: Step, q: Step) -> f64 {
    p[0] * q[0] + p[1] * q[1]
}

impl Tracker<'_> {
    /// The position at γ and Ω.
    fn position(&self, gamma: &[f64; 3], omega: f64) -> Position {
        if let Some(anchor) = self.pair {
            return Position { omega, anchor, gap: 0.0, free: gamma[anchor] };
        }
        let gap = |j: Axis| self.frame.r[j] / gamma[j];
        let anchor = self.active().min_by(|&i, &j| gap(i).abs().total_cmp(&gap(j).abs())).unwrap_or(Axis::ALL[0]);
        Position { omega, anchor, gap: gap(anchor), free: 0.0 }
    }

    fn active(&self) -> impl Iterator<Item = Axis> {
        Axis::ALL.into_iter().filter(|&j| self.sign[j] != 0.0)
    }

    fn gaps(&self, at: &Position) -> [f64; 3] {
        self.frame.diff[at.anchor].map(|difference| at.gap + at.omega * at.omega * difference)
    }

    fn gamma(&self, at: &Position) -> [f64; 3] {
        let gaps = self.gaps(at);
        Axis::ALL.map(|j| match self.pair {
            Some(axis) if axis == j => at.free,
            _ if self.sign[j] == 0.0 => 0.0,
            _ => self.frame.r[j] / gaps[j],
        })
    }

    /// J.
    fn moment(&self, gamma: &[f64; 3]) -> f64 {
        (0..3).map(|j| self.frame.a[j] * gamma[j] * gamma[j]).sum()
    }

    fn l(&self, at: &Position) -> f64 {
        at.omega * self.moment(&self.gamma(at))
    }

    /// The same position by its smallest gap.
    fn reanchored(&self, at: Position) -> Position {
        let gaps = self.gaps(&at);
        let smaller = |j: &Axis| gaps[*j].abs() < 0.5 * at.gap.abs();
        let smallest = self.active().filter(smaller).min_by(|&i, &j| gaps[i].abs().total_cmp(&gaps[j].abs()));
        smallest.map_or(at, |anchor| Position { anchor, gap: gaps[anchor], ..at })
    }

    fn linear(&self, at: &Position, scale: f64) -> Linear {
        let (gamma, gaps) = (self.gamma(at), self.gaps(at));
        let mut rates = [[0.0; 2]; 3];
        let (mut norm, mut norm_slope, mut turning) = (-0.5, [0.0; 2], [0.0; 2]);
        for j in Axis::ALL {
            let difference = self.frame.diff[at.anchor][j];
            if self.sign[j] != 0.0 {
                rates[j] = [at.gap / gaps[j], 2.0 * at.omega * scale * difference / gaps[j]];
            }
            let slope = if self.pair == Some(j) { [1.0, 0.0] } else { rates[j].map(|rate| -gamma[j] * rate) };
            norm += 0.5 * gamma[j] * gamma[j];
            for k in 0..2 {
                norm_slope[k] += gamma[j] * slope[k];
                turning[k] -= difference * gamma[j] * slope[k];
            }
        }
        // dl = J dΩ + 2Ω⟨Aγ, dγ⟩; as ⟨γ, dγ⟩ only makes good for |γ|² − 1, A − A_i is taken for A.
        let (moment, twice) = (self.moment(&gamma), 2.0 * at.omega);
        let l = at.omega * moment - twice * self.frame.a[at.anchor] * norm;
        Linear { rates, norm, norm_slope, l, l_slope: [twice * turning[0], moment * scale + twice * turning[1]] }
    }

    /// A unit tangent at a position on the branch.
    fn tangent(&self, at: &Position) -> Tangent {
        // √(r/a₃) is the angular velocity below which changes of Ω are measured absolutely.
        let floor = if self.frame.is_euler() { 1.0 } else { (self.frame.r_norm / self.frame.a[2]).sqrt() };
        let scale = at.omega.max(floor);
        let linear = self.linear(at, scale);
        let step = [-linear.norm_slope[1], linear.norm_slope[0]];
        let rates = linear.rates.map(|rate| product(rate, step));
        let length = self.product((&step, &rates), (&step, &rates)).sqrt();
        let l = product(linear.l_slope, step) / length;
        Tangent { step: step.map(|x| x / length), rates: rates.map(|x| x / length), scale, l }
    }

    /// The inner product of two directions in the measure of distance.
    fn product(&self, (p, p_rates): (&Step, &[f64; 3]), (q, q_rates): (&Step, &[f64; 3])) -> f64 {
        let free = if self.pair.is_some() { p[0] * q[0] } else { 0.0 };
        free + p[1] * q[1] + (0..3).map(|j| p_rates[j] * q_rates[j]).sum::<f64>()
    }

    /// The position a step away. The gap changes its logarithm by x: its sign is kept, and the error is of third order.
    fn moved(&self, at: &Position, [x, w]: Step, scale: f64) -> Position {
        let omega = at.omega + w * scale;
        match self.pair {
            Some(_) => Position { omega, free: at.free + x, ..*at },
            None => Position { omega, gap: at.gap * (1.0 + 0.5 * x) / (1.0 - 0.5 * x), ..*at },
        }
    }

    fn has_signs(&self, at: &Position) -> bool {
        let gaps = self.gaps(at);
        self.active().all(|j| gaps[j] * self.sign[j] > 0.0)
    }

    fn predicted(&self, base: &Position, tangent: &Tangent, step: f64) -> Option<Position> {
        let end = self.moved(base, tangent.step.map(|x| step * x), tangent.scale);
        self.has_signs(&end).then_some(end)
    }

    /// Newton's method for |γ|² = 1 and a condition c + ⟨slope, step⟩ = 0. Its first update may not exceed `reach`; `None` if
    /// it does not contract at once.
    fn corrected(
        &self,
        mut at: Position,
        condition: impl Fn(&Linear) -> (f64, Step),
        scale: f64,
        reach: f64,
    ) -> Option<Position> {
        let mut allowed = reach.max(CONVERGED);
        for _ in 0..MAX_ITERATIONS {
            let linear = self.linear(&at, scale);
            let ((n, [n_x, n_w]), (c, [c_x, c_w])) = ((linear.norm, linear.norm_slope), condition(&linear));
            let determinant = n_x * c_w - n_w * c_x;
            let step = [(n_w * c - n * c_w) / determinant, (n * c_x - n_x * c) / determinant];
            let rates = linear.rates.iter().map(|rate| product(*rate, step));
            let size = rates.chain(step).fold(0.0, |size: f64, x| size.max(x.abs()));
            at = self.moved(&at, step, scale);
            if size <= CONVERGED {
                return self.has_signs(&at).then_some(at);
            }
            // Written so that NaN is refused.
            if !(size <= allowed && step.iter().all(|x| x.is_finite())) {
                return None;
            }
            allowed = 0.5 * size;
        }
        None
    }

    /// A step, and the tangent at its end; `None` where it is too long.
    fn advance(&self, base: &Position, tangent: &Tangent, step: f64) -> Option<(Position, Tangent)> {
        // On the plane through the predicted point orthogonal to the tangent.
        let plane = |linear: &Linear| {
            let slope = |k: usize| {
                let unit = [f64::from(u8::from(k == 0)), f64::from(u8::from(k == 1))];
                self.product((&tangent.step, &tangent.rates), (&unit, &linear.rates.map(|rate| rate[k])))
            };
            (0.0, [slope(0), slope(1)])
        };
        let end = self.corrected(self.predicted(base, tangent, step)?, plane, tangent.scale, 0.5 * step)?;
        let end = self.reanchored(end);
        let mut ahead = self.tangent(&end);
        let turn = |ahead: &Tangent| self.product((&ahead.step, &ahead.rates), (&tangent.step, &tangent.rates));
        if turn(&ahead) < 0.0 {
            ahead = ahead.reversed();
        }
        let dip = (self.l(&end) - self.l(base)) / step - 0.5 * (tangent.l + ahead.l);
        let noise = ROUNDING * self.l(&end) / step;
        let smooth = dip.abs() <= LARGEST_DIP * tangent.l.max(ahead.l) + noise;
        (turn(&ahead) >= LARGEST_TURN && ahead.l > -noise && smooth).then_some((end, ahead))
    }

    /// The position at l inside a step, from the share of the step that the secant gives.
    fn land(&self, base: &Position, tangent: &Tangent, (end, step): (&Position, f64), l: f64) -> Option<Position> {
        let [from, to] = [base, end].map(|at| self.l(at));
        let share = if to > from { (l - from) / (to - from) } else { 1.0 };
        let predicted = self.predicted(base, tangent, share * step)?;
        self.corrected(predicted, |linear| (linear.l - l, linear.l_slope), tangent.scale, step.max(1e-6))
    }

    /// Follows the branch from a position, with l rising, to l. `None` when it is lost: steps below rounding, a fold before
    /// l is reached, or too many steps.
    fn follow(&self, mut base: Position, rising: Option<bool>, l: f64) -> Option<Position> {
        let mut tangent = self.tangent(&base);
        if !self.sets_out(&base, &tangent, rising) {
            tangent = tangent.reversed();
        }
        let mut step = 0.1;
        for _ in 0..MAX_STEPS {
            if step < SMALLEST_STEP {
                return None;
            }
            match self.advance(&base, &tangent, step) {
                Some((end, ahead)) if self.l(&end) < l => {
                    (base, tangent) = (end, ahead);
                    step = (1.5 * step).min(LARGEST_STEP);
                    continue;
                }
                Some((end, _)) => {
                    if let Some(found) = self.land(&base, &tangent, (&end, step), l) {
                        return Some(found);
                    }
                }
                None => {}
            }
            step *= 0.5;
        }
        None
    }

    /// Whether the tangent points where l rises; at a cusp, where it rises both ways, where μ = λ/Ω² (on a pair Ω) rises or
    /// falls as `rising` says.
    fn sets_out(&self, base: &Position, tangent: &Tangent, rising: Option<bool>) -> bool {
        let [x, w] = tangent.step;
        match (rising, self.pair) {
            (Some(rising), Some(_)) => (w > 0.0) == rising,
            // μ − A_i = B_i/Ω².
            (Some(rising), None) => ((x - 2.0 * w * tangent.scale / base.omega) * base.gap > 0.0) == rising,
            // From a pitchfork the only way is along the pair.
            (None, Some(_)) if base.free == 0.0 => x > 0.0,
            (None, _) => tangent.l > 0.0,
        }
    }
}

impl RelativeEquilibria<'_> {
    /// The equilibria at l, each found by Newton continuation along its curve from the curve's end at smaller l: l = 0, a cusp
    /// or a pitchfork. γ, h, Ω and, away from cusps and pitchforks, the Morse index are those found; names, multiplicities,
    /// eigenvalues and verdicts are those of [`at`](Self::at), and `error_bound` covers the difference in h as well. At l = 0
    /// there is nothing to follow.
    ///
    /// # Errors
    /// Those of [`at`](Self::at); [`CriticalError::Lost`] when a curve cannot be followed to l (as within rounding of a cusp
    /// or a pitchfork) or leads elsewhere.
    pub fn continued(&self, l: &Number) -> Result<Equilibria, CriticalError> {
        let mut found = self.at(l)?;
        if l.to_f64() == 0.0 {
            return Ok(found);
        }
        let frame = &self.set.frame;
        let momentum = (2.0 * abscissa(frame, l.to_f64())?).sqrt();
        let mut difference = 0.0_f64;
        for equilibrium in &mut found.list {
            let lost = || CriticalError::Lost { curve: equilibrium.curve };
            let named = |id: &CurveId| Some(CurveName::of(&self.set, *id)) == equilibrium.curve;
            let id = self.set.curves.ids().find(named).ok_or_else(lost)?;
            let (tracker, start, rising) = self.start(id).ok_or_else(lost)?;
            let end = tracker.follow(start, rising, momentum).ok_or_else(lost)?;
            let orbit = self.set.curves[id].orbit;
            let index = match orbit {
                Orbit::Circle(_) | Orbit::Sphere => equilibrium.index,
                // At a cusp or a pitchfork the Hessian is singular: its signs are no question for rounded numbers.
                _ if equilibrium.multiplicity == Multiplicity::Points(2) => equilibrium.index,
                _ => self.index(&tracker, &end).ok_or_else(lost)?,
            };
            let mut gamma = tracker.gamma(&end);
            let off = |gamma: [f64; 3]| {
                let gamma = frame.vector_to_body(gamma);
                (0..3).map(|k| (gamma[k] - equilibrium.gamma[k]).abs()).fold(0.0, f64::max)
            };
            if let Orbit::Pair(axis) = orbit {
                let mut image = gamma;
                image[axis] = -image[axis];
                if off(image) < off(gamma) {
                    gamma = image;
                }
            }
            let potential: f64 = (0..3).map(|j| gamma[j] * frame.r[j]).sum();
            let h = (0.5 * end.omega * end.omega * tracker.moment(&gamma) - potential) * frame.energy_unit;
            let size = (end.omega * momentum + frame.r_norm) * frame.energy_unit;
            let apart = (h - equilibrium.h).abs();
            if off(gamma) > AGREEMENT || apart > AGREEMENT * size || index != equilibrium.index {
                return Err(lost());
            }
            difference = difference.max(apart);
            equilibrium.omega = l.to_f64().signum() * end.omega * frame.frequency_unit;
            (equilibrium.h, equilibrium.gamma, equilibrium.index) = (h, frame.vector_to_body(gamma), index);
        }
        found.list = super::sorted(self.body, found.list, false);
        found.error_bound += difference;
        found.by_continuation = true;
        Ok(found)
    }

    /// The end of a curve at its smallest l, and at a cusp which way to go.
    fn start(&self, id: CurveId) -> Option<(Tracker<'_>, Position, Option<bool>)> {
        let (frame, curve) = (&self.set.frame, &self.set.curves[id]);
        let at = |point: &crate::curves::Point| (point.gamma, (2.0 * point.x).sqrt() / point.j);
        let ((gamma, omega), rising) = match curve.ends[0] {
            End::Origin => match &curve.arcs[0].shape {
                Shape::Generic(segments) => ((frame.r_hat().map(|x| segments[0].sign * x), 0.0), None),
                Shape::Straight { gamma, .. } => ((*gamma, 0.0), None),
                Shape::Symmetric { .. } => return None,
            },
            // The two curves of a cusp are in the order of the branch's parameter.
            End::Cusp(number) => {
                let cusp = &self.set.cusps[number];
                (at(&cusp.point), Some(cusp.curves[1] == id))
            }
            End::Pitchfork(number) => (at(&self.set.pitchforks[number].point), None),
            End::Infinity => return None,
        };
        let pair = if let Branch::Symmetric(axis) = curve.branch { Some(axis) } else { None };
        let sign = std::array::from_fn(|j| if frame.r[j] == 0.0 { 0.0 } else { gamma[j].signum() });
        let tracker = Tracker { frame, pair, sign };
        let start = tracker.position(&gamma, omega);
        Some((tracker, start, rising))
    }

    /// Morse index of U_l, `None` where an eigenvalue of the Hessian is zero within rounding.
    fn index(&self, tracker: &Tracker, at: &Position) -> Option<u8> {
        let near = |x: f64| Interval::point(x).widened(8.0);
        let (gamma, s) = (tracker.gamma(at), at.omega * at.omega);
        let state = State {
            w: gamma.map(|x| near(x * x)),
            gamma: gamma.map(near),
            tau: tracker.gaps(at).map(|gap| near(gap / s)),
            j: near(tracker.moment(&gamma)),
            s: near(s),
        };
        Reduced::new(&self.constants, &state).index(state.hessian_trace(&self.constants).sign())
    }
}
