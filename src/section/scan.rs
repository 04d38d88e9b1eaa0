//! The series of S over a step, and the cheap bounds that tell most steps apart, all lanes at once.

use pulp::Simd;

use super::condition::SectionCondition;
use crate::integrator::taylor::{Lanes, ROWS, lane_values};

/// S over the current step, S(x) = Σ c_k xᵏ with x ∈ [0, 1].
#[repr(C, align(64))]
pub(super) struct Scan<S: Simd> {
    c: [S::f64s; ROWS],
    /// Σ_{k≥1} |c_k|: if it is below |c_0|, there is no root.
    spread: [S::f64s; 1],
    /// Σ_{k≥2} k|c_k|: if it is below |c_1|, S is monotone.
    bend: [S::f64s; 1],
    /// S at the step's end, from the state there.
    end: [S::f64s; 1],
    terms: usize,
}

/// What the bounds say of one lane's step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Verdict {
    /// S at the step's end.
    pub end: f64,
    /// No root, whatever the sign at the end.
    pub rootless: bool,
    /// At most one root.
    pub monotone: bool,
    /// Σ |c_k|.
    pub size: f64,
}

impl<S: Simd> Scan<S> {
    #[inline(always)]
    pub fn new(simd: S) -> Self {
        let zero = simd.splat_f64s(0.0);
        Self { c: [zero; ROWS], spread: [zero], bend: [zero], end: [zero], terms: 0 }
    }

    /// Reads the expanded lanes.
    #[inline(always)]
    pub fn read(&mut self, simd: S, lanes: &Lanes<S>, condition: SectionCondition) {
        match condition {
            SectionCondition::Height => self.height(simd, lanes),
            SectionCondition::AngularMomentum => self.angular_momentum(simd, lanes),
        }
        self.bound(simd, lanes);
    }

    /// S = d/dt ⟨γ,r⟩: s_k = (k+1)⟨γ_{k+1}, r⟩.
    #[inline(always)]
    fn height(&mut self, simd: S, lanes: &Lanes<S>) {
        self.terms = lanes.order();
        let r = lanes.constants.center;
        for k in 0..self.terms {
            let gamma = lanes.series.gamma[k + 1];
            let dot = simd.mul_f64s(gamma[0], r[0]);
            let dot = simd.mul_add_f64s(gamma[1], r[1], dot);
            let dot = simd.mul_add_f64s(gamma[2], r[2], dot);
            self.c[k] = simd.mul_f64s(dot, simd.splat_f64s((k + 1) as f64));
        }
        // ⟨γ×ω, r⟩
        let [gamma, l] = lanes.next;
        let omega = lanes.constants.angular_velocity(simd, l);
        let mut sum = simd.splat_f64s(0.0);
        for i in 0..3 {
            let (p, q) = ((i + 1) % 3, (i + 2) % 3);
            let product = simd.mul_f64s(gamma[q], omega[p]);
            let product = simd.neg_f64s(simd.negate_mul_add_f64s(gamma[p], omega[q], product));
            sum = simd.mul_add_f64s(product, r[i], sum);
        }
        self.end[0] = sum;
    }

    /// S = ⟨l, γ×r⟩: three Cauchy products.
    #[inline(always)]
    fn angular_momentum(&mut self, simd: S, lanes: &Lanes<S>) {
        self.terms = lanes.order() + 1;
        let r = lanes.constants.center;
        let torque = |gamma: [S::f64s; 3]| {
            let mut product = gamma;
            for i in 0..3 {
                let (p, q) = ((i + 1) % 3, (i + 2) % 3);
                product[i] = simd.mul_f64s(gamma[q], r[p]);
                product[i] = simd.neg_f64s(simd.negate_mul_add_f64s(gamma[p], r[q], product[i]));
            }
            product
        };
        let dot = |u: [S::f64s; 3], v: [S::f64s; 3], sum: S::f64s| {
            simd.mul_add_f64s(u[2], v[2], simd.mul_add_f64s(u[1], v[1], simd.mul_add_f64s(u[0], v[0], sum)))
        };
        let zero = simd.splat_f64s(0.0);
        let mut torques = [[zero; 3]; ROWS];
        for k in 0..self.terms {
            torques[k] = torque(lanes.series.gamma[k]);
            let mut sum = zero;
            for j in 0..=k {
                sum = dot(lanes.series.l[j], torques[k - j], sum);
            }
            self.c[k] = sum;
        }
        self.end[0] = dot(lanes.next[1], torque(lanes.next[0]), zero);
    }

    /// Scales the series to x ∈ [0, 1] and sums its bounds.
    #[inline(always)]
    fn bound(&mut self, simd: S, lanes: &Lanes<S>) {
        let step = lanes.step[0];
        let mut power = simd.splat_f64s(1.0);
        let (mut spread, mut bend) = (simd.splat_f64s(0.0), simd.splat_f64s(0.0));
        for k in 1..self.terms {
            power = simd.mul_f64s(power, step);
            self.c[k] = simd.mul_f64s(self.c[k], power);
            let size = simd.abs_f64s(self.c[k]);
            spread = simd.add_f64s(spread, size);
            if k > 1 {
                bend = simd.mul_add_f64s(size, simd.splat_f64s(k as f64), bend);
            }
        }
        self.spread[0] = spread;
        self.bend[0] = bend;
    }

    /// What the bounds say of a lane. They leave room for the rounding of the coefficients.
    #[inline(always)]
    pub fn verdict(&self, lane: usize) -> Verdict {
        const ROOM: f64 = 1.0 + 1.0 / (1u64 << 40) as f64;
        let c = lane_values::<S>(&self.c);
        let (first, second) = (c[lane].abs(), c[S::F64_LANES + lane].abs());
        let spread = lane_values::<S>(&self.spread)[lane];
        Verdict {
            end: lane_values::<S>(&self.end)[lane],
            rootless: first > spread * ROOM,
            monotone: second > lane_values::<S>(&self.bend)[lane] * ROOM,
            size: first + spread,
        }
    }

    /// The coefficients of a lane.
    #[inline(always)]
    pub fn coefficients<'a>(&self, lane: usize, room: &'a mut [f64; ROWS]) -> &'a [f64] {
        let c = lane_values::<S>(&self.c);
        for k in 0..self.terms {
            room[k] = c[k * S::F64_LANES + lane];
        }
        &room[..self.terms]
    }
}
