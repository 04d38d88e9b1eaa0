//! The extra family over μ = a_i where r vanishes on the whole eigenspace of a_i (Theorem 3.3 of docs/mathematics.md).

use bifdiag_body::{Axis, Frame};

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
