//! Every root of a step's polynomial of S, once.
//!
//! A step is x ∈ [0, 1]. The signs at its ends are given, not computed from the polynomial: neighbouring steps
//! share the sign at their seam, so that no root there is found twice or lost. Zero counts as positive.

#![expect(clippy::inline_always, reason = "sums must be inlined into the function compiled for fused multiply-adds")]

use pulp::{Simd, WithSimd};

use crate::integrator::product::product_sum;
use crate::integrator::taylor::MAX_ORDER;

/// Most coefficients that a polynomial may have.
const MAX_TERMS: usize = MAX_ORDER + 2;
/// Halvings after which an interval is called a point.
pub(super) const DEPTH: u32 = 52;
/// Newton steps below this leave |p| ≤ 2⁻⁶⁰|p″|.
const CONVERGED: f64 = 1.0 / (1u64 << 30) as f64;

/// p(x) and p′(x).
#[inline(always)]
fn value_and_slope(c: &[f64], x: f64) -> (f64, f64) {
    let (mut value, mut slope) = (0.0_f64, 0.0_f64);
    for &coefficient in c.iter().rev() {
        slope = product_sum(slope, x, value);
        value = product_sum(value, x, coefficient);
    }
    (value, slope)
}

/// p′(x) and p″(x).
#[inline(always)]
fn slope_and_curvature(c: &[f64], x: f64) -> (f64, f64) {
    let (mut slope, mut curvature) = (0.0_f64, 0.0_f64);
    for (k, &coefficient) in c.iter().enumerate().skip(1).rev() {
        curvature = product_sum(curvature, x, slope);
        slope = product_sum(slope, x, coefficient * k as f64);
    }
    (slope, curvature)
}

/// The zero between `low` and `high` of a function that has only one there and is positive at `high` iff `rising`.
///
/// Newton's method, kept inside the bracket by bisection.
#[inline(always)]
fn bracketed_zero(f: impl Fn(f64) -> (f64, f64), mut low: f64, mut high: f64, rising: bool) -> f64 {
    let mut x = f64::midpoint(low, high);
    for _ in 0..2 * DEPTH {
        let (value, slope) = f(x);
        if (value >= 0.0) == rising {
            high = x;
        } else {
            low = x;
        }
        let newton = x - value / slope;
        let inside = newton >= low && newton <= high;
        let next = if inside { newton } else { f64::midpoint(low, high) };
        let change = (next - x).abs();
        x = next;
        if (inside && change <= CONVERGED) || change <= f64::EPSILON {
            break;
        }
    }
    x
}

/// The search for all roots of one polynomial.
struct RootSearch<'a, S: Simd> {
    simd: S,
    c: &'a [f64],
    /// Values below this are rounding.
    noise: f64,
    roots: &'a mut Vec<f64>,
    tangencies: u32,
}

/// Appends every root in (0, 1), ascending, and returns the number of extrema whose sign is within rounding:
/// there, a double root cannot be distinguished from two or none. The coefficients must be finite.
///
/// Bernstein coefficients bound the polynomial and its differences on an interval; halving continues until it is seen
/// to have no root, to be monotone, or to have exactly one extremum, at which it is then split. A nearly double root is
/// therefore resolved as well as the sign of a single value.
///
/// Fused multiply-adds are the processor's where `simd` has them; the roots are the same.
pub(super) fn all_roots<S: Simd>(
    simd: S,
    c: &[f64],
    start_positive: bool,
    end_positive: bool,
    roots: &mut Vec<f64>,
) -> u32 {
    debug_assert!(c.len() <= MAX_TERMS && c.iter().all(|x| x.is_finite()));
    let size = c.iter().fold(0.0, |sum, x| sum + x.abs());
    let mut bernstein = [0.0; MAX_TERMS];
    to_bernstein(c, &mut bernstein);
    let mut search = RootSearch { simd, c, noise: size * f64::EPSILON * 16.0, roots, tangencies: 0 };
    search.interval(&bernstein[..c.len()], (0.0, 1.0), (start_positive, end_positive), 0);
    search.tangencies
}

/// b_i = Σ_k C(i,k)/C(n,k) c_k.
fn to_bernstein(c: &[f64], b: &mut [f64; MAX_TERMS]) {
    let n = c.len() - 1;
    let mut binomial = 1.0;
    for (k, &coefficient) in c.iter().enumerate() {
        b[k] = coefficient / binomial;
        binomial = binomial * (n - k) as f64 / (k + 1) as f64;
    }
    for k in (1..=n).rev() {
        for i in k..=n {
            b[i] += b[i - 1];
        }
    }
}

