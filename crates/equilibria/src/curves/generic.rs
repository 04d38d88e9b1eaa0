//! The generic family of relative equilibria γ(μ) ∝ (μ − A)⁻¹ r (Staude; Theorem 3.2 of docs/mathematics.md).

use bifdiag_body::{Axis, Frame};

/// μ = a_base + δ. With δ kept apart, μ − a_base is exact however close μ comes to a moment of inertia.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mu {
    /// Axis of the frame.
    pub base: Axis,
    /// δ = μ − a_base.
    pub delta: f64,
}

impl Mu {
    /// μ itself, rounded.
    #[must_use]
    pub fn value(self, frame: &Frame) -> f64 {
        frame.a[self.base] + self.delta
    }

    /// μ − a_k: one rounding, and no cancellation as long as `base` is the moment next to μ.
    #[must_use]
    pub fn minus_moment(self, frame: &Frame, k: Axis) -> f64 {
        self.delta + frame.diff[self.base][k]
    }
}

/// The relative equilibrium at μ and its derivatives along the family.
///
/// With w_k = γ_k² the quantities are means over w, so that nothing cancels:
/// J = Σ w a, T = Σ w/(μ−a), V = Σ_{i<j} w_i w_j (a_i−a_j)²/((μ−a_i)(μ−a_j)), and (Lemma 3.5)
/// dJ/dμ = −2V, dx/dμ = −x (T + 4V/J), where x = l²/2 = s J²/2.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GenericState {
    /// γ in the frame.
    pub gamma: [f64; 3],
    /// J = ⟨γ, Aγ⟩.
    pub j: f64,
    /// s = Ω², the squared angular velocity.
    pub s: f64,
    /// x = l²/2.
    pub x: f64,
    /// T.
    pub mean_inverse: f64,
    /// V.
    pub spread: f64,
}

impl GenericState {
    /// The equilibrium at μ. Precondition: μ is no moment a_k with r_k ≠ 0, and some r_k ≠ 0.
    #[must_use]
    pub fn at(frame: &Frame, mu: Mu) -> Self {
        let mut inverse = [0.0; 3];
        let mut g = [0.0; 3];
        for k in Axis::ALL {
            if frame.r[k] > 0.0 {
                inverse[k] = 1.0 / mu.minus_moment(frame, k);
                g[k] = frame.r[k] * inverse[k];
            }
        }
        let p = g[0] * g[0] + g[1] * g[1] + g[2] * g[2];
        let s = p.sqrt();
        let gamma = g.map(|x| x / s);
        let w = gamma.map(|x| x * x);
        let j = w[0] * frame.a[0] + w[1] * frame.a[1] + w[2] * frame.a[2];
        let mean_inverse = w[0] * inverse[0] + w[1] * inverse[1] + w[2] * inverse[2];
        let pair = |i: usize, k: usize| {
            let d = frame.diff[i][k];
            w[i] * w[k] * d * d * inverse[i] * inverse[k]
        };
        let spread = pair(0, 1) + pair(0, 2) + pair(1, 2);
        Self { gamma, j, s, x: 0.5 * s * j * j, mean_inverse, spread }
    }

    /// T J + 4V: its zeros are the cusps, where dl = dh = 0 (4Q'P = 3P'Q in Lemma 4.5).
    #[must_use]
    pub fn cusp_function(&self) -> f64 {
        self.mean_inverse * self.j + 4.0 * self.spread
    }

    /// d ln x / dμ.
    #[must_use]
    pub fn log_slope(&self) -> f64 {
        -self.cusp_function() / self.j
    }
}
