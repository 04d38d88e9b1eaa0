//! The variational equations along the steps of [`Lanes`]: one tangent vector a lane.

use pulp::Simd;

use super::lanes::{Lanes, largest, state_of};
use super::series::{LaneVector, ROWS, Series, TopConstants, lane_values, lane_values_mut};
use crate::field::State;
use crate::integrator::product::ProductSum;

/// Length of a tangent vector beyond which it is scaled down, by a power of two and so without rounding.
const LONG: f64 = 1.0 / SHORT;
/// Length below which it is scaled up.
const SHORT: f64 = 1.0 / (1u128 << 100) as f64;

/// δγ̇ = δγ×ω + γ×δω, δl̇ = δl×ω + l×δω − δγ×r: linear along the orbit, with the orbit's own series as coefficients
/// (Proposition 12.2 of docs/algorithms.md).
///
/// Call [`advance`](Self::advance) between [`Lanes::expand`] and [`Lanes::commit`]. The orbits do not feel it.
#[repr(C, align(64))]
pub(crate) struct TangentLanes<S: Simd> {
    gamma: [LaneVector<S>; ROWS],
    l: [LaneVector<S>; ROWS],
    omega: [LaneVector<S>; ROWS],
    /// 1/scale of δl.
    momentum_weight: [S::f64s; 1],
    /// |δγ|² + |δl|²/scale² at the step's end.
    length_squared: [S::f64s; 1],
}

/// Sums of the Cauchy products of one order, apart where that shortens the chains of dependent sums.
#[derive(Clone, Copy)]
struct TangentProducts<S: Simd> {
    /// Of δγ×ω.
    varied_gamma: LaneVector<S>,
    /// Of γ×δω.
    varied_omega: LaneVector<S>,
    /// Of δω_pω_q + ω_pδω_q.
    omega_omega: LaneVector<S>,
}

impl<S: Simd> TangentLanes<S> {
    #[inline(always)]
    pub fn new(simd: S) -> Self {
        let zero = simd.splat_f64s(0.0);
        let rows = [[zero; 3]; ROWS];
        Self { gamma: rows, l: rows, omega: rows, momentum_weight: [zero], length_squared: [zero] }
    }

    /// Puts a tangent vector (δγ, δl) into a lane. `momentum_scale` is the unit of δl for its length.
    #[inline(always)]
    pub fn load(&mut self, lane: usize, vector: &State, momentum_scale: f64) {
        lane_values_mut::<S>(&mut self.momentum_weight)[lane] = 1.0 / momentum_scale;
        for i in 0..3 {
            lane_values_mut::<S>(&mut self.gamma[0][i..=i])[lane] = vector.gamma[i];
            lane_values_mut::<S>(&mut self.l[0][i..=i])[lane] = vector.l[i];
        }
    }

    /// Takes the tangent vectors over the lanes' steps.
    #[inline(always)]
    pub fn advance(&mut self, simd: S, lanes: &Lanes<S>) {
        self.expand(simd, lanes);
        self.sum_series(simd, lanes);
    }

    /// The same by series of a lower order.
    #[inline(always)]
    pub fn advance_roughly(&mut self, simd: S, lanes: &Lanes<S>, order: usize) {
        let order = order.min(lanes.order());
        Self::expand_all(std::slice::from_mut(self), simd, lanes, order);
        self.sum_to(simd, lanes.step[0], order);
    }

    /// Computes the series of the tangent vectors, beside those of the orbits.
    #[inline(always)]
    pub fn expand(&mut self, simd: S, lanes: &Lanes<S>) {
        Self::expand_all(std::slice::from_mut(self), simd, lanes, lanes.order());
    }

    /// The same for several vectors per lane, one row of each in turn: the processor can start the row of the next
    /// vector while it finishes this one.
    #[inline(always)]
    pub fn expand_all(all: &mut [Self], simd: S, lanes: &Lanes<S>, order: usize) {
        for tangent in all.iter_mut() {
            tangent.omega[0] = lanes.constants.angular_velocity(simd, tangent.l[0]);
        }
        for k in 0..order {
            for tangent in all.iter_mut() {
                let products = tangent.products(simd, &lanes.series, k);
                tangent.set_row(simd, &lanes.constants, k + 1, products);
            }
        }
    }

    /// max(|δγ_k|_∞, |δl_k|_∞ / scale).
    #[inline(always)]
    fn norm(&self, simd: S, k: usize) -> [S::f64s; 1] {
        let l = simd.mul_f64s(largest(simd, self.l[k]), self.momentum_weight[0]);
        [simd.max_f64s(largest(simd, self.gamma[k]), l)]
    }

