//! Sets that hold a state: a middle, the image of the box of the start, and ellipsoids that hold what came on the way.
//!
//! A linear map takes such a set to such a set, whatever it does to angles, so that nothing is ever wrapped. Each step adds
//! a ball, one more ellipsoid; so that they do not become many, two that hold equally many steps are joined, as digits are
//! carried in a binary counter: n steps leave at most 1 + log₂ n ellipsoids, and no step is joined more often than that.
//!
//! **Lemma.** Let a > 0, b > 0, 1/a² + 1/b² ≤ 1, K = (aE, bG) an N × 2N matrix, Q a 2N × N matrix, L an N × N matrix. For
//! ‖u‖ ≤ 1, ‖v‖ ≤ 1 the vector Eu + Gv is Lw + z with ‖w‖ ≤ ‖Q‖ and ‖z‖ ≤ ‖K − LQᵀ‖.
//!
//! *Proof.* Eu + Gv = Ky with y = (u/a, v/b), ‖y‖² ≤ 1/a² + 1/b² ≤ 1, and Ky = L(Qᵀy) + (K − LQᵀ)y. ∎
//!
//! Q is an orthonormal basis of the rows of K and L = KQ, both rounded, so that ‖Q‖ is nearly 1 and z nearly 0: it joins
//! the next ball. With a² = 1 + ‖G‖/‖E‖, b² = 1 + ‖E‖/‖G‖ (Frobenius norms) the norm of L is the sum of those of E and G,
//! and no other choice makes it smaller: where all ellipsoids are long in the same direction, as the flow makes them, sizes
//! add as they do for intervals of one dimension.

use crate::bound::{frobenius, norm, up};
use crate::scalar::Scalar;

/// A square matrix, by rows.
pub type Matrix<const N: usize> = [[f64; N]; N];

/// Roundings of a sum of N products, N ≤ 9, of rounded entries.
pub(crate) const ROUNDINGS: f64 = 16.0 * f64::EPSILON;

/// What is left of a row of a matrix of norm about 1 and is rounding.
const DEPENDENT: f64 = 1e-14;

/// All E u with ‖u‖ ≤ 1.
#[derive(Clone, Debug)]
struct Ellipsoid<const N: usize> {
    matrix: Matrix<N>,
    /// The steps whose balls it holds.
    steps: u32,
}

/// All F e + Σ Eᵢuᵢ with |e_j| ≤ radius_j, ‖uᵢ‖ ≤ 1.
#[derive(Clone, Debug)]
pub struct Shape<const N: usize> {
    /// F: the derivative of the flow since the start, without what integrals have cut off.
    pub frame: Matrix<N>,
    /// Radii of the box of the start.
    pub radii: [f64; N],
    /// Longest held first.
    ellipsoids: Vec<Ellipsoid<N>>,
}

impl<const N: usize> Shape<N> {
    /// A box.
    #[must_use]
    pub fn new(radii: [f64; N]) -> Self {
        Self { frame: identity(), radii, ellipsoids: Vec::new() }
    }

    /// Bounds of |x_i|.
    #[must_use]
    pub fn component_radii(&self) -> [f64; N] {
        std::array::from_fn(|i| {
            let box_part = (0..N).map(|j| self.frame[i][j].abs() * self.radii[j]).sum::<f64>();
            up(box_part + self.ellipsoids.iter().map(|e| norm(&e.matrix[i])).sum::<f64>())
        })
    }

    /// A bound of |⟨c, x⟩|, where `bound` bounds |⟨c, v⟩| for a vector v.
    #[must_use]
    pub fn reach(&self, bound: impl Fn([f64; N]) -> f64) -> f64 {
        let columns = |matrix: &Matrix<N>| transposed(matrix).map(&bound);
        let along = columns(&self.frame);
        let box_part = (0..N).map(|j| along[j] * self.radii[j]).sum::<f64>();
        up(box_part + self.ellipsoids.iter().map(|e| norm(&columns(&e.matrix))).sum::<f64>())
    }

    /// The columns of F with its radii and of all Eᵢ, in units of a power of two near the largest, so that their squares exist.
    pub(crate) fn generators(&self) -> impl Iterator<Item = [f64; N]> {
        let unit = -libm::ilogb(norm(&self.component_radii()));
        let columns = move |matrix: &Matrix<N>, factors: [f64; N]| {
            let mut columns = transposed(matrix);
            for (column, factor) in columns.iter_mut().zip(factors) {
                *column = column.map(|x| libm::ldexp(x * factor, unit));
            }
            columns
        };
        let first = columns(&self.frame, self.radii);
        first.into_iter().chain(self.ellipsoids.iter().flat_map(move |e| columns(&e.matrix, [1.0; N])))
    }

