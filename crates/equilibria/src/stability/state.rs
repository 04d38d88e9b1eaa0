//! A relative equilibrium as the linearisation sees it, in any arithmetic: squares of γ, gaps to the multiplier, J and Ω²;
//! and one that f64 found, enclosed by Newton's method in intervals.

use dashu_ratio::RBig;

use crate::curves::Mu;
use bifdiag_body::{Axis, Frame};
use bifdiag_numbers::Sign;
use bifdiag_numbers::enclosure::{Arithmetic, Enclosure};
use bifdiag_numbers::interval::Interval;

/// A body in the frame's axes and units.
#[derive(Clone, Debug)]
pub struct Constants<E: Arithmetic> {
    /// Principal moments, ascending.
    pub a: [E; 3],
    /// Their inverses.
    pub inverse: [E; 3],
    /// `diff[i][j]` = a_i − a_j.
    pub diff: [[E; 3]; 3],
    /// r_k².
    pub rho: [E; 3],
    /// r_k ≠ 0.
    pub active: [bool; 3],
    /// tr A.
    pub trace: E,
    /// det A.
    pub determinant: E,
    /// The precision of all of them.
    pub precision: E::Precision,
}

impl<E: Arithmetic> Constants<E> {
    fn of(a: [E; 3], diff: [[E; 3]; 3], rho: [E; 3], active: [bool; 3], precision: E::Precision) -> Self {
        let [a1, a2, a3] = a.clone();
        Self {
            inverse: a.clone().map(|a| E::small(1, precision) / a),
            trace: a1.clone() + a2.clone() + a3.clone(),
            determinant: a1 * a2 * a3,
            a,
            diff,
            rho,
            active,
            precision,
        }
    }

    /// From exact moments and squares r_k².
    #[must_use]
    pub fn exact(a: &[RBig; 3], rho: &[RBig; 3], precision: E::Precision) -> Self {
        let number = |x: &RBig| E::rational(x, precision);
        let diff = std::array::from_fn(|i| std::array::from_fn(|j| number(&(&a[i] - &a[j]))));
        Self::of(
            a.each_ref().map(number),
            diff,
            rho.each_ref().map(number),
            rho.each_ref().map(|x| !x.is_zero()),
            precision,
        )
    }

    /// A small whole number.
    pub(super) fn small(&self, value: i32) -> E {
        E::small(value, self.precision)
    }
}

impl Constants<Interval> {
    /// From a frame, whose numbers are rounded.
    #[must_use]
    pub fn rounded(frame: &Frame) -> Self {
        // Square roots in a frame are rounded twice.
        const ROOT: f64 = 3.0;
        let squared = |x: f64| {
            let r = if x == 0.0 { Interval::ZERO } else { Interval::point(x).widened(ROOT) };
            r * r
        };
        let diff = frame.diff.map(|row| row.map(Interval::rounded));
        Self::of(frame.a.map(Interval::rounded), diff, frame.r.map(squared), frame.r.map(|x| x != 0.0), ())
    }
}

/// A relative equilibrium (Theorem 3.2 and Theorem 3.3 of docs/mathematics.md), or all those over a range of the parameter.
#[derive(Clone, Debug)]
pub struct State<E> {
    /// w_k = γ_k².
    pub w: [E; 3],
    /// γ, up to signs.
    pub gamma: [E; 3],
    /// τ_k = μ − a_k.
    pub tau: [E; 3],
    /// J = ⟨γ, Aγ⟩.
    pub j: E,
    /// s = Ω².
    pub s: E,
}

/// J about the moment a_base, which keeps it narrow where γ is near that axis.
fn moment<E: Enclosure>(c: &Constants<E>, w: &[E; 3], base: Axis) -> E {
    Axis::ALL
        .into_iter()
        .filter(|&k| k != base)
        .fold(c.a[base].clone(), |j, k| j + w[k].clone() * c.diff[k][base].clone())
}

