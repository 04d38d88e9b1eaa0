//! Points of the families of relative equilibria, enclosed (Theorem 3.2 and Theorem 3.3 of docs/mathematics.md).
//!
//! A family is cut into halves; on each a coordinate y ≥ 0 measures the exact distance from its base:
//! |μ − a_base| on the generic family, v − P̂ with v = s² over a group without r. However small y is, nothing cancels.

use super::model::{Constants, Model};
use bifdiag_numbers::Sign;
use bifdiag_numbers::enclosure::{Arithmetic, Enclosure};

/// A half of a family with its coordinate y > 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Half {
    /// μ = a_base + sign · y.
    Generic { base: usize, sign: Sign },
    /// v = s² = P̂ + y over a group that carries no r.
    Over { group: usize },
}

/// A relative equilibrium, or all of them over a range of y.
#[derive(Clone, Debug)]
pub(super) struct State<E: Arithmetic> {
    /// γ along the first axis of each group.
    pub gamma: Vec<E>,
    pub j: E,
    /// ⟨γ, r⟩.
    pub rho: E,
    /// x = l²/2 = s J²/2.
    pub x: E,
    /// μ − a_k.
    pub tau: Vec<E>,
    /// d ln x / dy.
    pub log_slope: E,
    /// dJ/dy.
    pub j_slope: E,
}

/// What x of the generic family needs.
struct Weights<E: Arithmetic> {
    /// μ − a_k.
    tau: Vec<E>,
    /// τ_base/τ_k of the moments that carry r.
    ratio: Vec<Option<E>>,
    /// √P |τ_base|.
    root: E,
    /// γ_k².
    w: Vec<E>,
    j: E,
    x: E,
}

impl<E: Arithmetic> Weights<E> {
    fn generic(model: &Model, c: &Constants<E>, base: usize, sign: Sign, y: &E) -> Self {
        let zero = c.small(0);
        let delta = sign.orient(y.clone());
        let n = model.groups.len();
        let tau: Vec<E> =
            (0..n).map(|k| if k == base { delta.clone() } else { delta.clone() + c.diff[base][k].clone() }).collect();
        // Scaled by τ_base², which alone may be small: weights q_k (τ_base/τ_k)².
        let lead = tau[base].clone();
        let ratio: Vec<Option<E>> = (0..n)
            .map(|k| {
                let carries = model.active.contains(&k);
                carries.then(|| if k == base { c.small(1) } else { lead.clone() / tau[k].clone() })
            })
            .collect();
        let weight: Vec<Option<E>> = (0..n).map(|k| ratio[k].as_ref().map(|t| c.q[k].clone() * t.square())).collect();
        let total = sum(weight.iter().flatten().cloned(), &zero);
        // s = √P = √total / |τ_base|.
        let root = total.sqrt();
        let s = root.clone() / y.clone();
        let w: Vec<E> = weight.iter().map(|g| g.as_ref().map_or(zero.clone(), |g| g.clone() / total.clone())).collect();
        let j = mean(&w, c);
        let x = s * j.square() * half::<E>(c);
        Self { tau, ratio, root, w, j, x }
    }
}

impl<E: Arithmetic> State<E> {
    /// The state at y (> 0; 0 too over a group without r).
    pub fn at(model: &Model, c: &Constants<E>, half: Half, y: &E) -> Self {
        match half {
            Half::Generic { base, sign } => Self::generic(model, c, base, sign, y),
            Half::Over { group } => Self::over(model, c, group, y),
        }
    }

    /// x alone: less than half of the work.
    pub fn x_at(model: &Model, c: &Constants<E>, half: Half, y: &E) -> E {
        match half {
            Half::Generic { base, sign } => Weights::generic(model, c, base, sign, y).x,
            Half::Over { group } => Self::over(model, c, group, y).x,
        }
    }

