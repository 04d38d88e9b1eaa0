//! Where pairs of eigenvalues meet along the curves of maxima of U_l, in f64 with bounds.
//!
//! With weights g_k and lines T_k proportional to γ_k² and μ − a_k, linear forms of the parameter of a family, and
//! Q = Σ a_k g_k the discriminant b² − 4c of Theorem 13.1 of docs/mathematics.md has the sign of B² − 4 det A Q² C, where
//! B and C are the sums in [`collision_form`]. Bernstein's form counts its roots, f64 finds each, and wider intervals fence it.

use super::reduced::Reduced;
use super::state::{Constants, State};
use crate::curves::{Mu, MuInterval, SymmetricFamily};
use bifdiag_body::{Axis, Frame};
use bifdiag_numbers::Sign;
use bifdiag_numbers::bernstein::{Form as FormOf, Isolation};
use bifdiag_numbers::enclosure::{Arithmetic, Enclosure};
use bifdiag_numbers::interval::Interval;
use bifdiag_numbers::root::itp;
use bifdiag_numbers::wide::Interval128;

/// Of degree 18 at most: three distinct moments that all carry r.
type CollisionForm = FormOf<19>;

/// No path from the exact body to a coefficient of the form has as many roundings: 21 to a weight, 80 to B, 65 to
/// C and 55 to Q², with which the products have 135 and 170.
const ROUNDINGS: f64 = 256.0;

/// The family on which collisions are sought.
#[derive(Clone, Copy, Debug)]
pub(super) enum CollisionFamily {
    /// The generic family over an interval that has a right end.
    Generic(MuInterval),
    /// The family over a passive moment, on z = 1/s².
    Over(SymmetricFamily),
}

/// A parameter of a family.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Parameter {
    /// μ.
    Mu(Mu),
    /// z.
    Z(f64),
}

/// A place where b² − 4c changes its sign.
#[derive(Clone, Copy, Debug)]
pub(super) struct Collision {
    /// Where, rounded.
    pub at: Parameter,
    /// l and h in the body's units, each with a bound on its error.
    pub place: [(f64, f64); 2],
    /// b > 0: imaginary pairs meet; else real ones.
    pub is_imaginary: bool,
    /// b² − 4c > 0 where |δ|, or z, is larger.
    pub apart_above: bool,
}

/// Every collision on a family; `None` where rounding leaves their number or place open. `exact` gives the body's
/// numbers, enclosed.
pub(super) fn collisions(
    frame: &Frame,
    c: &Constants<Interval>,
    exact: &dyn Fn() -> Constants<Interval128>,
    family: &CollisionFamily,
) -> Option<Vec<Collision>> {
    let isolations = collision_form(frame, family).isolate_roots(ROUNDINGS);
    let roots: Vec<Parameter> =
        isolations.iter().map(|isolation| family.root(frame, c, isolation)).collect::<Option<_>>()?;
    if roots.is_empty() {
        return Some(Vec::new());
    }
    let exact = exact();
    roots.into_iter().map(|at| family.fenced(&exact, c, frame, at)).collect()
}

/// B² − 4 det A Q² C with S = Σ a_k² g_k, unit U of the lines, and i, j, k cyclic:
/// B = (tr A Q − 2S)² U + Σ a_j a_k ((T_j g_k + T_k g_j) Q + 4 (a_j − a_k)² g_j g_k U),
/// C = Σ (g_i T_j T_k Q + 4 (a_j − a_k)² T_i g_j g_k U).
fn collision_form(frame: &Frame, family: &CollisionFamily) -> CollisionForm {
    let Lines { unit, line, weight } = family.lines(frame);
    let a = frame.a;
    let degree = weight.iter().flatten().map(CollisionForm::degree).max().unwrap_or(0);
    let mean = |factor: &dyn Fn(usize) -> f64| {
        let mut sum = CollisionForm::zero(degree);
        for k in 0..3 {
            if let Some(weight) = &weight[k] {
                sum.add_scaled(factor(k), weight);
            }
        }
        sum
    };
    let q = mean(&|k| a[k]);
    let mut gyroscopic = CollisionForm::zero(degree);
    gyroscopic.add_scaled(a[0] + a[1] + a[2], &q);
    gyroscopic.add_scaled(-2.0, &mean(&|k| a[k] * a[k]));
    let mut swing = gyroscopic.times(&gyroscopic).times(&unit);
    let mut product = CollisionForm::zero(2 * degree + 2);
    for i in 0..3 {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        for (m, n) in [(j, k), (k, j)] {
            if let Some(weight) = &weight[n] {
                swing.add_scaled(a[j] * a[k], &line[m].times(weight).times(&q));
            }
        }
        if let (Some(p), Some(r)) = (&weight[j], &weight[k]) {
            let gap = frame.diff[j][k];
            let coupled = p.times(r).times(&unit);
            swing.add_scaled(4.0 * a[j] * a[k] * gap * gap, &coupled);
            product.add_scaled(4.0 * gap * gap, &coupled.times(&line[i]));
        }
        if let Some(weight) = &weight[i] {
            product.add_scaled(1.0, &line[j].times(&line[k]).times(weight).times(&q));
        }
    }
    let mut form = swing.times(&swing);
    form.add_scaled(-4.0 * (a[0] * a[1] * a[2]), &q.times(&q).times(&product));
    form
}

/// A family in linear forms; a weight that vanishes throughout is left out.
struct Lines {
    unit: CollisionForm,
    line: [CollisionForm; 3],
    weight: [Option<CollisionForm>; 3],
}

