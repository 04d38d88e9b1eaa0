//! Directions in which a body can be changed while what is special about it stays.

use rand_xoshiro::SplitMix64;
use rand_xoshiro::rand_core::RngCore;

use super::line::Line;
use super::place::{Change, Domain, Place};
use bifdiag_numbers::vector::dot;

/// An orthonormal basis of the directions at a body: A keeps its sum and its equal moments, r its length and its zeros.
#[derive(Clone, Debug, PartialEq)]
pub struct Chart {
    place: Place,
    basis: Vec<Change>,
}

impl Chart {
    /// The chart at a body.
    #[must_use]
    pub fn new(place: Place) -> Self {
        let mut basis: Vec<Change> = Vec::with_capacity(4);
        let Place { a, r } = place;
        // Each gap between moments that is open may change, and so may each component of r but the largest.
        let mut candidates: Vec<Change> = Vec::with_capacity(4);
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
        Self { place, basis }
    }

    /// Number of parameters.
    #[must_use]
    pub fn dimensions(&self) -> usize {
        self.basis.len()
    }

    /// The line with these coordinates of its direction; `None` where nothing can change.
    #[must_use]
    pub fn line(&self, coordinates: &[f64], domain: Domain) -> Option<Line> {
        let zero = [[0.0; 3]; 2];
        let change = self.basis.iter().zip(coordinates).fold(zero, |sum, (basis, x)| combined(&sum, *x, basis));
        Line::new(self.place, change, domain)
    }

    /// The body at these coordinates, on the line through them.
    #[must_use]
    pub fn body(&self, coordinates: &[f64], domain: Domain) -> Option<Place> {
        let length = coordinates.iter().map(|x| x * x).sum::<f64>().sqrt();
        let line = self.line(coordinates, domain)?;
        (length < line.reach()[1]).then(|| Place::of(line.at(length)))
    }

    /// How far it is to each kind of bodies that are special, by equal moments or a component of r that is 0, where this one
    /// is not; and the coordinates of the direction there, of length 1.
    #[must_use]
    pub fn to_special(&self) -> Vec<(f64, Vec<f64>)> {
        let Place { a, r } = self.place;
        let mut found = Vec::with_capacity(5);
        let mut note = |distance: f64, falling: &dyn Fn(&Change) -> f64| {
            let slope: Vec<f64> = self.basis.iter().map(falling).collect();
            let length = slope.iter().map(|x| x * x).sum::<f64>().sqrt();
            if distance > 0.0 && length > 0.0 {
                found.push((distance, slope.into_iter().map(|x| x / length).collect()));
            }
        };
        for (i, j) in [(0, 1), (1, 2)] {
            // The nearest A with A_i = A_j has the mean of both in their place.
            note((a[j] - a[i]) / std::f64::consts::SQRT_2, &|change| change[0][i] - change[0][j]);
        }
        for k in 0..3 {
            // r_k is the sine of the angle between r and the plane.
            note(libm::asin(r[k].min(1.0)), &|change| -change[1][k]);
        }
        found
    }

    /// A random direction: half of them uniform, half stretched along the distances to special bodies, so that cells as
    /// thin as their distance from those are crossed as often as others.
    pub fn random(&self, rng: &mut SplitMix64) -> Vec<f64> {
        let uniform = in_ball(rng, self.dimensions());
        if rng.next_u64() & 1 == 0 {
            return uniform;
        }
        let Place { a, r } = self.place;
        let g: [f64; 5] = std::array::from_fn(|_| 2.0 * unit(rng) - 1.0);
        // Gaps d1 = A2 − A1, d2 = A3 − A2 and components of r change by shares of themselves.
        let (d1, d2) = (g[0] * (a[1] - a[0]), g[1] * (a[2] - a[1]));
        let first = -(2.0 * d1 + d2) / 3.0;
        let change = [[first, first + d1, first + d1 + d2], std::array::from_fn(|k| g[2 + k] * r[k])];
        self.basis.iter().map(|basis| product(&change, basis)).collect()
    }
}

/// A number in [0, 1).
pub(super) fn unit(rng: &mut SplitMix64) -> f64 {
    (rng.next_u64() >> 11) as f64 / (1_u64 << 53) as f64
}

/// A uniform point of the ball.
fn in_ball(rng: &mut SplitMix64, dimensions: usize) -> Vec<f64> {
    loop {
        let point: Vec<f64> = (0..dimensions).map(|_| 2.0 * unit(rng) - 1.0).collect();
        let square: f64 = point.iter().map(|x| x * x).sum();
        if dimensions == 0 || (1e-6..=1.0).contains(&square) {
            return point;
        }
    }
}

fn product(p: &Change, q: &Change) -> f64 {
    dot(p[0], q[0]) + dot(p[1], q[1])
}

fn combined(p: &Change, factor: f64, q: &Change) -> Change {
    std::array::from_fn(|part| std::array::from_fn(|k| p[part][k] + factor * q[part][k]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn generic_bodies_have_four_parameters_and_special_ones_fewer() {
        let dimensions = |a, r| Chart::new(Place::of([a, r])).dimensions();
        assert_eq!(dimensions([0.5, 0.6, 0.9], [0.6, 0.1, 0.8]), 4);
        assert_eq!(dimensions([0.5, 0.6, 0.9], [0.6, 0.0, 0.8]), 3);
        assert_eq!(dimensions([0.5, 0.6, 0.9], [0.0, 0.0, 1.0]), 2);
        assert_eq!(dimensions([0.5, 0.5, 0.9], [0.3, 0.4, 0.5]), 2);
        assert_eq!(dimensions([0.5, 0.5, 0.9], [0.0, 0.0, 1.0]), 1);
        assert_eq!(dimensions([1.0, 1.0, 1.0], [0.0, 0.0, 1.0]), 0);
    }

    #[test]
    fn the_nearest_special_body_is_as_far_as_it_is() {
        let place = Place::of([[0.5, 0.6, 0.9], [0.6, 0.0, 0.8]]);
        let chart = Chart::new(place);
        let special = chart.to_special();
        assert_eq!(special.len(), 4);
        for (distance, direction) in special {
            let line = chart.line(&direction, Domain::All).unwrap();
            assert!((line.distance(line.reach()[1]) - distance).abs() < 0.3 * distance, "{distance}");
        }
    }

    #[test]
    fn the_basis_is_orthonormal_near_an_axis_too() {
        let chart = Chart::new(Place::of([[0.5, 0.6, 0.9], [1e-9, 1e-5, 1.0]]));
        for (i, p) in chart.basis.iter().enumerate() {
            for (j, q) in chart.basis.iter().enumerate() {
                assert!((product(p, q) - f64::from(u8::from(i == j))).abs() < 1e-12, "{i} {j}");
            }
        }
    }
}