    fn generic(model: &Model, c: &Constants<E>, base: usize, sign: Sign, y: &E) -> Self {
        let zero = c.small(0);
        let n = model.groups.len();
        let Weights { tau, ratio, root, w, j, x } = Weights::generic(model, c, base, sign, y);
        let gamma: Vec<E> = (0..n)
            .map(|k| {
                let Some(t) = &ratio[k] else { return zero.clone() };
                sign.orient(c.root_q[k].clone() * t.clone() / root.clone())
            })
            .collect();
        let rho = sum((0..n).map(|k| gamma[k].clone() * c.root_q[k].clone()), &zero);
        // T and V, times τ_base.
        let mean_ratio = sum((0..n).filter_map(|k| ratio[k].as_ref().map(|t| w[k].clone() * t.clone())), &zero);
        let mut spread = zero.clone();
        for i in 0..n {
            for k in i + 1..n {
                if let (Some(p), Some(q)) = (&ratio[i], &ratio[k]) {
                    let d = c.diff[i][k].square();
                    // w w d²/(τ_i τ_k) · τ_base = w w d² ratio_i / τ_k; the division by what is not small.
                    let (num, den) = if i == base { (p, &tau[k]) } else { (q, &tau[i]) };
                    spread = spread + w[i].clone() * w[k].clone() * d * num.clone() / den.clone();
                }
            }
        }
        // d ln x/dy = sign · d ln x/dμ = −sign (T + 4V/J).
        let bracket = mean_ratio + c.small(4) * spread.clone() / j.clone();
        let log_slope = -(bracket / y.clone());
        let j_slope = -(c.small(2) * spread / y.clone());
        Self { gamma, j, rho, x, tau, log_slope, j_slope }
    }

    fn over(model: &Model, c: &Constants<E>, group: usize, y: &E) -> Self {
        let zero = c.small(0);
        let n = model.groups.len();
        let (r_sum, p_sum) = c.sums[group].clone().unwrap_or((zero.clone(), zero.clone()));
        let v = p_sum + y.clone();
        let s = v.sqrt();
        let gamma: Vec<E> = (0..n)
            .map(|k| {
                if k == group {
                    (y.clone() / v.clone()).sqrt()
                } else if model.active.contains(&k) {
                    c.root_q[k].clone() / (s.clone() * c.diff[group][k].clone())
                } else {
                    zero.clone()
                }
            })
            .collect();
        let shift = r_sum.clone() / v.clone();
        let j = c.a[group].clone() - shift.clone();
        let rho = r_sum / s.clone();
        let x = s.clone() * j.square() * half::<E>(c);
        let tau = (0..n).map(|k| c.diff[group][k].clone()).collect();
        // x = √v J²/2: d ln x/dv = (1/2 + 2(R̂/v)/J)/v, dJ/dv = (R̂/v)/v.
        let log_slope = (half::<E>(c) + c.small(2) * shift.clone() / j.clone()) / v.clone();
        let j_slope = shift / v;
        Self { gamma, j, rho, x, tau, log_slope, j_slope }
    }

    /// h = x/J − ρ.
    pub fn h(&self) -> E {
        self.x.clone() / self.j.clone() - self.rho.clone()
    }
}

/// d²h/dx² = d(1/J)/dx of all states of an arc as −J'/(J² x) over (ln x)', with derivatives by y: where the arc ends at a cusp the
/// latter is 0 at the end, and has one sign inside.
#[derive(Clone, Debug)]
pub(super) struct Curvature<E> {
    numerator: E,
    denominator: E,
    /// The sign of the denominator inside, where it is 0 at the end at most.
    sign: Option<Sign>,
}

impl<E: Enclosure> Curvature<E> {
    /// From the states of an arc, with the one at its end and one inside.
    pub fn of(arc: &State<E>, [end, inside]: [&State<E>; 2]) -> Self {
        let numerator = -(arc.j_slope.clone() / (arc.j.square() * arc.x.clone()));
        let is_cusp = end.log_slope.strict_sign().is_none();
        let deciding = if is_cusp { inside } else { arc };
        Self { numerator, denominator: arc.log_slope.clone(), sign: deciding.log_slope.strict_sign() }
    }

    /// For a straight line.
    pub fn zero(c: &Constants<E>) -> Self {
        Self { numerator: c.small(0), denominator: c.small(1), sign: Some(Sign::Positive) }
    }

