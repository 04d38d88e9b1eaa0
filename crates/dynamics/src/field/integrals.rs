//! First integrals: the three of every top, and those of the integrable ones.

use super::heavy_top::{HeavyTop, State};
use super::units::{Dimension, Units};
use super::vector::dot;

/// The three integrals that every heavy top has.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Integrals {
    /// H.
    pub energy: f64,
    /// ⟨γ, l⟩.
    pub vertical_momentum: f64,
    /// ⟨γ, γ⟩.
    pub gamma_squared: f64,
}

impl Integrals {
    /// The integrals at a point of phase space.
    #[must_use]
    pub fn of(top: &HeavyTop, state: &State) -> Self {
        Self {
            energy: top.energy(state),
            vertical_momentum: dot(state.gamma, state.l),
            gamma_squared: dot(state.gamma, state.gamma),
        }
    }

    /// |self − other|, component by component.
    #[must_use]
    pub fn distance(&self, other: &Self) -> Self {
        Self {
            energy: (self.energy - other.energy).abs(),
            vertical_momentum: (self.vertical_momentum - other.vertical_momentum).abs(),
            gamma_squared: (self.gamma_squared - other.gamma_squared).abs(),
        }
    }

    /// Those of a reduced top as those of the top as given.
    #[must_use]
    pub fn restored(&self, units: Units) -> Self {
        Self {
            energy: units.restore(self.energy, Dimension::ENERGY),
            vertical_momentum: units.restore(self.vertical_momentum, Dimension::MOMENTUM),
            gamma_squared: self.gamma_squared,
        }
    }

    /// The larger of each component.
    #[must_use]
    pub fn max(&self, other: &Self) -> Self {
        Self {
            energy: self.energy.max(other.energy),
            vertical_momentum: self.vertical_momentum.max(other.vertical_momentum),
            gamma_squared: self.gamma_squared.max(other.gamma_squared),
        }
    }

    /// The largest of the three components.
    #[must_use]
    pub fn largest(&self) -> f64 {
        self.energy.max(self.vertical_momentum).max(self.gamma_squared)
    }
}

/// Kovalevskaya's integral K = (ω₁² − ω₂² + γ₁)² + (2ω₁ω₂ + γ₂)² of A = (2,2,1), r = (1,0,0).
#[must_use]
pub fn kovalevskaya(state: &State) -> f64 {
    let (omega_1, omega_2) = (0.5 * state.l[0], 0.5 * state.l[1]);
    let real = omega_1 * omega_1 - omega_2 * omega_2 + state.gamma[0];
    let imaginary = 2.0 * omega_1 * omega_2 + state.gamma[1];
    real * real + imaginary * imaginary
}
