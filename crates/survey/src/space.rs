//! The space of bodies up to units, and the order and the signs of their axes.
//!
//! Its points have four parameters: A1 ≤ A2 ≤ A3 with the sum 2, and r̂ with r_i ≥ 0. The second moments of mass are
//! m_i = 1 − A_i with the sum 1, so physical bodies are those with m_i ≥ 0. The metric is |dA|² + |dr̂|². A [`BodyLine`] is
//! straight in A and a great circle in r̂; a [`TangentBasis`] spans the directions in which a body can be changed while what
//! is special about it stays.

use bifdiag_body::Body;
use bifdiag_numbers::vector::{dot, norm};
use rand_xoshiro::SplitMix64;
use rand_xoshiro::rand_core::RngCore;

/// The bodies that are considered.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum BodySet {
    /// Bodies that exist: A_i + A_j > A_k, or equality and r_k = 0.
    Physical,
    /// All A > 0.
    All,
}

/// A body with A1 ≤ A2 ≤ A3, A1 + A2 + A3 = 2, r_i ≥ 0 and |r| = 1, or r = 0.
///
/// Where two moments are equal, r is turned in the plane of their axes until the component of the first of them is 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ReducedBody {
    /// A1, A2, A3.
    pub a: [f64; 3],
    /// r1, r2, r3.
    pub r: [f64; 3],
}

impl ReducedBody {
    /// The reduced body of A and r. Equal moments stay equal, and a component of r that is 0 stays 0.
    #[must_use]
    pub fn of([a, r]: [[f64; 3]; 2]) -> Self {
        let mut order = [0, 1, 2];
        order.sort_by(|&i, &j| a[i].total_cmp(&a[j]));
        let (mut a, mut r) = (order.map(|k| a[k]), order.map(|k| r[k].abs()));
        let sum = a[0] + a[1] + a[2];
        a = a.map(|x| 2.0 * x / sum);
        for (i, j) in [(0, 1), (1, 2)] {
            if a[i] == a[j] {
                r[j] = libm::hypot(r[i], r[j]);
                r[i] = 0.0;
            }
        }
        let norm = norm(r);
        if norm > 0.0 {
            r = r.map(|x| x / norm);
        }
        Self { a, r }
    }

    /// The reduced form of a body.
    #[must_use]
    pub fn of_body(body: &Body) -> Self {
        Self::of([body.moments_f64(), body.center_f64()])
    }

    /// A and r.
    #[must_use]
    pub fn values(&self) -> [[f64; 3]; 2] {
        [self.a, self.r]
    }

    /// True when the body belongs to a set.
    #[must_use]
    pub fn is_in(&self, set: BodySet) -> bool {
        let excess = self.a[0] + self.a[1] - self.a[2];
        self.a[0] > 0.0 && (set == BodySet::All || excess > 0.0 || (excess == 0.0 && self.r[2] == 0.0))
    }
}

/// A(s) = A + s a, r(s) = r + s d with d ⊥ r, so that r̂ runs on a great circle; |a|² + |d|² = 1.
#[derive(Clone, Debug, PartialEq)]
pub struct BodyLine {
    from: ReducedBody,
    change: [[f64; 3]; 2],
    reach: [f64; 2],
}

impl BodyLine {
    /// The line through a body in a direction; `None` where nothing changes.
    fn new(from: ReducedBody, change: [[f64; 3]; 2], set: BodySet) -> Option<Self> {
        let length = libm::hypot(norm(change[0]), norm(change[1]));
        if !(length.is_finite() && length > 0.0) {
            return None;
        }
        let change = change.map(|part| part.map(|x| x / length));
        let mut line = Self { from, change, reach: [0.0; 2] };
        line.reach = [line.end(-1.0, set), line.end(1.0, set)];
        Some(line)
    }

    /// How far the line runs back and forth, up to where it leaves the bodies with A1 ≤ A2 ≤ A3 and r_i ≥ 0 or the set.
    #[must_use]
    pub fn reach(&self) -> [f64; 2] {
        self.reach
    }

