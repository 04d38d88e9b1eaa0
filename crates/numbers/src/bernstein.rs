//! Real roots in (0, 1) of polynomials in Bernstein form with error bounds on the coefficients.
//!
//! A polynomial of degree n is Σ b_k C(n,k) v^(n−k) u^k with v = 1 − u. By Descartes' rule in Bernstein form the number
//! of roots in (0, 1) is at most the number V of sign changes of b_0 … b_n and has its parity, so V = 0 excludes and
//! V = 1 isolates; de Casteljau subdivision (convex combinations only) splits what is left. Source: Mourrain, Rouillier,
//! Roy, "Bernstein's basis and real root isolation" (2005). Signs smaller than their error bound count as unknown.

use super::UNIT_ROUNDOFF;

/// A homogeneous polynomial Σ c_k v^(n−k) u^k of degree less than `SIZE`, built of sums and products; `magnitude` bounds
/// the sum of the absolute values of what was added, relative to which rounding is counted.
#[derive(Clone, Copy, Debug)]
pub struct Form<const SIZE: usize> {
    degree: usize,
    coefficients: [f64; SIZE],
    magnitude: [f64; SIZE],
}

impl<const SIZE: usize> Form<SIZE> {
    /// The zero form of a degree.
    ///
    /// # Panics
    /// When `degree` is not less than `SIZE`.
    #[must_use]
    pub fn zero(degree: usize) -> Self {
        assert!(degree < SIZE, "these forms have degree less than {SIZE}");
        Self { degree, coefficients: [0.0; SIZE], magnitude: [0.0; SIZE] }
    }

    /// at_zero · v + at_one · u.
    #[must_use]
    pub fn linear(at_zero: f64, at_one: f64) -> Self {
        let mut form = Self::zero(1);
        form.coefficients[..2].copy_from_slice(&[at_zero, at_one]);
        form.magnitude[..2].copy_from_slice(&[at_zero.abs(), at_one.abs()]);
        form
    }

    /// The degree n, which all terms share.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// The product of two forms.
    #[must_use]
    pub fn times(&self, other: &Self) -> Self {
        let mut product = Self::zero(self.degree + other.degree);
        for i in 0..=self.degree {
            for j in 0..=other.degree {
                product.coefficients[i + j] += self.coefficients[i] * other.coefficients[j];
                product.magnitude[i + j] += self.magnitude[i] * other.magnitude[j];
            }
        }
        product
    }

    /// Adds `factor` times another form of the same degree.
    ///
    /// # Panics
    /// When the degrees differ.
    pub fn add_scaled(&mut self, factor: f64, other: &Self) {
        assert_eq!(self.degree, other.degree, "forms of one degree are added");
        for k in 0..=self.degree {
            self.coefficients[k] += factor * other.coefficients[k];
            self.magnitude[k] += factor.abs() * other.magnitude[k];
        }
    }

    /// c_0 … c_n.
    #[must_use]
    pub fn coefficients(&self) -> &[f64] {
        &self.coefficients[..=self.degree]
    }

    /// Isolates the roots in 0 < u < 1; no path from the exact numbers to a coefficient has more than `roundings` of
    /// them.
    #[must_use]
    pub fn isolate_roots(&self, roundings: f64) -> Vec<Isolation> {
        let mut binomial = 1.0;
        let mut bernstein = Bernstein::<SIZE> { degree: self.degree, b: [0.0; SIZE], error: [0.0; SIZE] };
        for k in 0..=self.degree {
            bernstein.b[k] = self.coefficients[k] / binomial;
            bernstein.error[k] = roundings * UNIT_ROUNDOFF * self.magnitude[k] / binomial;
            binomial = binomial * (self.degree - k) as f64 / (k + 1) as f64;
        }
        bernstein.isolate()
    }
}

/// A part of (0, 1): u and v = 1 − u at both ends, so that neither end loses digits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cell {
    /// u at the left and right end.
    pub u: [f64; 2],
    /// 1 − u at the left and right end.
    pub v: [f64; 2],
}

