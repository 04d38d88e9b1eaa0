//! Sets that hold a state: a middle, and a parallelepiped about it in an orthogonal frame (Lohner's representation).

use crate::bound::{frobenius, norm, up};
use crate::scalar::Scalar;

/// A square matrix, by rows.
pub type Matrix<const N: usize> = [[f64; N]; N];

/// Roundings of a sum of N products, N ≤ 9, of rounded entries.
const ROUNDINGS: f64 = 16.0 * f64::EPSILON;

/// All x = middle + F e with |e_j| ≤ radius_j, F the frame, whose columns are orthonormal within rounding.
#[derive(Clone, Debug)]
pub struct FramedSet<S, const N: usize> {
    /// The middle, a point.
    pub middle: [S; N],
    /// The frame.
    pub frame: Matrix<N>,
    /// Radii along its columns.
    pub radii: [f64; N],
}

impl<S: Scalar, const N: usize> FramedSet<S, N> {
    /// A box.
    #[must_use]
    pub fn new(middle: [S; N], radii: [f64; N]) -> Self {
        Self { middle, frame: identity(), radii }
    }

    /// A bound of ‖x − middle‖.
    #[must_use]
    pub fn size(&self) -> f64 {
        norm(&self.component_radii())
    }

    /// Bounds of |x_i − middle_i|.
    #[must_use]
    pub fn component_radii(&self) -> [f64; N] {
        image_radii(&self.frame, &self.radii)
    }

    /// The set that holds M(x − old middle) + v + `middle` for all x of this set and ‖v‖ ≤ `ball`: the frame follows M by
    /// QR, its widest columns first. `None` when the frame degenerates.
    #[must_use]
    pub fn mapped(&self, map: &Matrix<N>, ball: f64, middle: [S; N]) -> Option<Self> {
        let image = product(map, &self.frame);
        let frame = orthonormal(&image, &self.radii)?;
        let inverse_defect = orthogonality_defect(&frame);
        if inverse_defect > 1e-6 {
            return None;
        }
        // F⁻¹ = (1 − D)⁻¹ Fᵀ with D = 1 − FᵀF, so that |F⁻¹w − Fᵀw| ≤ ‖D‖/(1 − ‖D‖) ‖Fᵀ‖ ‖w‖.
        let inward = product(&transposed(&frame), &image);
        let rounding = up(ROUNDINGS * frobenius(map) * frobenius(&self.frame) * frobenius(&frame));
        let widest = norm(&self.radii);
        let length = up(frobenius(&image) * widest + ball + rounding * widest);
        let beside = up(inverse_defect / (1.0 - inverse_defect) * frobenius(&frame) * length
            + up(1.0 + 2.0 * inverse_defect) * ball
            + rounding * widest);
        let radii =
            std::array::from_fn(|i| up((0..N).map(|j| inward[i][j].abs() * self.radii[j]).sum::<f64>() + beside));
        Some(Self { middle, frame, radii })
    }
}

/// Bounds of |(M e)_i| for |e_j| ≤ radius_j.
#[must_use]
pub fn image_radii<const N: usize>(matrix: &Matrix<N>, radii: &[f64; N]) -> [f64; N] {
    std::array::from_fn(|i| up((0..N).map(|j| matrix[i][j].abs() * radii[j]).sum::<f64>()))
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

/// An upper bound of ‖1 − FᵀF‖.
fn orthogonality_defect<const N: usize>(frame: &Matrix<N>) -> f64 {
    let square = product(&transposed(frame), frame);
    let defect: Matrix<N> =
        std::array::from_fn(|i| std::array::from_fn(|j| square[i][j] - f64::from(u8::from(i == j))));
    up(frobenius(&defect) + ROUNDINGS * N as f64 * frobenius(frame) * frobenius(frame))
}

/// The columns of M, those first that are longest when weighted by the radii, made orthonormal by Gram and Schmidt, twice.
fn orthonormal<const N: usize>(matrix: &Matrix<N>, radii: &[f64; N]) -> Option<Matrix<N>> {
    let columns = transposed(matrix);
    let mut order: [usize; N] = std::array::from_fn(|j| j);
    let weight = |j: usize| columns[j].iter().map(|x| x * x).sum::<f64>().sqrt() * radii[j];
    order.sort_by(|i, j| weight(*j).total_cmp(&weight(*i)));
    let mut found: Vec<[f64; N]> = Vec::with_capacity(N);
    for j in order {
        let mut v = columns[j];
        for _ in 0..2 {
            let length = v.iter().map(|x| x * x).sum::<f64>().sqrt();
            v = v.map(|x| x / length);
            for u in &found {
                let along = (0..N).map(|i| u[i] * v[i]).sum::<f64>();
                for i in 0..N {
                    v[i] -= along * u[i];
                }
            }
        }
        let length = v.iter().map(|x| x * x).sum::<f64>().sqrt();
        found.push(v.map(|x| x / length));
    }
    let frame = transposed(&std::array::from_fn(|j| found[j]));
    frame.as_flattened().iter().all(|x| x.is_finite()).then_some(frame)
}