    fn end(&self, sign: f64, set: BodySet) -> f64 {
        let ([a, r], [da, dr]) = (self.from.values(), self.change);
        // Each of these stays ≥ 0; what is 0 and stays so is special about the whole line.
        let last = match set {
            BodySet::Physical => [a[0] + a[1] - a[2], da[0] + da[1] - da[2]],
            BodySet::All => [a[0], da[0]],
        };
        let bounds = [
            last,
            [a[1] - a[0], da[1] - da[0]],
            [a[2] - a[1], da[2] - da[1]],
            [r[0], dr[0]],
            [r[1], dr[1]],
            [r[2], dr[2]],
        ];
        let ends = bounds.into_iter().map(|[value, slope]| {
            let slope = sign * slope;
            // The special ones are special in every bit.
            if slope < 0.0 && (value > 0.0 || slope < -1e-12) { value.max(0.0) / -slope } else { f64::INFINITY }
        });
        ends.fold(f64::INFINITY, f64::min)
    }

    /// A and r at s; |r| is not 1.
    #[must_use]
    pub fn at(&self, s: f64) -> [[f64; 3]; 2] {
        let from = self.from.values();
        std::array::from_fn(|part| std::array::from_fn(|k| from[part][k] + s * self.change[part][k]))
    }

    /// How far the body at s is from that at 0: √(|ΔA|² + ∠²), with the angle ∠ between the two r.
    #[must_use]
    pub fn distance(&self, s: f64) -> f64 {
        let [da, dr] = self.change;
        libm::hypot(s * norm(da), libm::atan(s * norm(dr)))
    }

    /// Values of s on one side of 0, growing in size, as dense at both ends as in logarithms: those of the logistic
    /// function at even steps, which `shift` in [0, 1) moves.
    #[must_use]
    pub fn nodes(&self, forth: bool, shift: f64) -> Vec<f64> {
        const COUNT: usize = 30;
        /// e^−13 = 2e-6 of the side is left out at both ends.
        const END: f64 = 13.0;
        let side = if forth { self.reach[1] } else { -self.reach[0] };
        if side == 0.0 || !side.is_finite() {
            return Vec::new();
        }
        let step = 2.0 * END / COUNT as f64;
        (0..COUNT).map(|k| side / (1.0 + libm::exp(END - step * (k as f64 + shift)))).collect()
    }
}

/// An orthonormal basis of the directions at a body: A keeps its sum and its equal moments, r its length and its zeros.
#[derive(Clone, Debug, PartialEq)]
pub struct TangentBasis {
    body: ReducedBody,
    basis: Vec<[[f64; 3]; 2]>,
}

impl TangentBasis {
    /// The basis at a body.
    #[must_use]
    pub fn new(body: ReducedBody) -> Self {
        let mut basis: Vec<[[f64; 3]; 2]> = Vec::with_capacity(4);
        let ReducedBody { a, r } = body;
        // Each gap between moments that is open may change, and so may each component of r but the largest.
        let mut candidates: Vec<[[f64; 3]; 2]> = Vec::with_capacity(4);
        for change in [[-2.0, 1.0, 1.0], [-1.0, -1.0, 2.0]] {
            let keeps = |i: usize, j: usize| a[i] != a[j] || change[i] == change[j];
            if keeps(0, 1) && keeps(1, 2) {
                candidates.push([change, [0.0; 3]]);
            }
        }
        let largest = (0..3).max_by(|&i, &j| r[i].total_cmp(&r[j])).unwrap_or_default();
        for k in (0..3).filter(|&k| k != largest && r[k] > 0.0) {
            let unit: [f64; 3] = std::array::from_fn(|i| f64::from(u8::from(i == k)));
            candidates.push([[0.0; 3], std::array::from_fn(|i| unit[i] - r[k] * r[i])]);
        }
        for mut candidate in candidates {
            for known in &basis {
                let share = product(&candidate, known);
                candidate = combined(&candidate, -share, known);
            }
            let length = product(&candidate, &candidate).sqrt();
            basis.push(candidate.map(|part| part.map(|x| x / length)));
        }
        Self { body, basis }
    }

    /// Number of parameters.
    #[must_use]
    pub fn dimensions(&self) -> usize {
        self.basis.len()
    }

