//! A heavy top as the equations of motion see it, and its first integrals.

use super::units::{Dimension, TopUnits};
use super::{add, cross, dot, norm, scale, sub};
use bifdiag_body::Body;

/// A point of phase space: the vertical γ and the angular momentum l, both in body coordinates.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct State {
    /// The vertical, |γ| = 1.
    pub gamma: [f64; 3],
    /// Angular momentum.
    pub l: [f64; 3],
}

impl State {
    /// The state in other units.
    #[must_use]
    #[inline]
    pub fn reduced(&self, units: TopUnits) -> Self {
        Self { gamma: self.gamma, l: self.l.map(|x| units.reduce(x, Dimension::MOMENTUM)) }
    }

    /// A [`reduced`](Self::reduced) state as it was given.
    #[must_use]
    #[inline]
    pub fn restored(&self, units: TopUnits) -> Self {
        Self { gamma: self.gamma, l: self.l.map(|x| units.restore(x, Dimension::MOMENTUM)) }
    }
}

/// The moments and the centre of mass as doubles, in the axes and units in which the body was given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HeavyTop {
    moments: [f64; 3],
    inverse: [f64; 3],
    center: [f64; 3],
    units: TopUnits,
}

impl HeavyTop {
    /// The nearest doubles of an exact body.
    #[must_use]
    pub fn new(body: &Body) -> Self {
        Self::from_f64(body.moments_f64(), body.center_f64())
    }

    /// A top from doubles; the moments must be positive and everything finite, as in a [`Body`].
    pub(crate) fn from_f64(moments: [f64; 3], center: [f64; 3]) -> Self {
        Self { moments, inverse: moments.map(|a| 1.0 / a), center, units: TopUnits::of(moments, center) }
    }

    /// Units in which the top's numbers are of moderate size.
    #[must_use]
    pub fn units(&self) -> TopUnits {
        self.units
    }

    /// The same top in its own units.
    #[must_use]
    #[inline]
    pub fn reduced(&self) -> Self {
        if self.units.are_one() {
            return *self;
        }
        let moments = self.moments.map(|x| self.units.reduce(x, Dimension::INERTIA));
        let center = self.center.map(|x| self.units.reduce(x, Dimension::ENERGY));
        Self { moments, inverse: moments.map(|a| 1.0 / a), center, units: TopUnits::ONE }
    }

    /// The same top and a state of it, in units in which the angular velocity of the state is of moderate size too, and these.
    pub(crate) fn reduced_beside(&self, state: &State) -> (Self, State, TopUnits) {
        let (top, state) = (self.reduced(), state.reduced(self.units));
        let frequency = top.angular_velocity(state.l).iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        let time = TopUnits::of_frequency(frequency, top.center == [0.0; 3]);
        let center = top.center.map(|x| time.reduce(x, Dimension::ENERGY));
        (Self { center, ..top }, state.reduced(time), self.units.with_time_in(time))
    }

    /// A1, A2, A3.
    #[must_use]
    pub fn moments(&self) -> [f64; 3] {
        self.moments
    }

    /// 1/A1, 1/A2, 1/A3, rounded. (The Taylor integrator also takes along what the rounding leaves out.)
    #[must_use]
    pub fn inverse_moments(&self) -> [f64; 3] {
        self.inverse
    }

    /// The centre of mass r (with mg absorbed).
    #[must_use]
    pub fn center(&self) -> [f64; 3] {
        self.center
    }

    /// |r|.
    #[must_use]
    pub fn center_norm(&self) -> f64 {
        self.units.restore(norm(self.reduced().center), Dimension::ENERGY)
    }

    /// r̂ = r/|r|; None when r = 0.
    #[must_use]
    pub fn r_hat(&self) -> Option<[f64; 3]> {
        let center = self.reduced().center;
        let r = norm(center);
        (r > 0.0).then(|| center.map(|x| x / r))
    }

    /// A u.
    #[must_use]
    pub fn inertia(&self, u: [f64; 3]) -> [f64; 3] {
        [self.moments[0] * u[0], self.moments[1] * u[1], self.moments[2] * u[2]]
    }

