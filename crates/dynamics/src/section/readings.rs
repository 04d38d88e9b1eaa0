//! What is stored of a crossing, read off the states of all lanes at once.

use pulp::{Scalar, Simd};

use super::angle::angle;
use super::condition::SectionCondition;
use super::torus::{PpTorus, TorusPoint, positive_angle};
use crate::field::{Integrals, State};
use crate::integrator::taylor::{LaneVector, lane_values};

/// The constants of one top and its torus in every lane.
#[repr(C, align(64))]
pub(super) struct Gauge<S: Simd> {
    moments: LaneVector<S>,
    inverse: LaneVector<S>,
    center: LaneVector<S>,
    /// e_x', e_y', r̂.
    axes: [LaneVector<S>; 3],
    condition: SectionCondition,
}

/// Numbers of a state.
const COUNT: usize = 8;

/// The readings of all lanes.
pub(super) struct Readings<S: Simd>([S::f64s; COUNT]);

/// The readings of one state.
#[derive(Clone, Copy, Debug)]
pub(super) struct Reading {
    /// S.
    pub value: f64,
    /// Ṡ.
    pub rate: f64,
    /// Δ = ⟨ω×γ, A⁻¹(γ×r)⟩.
    pub delta: f64,
    /// ϑ'.
    pub theta: f64,
    /// ψ' in (−π, π].
    pub psi: f64,
    pub integrals: Integrals,
}

impl<S: Simd> Gauge<S> {
    #[inline(always)]
    pub fn new(simd: S, torus: &PpTorus, condition: SectionCondition) -> Self {
        let splat = |v: [f64; 3]| [simd.splat_f64s(v[0]), simd.splat_f64s(v[1]), simd.splat_f64s(v[2])];
        let top = torus.top();
        let [e_x, e_y, r_hat] = torus.axes();
        Self {
            moments: splat(top.moments()),
            inverse: splat(top.inverse_moments()),
            center: splat(top.center()),
            axes: [splat(e_x), splat(e_y), splat(r_hat)],
            condition,
        }
    }

    /// Reads states (γ, l). Without fused operations, so that the numbers are those of the scalar formulas.
    #[inline(always)]
    pub fn read(&self, simd: S, [gamma, l]: [LaneVector<S>; 2]) -> Readings<S> {
        let omega = times(simd, l, self.inverse);
        let torque = cross(simd, gamma, self.center);
        let gamma_dot = cross(simd, gamma, omega);
        let l_dot = sub(simd, cross(simd, l, omega), torque);
        let (value, rate) = match self.condition {
            SectionCondition::Height => {
                let arm = cross(simd, self.center, gamma);
                let first = dot(simd, times(simd, l_dot, self.inverse), arm);
                let second = dot(simd, omega, cross(simd, self.center, gamma_dot));
                (dot(simd, omega, arm), simd.add_f64s(first, second))
            }
            SectionCondition::AngularMomentum => {
                let second = dot(simd, l, cross(simd, gamma_dot, self.center));
                (dot(simd, l, torque), simd.add_f64s(dot(simd, l_dot, torque), second))
            }
        };
        let delta = dot(simd, cross(simd, omega, gamma), times(simd, torque, self.inverse));
        let [e_x, e_y, r_hat] = self.axes;
        let (x, y, z) = (dot(simd, gamma, e_x), dot(simd, gamma, e_y), dot(simd, gamma, r_hat));
        let radius = simd.sqrt_f64s(simd.add_f64s(simd.mul_f64s(x, x), simd.mul_f64s(y, y)));
        let mut divided = l;
        for i in 0..3 {
            divided[i] = simd.div_f64s(l[i], self.moments[i]);
        }
        let kinetic = simd.mul_f64s(simd.splat_f64s(0.5), dot(simd, l, divided));
        Readings([
            value,
            rate,
            delta,
            angle(simd, radius, z),
            angle(simd, x, y),
            simd.sub_f64s(kinetic, dot(simd, gamma, self.center)),
            dot(simd, gamma, l),
            dot(simd, gamma, gamma),
        ])
    }
}

