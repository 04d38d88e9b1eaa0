//! The flow reduced by l near a relative equilibrium: λ⁴ + bλ² + c, its signs and its roots, in any arithmetic.

use super::linear_type::{LinearType, Signs};
use super::state::{Constants, State};
use bifdiag_numbers::Sign;
use bifdiag_numbers::enclosure::Enclosure;

/// m and n of the resonances 1:1, 1:2 and 1:3 of two imaginary pairs: mb² = nc.
pub const RESONANCES: [[i32; 2]; 3] = [[1, 4], [4, 25], [9, 100]];

/// λ⁴ + bλ² + c with b = sβ, c = s²χ (Theorem 13.1 of docs/mathematics.md, Ω² = s taken out).
#[derive(Clone, Debug)]
pub struct Reduced<E> {
    s: E,
    beta: E,
    chi: E,
    /// β² − 4χ.
    discriminant: E,
    /// The part g²/(s det M) of β.
    gyroscopic: E,
    half: E,
}

/// The two eigenvalues with re ≥ 0 and im ≥ 0, each as [re, im], real ones first, then by size; and a bound on the error
/// of every one of the four numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Eigenvalues {
    /// λ₁ and λ₂.
    pub pairs: [[f64; 2]; 2],
    /// Bound on the error of each part.
    pub error: f64,
}

impl Eigenvalues {
    /// Fewer than seven digits of some part are known.
    #[must_use]
    pub fn are_coarse(&self) -> bool {
        const COARSE: f64 = 1e-7;
        self.pairs.as_flattened().iter().any(|part| *part != 0.0 && self.error > COARSE * part)
    }
}

impl<E: Enclosure> Reduced<E> {
    /// From an equilibrium: with v = γ×Aγ, g = tr A − 2|Aγ|²/J,
    /// β = g²J/det A + Σ_i (τ_j w_k + τ_k w_j + 4v_i²/J)/A_i and χ det A = Σ_i (w_i τ_j τ_k J + 4τ_i v_i²).
    #[must_use]
    pub fn new(c: &Constants<E>, state: &State<E>) -> Self {
        let State { w, tau, j, s, .. } = state;
        let (zero, four) = (c.small(0), c.small(4));
        let four_over_j = four.clone() / j.clone();
        let (mut beta, mut chi, mut squared) = (zero.clone(), zero.clone(), zero);
        for i in 0..3 {
            let (n, m) = ((i + 1) % 3, (i + 2) % 3);
            let v = w[n].clone() * w[m].clone() * c.diff[n][m].square();
            let swing = tau[n].clone() * w[m].clone() + tau[m].clone() * w[n].clone() + four_over_j.clone() * v.clone();
            beta = beta + c.inverse[i].clone() * swing;
            chi = chi + w[i].clone() * tau[n].clone() * tau[m].clone() * j.clone() + four.clone() * tau[i].clone() * v;
            squared = squared + w[i].clone() * c.a[i].square();
        }
        let g = c.trace.clone() - c.small(2) * squared / j.clone();
        let gyroscopic = g.square() * j.clone() / c.determinant.clone();
        beta = beta + gyroscopic.clone();
        chi = chi / c.determinant.clone();
        let discriminant = beta.square() - four * chi.clone();
        Self { s: s.clone(), beta, chi, discriminant, gyroscopic, half: E::double(0.5, c.precision) }
    }

    /// At rest: γ = ±r̂ with w = r̂², where b = ±r Σ(1 − w_i)/A_i and c = r²J/det A; `r` carries the sign.
    #[must_use]
    pub fn at_rest(c: &Constants<E>, w: &[E; 3], r: &E) -> Self {
        let (mut sum, mut j) = (c.small(0), c.small(0));
        for i in 0..3 {
            sum = sum + (c.small(1) - w[i].clone()) * c.inverse[i].clone();
            j = j + w[i].clone() * c.a[i].clone();
        }
        let (beta, chi) = (r.clone() * sum, r.square() * j / c.determinant.clone());
        let discriminant = beta.square() - c.small(4) * chi.clone();
        let gyroscopic = c.small(0);
        Self { s: c.small(1), beta, chi, discriminant, gyroscopic, half: E::double(0.5, c.precision) }
    }

    /// The same with b = 0, where that is known.
    #[must_use]
    pub fn without_b(mut self) -> Self {
        self.beta = self.half.clone() - self.half.clone();
        self
    }

    /// β and χ.
    #[must_use]
    pub fn coefficients(&self) -> [&E; 2] {
        [&self.beta, &self.chi]
    }

    /// β² − 4χ.
    #[must_use]
    pub fn discriminant(&self) -> &E {
        &self.discriminant
    }

    /// The part of β that stems from the gyroscopic forces, g²/(s det M).
    #[must_use]
    pub fn gyroscopic(&self) -> &E {
        &self.gyroscopic
    }

