//! The series of S over a step, and the cheap bounds that decide most steps, all lanes at once.

use pulp::Simd;

use super::condition::SectionCondition;
use super::halley::{ROOM, single_roots};
use crate::integrator::product::ProductSum;
use crate::integrator::taylor::{LaneVector, Lanes, ROWS, lane_values, lane_values_mut, magnitude};

/// Terms whose Bernstein coefficients are taken; the others are so small that the sum of their absolute values
/// suffices.
const LEADING: usize = 7;

/// 1/C(LEADING − 1, k).
const RECIPROCAL_BINOMIAL: [f64; LEADING] = [1.0, 1.0 / 6.0, 1.0 / 15.0, 1.0 / 20.0, 1.0 / 15.0, 1.0 / 6.0, 1.0];

/// 0, 1, 2, …: a number from memory is put into all lanes by the load.
const NUMBERS: [f64; ROWS] = {
    let mut numbers = [0.0; ROWS];
    let mut k = 0;
    while k < ROWS {
        numbers[k] = k as f64;
        k += 1;
    }
    numbers
};

/// Room for the rounding of the coefficients and of their bounds, relative to Σ |c_k|.
const ROUNDING: f64 = 1.0 / (1u64 << 46) as f64;

/// S over the current step, S(x) = Σ c_k xᵏ with x ∈ [0, 1].
#[repr(C, align(64))]
pub(super) struct Scan<S: Simd> {
    /// 0 beyond the terms.
    c: [S::f64s; ROOM],
    /// S ∈ [lowest, highest].
    lowest: [S::f64s; 1],
    highest: [S::f64s; 1],
    /// S′ ∈ [least_slope, greatest_slope].
    least_slope: [S::f64s; 1],
    greatest_slope: [S::f64s; 1],
    /// S″ ∈ [least_bend, greatest_bend].
    least_bend: [S::f64s; 1],
    greatest_bend: [S::f64s; 1],
    /// Σ |c_k|.
    size: [S::f64s; 1],
    /// S at the step's start, as the step before saw it; NaN in the first step of an orbit that starts with S = 0.
    start: [S::f64s; 1],
    /// S at the step's end, from the state there.
    end: [S::f64s; 1],
    /// Σ |c_k| below this is rounding.
    flat: [S::f64s; 1],
    terms: usize,
}

/// What the bounds say of one lane's step.
#[derive(Clone, Copy, Debug)]
pub(super) struct StepVerdict {
    /// S at the step's start: its sign is that of the end before; NaN if the orbit starts here with S = 0.
    pub start: f64,
    /// S at the step's end.
    pub end: f64,
    /// S has exactly one root: the signs at the ends differ, and it has at most one extremum.
    pub single: bool,
    /// Σ |c_k| is at rounding level.
    pub flat: bool,
}

impl<S: Simd> Scan<S> {
    #[inline(always)]
    pub fn new(simd: S) -> Self {
        let zero = simd.splat_f64s(0.0);
        Self {
            c: [zero; ROOM],
            lowest: [zero],
            highest: [zero],
            least_slope: [zero],
            greatest_slope: [zero],
            least_bend: [zero],
            greatest_bend: [zero],
            size: [zero],
            start: [zero],
            end: [zero],
            flat: [zero],
            terms: 0,
        }
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
        let rows = lanes.series.gamma[1..].iter().zip(&NUMBERS[1..]);
        for (c, (gamma, &k)) in self.c[..self.terms].iter_mut().zip(rows) {
            let dot = simd.mul_f64s(gamma[0], r[0]);
            let dot = simd.product_sum(gamma[1], r[1], dot);
            let dot = simd.product_sum(gamma[2], r[2], dot);
            *c = simd.mul_f64s(dot, simd.splat_f64s(k));
        }
        // ⟨γ×ω, r⟩
        let [gamma, l] = lanes.next;
        let omega = lanes.constants.angular_velocity(simd, l);
        let mut sum = simd.splat_f64s(0.0);
        for i in 0..3 {
            let (p, q) = ((i + 1) % 3, (i + 2) % 3);
            let negative = simd.product_difference(gamma[p], omega[q], simd.mul_f64s(gamma[q], omega[p]));
            sum = simd.product_difference(negative, r[i], sum);
        }
        self.end[0] = sum;
    }