/// True when all consecutive differences have one sign.
fn is_monotone(b: &(impl Iterator<Item = f64> + Clone)) -> bool {
    let pairs = || b.clone().zip(b.clone().skip(1));
    pairs().all(|(x, y)| x <= y) || pairs().all(|(x, y)| x >= y)
}

/// A part of the search: an interval, the Bernstein coefficients there, the signs at its ends, halvings so far.
struct RootInterval<'s, 'a, S: Simd> {
    search: &'s mut RootSearch<'a, S>,
    b: &'s [f64],
    ends: (f64, f64),
    positive: (bool, bool),
    depth: u32,
}

impl<S: Simd> WithSimd for RootInterval<'_, '_, S> {
    type Output = ();

    #[inline(always)]
    fn with_simd<T: Simd>(self, _: T) {
        self.search.look(self.b, self.ends, self.positive, self.depth);
    }
}

impl<S: Simd> RootSearch<'_, S> {
    /// Searches an interval, in a function compiled for the instructions.
    fn interval(&mut self, b: &[f64], ends: (f64, f64), positive: (bool, bool), depth: u32) {
        let simd = self.simd;
        simd.vectorize(RootInterval { search: self, b, ends, positive, depth });
    }

    #[inline(always)]
    fn look(&mut self, b: &[f64], (low, high): (f64, f64), (low_positive, high_positive): (bool, bool), depth: u32) {
        if low_positive == high_positive
            && b.iter().all(|&x| if low_positive { x > self.noise } else { x < -self.noise })
        {
            return;
        }
        if depth == DEPTH || is_monotone(&b.iter().copied()) {
            self.monotone((low, high), (low_positive, high_positive));
            return;
        }
        let differences = b.iter().zip(&b[1..]).map(|(x, y)| y - x);
        if is_monotone(&differences) {
            let rising_slope = b[b.len() - 1] - b[b.len() - 2] > 0.0;
            let c = self.c;
            let extremum = bracketed_zero(|x| slope_and_curvature(c, x), low, high, rising_slope);
            let (value, _) = value_and_slope(c, extremum);
            self.tangencies += u32::from(value.abs() <= self.noise);
            let positive = value >= 0.0;
            self.monotone((low, extremum), (low_positive, positive));
            self.monotone((extremum, high), (positive, high_positive));
            return;
        }
        if b.iter().all(|x| x.abs() <= self.noise) {
            // A root of high multiplicity, as wide as the rounding: halving would continue in all of it.
            self.tangencies += 1;
            self.monotone((low, high), (low_positive, high_positive));
            return;
        }
        let middle = f64::midpoint(low, high);
        let positive = value_and_slope(self.c, middle).0 >= 0.0;
        let (mut left, mut right) = ([0.0; MAX_TERMS], [0.0; MAX_TERMS]);
        halve(b, &mut left, &mut right);
        self.interval(&left[..b.len()], (low, middle), (low_positive, positive), depth + 1);
        self.interval(&right[..b.len()], (middle, high), (positive, high_positive), depth + 1);
    }

    #[inline(always)]
    fn monotone(&mut self, (low, high): (f64, f64), (low_positive, high_positive): (bool, bool)) {
        if low_positive != high_positive {
            let c = self.c;
            self.roots.push(bracketed_zero(|x| value_and_slope(c, x), low, high, high_positive));
        }
    }
}

