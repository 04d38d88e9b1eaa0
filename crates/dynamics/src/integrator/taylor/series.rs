//! The recurrence of the Taylor coefficients.

use pulp::{Simd, bytemuck};

use crate::field::HeavyTop;
use crate::integrator::product::ProductSum;

/// Rows of coefficients held: orders 0 to ROWS − 1.
pub(crate) const ROWS: usize = 34;

/// Below this order the rounding of 1/k would show as a linear drift of the first integrals (of 2·10⁻¹⁸ a time
/// unit at the paper's body); above, the terms are too small.
const EXACT_BELOW: usize = 10;

/// Registers that hold the sums of two orders and what goes into them: 18, and 9 factors.
const REGISTERS_FOR_TWO: usize = 27;

/// A module for the web does not know its processor; most have 16 registers.
const WASM: bool = cfg!(target_family = "wasm");

/// A vector of ℝ³ in every lane.
pub(crate) type LaneVector<S> = [<S as Simd>::f64s; 3];

/// The lanes of registers as plain numbers: the lanes of the first register, then those of the next.
#[inline(always)]
pub(crate) fn lane_values<S: Simd>(registers: &[S::f64s]) -> &[f64] {
    bytemuck::cast_slice(registers)
}

/// Likewise, mutable.
#[inline(always)]
pub(crate) fn lane_values_mut<S: Simd>(registers: &mut [S::f64s]) -> &mut [f64] {
    bytemuck::cast_slice_mut(registers)
}

/// The top's constants in every lane.
#[repr(C, align(64))]
pub(crate) struct TopConstants<S: Simd> {
    /// 1/A_i in two parts. A rounding error of a constant would be the same in every step and let the energy drift
    /// linearly; fused into a product that has to be rounded anyway, the second part is lost in no direction.
    inverse: LaneVector<S>,
    inverse_low: LaneVector<S>,
    /// A_j − A_k in two parts; the second is 0 unless the moments are of different size.
    difference: LaneVector<S>,
    difference_low: LaneVector<S>,
    /// r and −r.
    pub center: LaneVector<S>,
    opposite: LaneVector<S>,
    /// True when some second part of a difference is not 0.
    differences_have_low_parts: bool,
    divisors: [Divisor; ROWS],
}

/// What the sums of order k − 1 are multiplied with, in two parts.
#[derive(Clone, Copy, Default)]
#[repr(C, align(64))]
struct Divisor {
    /// 1/k.
    reciprocal: f64,
    reciprocal_low: f64,
    /// 1/(k A_i).
    inverse: [f64; 3],
    inverse_low: [f64; 3],
}

/// x (high + low), rounded.
#[inline(always)]
fn product<S: Simd>(simd: S, x: S::f64s, high: S::f64s, low: S::f64s) -> S::f64s {
    simd.product_sum(x, high, simd.mul_f64s(x, low))
}

/// (high + low)/k as the unevaluated sum of two doubles.
fn quotient_in_two_parts((high, low): (f64, f64), k: f64) -> (f64, f64) {
    let quotient = high / k;
    (quotient, ((-quotient).mul_add(k, high) + low) / k)
}

impl<S: Simd> TopConstants<S> {
    #[inline(always)]
    pub fn new(simd: S, top: &HeavyTop) -> Self {
        let a = top.moments();
        let b = a.map(|a| quotient_in_two_parts((1.0, 0.0), a));
        let mut difference = [0.0; 3];
        let mut low = [0.0; 3];
        for i in 0..3 {
            let (p, q) = ((i + 1) % 3, (i + 2) % 3);
            (difference[i], low[i]) = super::super::step::two_sum(a[p], -a[q]);
        }
        let splat = |v: [f64; 3]| [simd.splat_f64s(v[0]), simd.splat_f64s(v[1]), simd.splat_f64s(v[2])];
        let divisors = std::array::from_fn(|k| {
            if k == 0 {
                return Divisor::default();
            }
            let over_k = |parts| quotient_in_two_parts(parts, k as f64);
            let (whole, inverse) = (over_k((1.0, 0.0)), b.map(over_k));
            Divisor {
                reciprocal: whole.0,
                reciprocal_low: whole.1,
                inverse: inverse.map(|parts| parts.0),
                inverse_low: inverse.map(|parts| parts.1),
            }
        });
        Self {
            inverse: splat(b.map(|b| b.0)),
            inverse_low: splat(b.map(|b| b.1)),
            difference: splat(difference),
            difference_low: splat(low),
            center: splat(top.center()),
            opposite: splat(top.center().map(|r| -r)),
            differences_have_low_parts: low != [0.0; 3],
            divisors,
        }
    }

    /// 1/k, rounded.
    #[inline(always)]
    pub(super) fn reciprocal(&self, k: usize) -> f64 {
        self.divisors[k].reciprocal
    }

    /// A_p − A_q of l×ω = ((A_p − A_q) ω_pω_q)_i, rounded.
    #[inline(always)]
    pub(super) fn difference(&self, i: usize) -> S::f64s {
        self.difference[i]
    }

