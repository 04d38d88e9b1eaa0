//! What of A and r decides about relative equilibria, without principal axes: rational where the tensor is, also where
//! its moments are not (Proposition 13.4 of docs/algorithms.md).

use bifdiag_numbers::Sign;
use bifdiag_numbers::polynomial::Polynomial;
use bifdiag_numbers::symmetric::{Symmetric, dot};
use dashu_int::IBig;
use dashu_ratio::RBig;

use crate::stability::RESONANCES;

/// Of a tensor A and r in units in which both are whole.
#[derive(Clone, Debug)]
pub struct Invariants {
    /// det(μ − A).
    pub characteristic: Polynomial,
    /// D = Π (μ − a_k) over the moments that carry r.
    pub active: Polynomial,
    /// The rest of the characteristic polynomial.
    pub passive: Polynomial,
    /// N = R D = D Σ r_k²/(μ − a_k).
    pub numerator: Polynomial,
    /// p = D² Σ r_k²/(μ − a_k)² = ND′ − N′D.
    pub weight: Polynomial,
    /// |r|².
    pub squared: IBig,
    /// rᵀAr.
    pub along: IBig,
    /// tr A.
    trace: IBig,
    /// tr A².
    square_trace: IBig,
    /// det A.
    determinant: IBig,
}

impl Invariants {
    /// Of a matrix and a vector of integers; with r = 0 it is D = 1 and N = 0.
    #[must_use]
    pub fn new(matrix: &Symmetric, center: &[RBig; 3]) -> Self {
        let whole = |x: &RBig| x.numerator().clone();
        let polynomial = |c: &[RBig]| Polynomial::new(c.iter().map(whole).collect());
        let (characteristic, resolvent) = (polynomial(&matrix.characteristic()), polynomial(&matrix.resolvent(center)));
        // A factor of a monic polynomial is monic up to its sign.
        let shared = if resolvent.is_zero() { characteristic.clone() } else { characteristic.gcd(&resolvent) };
        let leading = shared.coefficients().last().cloned().unwrap_or(IBig::ONE);
        let passive = shared.scaled(&leading);
        let square = |x: &RBig| x * x;
        let square_trace = matrix.rows().iter().flatten().fold(RBig::ZERO, |sum, x| sum + square(x));
        let (active, numerator) = (characteristic.over_monic(&passive), resolvent.over_monic(&passive));
        Self {
            weight: numerator.times(&active.derivative()).minus(&numerator.derivative().times(&active)),
            active,
            numerator,
            passive,
            characteristic,
            squared: whole(&dot(center, center)),
            along: whole(&dot(center, &matrix.times(center))),
            trace: whole(&matrix.trace()),
            square_trace: whole(&square_trace),
            determinant: whole(&matrix.determinant()),
        }
    }

    /// Whether a number is a moment.
    #[must_use]
    pub fn has_moment(&self, a: &RBig) -> bool {
        self.characteristic.sign_at(a) == Sign::Zero
    }

    /// Whether a number is a moment and the mean of all three.
    #[must_use]
    pub fn has_mean(&self, a: &RBig) -> bool {
        self.has_moment(a) && RBig::from(3) * a == RBig::from(self.trace.clone())
    }

    /// D² Σ a_kⁿ r_k²/(μ − a_k)² for n = 1, 2, 3: with a_k = μ − τ_k, Σ r_k²/τ_k = N/D and
    /// Σ τ_k r_k² = μ|r|² − rᵀAr.
    #[must_use]
    pub fn moments(&self) -> [Polynomial; 3] {
        let mu = Polynomial::linear(&IBig::ZERO);
        let (nd, square) = (self.numerator.times(&self.active), self.active.squared());
        let first = mu.times(&self.weight).minus(&nd);
        let second = mu.times(&first.minus(&nd)).plus(&square.scaled(&self.squared));
        let cubic = mu.times(&first.minus(&nd.scaled(&IBig::from(2))));
        let rest = Polynomial::new(vec![self.along.clone(), IBig::from(2) * &self.squared]);
        [first, second, mu.times(&cubic).plus(&square.times(&rest))]
    }

    /// The signs of b and of mb² − nc, up to positive factors, on a family with weights g_k proportional to γ_k² whose
    /// moments Σ a_kⁿ g_k are Q, S and T for n = 1, 2, 3, and μ = over/under; `zero` is C = Σ (g_i τ_j τ_k Q +
    /// 4 (a_j − a_k)² τ_i g_j g_k), times a number. They are B = (tr A Q − 2S)² + Q (Q (μ tr A − tr A²) − μS + T) + 4 (QT − S²)
    /// and mB² − n det A Q² C.
    #[must_use]
    pub fn swing_and_resonances(
        &self,
        [over, under]: &[Polynomial; 2],
        [q, s, t]: &[Polynomial; 3],
        (zero, times): (&Polynomial, &IBig),
    ) -> (Polynomial, [Polynomial; 3]) {
        let two = IBig::from(2);
        let gyroscopic = q.scaled(&self.trace).minus(&s.scaled(&two)).squared();
        let lever = over.scaled(&self.trace).minus(&under.scaled(&self.square_trace));
        let hanging = q.times(&q.times(&lever).minus(&over.times(s)).plus(&under.times(t)));
        let coupled = q.times(t).minus(&s.squared()).scaled(&IBig::from(4));
        let swing = under.times(&gyroscopic.plus(&coupled)).plus(&hanging);
        let square = swing.squared().scaled(times);
        let product = q.times(under).squared().times(zero).scaled(&self.determinant);
        let resonances = RESONANCES.map(|[m, n]| square.scaled(&IBig::from(m)).minus(&product.scaled(&IBig::from(n))));
        (swing, resonances)
    }
}