/// De Casteljau's algorithm at the middle.
fn halve(b: &[f64], left: &mut [f64; MAX_TERMS], right: &mut [f64; MAX_TERMS]) {
    let n = b.len() - 1;
    let mut row = [0.0; MAX_TERMS];
    row[..=n].copy_from_slice(b);
    for level in 0..=n {
        left[level] = row[0];
        right[n - level] = row[n - level];
        for i in 0..n - level {
            row[i] = f64::midpoint(row[i], row[i + 1]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use pulp::Scalar;

    /// Coefficients of scale · Π (x − root_i).
    fn planted(roots: &[f64], scale: f64) -> Vec<f64> {
        let mut c = vec![scale];
        for &root in roots {
            c.insert(0, 0.0);
            for k in 0..c.len() - 1 {
                c[k] -= root * c[k + 1];
            }
        }
        c
    }

    fn found(c: &[f64]) -> (Vec<f64>, u32) {
        let mut roots = Vec::new();
        let end = c.iter().sum::<f64>() >= 0.0;
        let tangencies = all_roots(Scalar::new(), c, c[0] >= 0.0, end, &mut roots);
        (roots, tangencies)
    }

    #[test]
    fn simple_roots_are_all_found() {
        let inside = [0.1, 0.35, 0.36, 0.8];
        let c = planted(&[&inside[..], &[-0.5, 1.5, 3.0]].concat(), 2.5);
        let (roots, tangencies) = found(&c);
        assert_eq!((roots.len(), tangencies), (4, 0));
        for (x, y) in roots.iter().zip(inside) {
            assert!((x - y).abs() < 1e-11, "{roots:?}");
        }
    }

    #[test]
    fn close_pairs_are_resolved_down_to_the_root_of_the_rounding() {
        for gap in [1e-2, 1e-4, 1e-6] {
            let c = planted(&[0.4, 0.4 + gap, 2.0, -3.0], 1.0);
            let (roots, _) = found(&c);
            assert_eq!(roots.len(), 2, "gap {gap}");
            // p ≈ 5 (x−a)(x−b): a rounding of 1e-15 moves a root by 1e-15/(5 gap).
            assert!((roots[1] - roots[0] - gap).abs() < 1e-14 / gap, "{roots:?}");
        }
    }

    #[test]
    fn complex_pairs_just_off_the_axis_are_no_roots() {
        for gap in [1e-2, 1e-4, 1e-6] {
            let mut c = planted(&[0.4, 0.4], 1.0);
            c[0] += gap * gap;
            assert_eq!(found(&c), (vec![], 0), "gap {gap}");
        }
    }

    #[test]
    fn a_double_root_is_a_tangency_with_two_equal_roots_or_none() {
        let c = planted(&[0.3, 0.3, -1.0, 4.0, 1.7], 1.0);
        let (roots, tangencies) = found(&c);
        assert_eq!(tangencies, 1);
        assert!(roots.is_empty() || roots.len() == 2 && (roots[0] - 0.3).abs() < 1e-7 && (roots[1] - 0.3).abs() < 1e-7);
    }

    #[test]
    fn a_triple_root_is_found_an_odd_number_of_times() {
        let (roots, _) = found(&planted(&[0.6, 0.6, 0.6, 2.0], 1.0));
        assert_eq!(roots.len() % 2, 1);
        assert!(roots.iter().all(|x| (x - 0.6).abs() < 1e-4), "{roots:?}");
    }

    #[test]
    fn a_root_of_high_multiplicity_is_wide_but_found_at_once() {
        // Within rounding over a fifth of the interval: 2⁵⁰ halvings of it would take for ever.
        for multiplicity in [5, 8, 15] {
            let mut roots = vec![0.4; multiplicity];
            roots.push(1.9);
            let (found, tangencies) = found(&planted(&roots, 1.0));
            assert!(tangencies > 0);
            assert_eq!(found.len() % 2, multiplicity % 2);
            assert!(found.iter().all(|x| (x - 0.4).abs() < 0.3), "{found:?}");
        }
    }

    #[test]
    fn signs_at_the_ends_decide_over_roots_at_a_seam() {
        // p = x − 1 is −0 or rounding at its end; the next step says which.
        let c = [-1.0, 1.0];
        let mut roots = Vec::new();
        all_roots(Scalar::new(), &c, false, true, &mut roots);
        assert_eq!(roots, [1.0]);
        roots.clear();
        all_roots(Scalar::new(), &c, false, false, &mut roots);
        assert!(roots.is_empty());
    }

    proptest::proptest! {
        #[test]
        fn planted_roots_are_found(mut roots in proptest::collection::vec(0.02f64..0.98, 0..7), outside in proptest::collection::vec(1.2f64..9.0, 0..7)) {
            roots.sort_by(f64::total_cmp);
            let gap = roots.windows(2).map(|w| w[1] - w[0]).fold(1.0, f64::min);
            proptest::prop_assume!(gap > 0.02);
            let c = planted(&[&roots[..], &outside[..]].concat(), 1.0);
            let (found, _) = found(&c);
            proptest::prop_assert_eq!(found.len(), roots.len());
            for (x, y) in found.iter().zip(&roots) {
                proptest::prop_assert!((x - y).abs() < 1e-6, "{} {}", x, y);
            }
        }
    }
}