    /// S = ⟨l, γ×r⟩: three Cauchy products.
    #[inline(always)]
    fn angular_momentum(&mut self, simd: S, lanes: &Lanes<S>) {
        self.terms = lanes.order() + 1;
        let r = lanes.constants.center;
        let zero = simd.splat_f64s(0.0);
        let mut torques = [[zero; 3]; ROWS];
        for k in 0..self.terms {
            torques[k] = torque(simd, r, lanes.series.gamma[k]);
            let mut sum = zero;
            for j in 0..=k {
                sum = add_dot(simd, lanes.series.l[j], torques[k - j], sum);
            }
            self.c[k] = sum;
        }
        self.end[0] = add_dot(simd, lanes.next[1], torque(simd, r, lanes.next[0]), zero);
    }

    /// Scales the series to x ∈ [0, 1] and bounds it.
    ///
    /// S lies between the least and the greatest Bernstein coefficient of its leading terms, S′ likewise
    /// between those of the derivative, each widened by the sizes of the other terms and by the rounding.
    #[inline(always)]
    fn bound(&mut self, simd: S, lanes: &Lanes<S>) {
        const DEGREE: usize = LEADING - 1;
        let step = lanes.step[0];
        let mut power = simd.splat_f64s(1.0);
        let mut size = magnitude(simd, self.c[0]);
        let zero = simd.splat_f64s(0.0);
        let (mut rest, mut rest_slope) = (zero, zero);
        let (leading, others) = self.c[..self.terms].split_at_mut(LEADING);
        for c in &mut leading[1..] {
            power = simd.mul_f64s(power, step);
            *c = simd.mul_f64s(*c, power);
            size = simd.add_f64s(size, magnitude(simd, *c));
        }
        for (c, &k) in others.iter_mut().zip(&NUMBERS[LEADING..]) {
            power = simd.mul_f64s(power, step);
            *c = simd.mul_f64s(*c, power);
            let term = magnitude(simd, *c);
            size = simd.add_f64s(size, term);
            rest = simd.add_f64s(rest, term);
            rest_slope = simd.product_sum(term, simd.splat_f64s(k), rest_slope);
        }
        let rounding = simd.splat_f64s(ROUNDING);
        rest = simd.product_sum(size, rounding, rest);
        rest_slope = simd.product_sum(size, rounding, rest_slope);
        // Σ k(k−1)|c_k| ≤ (n−1) Σ k|c_k|, and they are small.
        let rest_bend = simd.mul_f64s(rest_slope, simd.splat_f64s(self.terms as f64));

        let mut b = [self.c[0]; LEADING];
        for k in 1..LEADING {
            b[k] = simd.mul_f64s(self.c[k], simd.splat_f64s(RECIPROCAL_BINOMIAL[k]));
        }
        for k in (1..LEADING).rev() {
            for i in k..LEADING {
                b[i] = simd.add_f64s(b[i], b[i - 1]);
            }
        }
        let (lowest, highest) = range(simd, &b);
        let slopes = differences(simd, &b);
        let (least_slope, greatest_slope) = range(simd, &slopes[..DEGREE]);
        let (least_bend, greatest_bend) = range(simd, &differences(simd, &slopes[..DEGREE])[..DEGREE - 1]);
        let degree = simd.splat_f64s(DEGREE as f64);
        let degrees = simd.splat_f64s((DEGREE * (DEGREE - 1)) as f64);
        self.lowest[0] = simd.sub_f64s(lowest, rest);
        self.highest[0] = simd.add_f64s(highest, rest);
        self.least_slope[0] = simd.sub_f64s(simd.mul_f64s(degree, least_slope), rest_slope);
        self.greatest_slope[0] = simd.product_sum(degree, greatest_slope, rest_slope);
        self.least_bend[0] = simd.sub_f64s(simd.mul_f64s(degrees, least_bend), rest_bend);
        self.greatest_bend[0] = simd.product_sum(degrees, greatest_bend, rest_bend);
        self.size[0] = size;
    }

    /// A new orbit in a lane: S at its start (NaN: exactly 0), and the size of S that is rounding.
    #[inline(always)]
    pub fn load(&mut self, lane: usize, start: f64, flat: f64) {
        lane_values_mut::<S>(&mut self.start)[lane] = start;
        lane_values_mut::<S>(&mut self.flat)[lane] = flat;
    }

    /// S at the start of a lane's next step.
    pub fn start_of(&self, lane: usize) -> f64 {
        lane_values::<S>(&self.start)[lane]
    }

    /// The next step begins where this one ends.
    #[inline(always)]
    pub fn commit(&mut self) {
        self.start = self.end;
    }