    /// A⁻¹ u, by division.
    #[must_use]
    pub fn inverse_inertia(&self, u: [f64; 3]) -> [f64; 3] {
        [u[0] / self.moments[0], u[1] / self.moments[1], u[2] / self.moments[2]]
    }

    /// ω = A⁻¹ l with the rounded inverse moments.
    #[must_use]
    pub fn angular_velocity(&self, l: [f64; 3]) -> [f64; 3] {
        [self.inverse[0] * l[0], self.inverse[1] * l[1], self.inverse[2] * l[2]]
    }

    /// (γ̇, l̇) = (γ×ω, l×ω − γ×r).
    #[must_use]
    pub fn vector_field(&self, state: &State) -> State {
        let omega = self.angular_velocity(state.l);
        State { gamma: cross(state.gamma, omega), l: sub(cross(state.l, omega), cross(state.gamma, self.center)) }
    }

    /// The Taylor coefficients x_0 … x_order of the solution through `state`: x_k = x⁽ᵏ⁾/k!.
    ///
    /// Plain arithmetic for a few low orders; the SIMD kernel of the Taylor integrator is the fast way.
    #[must_use]
    pub fn taylor_coefficients(&self, state: &State, order: usize) -> Vec<State> {
        let mut series = Vec::with_capacity(order + 1);
        series.push(*state);
        for k in 0..order {
            let mut next = State { gamma: [0.0; 3], l: scale(-1.0, cross(series[k].gamma, self.center)) };
            for j in 0..=k {
                let omega = self.angular_velocity(series[k - j].l);
                next.gamma = add(next.gamma, cross(series[j].gamma, omega));
                next.l = add(next.l, cross(series[j].l, omega));
            }
            let divisor = (k + 1) as f64;
            series.push(State { gamma: next.gamma.map(|x| x / divisor), l: next.l.map(|x| x / divisor) });
        }
        series
    }

    /// H = ⟨l, A⁻¹l⟩/2 − ⟨γ, r⟩.
    #[must_use]
    pub fn energy(&self, state: &State) -> f64 {
        0.5 * dot(state.l, self.inverse_inertia(state.l)) - dot(state.gamma, self.center)
    }

    /// U_l(γ) = l²/(2⟨γ,Aγ⟩) − ⟨γ,r⟩.
    #[must_use]
    #[inline]
    pub fn effective_potential(&self, gamma: [f64; 3], l: f64) -> f64 {
        if self.units.are_one() { self.plain_potential(gamma, l) } else { self.extreme_potential(gamma, l) }
    }

    #[inline]
    fn plain_potential(&self, gamma: [f64; 3], l: f64) -> f64 {
        0.5 * l * l / dot(gamma, self.inertia(gamma)) - dot(gamma, self.center)
    }

    #[cold]
    fn extreme_potential(&self, gamma: [f64; 3], l: f64) -> f64 {
        let potential = self.reduced().plain_potential(gamma, self.units.reduce(l, Dimension::MOMENTUM));
        self.units.restore(potential, Dimension::ENERGY)
    }

    /// max |l| on the energy surface H = h: √(2 A_max (h + |r|)), with at least ε²|r| for a sum that rounding leaves 0, so that
    /// steps next to the hanging equilibrium have a length. Never 0, also at rest without weight.
    #[must_use]
    pub fn momentum_scale(&self, h: f64) -> f64 {
        if !self.units.are_one() {
            let reduced = self.reduced().momentum_scale(self.units.reduce(h, Dimension::ENERGY));
            return self.units.restore(reduced, Dimension::MOMENTUM);
        }
        let largest = self.moments.iter().fold(0.0, |m: f64, &a| m.max(a));
        let weight = self.center_norm();
        let squared = 2.0 * largest * (h + weight).max(f64::EPSILON * f64::EPSILON * weight);
        squared.max(f64::MIN_POSITIVE).sqrt()
    }
}

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
    pub fn restored(&self, units: TopUnits) -> Self {
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