    /// The line with these coordinates of its direction; `None` where nothing can change.
    #[must_use]
    pub fn line(&self, coordinates: &[f64], set: BodySet) -> Option<BodyLine> {
        let zero = [[0.0; 3]; 2];
        let change = self.basis.iter().zip(coordinates).fold(zero, |sum, (basis, x)| combined(&sum, *x, basis));
        BodyLine::new(self.body, change, set)
    }

    /// A and r at these coordinates; |r| is not 1.
    #[must_use]
    pub fn at(&self, coordinates: &[f64]) -> [[f64; 3]; 2] {
        let values = self.body.values();
        self.basis.iter().zip(coordinates).fold(values, |sum, (basis, x)| combined(&sum, *x, basis))
    }

    /// A change of coordinates at a place for differences: small against its distances to special bodies.
    #[must_use]
    pub fn step(&self, coordinates: &[f64]) -> Option<f64> {
        const LONGEST: f64 = 1e-6;
        const SHARE: f64 = 1e-3;
        let [a, r] = self.at(coordinates);
        let distances = [a[0], a[1] - a[0], a[2] - a[1], r[0], r[1], r[2]];
        let is_open = |k: usize| {
            let [own, center] = self.body.values();
            [own[0], own[1] - own[0], own[2] - own[1], center[0], center[1], center[2]][k] > 0.0
        };
        let open = (0..6).filter(|&k| is_open(k)).map(|k| distances[k]);
        let nearest = open.fold(f64::INFINITY, f64::min);
        (nearest > 0.0).then(|| LONGEST.min(SHARE * nearest))
    }

    /// The coordinates of a change, projected on these directions.
    #[must_use]
    pub fn coordinates(&self, change: &[[f64; 3]; 2]) -> Vec<f64> {
        self.basis.iter().map(|basis| product(change, basis)).collect()
    }

    /// A random direction: half of them uniform, half stretched along the distances to special bodies, so that cells as
    /// thin as their distance from those are crossed as often as others.
    pub fn random(&self, rng: &mut SplitMix64) -> Vec<f64> {
        let uniform = in_ball(rng, self.dimensions());
        if rng.next_u64() & 1 == 0 {
            return uniform;
        }
        let ReducedBody { a, r } = self.body;
        let g: [f64; 5] = std::array::from_fn(|_| 2.0 * unit(rng) - 1.0);
        // Gaps d1 = A2 − A1, d2 = A3 − A2 and components of r change by shares of themselves.
        let (d1, d2) = (g[0] * (a[1] - a[0]), g[1] * (a[2] - a[1]));
        let first = -(2.0 * d1 + d2) / 3.0;
        let change = [[first, first + d1, first + d1 + d2], std::array::from_fn(|k| g[2 + k] * r[k])];
        self.coordinates(&change)
    }
}

/// A vector of length 1; `None` for none.
pub(crate) fn unit_vector(v: Vec<f64>) -> Option<Vec<f64>> {
    let length = v.iter().map(|x| x * x).sum::<f64>().sqrt();
    (length > 0.0 && length.is_finite()).then(|| v.into_iter().map(|x| x / length).collect())
}

/// A number in [0, 1).
pub(crate) fn unit(rng: &mut SplitMix64) -> f64 {
    (rng.next_u64() >> 11) as f64 / (1_u64 << 53) as f64
}

/// A uniform point of the ball.
pub(crate) fn in_ball(rng: &mut SplitMix64, dimensions: usize) -> Vec<f64> {
    loop {
        let point: Vec<f64> = (0..dimensions).map(|_| 2.0 * unit(rng) - 1.0).collect();
        let square: f64 = point.iter().map(|x| x * x).sum();
        if dimensions == 0 || (1e-6..=1.0).contains(&square) {
            return point;
        }
    }
}

fn product(p: &[[f64; 3]; 2], q: &[[f64; 3]; 2]) -> f64 {
    dot(p[0], q[0]) + dot(p[1], q[1])
}