impl<E: Enclosure> State<E> {
    /// The generic family at μ = a_base + δ; `base` is an active moment and δ holds no 0.
    #[must_use]
    pub fn generic(c: &Constants<E>, base: Axis, delta: &E) -> Self {
        let tau: [E; 3] =
            Axis::ALL.map(|k| if k == base { delta.clone() } else { delta.clone() + c.diff[base][k].clone() });
        // Weights r_k² (τ_base/τ_k)², only their quotient may be small.
        let weight: [Option<E>; 3] = Axis::ALL.map(|k| {
            c.active[k].then(|| {
                if k == base { c.rho[k].clone() } else { c.rho[k].clone() * (delta.clone() / tau[k].clone()).square() }
            })
        });
        let total = weight.iter().flatten().cloned().reduce(|sum, x| sum + x).unwrap_or_else(|| c.small(0));
        let w = weight.map(|g| g.map_or_else(|| c.small(0), |g| g / total.clone()));
        let length = total.sqrt();
        let gamma = Axis::ALL.map(|k| {
            if !c.active[k] {
                c.small(0)
            } else if k == base {
                c.rho[k].sqrt() / length.clone()
            } else {
                c.rho[k].sqrt() * delta.clone() / (tau[k].clone() * length.clone())
            }
        });
        let j = moment(c, &w, base);
        let s = (total / delta.square()).sqrt();
        Self { w, gamma, tau, j, s }
    }

    /// The family over the passive moment a_axis at z = 1/s².
    #[must_use]
    pub fn over(c: &Constants<E>, axis: Axis, z: &E) -> Self {
        let zeta = z.sqrt();
        let mut w: [E; 3] = Axis::ALL
            .map(|k| if c.active[k] { z.clone() * c.rho[k].clone() / c.diff[axis][k].square() } else { c.small(0) });
        w[axis] = w.iter().fold(c.small(1), |rest, w| rest - w.clone());
        let gamma = Axis::ALL.map(|k| {
            if c.active[k] {
                zeta.clone() * c.rho[k].sqrt() / c.diff[axis][k].clone()
            } else if k == axis {
                w[k].sqrt()
            } else {
                c.small(0)
            }
        });
        let j = moment(c, &w, axis);
        let s = (c.small(1) / z.clone()).sqrt();
        Self { w, gamma, tau: c.diff[axis].clone(), j, s }
    }

    /// Rotation about a principal axis, γ = ±e_axis, with Ω² = s > 0 and weight: τ_k = a_axis − a_k + `shift`, where the
    /// shift is ±r/s.
    #[must_use]
    pub fn about(c: &Constants<E>, axis: Axis, s: &E, shift: &E) -> Self {
        let w = Axis::ALL.map(|k| c.small(i32::from(k == axis)));
        let tau = Axis::ALL.map(|k| if k == axis { shift.clone() } else { c.diff[axis][k].clone() + shift.clone() });
        Self { gamma: w.clone(), w, tau, j: c.a[axis].clone(), s: s.clone() }
    }

    /// x = l²/2 = s J²/2.
    #[must_use]
    pub fn x(&self, c: &Constants<E>) -> E {
        self.s.clone() * self.j.square() / c.small(2)
    }

    /// l and h in the frame's units, in doubles.
    fn in_frame(&self, c: &Constants<E>) -> [[f64; 2]; 2] {
        let x = self.x(c);
        let l = (x.clone() * c.small(2)).sqrt();
        let h = x / self.j.clone() - self.potential(c);
        [l, h].map(|value| value.bounds())
    }

    /// Narrower enclosures do not improve l, h and Ω in doubles.
    #[must_use]
    pub fn is_sharp(&self, c: &Constants<E>) -> bool {
        let [l, h] = self.in_frame(c);
        [l, h, self.s.sqrt().bounds()].iter().all(|[lo, hi]| *hi <= lo.next_up().next_up())
    }

    /// Ω and μ = J + ⟨γ, r⟩/s, in the body's units and rounded; along a family μ is monotone, where l and h turn back at cusps.
    #[must_use]
    pub fn on_family(&self, c: &Constants<E>, frame: &Frame) -> [f64; 2] {
        let moment_unit = frame.momentum_unit / frame.frequency_unit;
        [(self.s.sqrt(), frame.frequency_unit), (self.j.clone() + self.gap(c), moment_unit)].map(|(value, unit)| {
            let [lo, hi] = value.bounds();
            (lo + 0.5 * (hi - lo)) * unit
        })
    }

    /// l and h in the body's units, each with a bound on its error.
    #[must_use]
    pub fn place(&self, c: &Constants<E>, frame: &Frame) -> [(f64, f64); 2] {
        let [l, h] = self.in_frame(c);
        [(l, frame.momentum_unit), (h, frame.energy_unit)].map(|([lo, hi], unit)| {
            let middle = lo + 0.5 * (hi - lo);
            (middle * unit, (hi - middle).max(middle - lo) * unit)
        })
    }