    /// The image under M, and a bound of how far its points are from where they should be, by rounding.
    #[must_use]
    pub fn image(&self, map: &Matrix<N>) -> (Self, f64) {
        let mut sizes = frobenius(&self.frame) * norm(&self.radii);
        let ellipsoids = self.ellipsoids.iter().map(|e| {
            sizes += frobenius(&e.matrix);
            Ellipsoid { matrix: product(map, &e.matrix), steps: e.steps }
        });
        let ellipsoids = ellipsoids.collect();
        let shape = Self { frame: product(map, &self.frame), radii: self.radii, ellipsoids };
        (shape, up(ROUNDINGS * frobenius(map) * sizes))
    }

    /// The sum with a ball, after ellipsoids that hold equally many steps were joined.
    #[must_use]
    pub fn widened(mut self, mut ball: f64) -> Self {
        while let [.., a, b] = &self.ellipsoids[..]
            && a.steps == b.steps
        {
            let (matrix, beside) = joined(&a.matrix, &b.matrix);
            let steps = a.steps + b.steps;
            ball = up(ball + beside);
            self.ellipsoids.truncate(self.ellipsoids.len() - 2);
            self.ellipsoids.push(Ellipsoid { matrix, steps });
        }
        self.ellipsoids.push(Ellipsoid { matrix: identity().map(|row| row.map(|x| ball * x)), steps: 1 });
        self
    }
}

/// All x = middle + y, y of a shape.
#[derive(Clone, Debug)]
pub struct FlowSet<S, const N: usize> {
    /// The middle, a point.
    pub middle: [S; N],
    /// What is about it.
    pub shape: Shape<N>,
}

impl<S: Scalar, const N: usize> FlowSet<S, N> {
    /// A box.
    #[must_use]
    pub fn new(middle: [S; N], radii: [f64; N]) -> Self {
        Self { middle, shape: Shape::new(radii) }
    }

    /// A bound of ‖x − middle‖.
    #[must_use]
    pub fn size(&self) -> f64 {
        norm(&self.component_radii())
    }

    /// Bounds of |x_i − middle_i|.
    #[must_use]
    pub fn component_radii(&self) -> [f64; N] {
        self.shape.component_radii()
    }

    /// The set that holds M(x − old middle) + v + `middle` for all x of this set and ‖v‖ ≤ `ball`; `None` when a number left
    /// the range of doubles.
    #[must_use]
    pub fn mapped(&self, map: &Matrix<N>, ball: f64, middle: [S; N]) -> Option<Self> {
        let (shape, rounding) = self.shape.image(map);
        let shape = shape.widened(up(ball + rounding));
        shape.component_radii().iter().all(|radius| radius.is_finite()).then_some(Self { middle, shape })
    }
}

/// L and a bound of ‖z‖ as in the lemma above, L already stretched by ‖Q‖.
fn joined<const N: usize>(first: &Matrix<N>, second: &Matrix<N>) -> (Matrix<N>, f64) {
    let sizes = [frobenius(first), frobenius(second)];
    let [a, b] = [1.0 + sizes[1] / sizes[0], 1.0 + sizes[0] / sizes[1]].map(f64::sqrt);
    // A power of two: nothing vanishes, and scaling is exact.
    let unit = libm::ldexp(1.0, libm::ilogb(a * sizes[0] + b * sizes[1]));
    let scaled = |matrix: &Matrix<N>, factor: f64| matrix.map(|row| row.map(|x| factor * (x / unit)));
    let (left, right) = (scaled(first, a), scaled(second, b));
    let dot = |u: [&[f64; N]; 2], v: [&[f64; N]; 2]| (0..N).map(|m| u[0][m] * v[0][m] + u[1][m] * v[1][m]).sum::<f64>();
    // Gram and Schmidt, twice. A row that depends on those before it is left out.
    let (mut q, mut p) = ([[0.0; N]; N], [[0.0; N]; N]);
    for i in 0..N {
        let (mut u, mut v) = (left[i], right[i]);
        for _ in 0..2 {
            for j in 0..i {
                let along = dot([&u, &v], [&q[j], &p[j]]);
                for m in 0..N {
                    u[m] -= along * q[j][m];
                    v[m] -= along * p[j][m];
                }
            }
            let length = dot([&u, &v], [&u, &v]).sqrt();
            let factor = if length > DEPENDENT { 1.0 / length } else { 0.0 };
            (u, v) = (u.map(|x| factor * x), v.map(|x| factor * x));
        }
        (q[i], p[i]) = (u, v);
    }
    let basis = |j: usize| [&q[j], &p[j]];
    let matrix: Matrix<N> = std::array::from_fn(|i| std::array::from_fn(|j| dot([&left[i], &right[i]], basis(j))));
    let (mut beside, mut gram) = (0.0, 0.0);
    for i in 0..N {
        let (mut u, mut v) = (left[i], right[i]);
        for j in 0..N {
            for m in 0..N {
                u[m] -= matrix[i][j] * q[j][m];
                v[m] -= matrix[i][j] * p[j][m];
            }
            // The square of a length is 0 or nearly 1.
            let inner = dot(basis(i), basis(j));
            let inner = if i == j && inner > 0.5 { inner - 1.0 } else { inner };
            gram += inner * inner;
        }
        beside += dot([&u, &v], [&u, &v]);
    }
    // ‖Q‖² = ‖QᵀQ‖ ≤ 1 + ‖QᵀQ − D‖ for a diagonal matrix D of zeros and ones; entries are below 2.
    let stretch = up(1.0 + 0.5 * (gram.sqrt() + 4.0 * N as f64 * ROUNDINGS));
    let size = frobenius(&matrix) + frobenius(&left) + frobenius(&right);
    let matrix = matrix.map(|row| row.map(|x| stretch * unit * x));
    (matrix, up(unit * (beside.sqrt() + 4.0 * N as f64 * ROUNDINGS * size)))
}