fn combined(p: &[[f64; 3]; 2], factor: f64, q: &[[f64; 3]; 2]) -> [[f64; 3]; 2] {
    std::array::from_fn(|part| std::array::from_fn(|k| p[part][k] + factor * q[part][k]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_order_and_signs_do_not_matter() {
        let body = ReducedBody::of([[4.0, 1.0, 3.0], [0.0, -2.0, 1.0]]);
        assert_eq!(body.a, [0.25, 0.75, 1.0]);
        assert_eq!(body, ReducedBody::of([[0.5, 1.5, 2.0], [4.0, 2.0, 0.0]]));
        assert!(body.is_in(BodySet::Physical) && body.r[2] == 0.0);
        // A disc: equal moments, r turned.
        let top = ReducedBody::of([[1.0, 1.0, 2.0], [3.0, 4.0, 0.0]]);
        assert_eq!(top.values(), [[0.5, 0.5, 1.0], [0.0, 1.0, 0.0]]);
        assert!(!ReducedBody::of([[1.0, 1.0, 2.0], [3.0, 4.0, 1.0]]).is_in(BodySet::Physical));
        assert!(!ReducedBody::of([[1.0, 1.0, 3.0], [1.0, 1.0, 1.0]]).is_in(BodySet::Physical));
    }

    #[test]
    fn a_line_ends_where_a_body_ceases_to_exist_or_is_special() {
        let body = ReducedBody::of([[0.5, 0.6, 0.9], [0.6, 0.0, 0.8]]);
        let line = |change, set| BodyLine::new(body, change, set).unwrap();
        let flatter = [[-0.5, -0.5, 1.0], [0.0; 3]];
        let unit = 1.5_f64.sqrt();
        // A3 − A2 shrinks to 0 on the one side; A1 + A2 − A3 = 0.2 (or A1 = 0.5) on the other.
        let close = |found: [f64; 2], wanted: [f64; 2]| (0..2).all(|k| (found[k] - wanted[k]).abs() < 1e-12);
        assert!(close(line(flatter, BodySet::Physical).reach(), [0.2 * unit, 0.1 * unit]));
        assert!(close(line(flatter, BodySet::All).reach(), [0.2 * unit, unit]));
        // r turns by a quarter at most.
        let turned = line([[0.0; 3], [-0.8, 0.0, 0.6]], BodySet::All);
        assert!((turned.distance(turned.reach()[1]) - libm::atan(0.75)).abs() < 1e-12);
        assert!((turned.reach()[0] - 4.0 / 3.0).abs() < 1e-12);
        assert!(turned.nodes(true, 0.5).iter().all(|s| *s > 0.0 && *s < turned.reach()[1]));
        let basis = TangentBasis::new(body);
        let whole = basis.line(&[0.1, 0.2, 0.3], BodySet::Physical).unwrap();
        assert!(whole.at(0.5 * whole.reach()[0]).iter().flatten().all(|x| *x >= 0.0));
        assert_eq!(whole.at(0.01)[1][1], 0.0);
    }

    #[test]
    fn generic_bodies_have_four_parameters_and_special_ones_fewer() {
        let dimensions = |a, r| TangentBasis::new(ReducedBody::of([a, r])).dimensions();
        assert_eq!(dimensions([0.5, 0.6, 0.9], [0.6, 0.1, 0.8]), 4);
        assert_eq!(dimensions([0.5, 0.6, 0.9], [0.6, 0.0, 0.8]), 3);
        assert_eq!(dimensions([0.5, 0.6, 0.9], [0.0, 0.0, 1.0]), 2);
        assert_eq!(dimensions([0.5, 0.5, 0.9], [0.3, 0.4, 0.5]), 2);
        assert_eq!(dimensions([0.5, 0.5, 0.9], [0.0, 0.0, 1.0]), 1);
        assert_eq!(dimensions([1.0, 1.0, 1.0], [0.0, 0.0, 1.0]), 0);
    }

    #[test]
    fn the_basis_is_orthonormal_near_an_axis_too() {
        let basis = TangentBasis::new(ReducedBody::of([[0.5, 0.6, 0.9], [1e-9, 1e-5, 1.0]]));
        for (i, p) in basis.basis.iter().enumerate() {
            for (j, q) in basis.basis.iter().enumerate() {
                assert!((product(p, q) - f64::from(u8::from(i == j))).abs() < 1e-12, "{i} {j}");
            }
        }
    }
}
