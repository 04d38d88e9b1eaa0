//! Verdicts on the stability of a relative equilibrium, with their reasons.

use crate::curves::{CriticalSet, Curve};
use crate::stability::LinearType;
use bifdiag_schema::{NonlinearVerdict, Reason};

/// What a verdict needs besides the linear type (Proposition 13.6 of docs/mathematics.md).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Setting {
    /// Morse index of U_l; across a circle its transverse index; where the Hessian is degenerate, its negative squares.
    pub index: u8,
    /// Where the Hessian is degenerate: whether U_l has a strict minimum, if that is known.
    pub minimum: Option<bool>,
    /// A further integral confines the motion as soon as no eigenvalue says otherwise: γ = ±r̂ on the axis of symmetry
    /// (Lagrange), circles of regular precessions, and every rotation without weight (Euler).
    pub integral: bool,
}

impl Setting {
    /// That of the rotations of a curve between its ends; `None` for a pole line.
    #[must_use]
    pub fn along(set: &CriticalSet, curve: &Curve) -> Option<Self> {
        Some(Self { index: curve.index?, minimum: None, integral: set.has_integral(curve) })
    }

    /// What follows from eigenvalues, energy and integrals; `None` at two imaginary pairs that are left to the normal form.
    #[must_use]
    pub fn verdict(self, kind: LinearType) -> Option<(NonlinearVerdict, Reason)> {
        Some(match kind {
            _ if kind.is_unstable() => (NonlinearVerdict::Unstable, Reason::Spectrum),
            LinearType::Zero if self.minimum == Some(true) => (NonlinearVerdict::Stable, Reason::Energy),
            LinearType::Zero if self.integral => (NonlinearVerdict::Stable, Reason::Integral),
            LinearType::Zero => (NonlinearVerdict::Open, Reason::Degenerate),
            // No eigenvalue vanishes at the cusp of a circle, where U_l has no minimum across it.
            _ if self.index == 0 && self.minimum != Some(false) => (NonlinearVerdict::Stable, Reason::Energy),
            _ if self.integral => (NonlinearVerdict::Stable, Reason::Integral),
            _ => return None,
        })
    }
}

/// Arnold's determinant over s = Ω².
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Determinant {
    /// K₁₁ω₂² + K₁₂ω₁ω₂ + K₂₂ω₁² for H = ω₁I₁ − ω₂I₂ + K₁₁I₁² + K₁₂I₁I₂ + K₂₂I₂² + …, over Ω².
    pub value: f64,
    /// Bound on its error.
    pub error: f64,
}

/// Stability beyond the linearisation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nonlinear {
    /// The verdict.
    pub verdict: NonlinearVerdict,
    /// Its reason.
    pub why: Reason,
    /// Arnold's determinant, where the normal form decides and there is one.
    pub arnold: Option<Determinant>,
    /// Distances from the resonances 1:1, 1:2 and 1:3, where the normal form decides: (b² − 4c)/b², (4b² − 25c)/b² and
    /// (9b² − 100c)/b².
    pub near: Option<[f64; 3]>,
    /// The verdict and its reason are proved; false only where the enclosures did not part the determinant, or what takes
    /// its place at a resonance, from 0.
    pub proved: bool,
}

impl Nonlinear {
    /// A verdict that needs no normal form.
    #[must_use]
    pub fn of((verdict, why): (NonlinearVerdict, Reason)) -> Self {
        Self { verdict, why, arnold: None, near: None, proved: true }
    }

    /// The same of a body whose moments are those that were judged times `moment_unit`, a power of two, at the same spin in
    /// its own unit of time: D₄/Ω² is an inverse moment of inertia.
    pub(crate) fn in_unit(self, moment_unit: f64) -> Self {
        let scaled =
            |Determinant { value, error }| Determinant { value: value / moment_unit, error: error / moment_unit };
        Self { arnold: self.arnold.map(scaled), ..self }
    }

    /// None so far: a normal form would decide, and was not requested.
    pub(crate) fn deferred() -> Self {
        Self { proved: false, ..Self::of((NonlinearVerdict::Open, Reason::Degenerate)) }
    }

    /// No verdict was asked for. (One that was not reached has its distances from the resonances.)
    #[must_use]
    pub fn is_deferred(&self) -> bool {
        !self.proved && self.near.is_none()
    }
}
