//! How a tangent vector grows along an orbit: what is asked, and what is found.

use super::evidence::Evidence;
use crate::field::{Dimension, State, Units};

/// The largest Lyapunov exponent of an orbit over a finite time, per unit of time.
///
/// A tangent vector δ = (δγ, δl) is taken along by the variational equations. It starts tangent to the energy surface
/// and to ⟨γ,γ⟩ = 1, ⟨γ,l⟩ = l and so remains. The flow on that surface has the exponents λ, 0, −λ, so that one vector
/// tells all of them. Lengths are |δ|² = |δγ|² + |δl|²/(2 A_max (h + 2|r|)), without units.
///
/// Regular orbits shear: |δ| grows like t, and `exponent` falls like ln(T)/T, `mean_rate` like 2/T. An exponent that
/// does not exceed a few times that is not chaos that this time can show.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lyapunov {
    /// λ(T) = ln(|δ(T)|/|δ(0)|)/T.
    pub exponent: f64,
    /// λ(T/2).
    pub exponent_half: f64,
    /// The mean of d ln|δ|/dt over [0, T] with the weight exp(−1/(u(1−u))), u = t/T. It forgets the choice of δ(0) and
    /// the phase at T, so that for regular orbits it is the sharper of the two.
    pub mean_rate: f64,
    /// The same over [0, T/2].
    pub mean_rate_half: f64,
    /// T: the end of the first step that reaches the time asked for.
    pub time: f64,
}

impl Lyapunov {
    /// |λ(T) − λ(T/2)|: how far `exponent` has converged.
    #[must_use]
    pub fn error(&self) -> f64 {
        (self.exponent - self.exponent_half).abs()
    }

    /// That of a reduced top as that of the top as given.
    fn restored(self, units: Units) -> Self {
        let rate = |x| units.restore(x, Dimension::FREQUENCY);
        Self {
            exponent: rate(self.exponent),
            exponent_half: rate(self.exponent_half),
            mean_rate: rate(self.mean_rate),
            mean_rate_half: rate(self.mean_rate_half),
            time: units.restore(self.time, Dimension::TIME),
        }
    }
}

/// An orbit along which a tangent vector is taken.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Course {
    /// Its state at time 0.
    pub start: State,
    /// For how long it is followed.
    pub time: f64,
    /// Times at which ln|δ| is wanted, ascending.
    pub at: Vec<f64>,
    /// The unit of the times at which evidence is taken; without a positive one there is none.
    pub unit: f64,
    /// Stop as soon as the evidence decides whether the orbit is regular, or when there is no more to come; there is then no exponent.
    pub until_decided: bool,
}

/// How a tangent vector has grown along a course.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Growth {
    /// None where the time is not a positive number, where the motion did not remain finite, and where the run was
    /// stopped.
    pub lyapunov: Option<Lyapunov>,
    /// ln(|δ(t)|/|δ(0)|) at the times asked for, as far as the orbit came.
    pub logs: Vec<f64>,
    /// What was seen at the times `unit` · 2^{k/2} that were passed.
    pub evidence: Vec<Evidence>,
    /// The motion and the tangent vector remained finite as far as they were followed.
    pub finite: bool,
}

impl Growth {
    /// That of a reduced top as that of the top as given.
    pub(super) fn restored(self, units: Units) -> Self {
        Self {
            lyapunov: self.lyapunov.map(|exponent| exponent.restored(units)),
            evidence: self.evidence.into_iter().map(|seen| seen.restored(units)).collect(),
            ..self
        }
    }
}