    /// −d ln x/dμ on the generic family: T + 4V/J (Lemma 3.5 of docs/mathematics.md).
    #[must_use]
    pub fn falling(&self, c: &Constants<E>) -> E {
        let mut mean = c.small(0);
        let mut spread = c.small(0);
        for i in (0..3).filter(|&i| c.active[i]) {
            mean = mean + self.w[i].clone() / self.tau[i].clone();
            for k in (i + 1..3).filter(|&k| c.active[k]) {
                let d = c.diff[i][k].square() / (self.tau[i].clone() * self.tau[k].clone());
                spread = spread + self.w[i].clone() * self.w[k].clone() * d;
            }
        }
        mean + c.small(4) * spread / self.j.clone()
    }

    /// The trace of the Hessian over s: Σ (1 − w_i)τ_i + (4/J)Σ v_i² (Proposition 4.2 of docs/mathematics.md).
    #[must_use]
    pub fn hessian_trace(&self, c: &Constants<E>) -> E {
        let (mut trace, mut spread) = (c.small(0), c.small(0));
        for i in 0..3 {
            let (n, m) = ((i + 1) % 3, (i + 2) % 3);
            trace = trace + (c.small(1) - self.w[i].clone()) * self.tau[i].clone();
            spread = spread + self.w[n].clone() * self.w[m].clone() * c.diff[n][m].square();
        }
        trace + c.small(4) * spread / self.j.clone()
    }

    /// ⟨γ, r⟩ = s(μ − J) (from s(μ − A)γ = r).
    #[must_use]
    pub fn potential(&self, c: &Constants<E>) -> E {
        self.s.clone() * self.gap(c)
    }

    /// μ − J.
    fn gap(&self, c: &Constants<E>) -> E {
        (0..3).fold(c.small(0), |sum, k| sum + self.w[k].clone() * self.tau[k].clone())
    }
}

/// Where a relative equilibrium lies on its family, as f64 found it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Place {
    /// On the generic family.
    Generic(Mu),
    /// Over a passive moment, with this s = Ω².
    Over {
        /// The axis of the frame.
        axis: Axis,
        /// Ω².
        s: f64,
        /// R̂ (Theorem 3.3 of docs/mathematics.md).
        r_sum: f64,
    },
    /// Rotation about a principal axis of the frame.
    About {
        /// The axis.
        axis: Axis,
        /// ⟨γ, r⟩: r, −r or, without weight, 0.
        weight: f64,
    },
}

/// Distance searched for the root, in units of the distance that the residual suggests.
const SAFETY: f64 = 2.0;

impl Place {
    /// An enclosure of the equilibrium at x = l²/2; `None` where f64 cannot separate it from a neighbour.
    #[must_use]
    pub fn enclosed(self, c: &Constants<Interval>, x: Interval) -> Option<State<Interval>> {
        match self {
            Self::Generic(mu) => {
                let at = State::generic(c, mu.base, &Interval::point(mu.delta));
                let change = logarithm(x, at.x(c))?;
                let reach = SAFETY * change.magnitude() / at.falling(c).magnitude();
                let range = around(mu.delta, reach)?;
                let over = State::generic(c, mu.base, &range);
                let step = change / over.falling(c);
                (step.magnitude() <= reach).then_some(over)
            }
            Self::Over { axis, s, r_sum } => {
                let r_sum = Interval::rounded(r_sum);
                let z = 1.0 / (s * s);
                // −d ln x/dz = (a + 3zR̂)/(2zJ)
                let falling = |at: &State<Interval>, z: Interval| (c.a[axis] + z * r_sum * 3.0) / (z * 2.0 * at.j);
                let point = Interval::point(z);
                let at = State::over(c, axis, &point);
                let change = logarithm(x, at.x(c))?;
                let reach = SAFETY * change.magnitude() / falling(&at, point).magnitude();
                let range = around(z, reach)?;
                let over = State::over(c, axis, &range);
                let step = change / falling(&over, range);
                (step.magnitude() <= reach && over.w[axis].sign() == Some(Sign::Positive)).then_some(over)
            }
            Self::About { axis, weight } => {
                let s = x * 2.0 / c.a[axis].square();
                let shift = if weight == 0.0 { Interval::ZERO } else { Interval::point(weight).widened(3.0) / s };
                Some(State::about(c, axis, &s, &shift))
            }
        }
    }
}

/// The doubles from y − reach to y + reach, if all of them have the sign of y.
fn around(y: f64, reach: f64) -> Option<Interval> {
    let range = Interval::between((y - reach).next_down(), (y + reach).next_up());
    range.is_positive().map(|_| range)
}

/// ln(x/y) of neighbours: with e = (x − y)/y it is e up to e².
fn logarithm(x: Interval, y: Interval) -> Option<Interval> {
    let e = (x - y) / y;
    let size = e.magnitude();
    (size < 1e-3).then(|| e + Interval::between(-size * size, size * size).widened(4.0))
}
