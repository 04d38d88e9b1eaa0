//! Sets that hold a state: a middle, and a parallelepiped about it in a frame that follows the flow (Lohner's representation).

use crate::bound::{frobenius, norm, up};
use crate::scalar::Scalar;

/// A square matrix, by rows.
pub type Matrix<const N: usize> = [[f64; N]; N];

/// Roundings of a sum of N products, N ≤ 9, of rounded entries.
pub(crate) const ROUNDINGS: f64 = 16.0 * f64::EPSILON;

/// A frame whose inverse is larger than this is made orthogonal.
const STRETCH: f64 = 50.0;

/// All x = middle + F e with |e_j| ≤ radius_j, F the frame, whose columns have length 1 within rounding.
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

    /// The set that holds M(x − old middle) + v + `middle` for all x of this set and ‖v‖ ≤ `ball`. The frame follows M as it is,
    /// so that nothing is wrapped, until its columns become too parallel; then it is made orthogonal by QR, the widest columns
    /// first (Lohner). `None` when the frame degenerates.
    #[must_use]
    pub fn mapped(&self, map: &Matrix<N>, ball: f64, middle: [S; N]) -> Option<Self> {
        let image = product(map, &self.frame);
        let (frame, inverse) = followed(&image).or_else(|| {
            let frame = orthonormal(&image, &self.radii)?;
            Some((frame, transposed(&frame)))
        })?;
        // F⁻¹ = (1 − D)⁻¹ G with D = 1 − GF, so that |F⁻¹w − Gw| ≤ ‖D‖/(1 − ‖D‖) ‖G‖ ‖w‖.
        let defect = inverse_defect(&inverse, &frame);
        if defect > 1e-6 {
            return None;
        }
        let inward = product(&inverse, &image);
        let (widest, size) = (norm(&self.radii), frobenius(&inverse));
        // Of the image, and of what G makes of it.
        let rounding = up(2.0 * ROUNDINGS * frobenius(map) * frobenius(&self.frame) * size * widest);
        let beside = up(defect / (1.0 - defect) * (size * frobenius(&image) * widest + rounding)
            + size / (1.0 - defect) * ball
            + rounding);
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

/// An upper bound of ‖1 − GF‖.
fn inverse_defect<const N: usize>(inverse: &Matrix<N>, frame: &Matrix<N>) -> f64 {
    let product = product(inverse, frame);
    let defect: Matrix<N> =
        std::array::from_fn(|i| std::array::from_fn(|j| product[i][j] - f64::from(u8::from(i == j))));
    up(frobenius(&defect) + ROUNDINGS * N as f64 * frobenius(inverse) * frobenius(frame))
}

/// A bound of ‖M⁻¹‖, infinite where there is none: M⁻¹ = (1 − D)⁻¹G with D = 1 − GM.
pub(crate) fn inverse_bound<const N: usize>(matrix: &Matrix<N>) -> f64 {
    let Some(inverse) = inverse(matrix) else { return f64::INFINITY };
    let defect = inverse_defect(&inverse, matrix);
    if defect < 0.5 { up(frobenius(&inverse) / (1.0 - defect)) } else { f64::INFINITY }
}

/// The columns of M brought to length 1, and the inverse of that; `None` where it is larger than [`STRETCH`].
fn followed<const N: usize>(matrix: &Matrix<N>) -> Option<(Matrix<N>, Matrix<N>)> {
    let columns = transposed(matrix).map(|column| {
        let length = column.iter().map(|x| x * x).sum::<f64>().sqrt();
        column.map(|x| x / length)
    });
    let frame = transposed(&columns);
    let inverse = inverse(&frame)?;
    (frobenius(&inverse) <= STRETCH).then_some((frame, inverse))
}

/// The inverse, rounded, by Gauss and Jordan with pivots.
fn inverse<const N: usize>(matrix: &Matrix<N>) -> Option<Matrix<N>> {
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