    /// Shortens the lanes' steps to those that keep the truncation errors of the tangent vectors within the orbits' tolerance.
    /// Those of the orbits can be too long: near an equilibrium an orbit may not feel what is fast there.
    #[inline(always)]
    pub fn shorten_steps(&self, simd: S, lanes: &mut Lanes<S>) {
        let order = lanes.order();
        let (start, before_last, last) = (self.norm(simd, 0), self.norm(simd, order - 1), self.norm(simd, order));
        let of = |registers: &[S::f64s; 1], lane: usize| lane_values::<S>(registers)[lane];
        for lane in 0..S::F64_LANES {
            let size = of(&start, lane);
            if size > 0.0 {
                let longest = lanes.step_for(of(&last, lane) / size, of(&before_last, lane) / size);
                lanes.shorten_step(lane, longest);
            }
        }
    }

    /// A lane's vector (δγ, δl).
    #[inline(always)]
    pub fn vector(&self, lane: usize) -> State {
        state_of::<S>(&[self.gamma[0], self.l[0]], lane)
    }

    /// |δγ|² + |δl|²/scale² of a lane.
    #[inline(always)]
    pub fn length_squared(&self, lane: usize) -> f64 {
        lane_values::<S>(&self.length_squared)[lane]
    }

    /// Scales a lane's vector if it is very long or very short; the power of two that was taken out of it.
    #[inline(always)]
    pub fn renormalise(&mut self, lane: usize) -> i32 {
        let squared = self.length_squared(lane);
        let (factor, power) = match squared {
            x if x > LONG * LONG => (SHORT, 100),
            x if x < SHORT * SHORT => (LONG, -100),
            _ => return 0,
        };
        for part in [&mut self.gamma[0], &mut self.l[0]] {
            for i in 0..3 {
                lane_values_mut::<S>(&mut part[i..=i])[lane] *= factor;
            }
        }
        power
    }

    /// The products of order k, the newest coefficients last.
    #[inline(always)]
    fn products(&self, simd: S, orbit: &Series<S>, k: usize) -> TangentProducts<S> {
        let zero = [simd.splat_f64s(0.0); 3];
        let mut sums = TangentProducts::<S> { varied_gamma: zero, varied_omega: zero, omega_omega: zero };
        for j in 0..=k {
            let (gamma, omega) = (orbit.gamma[k - j], orbit.omega[k - j]);
            let (delta_gamma, delta_omega) = (self.gamma[j], self.omega[j]);
            for i in 0..3 {
                let (p, q) = ((i + 1) % 3, (i + 2) % 3);
                let product = &mut sums.varied_gamma[i];
                *product = simd.product_sum(delta_gamma[p], omega[q], *product);
                *product = simd.product_difference(delta_gamma[q], omega[p], *product);
                let product = &mut sums.varied_omega[i];
                *product = simd.product_sum(gamma[p], delta_omega[q], *product);
                *product = simd.product_difference(gamma[q], delta_omega[p], *product);
                let product = &mut sums.omega_omega[i];
                *product = simd.product_sum(delta_omega[p], omega[q], *product);
                *product = simd.product_sum(omega[p], delta_omega[q], *product);
            }
        }
        sums
    }

    /// Row k from the products of order k − 1.
    #[inline(always)]
    fn set_row(&mut self, simd: S, top: &TopConstants<S>, k: usize, products: TangentProducts<S>) {
        let reciprocal = simd.splat_f64s(top.reciprocal(k));
        let gamma = self.gamma[k - 1];
        for i in 0..3 {
            let (p, q) = ((i + 1) % 3, (i + 2) % 3);
            let sum = simd.add_f64s(products.varied_gamma[i], products.varied_omega[i]);
            self.gamma[k][i] = simd.mul_f64s(sum, reciprocal);
            let torque = simd.mul_f64s(gamma[q], top.center[p]);
            let torque = simd.product_difference(gamma[p], top.center[q], torque);
            let sum = simd.product_sum(products.omega_omega[i], top.difference(i), torque);
            self.l[k][i] = simd.mul_f64s(sum, reciprocal);
        }
        self.omega[k] = top.angular_velocity(simd, self.l[k]);
    }

    /// The vectors at the steps' ends become the rows 0.
    #[inline(always)]
    pub fn sum_series(&mut self, simd: S, lanes: &Lanes<S>) {
        self.sum_to(simd, lanes.step[0], lanes.order());
    }

    #[inline(always)]
    fn sum_to(&mut self, simd: S, step: S::f64s, order: usize) {
        let (mut gamma, mut l) = (self.gamma[order], self.l[order]);
        for k in (0..order).rev() {
            for i in 0..3 {
                gamma[i] = simd.product_sum(gamma[i], step, self.gamma[k][i]);
                l[i] = simd.product_sum(l[i], step, self.l[k][i]);
            }
        }
        (self.gamma[0], self.l[0]) = (gamma, l);
        let mut squared = simd.splat_f64s(0.0);
        for i in 0..3 {
            let momentum = simd.mul_f64s(l[i], self.momentum_weight[0]);
            squared = simd.product_sum(gamma[i], gamma[i], squared);
            squared = simd.product_sum(momentum, momentum, squared);
        }
        self.length_squared = [squared];
    }
}
