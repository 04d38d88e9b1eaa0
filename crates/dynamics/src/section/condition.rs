//! Section conditions S = Ẇ, and the way from a point close to the section onto it.

use crate::field::{Dimension, HeavyTop, State, add, cross, dot, scale};

/// What is a section: the zeros of S = Ẇ for a bounded function W of the state.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SectionCondition {
    /// W = ⟨γ,r⟩, S = ⟨ω, r×γ⟩ (Eq. PSecCond): the paper's.
    #[default]
    Height,
    /// W = −⟨l,l⟩/2, S = ⟨l, γ×r⟩: Gashenenko's and Richter's.
    AngularMomentum,
}

impl SectionCondition {
    /// The dimension of S.
    #[must_use]
    pub fn dimension(self) -> Dimension {
        match self {
            Self::Height => Dimension::ENERGY.rate(),
            Self::AngularMomentum => {
                let (l, r) = (Dimension::MOMENTUM, Dimension::ENERGY);
                Dimension { inertia: l.inertia + r.inertia, time: l.time + r.time }
            }
        }
    }

    /// S at a state.
    #[must_use]
    #[inline(always)]
    pub fn value(self, top: &HeavyTop, state: &State) -> f64 {
        match self {
            Self::Height => dot(top.angular_velocity(state.l), cross(top.center(), state.gamma)),
            Self::AngularMomentum => dot(state.l, cross(state.gamma, top.center())),
        }
    }

    /// Ṡ at a state: < 0 incoming, > 0 outgoing, 0 on the line of tangency.
    #[must_use]
    #[inline(always)]
    pub fn rate(self, top: &HeavyTop, state: &State) -> f64 {
        let field = top.vector_field(state);
        match self {
            Self::Height => {
                dot(top.angular_velocity(field.l), cross(top.center(), state.gamma))
                    + dot(top.angular_velocity(state.l), cross(top.center(), field.gamma))
            }
            Self::AngularMomentum => {
                dot(field.l, cross(state.gamma, top.center())) + dot(state.l, cross(field.gamma, top.center()))
            }
        }
    }

    /// An upper bound of |S| on the energy surface h, the unit in which |S| is called small.
    #[must_use]
    pub fn scale(self, top: &HeavyTop, h: f64) -> f64 {
        let momentum = top.momentum_scale(h) * top.center_norm();
        match self {
            Self::Height => momentum * top.inverse_moments().iter().fold(0.0, |m: f64, &b| m.max(b)),
            Self::AngularMomentum => momentum,
        }
    }
}

/// Moves a state that is close to the section, where S = `residual`, onto it along the flow: the time that this
/// takes and the state there.
///
/// The polynomial's root is as good as the step's tolerance; Newton's method in time with the flow's own series
/// brings |S| down to rounding. Near a tangency it stops where it no longer improves.
#[inline(never)]
pub(super) fn polished(top: &HeavyTop, condition: SectionCondition, state: &State, mut residual: f64) -> (f64, State) {
    let (mut offset, mut best) = (0.0, *state);
    for _ in 0..4 {
        let t = -residual / condition.rate(top, &best);
        if t.is_nan() {
            break;
        }
        let mut next = State::default();
        for x in top.taylor_coefficients(&best, 4).iter().rev() {
            next.gamma = add(scale(t, next.gamma), x.gamma);
            next.l = add(scale(t, next.l), x.l);
        }
        let value = condition.value(top, &next);
        if value.is_nan() || value.abs() >= residual.abs() {
            break;
        }
        (offset, best, residual) = (offset + t, next, value);
    }
    (offset, best)
}