    /// The sign of the difference to another one inside of both arcs, if it is the same everywhere.
    pub fn minus(&self, other: &Self) -> Option<Sign> {
        if [self, other].iter().all(|arc| arc.denominator.strict_sign().is_some()) {
            let quotient = |arc: &Self| arc.numerator.clone() / arc.denominator.clone();
            return (quotient(self) - quotient(other)).strict_sign();
        }
        let product = |p: &Self, q: &Self| p.numerator.clone() * q.denominator.clone();
        Some((product(self, other) - product(other, self)).strict_sign()? * self.sign? * other.sign?)
    }
}

fn half<E: Arithmetic>(c: &Constants<E>) -> E {
    E::double(0.5, c.precision)
}

fn sum<E: Arithmetic>(terms: impl Iterator<Item = E>, zero: &E) -> E {
    terms.fold(zero.clone(), |total, term| total + term)
}

/// Σ w a with Σ w = 1: the narrowest over all choices of a moment to measure from.
fn mean<E: Arithmetic>(w: &[E], c: &Constants<E>) -> E {
    let about = |base: usize| {
        (0..w.len())
            .filter(|&k| k != base)
            .fold(c.a[base].clone(), |total, k| total + w[k].clone() * c.diff[k][base].clone())
    };
    (1..w.len()).fold(about(0), |best, base| c.common(&best, &about(base)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use bifdiag_body::Body;
    use bifdiag_equilibria::curves::{GenericState, Mu, SymmetricFamily};
    use bifdiag_numbers::enclosure::Enclosure;
    use bifdiag_numbers::interval::Interval;
    use bifdiag_numbers::wide::Wide;

    const BODIES: [([&str; 3], [&str; 3]); 3] = [
        (["2", "1.1", "1"], ["0.3", "0.5", "0.7"]),
        (["2", "1.1", "1"], ["0.94868", "0", "0.61623"]),
        (["1", "1.3", "1.9"], ["0.8", "1e-4", "0.6"]),
    ];

    fn near<E: Enclosure>(set: &E, value: f64, tolerance: f64) {
        let [lo, hi] = set.bounds();
        let slack = tolerance * (1.0 + value.abs());
        assert!(lo - slack <= value && value <= hi + slack && hi - lo < slack, "{value} in [{lo}, {hi}]");
    }

    fn compare<E: Enclosure>(precision: E::Precision) {
        for (a, r) in BODIES {
            let body = Body::parse(&a, &r).unwrap();
            let frame = body.frame();
            let model = Model::new(&body, &frame);
            let c = Constants::<E>::new(&model, precision);
            for &base in &model.active {
                for sign in Sign::BOTH {
                    for y in [1e-9, 0.03, 0.2] {
                        let state = State::at(&model, &c, Half::Generic { base, sign }, &E::double(y, precision));
                        let mu = Mu { base: model.axis[base], delta: f64::from(sign) * y };
                        let expected = GenericState::at(&frame, mu);
                        near(&state.j, expected.j, 1e-12);
                        near(&(state.x.clone() * E::double(y, precision)), expected.x * y, 1e-12);
                        let slope = f64::from(sign) * expected.log_slope() * y;
                        near(&(state.log_slope.clone() * E::double(y, precision)), slope, 1e-11);
                        for k in 0..3 {
                            near(&state.gamma[k], expected.gamma[k], 1e-12);
                        }
                    }
                }
            }
            for &group in &model.passive {
                let family = SymmetricFamily::over(&frame, model.axis[group]);
                for t in [0.1, 1.0, 10.0] {
                    let y = t * (2.0 * family.s_pitchfork + t);
                    let state = State::at(&model, &c, Half::Over { group }, &E::double(y, precision));
                    let expected = family.at(&frame, t);
                    near(&state.x, expected.x, 1e-12);
                    near(
                        &(state.x.clone()
                            * state.log_slope.clone()
                            * c.small(2)
                            * E::double(family.s_pitchfork + t, precision)),
                        expected.x_slope,
                        1e-12,
                    );
                    near(&state.gamma[group], expected.gamma[group], 1e-12);
                }
            }
        }
    }

    #[test]
    fn both_arithmetics_enclose_the_closed_form() {
        compare::<Interval>(());
        compare::<Wide>(100);
    }
}