impl Cell {
    fn split(&self, t: f64) -> (Self, Self) {
        let at = |ends: [f64; 2]| (1.0 - t) * ends[0] + t * ends[1];
        let (u, v) = (at(self.u), at(self.v));
        (Self { u: [self.u[0], u], v: [self.v[0], v] }, Self { u: [u, self.u[1]], v: [v, self.v[1]] })
    }

    /// Too narrow, relative to the distance from either end of (0, 1), to be split further in `f64`.
    fn is_exhausted(&self) -> bool {
        // In the coordinate of the nearer end, which alone resolves it: near 1 a cell can be no narrower than one bit
        // of u.
        let [far, near] = if self.u[1] < self.v[0] { self.u } else { [self.v[1], self.v[0]] };
        (near - far).abs() <= 8.0 * f64::EPSILON * near || near < 1e-290
    }
}

/// A part of (0, 1) that holds roots.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Isolation {
    /// The part of (0, 1) that holds them.
    pub cell: Cell,
    /// `None`: exactly one root, simple. `Some(n)`: at most n roots (perhaps none) that rounding does not separate.
    pub cluster: Option<u32>,
    /// For a simple root: the polynomial is positive to its right.
    pub rising: bool,
}

#[derive(Clone, Copy)]
struct Bernstein<const SIZE: usize> {
    degree: usize,
    b: [f64; SIZE],
    error: [f64; SIZE],
}

impl<const SIZE: usize> Bernstein<SIZE> {
    fn sign(&self, k: usize) -> Option<bool> {
        (self.b[k].abs() > self.error[k]).then(|| self.b[k] > 0.0)
    }

    /// The last known sign is positive.
    fn ends_positive(&self) -> bool {
        (0..=self.degree).rev().find_map(|k| self.sign(k)).unwrap_or(false)
    }

    /// The smallest and the largest number of sign changes compatible with the error bounds.
    fn sign_changes(&self) -> (u32, u32) {
        let mut fewest = 0;
        let mut last_known = None;
        // Most changes so far if the current sign is taken as (negative, positive); None: impossible.
        let mut most: [Option<u32>; 2] = [Some(0), Some(0)];
        for k in 0..=self.degree {
            let sign = self.sign(k);
            if let (Some(now), Some(before)) = (sign, last_known) {
                fewest += u32::from(now != before);
            }
            last_known = sign.or(last_known);
            let reach = |to: usize| {
                if sign.is_some_and(|positive| usize::from(positive) != to) {
                    return None;
                }
                if k == 0 {
                    return Some(0);
                }
                let stay = most[to];
                let switch = most[1 - to].map(|n| n + 1);
                stay.max(switch)
            };
            most = [reach(0), reach(1)];
        }
        (fewest, most[0].max(most[1]).unwrap_or(0))
    }

    /// De Casteljau subdivision at t.
    fn split(&self, t: f64) -> (Self, Self) {
        let (mut left, mut right) = (*self, *self);
        let n = self.degree;
        let mut row = *self;
        for step in 0..=n {
            left.b[step] = row.b[0];
            left.error[step] = row.error[0];
            right.b[n - step] = row.b[n - step];
            right.error[n - step] = row.error[n - step];
            for k in 0..n - step {
                let rounding = 2.0 * UNIT_ROUNDOFF * (row.b[k].abs() + row.b[k + 1].abs());
                row.b[k] = (1.0 - t) * row.b[k] + t * row.b[k + 1];
                row.error[k] = (1.0 - t) * row.error[k] + t * row.error[k + 1] + rounding;
            }
        }
        (left, right)
    }

