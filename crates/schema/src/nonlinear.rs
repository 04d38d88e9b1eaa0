//! Stability beyond the linearisation: the verdict on a relative equilibrium with its reason, and what friction leaves of it.

use std::fmt;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::term::term;

term! {
    /// Whether a relative equilibrium is stable: in the sense of Lyapunov, at fixed l, modulo rotation about the vertical; of a
    /// circle or sphere of them, as a whole.
    pub enum NonlinearVerdict {
        /// Motions that start near it stay near it for all time.
        Stable = "stable",
        /// Some motions that start arbitrarily near leave it.
        Unstable = "unstable",
        /// None of the theorems that the program uses decides.
        Open = "open",
    }
}

term! {
    /// Why a relative equilibrium has its verdict.
    pub enum Reason {
        /// A strict minimum of U_l (Lagrange–Dirichlet), or a circle or sphere of minima as a whole.
        Energy = "energy",
        /// A further integral, as at the sleeping top.
        Integral = "integral",
        /// Arnold's theorem: no resonance ω₁ = ω₂, 2ω₂ or 3ω₂, and D₄ is not 0; or D₄ = 0, no resonance k₁ω₁ = k₂ω₂ with
        /// k₁ + k₂ ≤ 6, and D₆ is not 0. Also at ω₁ = 2ω₂ where the resonant cubic term vanishes.
        Arnold = "arnold",
        /// An eigenvalue with positive real part.
        Spectrum = "spectrum",
        /// ω₁ = 2ω₂.
        Resonance12 = "resonance 1:2",
        /// ω₁ = 3ω₂.
        Resonance13 = "resonance 1:3",
        /// ω₁ = ω₂.
        Resonance11 = "resonance 1:1",
        /// An eigenvalue zero, or D₄ = 0 where D₆ does not decide.
        Degenerate = "degenerate",
    }
}

/// Distances to the resonances, from the coefficients of λ⁴ + bλ² + c; each vanishes at its resonance, to rounding.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ResonancesDocument {
    /// (b² − 4c)/b².
    #[serde(rename = "1:1")]
    pub one_to_one: f64,
    /// (4b² − 25c)/b².
    #[serde(rename = "1:2")]
    pub one_to_two: f64,
    /// (9b² − 100c)/b².
    #[serde(rename = "1:3")]
    pub one_to_three: f64,
}

/// The verdict on the stability of a relative equilibrium, with its evidence.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct NonlinearDocument {
    /// Stable, unstable, or open.
    pub verdict: NonlinearVerdict,
    /// Why.
    pub why: Reason,
    /// Arnold's determinant D₄ = K₁₁ω₂² + K₁₂ω₁ω₂ + K₂₂ω₁² over Ω², where H = ω₁I₁ − ω₂I₂ + K₁₁I₁² + K₁₂I₁I₂ + K₂₂I₂² + … with
    /// the pair of positive Krein sign first; `null` except at index 2 with two distinct imaginary pairs, and there too where
    /// a further integral decides, at a resonance 1:2 that makes it unstable, and along a curve.
    #[serde(rename = "D4_over_s")]
    pub d4_over_s: Option<f64>,
    /// Bound on its error.
    #[serde(rename = "D4_error")]
    pub d4_error: Option<f64>,
    /// Distances to the resonances; `null` except at index 2 with imaginary pairs, and there too where a further integral
    /// decides, and along a curve.
    pub near: Option<ResonancesDocument>,
    /// Decided by enclosures and exact arithmetic; in an atlas: `verify` confirms it.
    pub proved: bool,
}

impl NonlinearDocument {
    /// A verdict along a curve, where the normal form is another at each point.
    #[must_use]
    pub fn along(verdict: NonlinearVerdict, why: Reason, proved: bool) -> Self {
        Self { verdict, why, d4_over_s: None, d4_error: None, near: None, proved }
    }
}

/// As tables say it.
impl fmt::Display for NonlinearDocument {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let verdict = self.verdict.word();
        let why = match self.why {
            // The linear type says so already.
            Reason::Spectrum => return f.write_str(verdict),
            Reason::Arnold => "Arnold",
            Reason::Resonance12 => "1:2 resonance",
            Reason::Resonance13 => "1:3 resonance",
            Reason::Resonance11 => "1:1 resonance",
            why @ (Reason::Energy | Reason::Integral | Reason::Degenerate) => why.word(),
        };
        write!(f, "{verdict} ({why})")
    }
}

/// What friction that conserves l leaves of the stability.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Damped {
    /// It stays stable.
    Survives,
    /// It is unstable, however small the friction.
    Lost,
}

/// A relative equilibrium with friction that conserves l (Thomson, Tait and Chetaev): it survives exactly at a minimum of U_l.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct FrictionDocument {
    /// What it leaves; `null` at a degenerate point that no theorem decides.
    pub conserving_l: Option<Damped>,
    /// Directions that grow: the Morse index.
    pub growing: u8,
    /// Pairs of `eigenvalues`, each with d Re λ/dδ at δ = 0 for the torque −δA(ω − Ωγ): of an imaginary pair negative exactly if
    /// its Krein sign is positive. Without double pairs and zeros; empty along a curve. Computed in doubles: they grow without bound
    /// towards a collision of eigenvalues, and lose digits there.
    pub rates: Vec<([f64; 2], f64)>,
}