    /// ω_pω_q D − (γ×r)_i; `low`: D has a second part.
    #[inline(always)]
    fn torques(&self, simd: S, gamma: LaneVector<S>, omega_omega: LaneVector<S>, low: bool) -> LaneVector<S> {
        let mut sums = gamma;
        for i in 0..3 {
            let (p, q) = ((i + 1) % 3, (i + 2) % 3);
            let arm = if low {
                // The low part goes in first: added to the rounded sum it would always be lost.
                simd.product_sum(gamma[q], self.center[p], simd.mul_f64s(omega_omega[i], self.difference_low[i]))
            } else {
                simd.mul_f64s(gamma[q], self.center[p])
            };
            let torque = simd.product_sum(gamma[p], self.opposite[q], arm);
            sums[i] = simd.product_sum(omega_omega[i], self.difference[i], torque);
        }
        sums
    }

    /// ω = A⁻¹ l with the second part of A⁻¹.
    #[inline(always)]
    fn exact_angular_velocity(&self, simd: S, l: LaneVector<S>) -> LaneVector<S> {
        let mut omega = l;
        for i in 0..3 {
            omega[i] = product(simd, l[i], self.inverse[i], self.inverse_low[i]);
        }
        omega
    }

    /// ω = A⁻¹ l.
    #[inline(always)]
    pub fn angular_velocity(&self, simd: S, l: LaneVector<S>) -> LaneVector<S> {
        [
            simd.mul_f64s(l[0], self.inverse[0]),
            simd.mul_f64s(l[1], self.inverse[1]),
            simd.mul_f64s(l[2], self.inverse[2]),
        ]
    }
}

/// Taylor coefficients x_k = x⁽ᵏ⁾/k! of γ, ω and l: `gamma[k][axis]`, every lane an orbit.
///
/// Rows are whole cache lines: a register that crosses one costs two loads, and loads limit the kernel.
#[repr(C, align(64))]
pub(crate) struct Series<S: Simd> {
    pub gamma: [LaneVector<S>; ROWS],
    pub l: [LaneVector<S>; ROWS],
    pub(super) omega: [LaneVector<S>; ROWS],
}

/// Sums of Cauchy products of one order: those of γ×ω, and ω_jω_k of l×ω.
#[derive(Clone, Copy)]
struct SeriesProducts<S: Simd> {
    gamma_omega: LaneVector<S>,
    omega_omega: LaneVector<S>,
}

impl<S: Simd> SeriesProducts<S> {
    #[inline(always)]
    fn zero(simd: S) -> Self {
        let zero = simd.splat_f64s(0.0);
        Self { gamma_omega: [zero; 3], omega_omega: [zero; 3] }
    }

    /// Adds γ_j × ω_k and the products of ω_j with ω_k.
    #[inline(always)]
    fn add(&mut self, simd: S, gamma_j: LaneVector<S>, omega_j: LaneVector<S>, omega_k: LaneVector<S>) {
        for i in 0..3 {
            let (p, q) = ((i + 1) % 3, (i + 2) % 3);
            self.gamma_omega[i] = simd.product_sum(gamma_j[p], omega_k[q], self.gamma_omega[i]);
            self.omega_omega[i] = simd.product_sum(omega_j[p], omega_k[q], self.omega_omega[i]);
        }
        for i in 0..3 {
            let (p, q) = ((i + 1) % 3, (i + 2) % 3);
            self.gamma_omega[i] = simd.product_difference(gamma_j[q], omega_k[p], self.gamma_omega[i]);
        }
    }
}

impl<S: Simd> Series<S> {
    #[inline(always)]
    pub fn new(simd: S) -> Self {
        let zero = [[simd.splat_f64s(0.0); 3]; ROWS];
        Self { gamma: zero, l: zero, omega: zero }
    }

    /// Fills the rows 1 … `order` (even) from row 0 of γ and l.
    ///
    /// Two orders k, k+1 at a time, and the terms with the newest coefficients come last, so that the processor can start
    /// the sums of the next pair while it still finishes this one. (Engines of WebAssembly compile function by function,
    /// first for speed of compiling: this one must be left and entered again before a better one takes its place.)
    #[cfg_attr(target_family = "wasm", inline(never))]
    #[cfg_attr(not(target_family = "wasm"), inline(always))]
    pub fn expand(&mut self, simd: S, top: &TopConstants<S>, order: usize) {
        debug_assert!(order.is_multiple_of(2) && order < ROWS);
        // What does not change from row to row is known where the rows are compiled: they have no branches.
        if top.differences_have_low_parts {
            self.expand_with(simd, top, order, true);
        } else {
            self.expand_with(simd, top, order, false);
        }
    }