    /// The roots, from left to right. The cells still to be examined are in a list: towards an end of (0, 1) cells are
    /// halved
    /// a thousand times, which is too deep for the stack of a browser.
    fn isolate(self) -> Vec<Isolation> {
        let mut found = Vec::new();
        let mut open = vec![(self, Cell { u: [0.0, 1.0], v: [1.0, 0.0] })];
        while let Some((form, cell)) = open.pop() {
            let (fewest, most) = form.sign_changes();
            if most == 0 {
                continue;
            }
            if fewest == 1 && most == 1 {
                found.push(Isolation { cell, cluster: None, rising: form.ends_positive() });
                continue;
            }
            let all_unknown = (0..=form.degree).all(|k| form.sign(k).is_none());
            if cell.is_exhausted() || all_unknown {
                found.push(Isolation { cell, cluster: Some(most), rising: form.ends_positive() });
                continue;
            }
            // A split at a root would leave its sign unknown on both sides: move aside.
            let splits = [0.5, 0.4375, 0.5625, 0.375];
            let halves = |t: &f64| (*t, form.split(*t));
            let usable = splits.iter().map(halves).find(|(_, (_, right))| right.sign(0).is_some());
            let (t, (left, right)) = usable.unwrap_or_else(|| halves(&0.5));
            let (left_cell, right_cell) = cell.split(t);
            open.push((right, right_cell));
            open.push((left, left_cell));
        }
        found
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const SIZE: usize = 11;

    /// Π (u − root_k) as a form; each factor is −root v + (1 − root) u.
    fn with_roots(roots: &[f64]) -> Form<SIZE> {
        roots.iter().fold(Form { degree: 0, coefficients: one(), magnitude: one() }, |form, &root| {
            form.times(&Form::linear(-root, 1.0 - root))
        })
    }

    fn one() -> [f64; SIZE] {
        let mut c = [0.0; SIZE];
        c[0] = 1.0;
        c
    }

    #[test]
    fn a_double_root_near_one_comes_to_an_end() {
        for gap in [0.0, 1e-3, 0.03, 0.04, 0.06, 0.3] {
            for offset in [0.0, 1e-17, 1e-16] {
                let found = with_roots(&[1.0 - gap, 1.0 - gap - offset, 0.2, -0.3]).isolate_roots(64.0);
                assert!(found.len() <= 64, "{gap}: {}", found.len());
            }
        }
        // A cell of one bit of u near 1, where v has many more digits.
        let u = [1.0 - f64::EPSILON, 1.0 - f64::EPSILON / 2.0];
        let wide = Cell { u, v: [2e-16, 1e-16] };
        assert!(!wide.is_exhausted());
        assert!(Cell { v: [2e-16, 2e-16 * (1.0 - 4.0 * f64::EPSILON)], ..wide }.is_exhausted());
    }

    proptest! {
        #[test]
        fn planted_roots_are_isolated(
            mut roots in proptest::collection::vec(-0.5..1.5f64, 1..=8),
        ) {
            roots.sort_by(f64::total_cmp);
            prop_assume!(roots.windows(2).all(|pair| pair[1] - pair[0] > 1e-2));
            prop_assume!(roots.iter().all(|r| r.abs() > 1e-2 && (r - 1.0).abs() > 1e-2));
            let inside: Vec<f64> = roots.iter().copied().filter(|r| (0.0..1.0).contains(r)).collect();
            let mut found = with_roots(&roots).isolate_roots(64.0);
            found.sort_by(|a, b| a.cell.u[0].total_cmp(&b.cell.u[0]));
            prop_assert_eq!(found.len(), inside.len());
            for (isolation, root) in found.iter().zip(&inside) {
                prop_assert_eq!(isolation.cluster, None);
                prop_assert!(isolation.cell.u[0] <= *root && *root <= isolation.cell.u[1]);
            }
        }
    }

    #[test]
    fn a_double_root_is_a_cluster_not_a_guess() {
        let found = with_roots(&[0.3, 0.3, 0.8]).isolate_roots(64.0);
        assert_eq!(found.iter().filter(|i| i.cluster.is_none()).count(), 1);
        let clusters: Vec<_> = found.iter().filter(|i| i.cluster.is_some()).collect();
        assert!(!clusters.is_empty());
        assert!(clusters.iter().all(|i| i.cell.u[0] < 0.3 + 1e-6 && i.cell.u[1] > 0.3 - 1e-6));
    }

    #[test]
    fn roots_of_very_different_size_are_isolated() {
        let roots = [1e-14, 1e-9, 1e-4, 0.5];
        let found = with_roots(&roots).isolate_roots(64.0);
        assert_eq!(found.len(), 4);
        assert!(found.iter().zip(roots).all(|(i, root)| i.cell.u[0] <= root && root <= i.cell.u[1]));
    }
}