    /// The signs that are certain.
    #[must_use]
    pub fn signs(&self) -> [Option<Sign>; 3] {
        [self.beta.sign(), self.chi.sign(), self.discriminant.sign()]
    }

    /// Morse index of U_l, from the sign of the trace of its Hessian.
    #[must_use]
    pub fn index(&self, trace: Option<Sign>) -> Option<u8> {
        match (self.chi.sign()?, trace) {
            (Sign::Negative, _) => Some(1),
            (Sign::Positive, Some(Sign::Positive)) => Some(0),
            (Sign::Positive, Some(Sign::Negative)) => Some(2),
            _ => None,
        }
    }

    /// The linear type, if the signs that decide it are certain.
    #[must_use]
    pub fn linear_type(&self) -> Option<LinearType> {
        let [b, c, discriminant] = self.signs();
        // c < 0 and b² < 4c leave nothing for the other signs to say, and c = 0 only b.
        let signs = match (c?, discriminant) {
            (c @ Sign::Negative, _) => Signs { b: Sign::Positive, c, discriminant: Sign::Positive },
            (c @ Sign::Zero, _) => Signs { b: b?, c, discriminant: Sign::Positive },
            (c, Some(Sign::Negative)) => Signs { b: Sign::Positive, c, discriminant: Sign::Negative },
            (c, discriminant) => Signs { b: b?, c, discriminant: discriminant? },
        };
        Some(signs.linear_type())
    }

    /// The type across a circle or a sphere of equilibria.
    #[must_use]
    pub fn transverse_type(&self) -> Option<LinearType> {
        self.beta.sign().map(Signs::transverse_type)
    }

    /// The eigenvalues, of a type that is known, times `unit`. On a circle: the transverse pair, then zero.
    #[must_use]
    pub fn eigenvalues(&self, kind: LinearType, is_circle: bool, unit: f64) -> Eigenvalues {
        let parts = if is_circle { self.beside_zero() } else { self.four(kind) };
        let mut error = 0.0_f64;
        let pairs = parts.map(|pair| {
            pair.map(|part| {
                let Some(part) = part else { return 0.0 };
                let [lo, hi] = part.bounds().map(|x| x.max(0.0));
                let middle = lo + 0.5 * (hi - lo);
                error = error.max(((hi - middle).max(middle - lo) + f64::EPSILON * middle) * unit);
                middle * unit
            })
        });
        Eigenvalues { pairs: sorted(pairs), error }
    }

    /// λ² = −b, and a pair of zeros.
    fn beside_zero(&self) -> [[Option<E>; 2]; 2] {
        let size = |x: E| Some((self.s.clone() * x).sqrt());
        let first = match self.beta.sign() {
            Some(Sign::Zero) => [None, None],
            Some(Sign::Negative) => [size(-self.beta.clone()), None],
            _ => [None, size(self.beta.clone())],
        };
        [first, [None, None]]
    }

    /// The roots of κ² + βκ + χ, λ² = sκ.
    fn four(&self, kind: LinearType) -> [[Option<E>; 2]; 2] {
        let half = |x: E| x * self.half.clone();
        let size = |x: E| Some((self.s.clone() * x).sqrt());
        let (beta, chi) = (self.beta.clone(), self.chi.clone());
        match kind {
            LinearType::Complex => {
                // |λ²| = √c; the smaller part from the product re·im = √(4c − b²)/4.
                let modulus = chi.sqrt();
                let root = half((-self.discriminant.clone()).sqrt());
                let positive = beta.sign() == Some(Sign::Negative);
                let large = half(modulus + if positive { half(-beta) } else { half(beta) }).sqrt();
                let small = half(root) / large.clone();
                let unit = self.s.sqrt();
                let [large, small] = [large, small].map(|x| Some(unit.clone() * x));
                let pair = if positive { [large, small] } else { [small, large] };
                [pair.clone(), pair]
            }
            LinearType::DoubleElliptic => [[None, size(half(beta.clone()))], [None, size(half(beta))]],
            LinearType::DoubleReal => [[size(half(-beta.clone())), None], [size(half(-beta)), None]],
            LinearType::SaddleCentre => {
                let root = self.discriminant.sqrt();
                [[size(half(root.clone() - beta.clone())), None], [None, size(half(root + beta))]]
            }
            LinearType::Elliptic => {
                let large = half(beta + self.discriminant.sqrt());
                [[None, size(large.clone())], [None, size(chi / large)]]
            }
            LinearType::Saddle => {
                let large = half(self.discriminant.sqrt() - beta);
                [[size(large.clone()), None], [size(chi / large), None]]
            }
            LinearType::Zero | LinearType::ZeroReal => self.beside_zero(),
        }
    }
}

/// Real before imaginary, then by size.
fn sorted(mut pairs: [[f64; 2]; 2]) -> [[f64; 2]; 2] {
    pairs.sort_by(|p, q| q[0].total_cmp(&p[0]).then(q[1].total_cmp(&p[1])));
    pairs
}
