//! Orbits side by side, one in each SIMD lane, each with its own time and step.

use pulp::Simd;

use super::moments::Moments;
use super::series::{LaneVector, Series, TopConstants, lane_values, lane_values_mut};
use super::step_size::{StepRule, order_for};
use crate::field::{HeavyTop, State};
use crate::integrator::product::ProductSum;
use crate::integrator::step::Instant;

/// As many orbits as a register has lanes.
///
/// Call [`expand`](Self::expand), read the series and the state at the end of the step, then [`commit`](Self::commit).
/// States are kept as sums of two doubles (compensated summation).
#[repr(C, align(64))]
pub(crate) struct Lanes<S: Simd> {
    pub series: Series<S>,
    /// γ and l at the step's end.
    pub next: [LaneVector<S>; 2],
    /// Length of the step.
    pub step: [S::f64s; 1],
    /// What the rows 0 leave out.
    low: [LaneVector<S>; 2],
    next_low: [LaneVector<S>; 2],
    /// 1/scale of l.
    momentum_weight: [S::f64s; 1],
    pub constants: TopConstants<S>,
    /// Time at the step's start, in two parts.
    time: [S::f64s; 1],
    time_low: [S::f64s; 1],
    order: usize,
    rule: StepRule,
}

impl<S: Simd> Lanes<S> {
    /// Lanes at rest; [`load`](Self::load) orbits into them.
    #[inline(always)]
    pub fn new(simd: S, top: &HeavyTop, tolerance: f64) -> Self {
        let zero = simd.splat_f64s(0.0);
        let order = order_for(tolerance);
        let largest = top.moments().iter().fold(0.0, |m: f64, &a| m.max(a));
        // Only equilibria have no scale of their own; for them, two radians of the fastest pendulum.
        let longest = 2.0 * (largest / top.center_norm()).sqrt();
        Self {
            series: Series::new(simd),
            next: [[zero; 3]; 2],
            step: [zero],
            low: [[zero; 3]; 2],
            next_low: [[zero; 3]; 2],
            momentum_weight: [zero],
            constants: TopConstants::new(simd, top),
            time: [zero],
            time_low: [zero],
            order,
            rule: StepRule::new(tolerance, order, longest),
        }
    }

    /// Puts an orbit into a lane at time 0. `momentum_scale` is the unit of |l| for the tolerance.
    #[inline(always)]
    pub fn load(&mut self, lane: usize, state: &State, momentum_scale: f64) {
        for i in 0..3 {
            lane_values_mut::<S>(&mut self.series.gamma[0][i..=i])[lane] = state.gamma[i];
            lane_values_mut::<S>(&mut self.series.l[0][i..=i])[lane] = state.l[i];
            for part in &mut self.low {
                lane_values_mut::<S>(&mut part[i..=i])[lane] = 0.0;
            }
        }
        lane_values_mut::<S>(&mut self.momentum_weight)[lane] = 1.0 / momentum_scale;
        lane_values_mut::<S>(&mut self.time)[lane] = 0.0;
        lane_values_mut::<S>(&mut self.time_low)[lane] = 0.0;
    }

    /// What a lane knows of its orbit, between two steps: γ, l, what they leave out, the time in two parts.
    pub fn saved(&self, lane: usize) -> [f64; 14] {
        let of = |register: S::f64s| lane_values::<S>(&[register])[lane];
        let vectors = [self.series.gamma[0], self.series.l[0], self.low[0], self.low[1]];
        std::array::from_fn(|k| match k {
            0..12 => of(vectors[k / 3][k % 3]),
            12 => of(self.time[0]),
            _ => of(self.time_low[0]),
        })
    }

