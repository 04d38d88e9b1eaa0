//! A relative equilibrium as the linearisation sees it, enclosed: squares of γ, gaps to the multiplier, J and Ω².

use super::constants::Constants;
use bifdiag_body::{Axis, Frame};
use bifdiag_numbers::enclosure::Enclosure;

/// A relative equilibrium (Theorem 3.2 and Theorem 3.3 of docs/mathematics.md), or all those over a range of the parameter.
#[derive(Clone, Debug)]
pub struct State<E> {
    /// w_k = γ_k².
    pub w: [E; 3],
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
        // Weights r_k² (τ_base/τ_k)², of which only the quotient may be small.
        let weight: [Option<E>; 3] = Axis::ALL.map(|k| {
            c.active[k].then(|| {
                if k == base { c.rho[k].clone() } else { c.rho[k].clone() * (delta.clone() / tau[k].clone()).square() }
            })
        });
        let total = weight.iter().flatten().cloned().reduce(|sum, x| sum + x).unwrap_or_else(|| c.small(0));
        let w = weight.map(|g| g.map_or_else(|| c.small(0), |g| g / total.clone()));
        let j = moment(c, &w, base);
        let s = (total / delta.square()).sqrt();
        Self { w, tau, j, s }
    }

    /// The family over the passive moment a_axis at z = 1/s².
    #[must_use]
    pub fn over(c: &Constants<E>, axis: Axis, z: &E) -> Self {
        let mut w: [E; 3] = Axis::ALL
            .map(|k| if c.active[k] { z.clone() * c.rho[k].clone() / c.diff[axis][k].square() } else { c.small(0) });
        w[axis] = w.iter().fold(c.small(1), |rest, w| rest - w.clone());
        let j = moment(c, &w, axis);
        let s = (c.small(1) / z.clone()).sqrt();
        Self { w, tau: c.diff[axis].clone(), j, s }
    }

    /// Rotation about a principal axis, γ = ±e_axis, with Ω² = s > 0 and weight: τ_k = a_axis − a_k + `shift`, where the
    /// shift is ±r/s.
    #[must_use]
    pub fn about(c: &Constants<E>, axis: Axis, s: &E, shift: &E) -> Self {
        let w = Axis::ALL.map(|k| c.small(i32::from(k == axis)));
        let tau = Axis::ALL.map(|k| if k == axis { shift.clone() } else { c.diff[axis][k].clone() + shift.clone() });
        Self { w, tau, j: c.a[axis].clone(), s: s.clone() }
    }

    /// x = l²/2 = s J²/2.
    #[must_use]
    pub fn x(&self, c: &Constants<E>) -> E {
        self.s.clone() * self.j.square() / c.small(2)
    }

    /// l and h in the body's units, each with a bound on its error.
    #[must_use]
    pub fn place(&self, c: &Constants<E>, frame: &Frame) -> [(f64, f64); 2] {
        let x = self.x(c);
        let l = (x.clone() * c.small(2)).sqrt();
        let h = x / self.j.clone() - self.potential(c);
        [(l, frame.momentum_unit), (h, frame.energy_unit)].map(|(value, unit)| {
            let [lo, hi] = value.bounds();
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
        let gap = (0..3).fold(c.small(0), |sum, k| sum + self.w[k].clone() * self.tau[k].clone());
        self.s.clone() * gap
    }
}
