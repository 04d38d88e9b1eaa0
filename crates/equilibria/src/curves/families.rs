//! The two families of relative equilibria in closed form: over every multiplier μ, and over a moment a_i on whose
//! eigenspace r vanishes (Theorems 3.2 and 3.3 of docs/mathematics.md).

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

/// The relative equilibrium γ(μ) ∝ (μ − A)⁻¹ r of the generic family (Staude) and its derivatives along the family.
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

/// The family over a principal axis i without centre of mass: γ_j = r_j/(s (a_i − a_j)) for the other axes and
/// γ_i = ±√(1 − …), one pair for every s ≥ ŝ = √P̂; a circle when a_i is a double moment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SymmetricFamily {
    /// The first axis of the eigenspace.
    pub axis: Axis,
    /// R̂ = Σ r_j²/(a_i − a_j).
    pub r_sum: f64,
    /// ŝ = √(Σ r_j²/(a_i − a_j)²): the pitchfork. 0 when r = 0.
    pub s_pitchfork: f64,
}

/// A relative equilibrium of the family, at s = ŝ + t.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SymmetricState {
    /// γ in the frame, with γ_i ≥ 0.
    pub gamma: [f64; 3],
    /// J = a_i − R̂/s².
    pub j: f64,
    /// x = l²/2 = s J²/2.
    pub x: f64,
    /// dx/ds = (J/2)(a_i + 3R̂/s²).
    pub x_slope: f64,
}

impl SymmetricFamily {
    /// The family over an axis on whose eigenspace r vanishes.
    #[must_use]
    pub fn over(frame: &Frame, axis: Axis) -> Self {
        let mut p_sum = 0.0;
        for k in 0..3 {
            if frame.r[k] > 0.0 {
                let ratio = frame.r[k] / frame.diff[axis][k];
                p_sum += ratio * ratio;
            }
        }
        Self { axis, r_sum: frame.symmetric_sums[axis].r_sum, s_pitchfork: p_sum.sqrt() }
    }

    /// The equilibrium at s = ŝ + t, t ≥ 0 (t > 0 when r = 0).
    #[must_use]
    pub fn at(&self, frame: &Frame, t: f64) -> SymmetricState {
        let s = self.s_pitchfork + t;
        let mut gamma = [0.0; 3];
        for k in 0..3 {
            if frame.r[k] > 0.0 {
                gamma[k] = frame.r[k] / (s * frame.diff[self.axis][k]);
            }
        }
        // 1 − ŝ²/s² without cancellation near the pitchfork.
        gamma[self.axis] = (t * (2.0 * self.s_pitchfork + t)).sqrt() / s;
        let a = frame.a[self.axis];
        let shift = self.r_sum / (s * s);
        // a_i − R̂/s², as a sum of positive terms.
        let j = (0..3).map(|k| gamma[k] * gamma[k] * frame.a[k]).sum::<f64>();
        SymmetricState { gamma, j, x: 0.5 * s * j * j, x_slope: 0.5 * j * (a + 3.0 * shift) }
    }

    /// t at the cusp, s² = −3R̂/a_i, if that lies beyond the pitchfork: decided exactly by the sign of −3R̂ − a_i P̂, which
    /// is a_i (s² − ŝ²) and gives t without cancellation.
    #[must_use]
    pub fn cusp(&self, frame: &Frame) -> Option<f64> {
        let excess = frame.symmetric_sums[self.axis].cusp_excess;
        if excess <= 0.0 {
            return None;
        }
        let a = frame.a[self.axis];
        Some(excess / (a * ((-3.0 * self.r_sum / a).sqrt() + self.s_pitchfork)))
    }
}