    /// Puts what was [`saved`](Self::saved) into a lane that was loaded with the orbit's start.
    pub fn restore(&mut self, lane: usize, saved: &[f64; 14]) {
        let [low_gamma, low_l] = &mut self.low;
        let vectors = [&mut self.series.gamma[0], &mut self.series.l[0], low_gamma, low_l];
        for (vector, numbers) in vectors.into_iter().zip(saved.chunks(3)) {
            for i in 0..3 {
                lane_values_mut::<S>(&mut vector[i..=i])[lane] = numbers[i];
            }
        }
        lane_values_mut::<S>(&mut self.time)[lane] = saved[12];
        lane_values_mut::<S>(&mut self.time_low)[lane] = saved[13];
    }

    /// Order of the series.
    #[inline(always)]
    pub fn order(&self) -> usize {
        self.order
    }

    /// Time at the step's start.
    #[inline(always)]
    pub fn time(&self, lane: usize) -> Instant {
        Instant::new(lane_values::<S>(&self.time)[lane], lane_values::<S>(&self.time_low)[lane])
    }

    /// Length of a lane's step.
    #[inline(always)]
    pub fn step_of(&self, lane: usize) -> f64 {
        lane_values::<S>(&self.step)[lane]
    }

    /// Time at a lane's step's end, rounded.
    #[inline(always)]
    pub fn end_of(&self, lane: usize) -> f64 {
        lane_values::<S>(&self.time)[lane] + self.step_of(lane)
    }

    /// True when some lane is at this time or beyond.
    #[inline(always)]
    pub fn any_is_at(&self, time: f64) -> bool {
        lane_values::<S>(&self.time).iter().any(|&t| t >= time)
    }

    /// Computes the series, the steps and the states at the steps' ends.
    #[inline(always)]
    pub fn expand(&mut self, simd: S) {
        self.expand_only(simd);
        self.sum_series(simd);
    }

    /// Computes the series and the steps; these may be [shortened](Self::shorten_step) before the series are
    /// [summed](Self::sum_series).
    #[inline(always)]
    pub fn expand_only(&mut self, simd: S) {
        self.series.expand(simd, &self.constants, self.order);
        let last = [self.coefficient_norm(simd, self.order)];
        let before_last = [self.coefficient_norm(simd, self.order - 1)];
        let (last, before_last) = (lane_values::<S>(&last), lane_values::<S>(&before_last));
        for (lane, step) in lane_values_mut::<S>(&mut self.step).iter_mut().enumerate() {
            *step = self.rule.step(last[lane], before_last[lane]);
        }
    }

    /// Ends a lane's step after this time, if that is shorter.
    #[inline(always)]
    pub fn shorten_step(&mut self, lane: usize, longest: f64) {
        let step = &mut lane_values_mut::<S>(&mut self.step)[lane];
        *step = step.min(longest);
    }

    /// The step that the norms of the last two coefficients allow.
    #[inline(always)]
    pub fn step_for(&self, last: f64, before_last: f64) -> f64 {
        self.rule.step(last, before_last)
    }

    /// max(|γ_k|_∞, |l_k|_∞ / scale).
    #[inline(always)]
    fn coefficient_norm(&self, simd: S, k: usize) -> S::f64s {
        let l = simd.mul_f64s(largest(simd, self.series.l[k]), self.momentum_weight[0]);
        simd.max_f64s(largest(simd, self.series.gamma[k]), l)
    }

    /// Σ_{k≥1} x_k tᵏ⁻¹ of γ and l.
    #[inline(always)]
    fn slopes(&self, simd: S, t: S::f64s) -> [LaneVector<S>; 2] {
        let (mut gamma, mut l) = (self.series.gamma[self.order], self.series.l[self.order]);
        let rows = 1..self.order;
        for (gamma_k, l_k) in self.series.gamma[rows.clone()].iter().zip(&self.series.l[rows]).rev() {
            for i in 0..3 {
                gamma[i] = simd.product_sum(gamma[i], t, gamma_k[i]);
                l[i] = simd.product_sum(l[i], t, l_k[i]);
            }
        }
        [gamma, l]
    }

