//! The plane in which a cloud of crossings is widest.

use crate::section::orbit::SectionPoint;

pub(super) type Vector6 = [f64; 6];

/// Rounds of Jacobi's method; the convergence is quadratic after the first few.
const ROUNDS: usize = 12;

/// The crossings' (γ, l/|l|_max) about their mean.
pub(super) fn centred(points: &[&SectionPoint]) -> Vec<Vector6> {
    let largest = points.iter().flat_map(|point| point.l).fold(f64::MIN_POSITIVE, |m, x| m.max(x.abs()));
    let mut cloud: Vec<Vector6> = points
        .iter()
        .map(|point| {
            let ([a, b, c], [d, e, f]) = (point.gamma, point.l.map(|x| x / largest));
            [a, b, c, d, e, f]
        })
        .collect();
    let count = cloud.len() as f64;
    for axis in 0..6 {
        let mean = cloud.iter().map(|x| x[axis]).sum::<f64>() / count;
        for x in &mut cloud {
            x[axis] -= mean;
        }
    }
    cloud
}

/// The coordinates of a centred cloud along its two largest principal axes.
pub(super) fn principal_coordinates(cloud: &[Vector6]) -> Vec<[f64; 2]> {
    let mut covariance = [[0.0; 6]; 6];
    for x in cloud {
        for i in 0..6 {
            for j in 0..6 {
                covariance[i][j] += x[i] * x[j];
            }
        }
    }
    let axes = principal_axes(covariance);
    let along = |x: &Vector6, axis: &Vector6| x.iter().zip(axis).map(|(a, b)| a * b).sum();
    cloud.iter().map(|x| [along(x, &axes[0]), along(x, &axes[1])]).collect()
}

/// Eigenvectors of a symmetric matrix, those of the largest eigenvalues first, by Jacobi's rotations.
fn principal_axes(mut a: [Vector6; 6]) -> [Vector6; 6] {
    // Rows are the vectors.
    let mut axes = [[0.0; 6]; 6];
    for i in 0..6 {
        axes[i][i] = 1.0;
    }
    for _ in 0..ROUNDS {
        for p in 0..6 {
            for q in p + 1..6 {
                if a[p][q] != 0.0 {
                    let (cos, sin) = jacobi_rotation(a[p][p], a[p][q], a[q][q]);
                    for row in &mut a {
                        (row[p], row[q]) = (cos * row[p] - sin * row[q], sin * row[p] + cos * row[q]);
                    }
                    rotate_rows(&mut a, p, q, cos, sin);
                    rotate_rows(&mut axes, p, q, cos, sin);
                }
            }
        }
    }
    let mut order = [0, 1, 2, 3, 4, 5];
    order.sort_by(|&i: &usize, &j: &usize| a[j][j].total_cmp(&a[i][i]));
    order.map(|i| axes[i])
}

fn rotate_rows(m: &mut [Vector6; 6], p: usize, q: usize, cos: f64, sin: f64) {
    for k in 0..6 {
        (m[p][k], m[q][k]) = (cos * m[p][k] - sin * m[q][k], sin * m[p][k] + cos * m[q][k]);
    }
}

/// (cos, sin) of the smaller rotation that makes the off-diagonal element vanish.
fn jacobi_rotation(a_pp: f64, a_pq: f64, a_qq: f64) -> (f64, f64) {
    let cot = (a_qq - a_pp) / (2.0 * a_pq);
    let tan = 1.0 / (cot.abs() + (cot * cot + 1.0).sqrt());
    let tan = if cot < 0.0 { -tan } else { tan };
    let cos = 1.0 / (tan * tan + 1.0).sqrt();
    (cos, cos * tan)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_diagonalise_the_matrix() {
        let mut matrix = [[0.0; 6]; 6];
        for i in 0..6_u32 {
            for j in 0..6_u32 {
                let x = f64::from((7 * i * i + 3 * i * j + 7 * j * j + 5 * (i + j)) % 11) - 4.0;
                matrix[i as usize][j as usize] = x;
            }
        }
        let axes = principal_axes(matrix);
        let product = |u: &Vector6, v: &Vector6| -> f64 { u.iter().zip(v).map(|(a, b)| a * b).sum() };
        let times = |u: &Vector6| -> Vector6 { std::array::from_fn(|i| product(&matrix[i], u)) };
        let mut before = f64::INFINITY;
        for i in 0..6 {
            let image = times(&axes[i]);
            let value = product(&axes[i], &image);
            assert!(value <= before);
            before = value;
            for j in 0..6 {
                assert!((product(&axes[i], &axes[j]) - f64::from(u8::from(i == j))).abs() < 1e-14);
                assert!((image[j] - value * axes[i][j]).abs() < 1e-12);
            }
        }
    }
}