    /// `low`: the differences have second parts.
    #[inline(always)]
    fn expand_with(&mut self, simd: S, top: &TopConstants<S>, order: usize, low: bool) {
        self.omega[0] = top.exact_angular_velocity(simd, self.l[0]);
        let mut first = SeriesProducts::zero(simd);
        first.add(simd, self.gamma[0], self.omega[0], self.omega[0]);
        self.set_row(simd, top, 1, first, low, true);
        let mut second = SeriesProducts::zero(simd);
        second.add(simd, self.gamma[1], self.omega[1], self.omega[0]);
        second.add(simd, self.gamma[0], self.omega[0], self.omega[1]);
        self.set_row(simd, top, 2, second, low, true);

        for k in (2..order.min(EXACT_BELOW - 2)).step_by(2) {
            self.pair(simd, top, k, low, [true, true]);
        }
        if order > EXACT_BELOW - 2 {
            self.pair(simd, top, EXACT_BELOW - 2, low, [true, false]);
        }
        for k in (EXACT_BELOW..order).step_by(2) {
            self.pair(simd, top, k, low, [false, false]);
        }
    }

    /// The rows k+1 and k+2, the newest coefficients last; `exact`: with the second parts of the divisors.
    #[inline(always)]
    fn pair(&mut self, simd: S, top: &TopConstants<S>, k: usize, low: bool, exact: [bool; 2]) {
        assert!(k + 2 < ROWS);
        let (mut even, mut odd) = self.known_products(simd, k);
        let (gamma_k, omega_k) = (self.gamma[k], self.omega[k]);
        even.add(simd, gamma_k, omega_k, self.omega[0]);
        even.add(simd, self.gamma[0], self.omega[0], omega_k);
        self.set_row(simd, top, k + 1, even, low, exact[0]);
        odd.add(simd, gamma_k, omega_k, self.omega[1]);
        odd.add(simd, self.gamma[1], self.omega[1], omega_k);
        odd.add(simd, self.gamma[k + 1], self.omega[k + 1], self.omega[0]);
        odd.add(simd, self.gamma[0], self.omega[0], self.omega[k + 1]);
        self.set_row(simd, top, k + 2, odd, low, exact[1]);
    }

    /// The terms of orders k and k+1 that need the rows 1 … k−1 only. Two orders at a time share their loads where
    /// there are registers for the sums of both.
    #[inline(always)]
    fn known_products(&self, simd: S, k: usize) -> (SeriesProducts<S>, SeriesProducts<S>) {
        let (gamma, omega) = (&self.gamma[1..k], &self.omega[1..k]);
        let last = k - 2;
        let (mut even, mut odd) = (SeriesProducts::zero(simd), SeriesProducts::zero(simd));
        if last > 0 {
            // Slices of one length: indices need no checks, which would take a tenth of the loop's time.
            let turns = last - 1;
            let (gamma_even, omega_even) = (&gamma[1..=turns], &omega[1..=turns]);
            let (gamma_odd, omega_odd) = (&gamma[2..2 + turns], &omega[2..2 + turns]);
            let partners = &omega[1..=turns];
            if S::REGISTER_COUNT < REGISTERS_FOR_TWO || WASM {
                for j in 0..turns {
                    even.add(simd, gamma_even[j], omega_even[j], partners[turns - 1 - j]);
                }
                for j in 0..turns {
                    odd.add(simd, gamma_odd[j], omega_odd[j], partners[turns - 1 - j]);
                }
            } else {
                let (mut gamma_j, mut omega_j) = (gamma[1], omega[1]);
                for j in 0..turns {
                    let partner = partners[turns - 1 - j];
                    even.add(simd, gamma_j, omega_j, partner);
                    (gamma_j, omega_j) = (gamma_odd[j], omega_odd[j]);
                    odd.add(simd, gamma_j, omega_j, partner);
                }
            }
            even.add(simd, gamma[0], omega[0], omega[last]);
            odd.add(simd, gamma[1], omega[1], omega[last]);
        }
        even.add(simd, gamma[last], omega[last], omega[0]);
        (even, odd)
    }

    /// Row k from the Cauchy products of order k − 1; `exact`: with the second parts of the divisors.
    #[inline(always)]
    fn set_row(
        &mut self,
        simd: S,
        top: &TopConstants<S>,
        k: usize,
        products: SeriesProducts<S>,
        low: bool,
        exact: bool,
    ) {
        let sums = top.torques(simd, self.gamma[k - 1], products.omega_omega, low);
        let divisor = &top.divisors[k];
        let (reciprocal, reciprocal_low) =
            (simd.splat_f64s(divisor.reciprocal), simd.splat_f64s(divisor.reciprocal_low));
        for i in 0..3 {
            let (inverse, inverse_low) = (simd.splat_f64s(divisor.inverse[i]), simd.splat_f64s(divisor.inverse_low[i]));
            if exact {
                self.gamma[k][i] = product(simd, products.gamma_omega[i], reciprocal, reciprocal_low);
                self.l[k][i] = product(simd, sums[i], reciprocal, reciprocal_low);
                self.omega[k][i] = product(simd, sums[i], inverse, inverse_low);
            } else {
                self.gamma[k][i] = simd.mul_f64s(products.gamma_omega[i], reciprocal);
                self.l[k][i] = simd.mul_f64s(sums[i], reciprocal);
                self.omega[k][i] = simd.mul_f64s(sums[i], inverse);
            }
        }
    }
}
