//! Coordinates in which a body is improved: logarithms of ratios, so that near-axis and near-symmetric bodies are ordinary.

use crate::digits::{DIGITS, rounded};

/// Coordinates around a body; components of r that are 0 stay 0, and units stay the same.
#[derive(Clone, Debug)]
pub(super) struct Chart {
    base: [[f64; 3]; 2],
    /// Places of (A1, A2, A3, r1, r2, r3) that vary.
    free: Vec<usize>,
}

impl Chart {
    /// All ratios vary but those of the largest moment and of the largest component of r.
    pub(super) fn around(base: [[f64; 3]; 2]) -> Self {
        let largest =
            |values: &[f64; 3]| (0..3).max_by(|&i, &j| values[i].abs().total_cmp(&values[j].abs())).unwrap_or_default();
        let fixed = [largest(&base[0]), 3 + largest(&base[1])];
        let free = (0..6).filter(|place| !fixed.contains(place) && base[place / 3][place % 3] != 0.0).collect();
        Self { base, free }
    }

    /// Number of coordinates.
    pub(super) fn dimensions(&self) -> usize {
        self.free.len()
    }

    /// A and r at these coordinates, rounded to a few digits: so that what is found can be written down.
    pub(super) fn values(&self, coordinates: &[f64]) -> [[f64; 3]; 2] {
        let mut values = self.base;
        for (place, coordinate) in self.free.iter().zip(coordinates) {
            values[place / 3][place % 3] *= libm::exp(*coordinate);
        }
        values.map(|triple| triple.map(|x| rounded(x, DIGITS)))
    }
}