impl CollisionFamily {
    fn lines(&self, frame: &Frame) -> Lines {
        let active = |k: Axis| frame.r[k] > 0.0;
        match self {
            Self::Generic(interval) => {
                let (ends, unit) = interval.lines(frame);
                let line = ends.map(|[at_zero, at_one]| CollisionForm::linear(at_zero, at_one));
                let weight = Axis::ALL.map(|k| {
                    let others =
                        Axis::ALL.into_iter().filter(|&m| m != k && active(m)).map(|m| line[m].times(&line[m]));
                    let product = others.reduce(|product, square| product.times(&square));
                    product.filter(|_| active(k)).map(|product| {
                        let mut weight = CollisionForm::zero(product.degree());
                        weight.add_scaled(frame.r[k] * frame.r[k], &product);
                        weight
                    })
                });
                Lines { unit: CollisionForm::linear(unit[0], unit[1]), line, weight }
            }
            // γ_k² = (r_k/(a − a_k))² z and the rest of 1, with z = u/P̂.
            Self::Over(family) => {
                let gap = |k: Axis| frame.diff[family.axis][k];
                let weight = Axis::ALL.map(|k| {
                    let ratio = frame.r[k] / (gap(k) * family.s_pitchfork);
                    if k == family.axis {
                        Some(CollisionForm::linear(1.0, 0.0))
                    } else {
                        active(k).then(|| CollisionForm::linear(0.0, ratio * ratio))
                    }
                });
                let line = Axis::ALL.map(|k| CollisionForm::linear(gap(k), gap(k)));
                Lines { unit: CollisionForm::linear(1.0, 1.0), line, weight }
            }
        }
    }

    /// The equilibrium over a positive |δ| or z.
    fn state<E: Enclosure>(&self, c: &Constants<E>, at: Parameter, size: E) -> State<E> {
        match (self, at) {
            (Self::Over(family), _) => State::over(c, family.axis, &size),
            (_, Parameter::Mu(mu)) if mu.delta < 0.0 => State::generic(c, mu.base, &-size),
            (_, Parameter::Mu(mu)) => State::generic(c, mu.base, &size),
            (Self::Generic(_), Parameter::Z(_)) => unreachable!("the generic family has the parameter μ"),
        }
    }

    /// The equilibrium at a parameter, linearised.
    pub(super) fn reduced(&self, c: &Constants<Interval>, at: Parameter) -> Reduced<Interval> {
        Reduced::new(c, &self.state(c, at, Interval::point(at.size())))
    }

    /// The root of b² − 4c in an isolating cell, rounded.
    fn root(&self, frame: &Frame, c: &Constants<Interval>, isolation: &Isolation) -> Option<Parameter> {
        if isolation.cluster.is_some() {
            return None;
        }
        let value = |at: Parameter| self.reduced(c, at).discriminant().middle().lo;
        match self {
            Self::Generic(interval) => {
                Some(Parameter::Mu(interval.polish(frame, isolation, |mu| value(Parameter::Mu(mu)))))
            }
            Self::Over(family) => {
                let z_max = 1.0 / (family.s_pitchfork * family.s_pitchfork);
                let [from, to] = isolation.cell.u.map(|u| u * z_max);
                let at = |z: f64| value(Parameter::Z(z));
                // The limit z = 0 is left out; the root is not there.
                let from = if from == 0.0 { f64::EPSILON * to } else { from };
                let (low, high) = (at(from), at(to));
                ((low > 0.0) != (high > 0.0)).then(|| Parameter::Z(itp(from, to, low, high, 0.0, at)))
            }
        }
    }

    /// The collision next to a parameter: steps of Newton's method, and signs on both sides of where it leads.
    fn fenced(
        &self,
        exact: &Constants<Interval128>,
        c: &Constants<Interval>,
        frame: &Frame,
        at: Parameter,
    ) -> Option<Collision> {
        let wide = |x: f64| Interval128::double(x, ());
        let reduced = |y: Interval128| Reduced::new(exact, &self.state(exact, at, y));
        let y = at.size();
        let rounded = |y: f64| Reduced::new(c, &self.state(c, at, Interval::point(y))).discriminant().middle().lo;
        let step = y * STEP;
        let slope = (rounded(y + step) - rounded(y - step)) / (2.0 * step);
        let (mut middle, mut reach) = (wide(y), f64::INFINITY);
        for _ in 0..STEPS {
            let [lo, hi] = reduced(middle.clone()).discriminant().bounds();
            let correction = -(lo + 0.5 * (hi - lo)) / slope;
            middle = middle + wide(correction);
            // The slope is known to a millionth and more; beyond, the bits end.
            reach = correction.abs() * 1e-3 + y * 1e-24;
            if reach <= ENOUGH * y {
                break;
            }
        }
        let (from, to) = (middle.clone() - wide(reach), middle + wide(reach));
        let [below, above] = [&from, &to].map(|y| reduced(y.clone()).discriminant().sign());
        if below? * above? != Sign::Negative {
            return None;
        }
        let state = self.state(exact, at, from.hull(&to));
        let is_imaginary = self.reduced(c, at).signs()[0]? == Sign::Positive;
        Some(Collision { at, place: state.place(exact, frame), is_imaginary, apart_above: above? == Sign::Positive })
    }
}

/// The most steps.
const STEPS: usize = 4;

/// Relative width of the fence with which no more steps are made: l and h are then right to the last bit or two.
const ENOUGH: f64 = 2e-17;

/// Relative distance over which the slope of b² − 4c is taken.
const STEP: f64 = 1e-6;

impl Parameter {
    /// |δ| or z.
    pub(super) fn size(self) -> f64 {
        match self {
            Self::Mu(mu) => mu.delta.abs(),
            Self::Z(z) => z,
        }
    }
}
