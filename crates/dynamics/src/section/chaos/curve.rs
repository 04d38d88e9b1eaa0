//! A cloud of crossings: the plane in which it is widest, and the rotation number along it if it is a closed curve of any
//! shape, from close returns and the curve's first harmonic.

use super::averages::bump;
use crate::section::orbit::SectionPoint;

/// Points that are evaluated; more would add nothing to fourteen digits.
const MOST_POINTS: usize = 2000;
/// Points among which close returns are looked for.
const RETURN_POINTS: usize = 600;
/// Last pairs of close returns that are tried.
const PAIRS: usize = 4;
/// The length of a curve through N points is that through N/2 of them; through points in no order it is up to twice it.
const LONGER: f64 = 1.2;
/// A cloud smaller than this, relative to the size of the phase space, is a point.
const POINT: f64 = 1e-9;
/// Steps of the search for the largest harmonic.
const BISECTIONS: u32 = 44;

/// The rotation number in turns, and its difference between the first and the second half of the points.
///
/// Times q at which the orbit comes closer to itself than ever before are the denominators of the convergents p/q of the
/// rotation number, with p·q₋ ≡ ±1 (mod q) for the record q₋ before. The points, put in the order of nρ mod 1, must
/// then follow a curve. ρ itself is where the curve's first harmonic Σ w_n x_n e^(−2πinρ) is largest, w the weight of a
/// weighted Birkhoff average.
pub(super) fn rotation_along_curve(cloud: &[Vector6]) -> Option<(f64, f64)> {
    let cloud = &cloud[..cloud.len().min(MOST_POINTS)];
    let size = cloud.iter().map(|x| distance_squared(x, &[0.0; 6])).fold(0.0, f64::max);
    if size < POINT * POINT {
        return None;
    }
    let records = close_returns(&cloud[..cloud.len().min(RETURN_POINTS)]);
    records.windows(2).rev().take(PAIRS).find_map(|pair| {
        let (before, q) = (pair[0], pair[1]);
        let p = (1..q).find(|p| p * before % q == 1)?;
        let guess = p as f64 / q as f64;
        let number = largest_harmonic(cloud, guess)?;
        let (first, second) = cloud.split_at(cloud.len() / 2);
        let follows = length_in_order(cloud, number) <= LONGER * length_in_order(first, number);
        let error = || Some((largest_harmonic(first, guess)? - largest_harmonic(second, guess)?).abs());
        follows.then(|| Some((number, error()?)))?
    })
}

/// The times k ≥ 1 at which the mean square of |x_{n+k} − x_n| is smaller than at all times before.
fn close_returns(cloud: &[Vector6]) -> Vec<usize> {
    let longest = cloud.len() / 3;
    let mut records = Vec::new();
    let mut least = f64::INFINITY;
    for k in 1..=longest {
        let pairs = cloud.iter().zip(&cloud[k..]).take(cloud.len() - longest);
        let sum: f64 = pairs.map(|(x, y)| distance_squared(x, y)).sum();
        if sum < least {
            least = sum;
            records.push(k);
        }
    }
    records
}

fn distance_squared(x: &Vector6, y: &Vector6) -> f64 {
    x.iter().zip(y).map(|(a, b)| (a - b) * (a - b)).sum()
}

/// The length of the closed path through the points in the order of nρ mod 1.
fn length_in_order(cloud: &[Vector6], number: f64) -> f64 {
    let phase = |n: usize| {
        let turns = n as f64 * number;
        turns - turns.floor()
    };
    let mut order: Vec<(f64, usize)> = (0..cloud.len()).map(|n| (phase(n), n)).collect();
    order.sort_by(|a, b| a.0.total_cmp(&b.0));
    let next = order.iter().cycle().skip(1);
    order.iter().zip(next).map(|(a, b)| distance_squared(&cloud[a.1], &cloud[b.1]).sqrt()).sum()
}

/// Where |Σ w_n x_n e^(−2πinρ)|² is largest near a guess: the zero of its derivative by bisection, within one
/// resolution 1/N of the guess. None if there is no maximum.
fn largest_harmonic(cloud: &[Vector6], guess: f64) -> Option<f64> {
    let width = 1.0 / cloud.len() as f64;
    let (mut low, mut high) = (guess - width, guess + width);
    if harmonic_slope(cloud, low) <= 0.0 || harmonic_slope(cloud, high) >= 0.0 {
        return None;
    }
    for _ in 0..BISECTIONS {
        let middle = f64::midpoint(low, high);
        if harmonic_slope(cloud, middle) > 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    Some(f64::midpoint(low, high))
}

/// A positive multiple of d/dρ |Σ w_n x_n e^(−2πinρ)|².
fn harmonic_slope(cloud: &[Vector6], number: f64) -> f64 {
    let size = (cloud.len() + 1) as f64;
    // Sums of w x cos, w x sin, and the same with the time after the middle as a further factor, which changes the
    // phase of the sum but not its size.
    let mut sums = [[0.0_f64; 6]; 4];
    for (n, x) in cloud.iter().enumerate() {
        let time = (n + 1) as f64 - 0.5 * size;
        let (sin, cos) = libm::sincos(std::f64::consts::TAU * number * time);
        let weight = bump((n + 1) as f64 / size);
        let factors = [weight * cos, weight * sin, weight * time * cos, weight * time * sin];
        for (sum, factor) in sums.iter_mut().zip(factors) {
            for (total, coordinate) in sum.iter_mut().zip(x) {
                *total += factor * coordinate;
            }
        }
    }
    // |C|² + |S|² with C' = −t S, S' = t C
    (0..6).map(|i| sums[1][i] * sums[2][i] - sums[0][i] * sums[3][i]).sum()
}

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
    use std::f64::consts::TAU;

    use super::*;

    fn orbit(count: u32, rho: f64, curve: impl Fn(f64) -> Vector6) -> Vec<Vector6> {
        (0..count).map(|n| curve(TAU * rho * f64::from(n))).collect()
    }

    /// A curve with double loops, seen from no centre as a circle.
    fn knotted(t: f64) -> Vector6 {
        let (a, b, c) = (libm::cos(t), libm::sin(2.0 * t), libm::cos(3.0 * t));
        [0.3 * a, b, 0.8 * c, 0.4 * libm::sin(t + 0.3), 0.2 * b * c, a * c]
    }

    #[test]
    fn the_number_of_any_closed_curve_is_found() {
        for rho in [0.381_966_011_25, 0.041_7, 0.297_1, 0.441_1] {
            let (number, error) = rotation_along_curve(&orbit(500, rho, knotted)).unwrap();
            let number = number.min(1.0 - number);
            assert!((number - rho).abs() < 1e-9 && error < 1e-6, "{rho} {number} {error:e}");
        }
    }

    #[test]
    fn what_is_no_curve_has_no_number() {
        // A torus, a point, and noise.
        let torus = orbit(500, 0.381_966_011_25, |t| {
            let s = t * 1.303_577_269;
            [libm::cos(t), libm::sin(t), libm::cos(s), libm::sin(s), 0.0, 0.0]
        });
        assert_eq!(rotation_along_curve(&torus), None);
        let point = orbit(500, 0.37, |t| [1e-13 * libm::cos(t), 0.0, 0.0, 0.0, 0.0, 0.0]);
        assert_eq!(rotation_along_curve(&point), None);
        let mut x = 0.3_f64;
        let mut logistic = || {
            x = 3.99 * x * (1.0 - x);
            x
        };
        let noise: Vec<Vector6> = (0..500).map(|_| [(); 6].map(|()| logistic())).collect();
        assert_eq!(rotation_along_curve(&noise), None);
    }

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