impl<S: Simd> Readings<S> {
    /// Those of one lane.
    #[inline(always)]
    pub fn of(&self, lane: usize) -> Reading {
        let values = lane_values::<S>(&self.0);
        let [value, rate, delta, theta, psi, energy, vertical_momentum, gamma_squared]: [f64; COUNT] =
            std::array::from_fn(|k| values[k * S::F64_LANES + lane]);
        Reading { value, rate, delta, theta, psi, integrals: Integrals { energy, vertical_momentum, gamma_squared } }
    }
}

impl Reading {
    /// Of a single state.
    pub fn new(torus: &PpTorus, condition: SectionCondition, state: &State) -> Self {
        let simd = Scalar::new();
        Gauge::<Scalar>::new(simd, torus, condition).read(simd, [state.gamma, state.l]).of(0)
    }

    /// The point of the torus of the state that was read, which lies on the section.
    #[inline(always)]
    pub fn place(&self, torus: &PpTorus, state: &State) -> TorusPoint {
        torus.on_sheet(state, self.delta, self.theta, positive_angle(self.psi))
    }
}

/// ⟨u, v⟩.
#[inline(always)]
fn dot<S: Simd>(simd: S, u: LaneVector<S>, v: LaneVector<S>) -> S::f64s {
    let [x, y, z] = times(simd, u, v);
    simd.add_f64s(simd.add_f64s(x, y), z)
}

/// u × v.
#[inline(always)]
fn cross<S: Simd>(simd: S, u: LaneVector<S>, v: LaneVector<S>) -> LaneVector<S> {
    let mut product = u;
    for i in 0..3 {
        let (p, q) = ((i + 1) % 3, (i + 2) % 3);
        product[i] = simd.sub_f64s(simd.mul_f64s(u[p], v[q]), simd.mul_f64s(u[q], v[p]));
    }
    product
}

/// Component by component.
#[inline(always)]
fn times<S: Simd>(simd: S, u: LaneVector<S>, v: LaneVector<S>) -> LaneVector<S> {
    [simd.mul_f64s(u[0], v[0]), simd.mul_f64s(u[1], v[1]), simd.mul_f64s(u[2], v[2])]
}

/// u − v.
#[inline(always)]
fn sub<S: Simd>(simd: S, u: LaneVector<S>, v: LaneVector<S>) -> LaneVector<S> {
    [simd.sub_f64s(u[0], v[0]), simd.sub_f64s(u[1], v[1]), simd.sub_f64s(u[2], v[2])]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::field::HeavyTop;

    #[test]
    fn readings_are_those_of_the_scalar_formulas() {
        let torus = PpTorus::new(&HeavyTop::from_f64([2.0, 1.1, 1.0], [0.9, -0.2, 0.6])).unwrap();
        for k in 0..100 {
            let x = |step: f64| 2.0 * ((f64::from(k) + 0.37) * step % 1.0) - 1.0;
            let gamma = [x(0.41), x(0.73), x(0.27)];
            let size = crate::field::norm(gamma);
            let state = State { gamma: gamma.map(|g| g / size), l: [3.0 * x(0.13), 3.0 * x(0.59), 3.0 * x(0.87)] };
            for condition in [SectionCondition::Height, SectionCondition::AngularMomentum] {
                let reading = Reading::new(&torus, condition, &state);
                assert_eq!(reading.value, condition.value(torus.top(), &state));
                assert_eq!(reading.rate, condition.rate(torus.top(), &state));
                assert_eq!(reading.delta, torus.delta(&state));
                assert_eq!(reading.integrals, Integrals::of(torus.top(), &state));
                let point = reading.place(&torus, &state);
                assert_eq!((point.theta, point.psi), torus.angles(state.gamma));
                assert_eq!(point, torus.point(&state));
            }
        }
    }
}
