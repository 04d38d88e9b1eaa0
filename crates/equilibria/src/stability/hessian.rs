//! The Hessian of U_l at a relative equilibrium that continuation found, in f64 with a bound on its rounding.

use super::RelativeEquilibrium;
use bifdiag_body::Frame;
use bifdiag_numbers::Sign;

/// Rounding of a sum of products, relative to the sum of its absolute terms: γ and the gaps come with an error of
/// a few units in the last place, each term is a product of at most six of them.
const ROUNDING: f64 = 32.0 * f64::EPSILON;

/// A sum that knows how much of it is rounding.
#[derive(Clone, Copy, Default)]
struct Sum {
    value: f64,
    magnitude: f64,
}

impl Sum {
    fn add(&mut self, term: f64) {
        self.value += term;
        self.magnitude += term.abs();
    }

    /// The sign, zero where rounding hides it.
    fn sign(&self) -> Sign {
        if self.value.abs() <= ROUNDING * self.magnitude {
            Sign::Zero
        } else if self.value > 0.0 {
            Sign::Positive
        } else {
            Sign::Negative
        }
    }
}

/// Signs of determinant and trace of K = B + (4s/J) a aᵀ on the tangent plane (Theorem 13.1 of docs/mathematics.md):
/// with v = γ×Aγ, det K = Σ γ_i² B_j B_k + (4s/J) Σ B_i v_i², tr K = Σ (1 − γ_i²) B_i + (4s/J)|v|². 0 where rounding hides them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Hessian {
    /// Sign of the determinant.
    pub determinant: Sign,
    /// Sign of the trace.
    pub trace: Sign,
}

impl Hessian {
    /// The Hessian at `point`. Right as long as γ, Ω and the gaps are right to a few units in the last place, as the
    /// tracker gives them.
    #[must_use]
    pub fn new(frame: &Frame, point: &RelativeEquilibrium) -> Self {
        let (a, gamma, gap) = (&frame.a, &point.gamma, &point.gap);
        let square = gamma.map(|x| x * x);
        let j_gamma = a[0] * square[0] + a[1] * square[1] + a[2] * square[2];
        let coupling = 4.0 * point.omega * point.omega / j_gamma;
        let (mut determinant, mut trace) = (Sum::default(), Sum::default());
        for i in 0..3 {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            let v = gamma[j] * gamma[k] * frame.diff[k][j];
            let coupled = coupling * v * v;
            determinant.add(square[i] * gap[j] * gap[k]);
            determinant.add(coupled * gap[i]);
            trace.add((square[j] + square[k]) * gap[i]);
            trace.add(coupled);
        }
        Self { determinant: determinant.sign(), trace: trace.sign() }
    }

    /// Morse index of U_l, `None` where an eigenvalue of the Hessian is zero within rounding.
    #[must_use]
    pub fn index(self) -> Option<u8> {
        match (self.determinant, self.trace) {
            (Sign::Negative, _) => Some(1),
            (Sign::Positive, Sign::Positive) => Some(0),
            (Sign::Positive, Sign::Negative) => Some(2),
            _ => None,
        }
    }
}