    /// x(t + step) = x₀ + Σ_{k≥1} x_k stepᵏ, with the rounding error of the sum carried along.
    #[inline(always)]
    pub fn sum_series(&mut self, simd: S) {
        let t = self.step[0];
        for (part, slope) in self.slopes(simd, t).into_iter().enumerate() {
            for i in 0..3 {
                let start = [self.series.gamma[0][i], self.series.l[0][i]][part];
                let increment = simd.product_sum(slope[i], t, self.low[part][i]);
                (self.next[part][i], self.next_low[part][i]) = two_sum(simd, start, increment);
            }
        }
    }

    /// ∫ (ξ − 1/2)ʲ γ dt over the step for j < `N` ≤ `MOMENTS`, where ξ runs from 0 to 1.
    #[inline(always)]
    pub fn gamma_moments<const N: usize>(&self, simd: S, moments: &Moments) -> [LaneVector<S>; N] {
        let t = self.step[0];
        let mut sums = [[simd.splat_f64s(0.0); 3]; N];
        let mut power = t;
        for k in 0..=self.order {
            for i in 0..3 {
                let term = simd.mul_f64s(self.series.gamma[k][i], power);
                for (j, sum) in sums.iter_mut().enumerate() {
                    sum[i] = simd.product_sum(term, simd.splat_f64s(moments.of_powers[k][j]), sum[i]);
                }
            }
            power = simd.mul_f64s(power, t);
        }
        sums
    }

    /// Moves every lane to its step's end.
    #[inline(always)]
    pub fn commit(&mut self, simd: S) {
        self.series.gamma[0] = self.next[0];
        self.series.l[0] = self.next[1];
        self.low = self.next_low;
        let (sum, error) = two_sum(simd, self.time[0], simd.add_f64s(self.step[0], self.time_low[0]));
        (self.time[0], self.time_low[0]) = (sum, error);
    }

    /// The states of all lanes, each `offset` after its step's start.
    #[inline(always)]
    pub fn states_at(&self, simd: S, offset: S::f64s) -> [LaneVector<S>; 2] {
        let [mut gamma, mut l] = self.slopes(simd, offset);
        for i in 0..3 {
            let increment = simd.product_sum(gamma[i], offset, self.low[0][i]);
            gamma[i] = simd.add_f64s(self.series.gamma[0][i], increment);
            let increment = simd.product_sum(l[i], offset, self.low[1][i]);
            l[i] = simd.add_f64s(self.series.l[0][i], increment);
        }
        [gamma, l]
    }
}

/// One lane of vectors γ and l.
#[inline(always)]
pub(crate) fn state_of<S: Simd>(vectors: &[LaneVector<S>; 2], lane: usize) -> State {
    let values = lane_values::<S>(vectors.as_flattened());
    let at = |i: usize| values[i * S::F64_LANES + lane];
    State { gamma: [at(0), at(1), at(2)], l: [at(3), at(4), at(5)] }
}

/// The largest |component|. (A function: closures are not always inlined, and a call of a SIMD instruction
/// outside the functions compiled for it costs more than the instruction.)
#[inline(always)]
pub(super) fn largest<S: Simd>(simd: S, v: LaneVector<S>) -> S::f64s {
    let two = simd.max_f64s(magnitude(simd, v[0]), magnitude(simd, v[1]));
    simd.max_f64s(two, magnitude(simd, v[2]))
}

/// |x|.
#[inline(always)]
pub(crate) fn magnitude<S: Simd>(simd: S, x: S::f64s) -> S::f64s {
    simd.and_f64s(x, simd.splat_f64s(f64::from_bits(u64::MAX >> 1)))
}

/// s + e = a + b exactly, s the rounded sum (Knuth's TwoSum).
#[inline(always)]
fn two_sum<S: Simd>(simd: S, a: S::f64s, b: S::f64s) -> (S::f64s, S::f64s) {
    let sum = simd.add_f64s(a, b);
    let b_part = simd.sub_f64s(sum, a);
    let a_part = simd.sub_f64s(sum, b_part);
    (sum, simd.add_f64s(simd.sub_f64s(a, a_part), simd.sub_f64s(b, b_part)))
}