    /// The lanes, as bits, whose step is not simply free of crossings. Without branches: which lanes cross is
    /// not to be predicted.
    #[inline(always)]
    pub fn lanes_with_news(&self, simd: S) -> u32 {
        let (zero, one) = (simd.splat_f64s(0.0), simd.splat_f64s(1.0));
        let (start, end) = (self.start[0], self.end[0]);
        let crosses = simd.xor_m64s(simd.less_than_or_equal_f64s(zero, start), simd.less_than_or_equal_f64s(zero, end));
        let flat = simd.less_than_or_equal_f64s(self.size[0], self.flat[0]);
        let rootless = one_sign(simd, self.lowest[0], self.highest[0]);
        let monotone = one_sign(simd, self.least_slope[0], self.greatest_slope[0]);
        // False where an orbit begins on the section: no comparison holds for NaN.
        let under_way = simd.less_than_or_equal_f64s(start, start);
        let free = simd.and_m64s(simd.or_m64s(rootless, monotone), under_way);
        let news = simd.select_f64s(free, zero, one);
        let news = [simd.select_f64s(simd.or_m64s(crosses, flat), one, news)];
        let lanes = lane_values::<S>(&news).iter().zip(0..);
        lanes.fold(0, |bits, (&news, lane)| bits | (u32::from(news > 0.0) << lane))
    }

    /// What the bounds say of a lane.
    #[inline(always)]
    pub fn verdict(&self, lane: usize) -> StepVerdict {
        let of = lane_values::<S>;
        let (start, end) = (of(&self.start)[lane], of(&self.end)[lane]);
        let monotone = of(&self.least_slope)[lane] > 0.0 || of(&self.greatest_slope)[lane] < 0.0;
        let unimodal = monotone || of(&self.least_bend)[lane] > 0.0 || of(&self.greatest_bend)[lane] < 0.0;
        StepVerdict {
            start,
            end,
            single: unimodal && (start >= 0.0) != (end >= 0.0) && !start.is_nan(),
            flat: of(&self.size)[lane] <= of(&self.flat)[lane],
        }
    }

    /// The roots of the lanes whose verdict is `single`, as times after the step's start.
    #[inline(always)]
    pub fn single_roots(&self, simd: S, lanes: &Lanes<S>) -> S::f64s {
        let zero = simd.splat_f64s(0.0);
        let up =
            simd.and_m64s(simd.less_than_f64s(self.start[0], zero), simd.less_than_or_equal_f64s(zero, self.end[0]));
        let down =
            simd.and_m64s(simd.less_than_or_equal_f64s(zero, self.start[0]), simd.less_than_f64s(self.end[0], zero));
        let sloped = one_sign(simd, self.least_slope[0], self.greatest_slope[0]);
        let bent = one_sign(simd, self.least_bend[0], self.greatest_bend[0]);
        let wanted = simd.and_m64s(simd.or_m64s(up, down), simd.or_m64s(sloped, bent));
        simd.mul_f64s(single_roots(simd, &self.c, self.terms, self.end[0], wanted), lanes.step[0])
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

/// γ×r.
#[inline(always)]
fn torque<S: Simd>(simd: S, r: LaneVector<S>, gamma: LaneVector<S>) -> LaneVector<S> {
    let mut product = gamma;
    for i in 0..3 {
        let (p, q) = ((i + 1) % 3, (i + 2) % 3);
        let negative = simd.product_difference(gamma[p], r[q], simd.mul_f64s(gamma[q], r[p]));
        product[i] = simd.sub_f64s(simd.splat_f64s(0.0), negative);
    }
    product
}

/// ⟨u, v⟩ + sum.
#[inline(always)]
fn add_dot<S: Simd>(simd: S, u: LaneVector<S>, v: LaneVector<S>, sum: S::f64s) -> S::f64s {
    simd.product_sum(u[2], v[2], simd.product_sum(u[1], v[1], simd.product_sum(u[0], v[0], sum)))
}

/// b_{k+1} − b_k; the last entries are without meaning.
#[inline(always)]
fn differences<S: Simd>(simd: S, b: &[S::f64s]) -> [S::f64s; LEADING] {
    let mut difference = [b[0]; LEADING];
    for k in 1..b.len() {
        difference[k - 1] = simd.sub_f64s(b[k], b[k - 1]);
    }
    difference
}

/// The least and the greatest of some registers, lane by lane.
#[inline(always)]
fn range<S: Simd>(simd: S, b: &[S::f64s]) -> (S::f64s, S::f64s) {
    let (mut least, mut greatest) = (b[0], b[0]);
    for &x in &b[1..] {
        least = simd.min_f64s(least, x);
        greatest = simd.max_f64s(greatest, x);
    }
    (least, greatest)
}

/// True when 0 is outside [least, greatest].
#[inline(always)]
fn one_sign<S: Simd>(simd: S, least: S::f64s, greatest: S::f64s) -> S::m64s {
    let zero = simd.splat_f64s(0.0);
    simd.or_m64s(simd.less_than_f64s(zero, least), simd.less_than_f64s(greatest, zero))
}
