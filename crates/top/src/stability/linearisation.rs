//! The characteristic polynomial λ⁴ + bλ² + c of a relative equilibrium, and what it says.

use nalgebra::Complex;

use super::{RelativeEquilibrium, Stability};
use crate::body::Frame;

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

    fn error(&self) -> f64 {
        ROUNDING * self.magnitude
    }
}

/// Second variation and linearised flow at a relative equilibrium (Theorem 13.1 of docs/mathematics.md).
///
/// Reduced by the rotation about the vertical, the motion near γ is M q̈ + G q̇ + K q = 0 on the tangent plane of S²:
/// - K = B + (4s/J) a aᵀ is the Hessian of U_l, B = diag(B_j) restricted to the plane, a the tangential part of Aγ;
/// - M = (det A/J) N, N the restriction of A⁻¹, hence det M = det A/J;
/// - G = g (0 −1; 1 0), g = Ω(tr A − 2|Aγ|²/J).
///
/// So det(Mλ² + Gλ + K) gives, with v = γ×Aγ and without choosing a basis of the plane,
/// - det K = Σ γ_i² B_j B_k + (4s/J) Σ B_i v_i²,  tr K = Σ (1 − γ_i²) B_i + (4s/J)|v|²,
/// - c = det K / det M, hence c < 0 (one real pair) exactly where the Morse index is 1,
/// - b = g²/det M + Σ (B_j γ_k² + B_k γ_j²)/A_i + (4s/J) Σ v_i²/A_i.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Linearisation {
    /// Coefficient of λ².
    pub b: f64,
    /// Bound on the error of `b`.
    pub b_error: f64,
    /// Constant coefficient, det K/det M.
    pub c: f64,
    /// Bound on the error of `c`.
    pub c_error: f64,
    /// Trace of the Hessian K of U_l on the tangent plane.
    pub hessian_trace: f64,
    /// Bound on the error of `hessian_trace`.
    pub hessian_trace_error: f64,
    /// Determinant of the Hessian K of U_l on the tangent plane.
    pub hessian_determinant: f64,
}

impl Linearisation {
    /// The linearisation at `point`. The error bounds suppose that γ, Ω and the gaps are right to a few units in
    /// the last place, as the tracker and the closed form give them.
    #[must_use]
    pub fn new(frame: &Frame, point: &RelativeEquilibrium) -> Self {
        let (a, gamma, gap) = (&frame.a, &point.gamma, &point.gap);
        let square = gamma.map(|x| x * x);
        let j_gamma = a[0] * square[0] + a[1] * square[1] + a[2] * square[2];
        let a_gamma_squared = a[0] * a[0] * square[0] + a[1] * a[1] * square[1] + a[2] * a[2] * square[2];
        let s = point.omega * point.omega;
        let inverse_j = 1.0 / j_gamma;
        let coupling = 4.0 * s * inverse_j;
        let inverse_det_m = j_gamma / (a[0] * a[1] * a[2]);

        let (mut determinant, mut trace, mut b) = (Sum::default(), Sum::default(), Sum::default());
        for i in 0..3 {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            let v = gamma[j] * gamma[k] * frame.diff[k][j];
            let coupled = coupling * v * v;
            determinant.add(square[i] * gap[j] * gap[k]);
            determinant.add(coupled * gap[i]);
            trace.add((square[j] + square[k]) * gap[i]);
            trace.add(coupled);
            let inverse_a = 1.0 / a[i];
            b.add(gap[j] * square[k] * inverse_a);
            b.add(gap[k] * square[j] * inverse_a);
            b.add(coupled * inverse_a);
        }
        let trace_a = a[0] + a[1] + a[2];
        let twice = 2.0 * a_gamma_squared * inverse_j;
        let gyroscopic = point.omega * (trace_a - twice);
        let gyroscopic_error = ROUNDING * point.omega.abs() * (trace_a + twice);
        b.add(gyroscopic * gyroscopic * inverse_det_m);
        let gyroscopic_square_error = (2.0 * gyroscopic.abs() + gyroscopic_error) * gyroscopic_error;
        Self {
            b: b.value,
            b_error: b.error() + gyroscopic_square_error * inverse_det_m,
            c: determinant.value * inverse_det_m,
            c_error: determinant.error() * inverse_det_m,
            hessian_trace: trace.value,
            hessian_trace_error: trace.error(),
            hessian_determinant: determinant.value,
        }
    }

    /// Morse index of U_l, `None` where an eigenvalue of the Hessian is zero within rounding.
    #[must_use]
    pub fn index(&self) -> Option<u8> {
        if self.c < -self.c_error {
            Some(1)
        } else if self.c <= self.c_error || self.hessian_trace.abs() <= self.hessian_trace_error {
            None
        } else if self.hessian_trace > 0.0 {
            Some(0)
        } else {
            Some(2)
        }
    }

    /// b² − 4c: negative for a complex quadruple.
    #[must_use]
    pub fn discriminant(&self) -> f64 {
        self.b * self.b - 4.0 * self.c
    }

    /// Bound on the error of [`Self::discriminant`].
    #[must_use]
    pub fn discriminant_error(&self) -> f64 {
        (2.0 * self.b.abs() + self.b_error) * self.b_error
            + 4.0 * self.c_error
            + f64::EPSILON * (self.b * self.b + 4.0 * self.c.abs())
    }

    /// The spectral type; [`Stability::Degenerate`] where the error bounds leave two types open.
    ///
    /// A minimum of U_l is elliptic even where its two frequencies agree: the energy is definite there, so a double
    /// pair is semisimple. On a circle of relative equilibria c = 0 and the type is degenerate.
    #[must_use]
    pub fn stability(&self) -> Stability {
        match self.index() {
            None => Stability::Degenerate,
            Some(0) => Stability::Elliptic,
            Some(1) => Stability::SaddleCentre,
            Some(_maximum) => {
                let (discriminant, error) = (self.discriminant(), self.discriminant_error());
                if discriminant < -error {
                    Stability::Complex
                } else if discriminant <= error || self.b.abs() <= self.b_error {
                    Stability::Degenerate
                } else if self.b > 0.0 {
                    Stability::Elliptic
                } else {
                    Stability::Saddle
                }
            }
        }
    }

    /// The four roots of λ⁴ + bλ² + c as ±λ₁, ±λ₂.
    #[must_use]
    pub fn eigenvalues(&self) -> [Complex<f64>; 4] {
        let discriminant = self.discriminant();
        let [first, second] = if discriminant >= 0.0 {
            // The larger root without cancellation, the smaller one from the product c.
            let root = discriminant.sqrt();
            let larger = -0.5 * (self.b + if self.b < 0.0 { -root } else { root });
            let smaller = if larger == 0.0 { 0.0 } else { self.c / larger };
            [larger, smaller].map(real_square_root)
        } else {
            let [re, im] = [-0.5 * self.b, 0.5 * (-discriminant).sqrt()];
            // |λ²|² = c.
            let major = (0.5 * (self.c.max(0.0).sqrt() + re.abs())).sqrt();
            let minor = 0.5 * im / major;
            let [x, y] = if re >= 0.0 { [major, minor] } else { [minor, major] };
            [Complex::new(x, y), Complex::new(x, -y)]
        };
        [first, -first, second, -second]
    }
}

fn real_square_root(x: f64) -> Complex<f64> {
    if x >= 0.0 { Complex::new(x.sqrt(), 0.0) } else { Complex::new(0.0, (-x).sqrt()) }
}