/// 1.
#[must_use]
pub fn identity<const N: usize>() -> Matrix<N> {
    let mut matrix = [[0.0; N]; N];
    for (i, row) in matrix.iter_mut().enumerate() {
        row[i] = 1.0;
    }
    matrix
}

/// M P, rounded.
#[must_use]
pub fn product<const N: usize>(left: &Matrix<N>, right: &Matrix<N>) -> Matrix<N> {
    let mut result = [[0.0; N]; N];
    for i in 0..N {
        for (j, row) in right.iter().enumerate() {
            for m in 0..N {
                result[i][m] += left[i][j] * row[m];
            }
        }
    }
    result
}

fn transposed<const N: usize>(matrix: &Matrix<N>) -> Matrix<N> {
    std::array::from_fn(|i| std::array::from_fn(|j| matrix[j][i]))
}

/// The inverse, rounded, by Gauss and Jordan with pivots.
pub(crate) fn inverse<const N: usize>(matrix: &Matrix<N>) -> Option<Matrix<N>> {
    let (mut left, mut right) = (*matrix, identity());
    for k in 0..N {
        let pivot = (k..N).max_by(|i, j| left[*i][k].abs().total_cmp(&left[*j][k].abs()))?;
        left.swap(k, pivot);
        right.swap(k, pivot);
        let factor = 1.0 / left[k][k];
        left[k] = left[k].map(|x| factor * x);
        right[k] = right[k].map(|x| factor * x);
        for i in (0..N).filter(|i| *i != k) {
            let factor = left[i][k];
            for m in 0..N {
                left[i][m] -= factor * left[k][m];
                right[i][m] -= factor * right[k][m];
            }
        }
    }
    right.as_flattened().iter().all(|x| x.is_finite()).then_some(right)
}

#[cfg(test)]
mod tests {
    use super::*;
    use support::random::SplitMix64;

    type Ellipse = Matrix<5>;

    /// The largest ⟨c, x⟩ over an ellipsoid.
    fn support(matrix: &Ellipse, c: &[f64; 5]) -> f64 {
        let along: [f64; 5] = std::array::from_fn(|j| (0..5).map(|i| c[i] * matrix[i][j]).sum());
        along.iter().map(|x| x * x).sum::<f64>().sqrt()
    }

    /// In no direction does the sum of two ellipsoids reach further than what joins them, though one may be flat, or tiny.
    #[test]
    fn what_joins_two_ellipsoids_holds_their_sum() {
        let mut random = SplitMix64::new(5);
        for round in 0..400 {
            let scale = [1.0, 1e-8, 1e-120, 1e-30][round % 4];
            let mut matrix = |columns: usize, size: f64| -> Ellipse {
                std::array::from_fn(|_| {
                    std::array::from_fn(|j| if j < columns { size * random.between(-1.0, 1.0) } else { 0.0 })
                })
            };
            let first = matrix(1 + round % 5, scale);
            let second = matrix(1 + round / 7 % 5, scale * [1.0, 1e-6, 1e-17][round % 3]);
            let (held, beside) = joined(&first, &second);
            let sizes = frobenius(&first) + frobenius(&second);
            assert!(frobenius(&held) <= sizes * (1.0 + 1e-9) && beside <= 1e-11 * sizes, "{round}");
            for _ in 0..50 {
                let c: [f64; 5] = std::array::from_fn(|_| random.between(-1.0, 1.0));
                let length = c.iter().map(|x| x * x).sum::<f64>().sqrt();
                let (sum, bound) = (support(&first, &c) + support(&second, &c), support(&held, &c) + length * beside);
                assert!(sum <= bound * (1.0 + 1e-14), "{round}: {sum} {bound}");
            }
        }
    }

    /// Steps are carried as in a binary counter, and a ball that is only mapped by 1 grows as intervals do.
    #[test]
    fn steps_leave_few_ellipsoids() {
        let mut shape = Shape::<5>::new([0.0; 5]);
        for step in 1..=1000_u32 {
            shape = shape.image(&identity()).0.widened(1e-9);
            assert_eq!(shape.ellipsoids.iter().map(|e| e.steps).sum::<u32>(), step);
            assert!(shape.ellipsoids.len() <= 1 + step.ilog2() as usize + 1);
        }
        let radius = shape.component_radii()[0];
        assert!((1e-6..1.01e-6).contains(&radius), "{radius}");
    }
}
