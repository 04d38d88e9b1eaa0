//! The Kronecker sequence: low discrepancy in the unit cube, the same numbers on every machine.

use rand_xoshiro::SplitMix64;
use rand_xoshiro::rand_core::{RngCore, SeedableRng};

/// 2^64 g^−j, j = 1 … d, rounded down, where g is the positive root of x^(d+1) = x + 1; row d − 1.
const STEPS: [&[u64]; 4] = [
    &[0x9e37_79b9_7f4a_7c15],
    &[0xc13f_a9a9_02a6_328f, 0x91e1_0da5_c79e_7b1c],
    &[0xd1b5_4a32_d192_ed03, 0xabc9_8388_fb8f_ac02, 0x8cb9_2ba7_2f3d_8dd7],
    &[0xdb4f_0b91_75ae_2165, 0xbbe0_5633_03a4_615f, 0xa0f2_ec75_a1fe_1575, 0x89e1_8285_7d9e_d688],
];

/// The most dimensions of [`point`].
pub const DIMENSIONS_MAX: usize = STEPS.len();

/// Point n of the sequence in the open unit cube of `dimensions` dimensions: x_j = frac(x_j(0) + n g^−j) (M. Roberts, *The
/// unreasonable effectiveness of quasirandom sequences*, 2018; for one dimension the golden ratio). The fractions are
/// taken in 64-bit integers, so the numbers are the same on every machine. `seed` chooses the point at which it starts.
///
/// Coordinates beyond the fourth repeat those before.
#[must_use]
pub fn point(n: u64, dimensions: usize, seed: u64) -> Vec<f64> {
    let steps = STEPS[dimensions.clamp(1, DIMENSIONS_MAX) - 1];
    (0..dimensions)
        .map(|j| {
            // Not the middle of the cube, where bodies are symmetric.
            let start = random(seed.wrapping_mul(DIMENSIONS_MAX as u64).wrapping_add(j as u64 + 1));
            let bits = n.wrapping_mul(steps[j % steps.len()]).wrapping_add(start);
            // 52 bits and a half of the last: never 0 and never 1.
            ((bits >> 12) as f64 + 0.5) / 4_503_599_627_370_496.0
        })
        .collect()
}

/// The number k of the generator `SplitMix64` that is seeded with 0. (Its state is a multiple of the golden step.)
#[must_use]
pub fn random(k: u64) -> u64 {
    SplitMix64::seed_from_u64(k.wrapping_sub(1).wrapping_mul(STEPS[0][0])).next_u64()
}

/// The sequence in the unit square, point after point: x ← frac(x + step) in `f64`, from a random point.
#[derive(Clone, Debug, PartialEq)]
pub struct Square {
    position: [f64; 2],
}

/// 1/g and 1/g² with g³ = g + 1.
const SQUARE_STEP: [f64; 2] = [0.754_877_666_246_692_8, 0.569_840_290_998_053_3];

impl Square {
    /// The sequence that a seed chooses.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        let mut generator = SplitMix64::seed_from_u64(seed);
        Self { position: [(); 2].map(|()| (generator.next_u64() >> 11) as f64 / (1u64 << 53) as f64) }
    }

    /// The next point, in [0, 1)².
    pub fn advance(&mut self) -> [f64; 2] {
        for (x, step) in self.position.iter_mut().zip(SQUARE_STEP) {
            *x += step;
            *x -= x.floor();
        }
        self.position
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_steps_are_powers_of_the_roots() {
        for dimensions in 1..=DIMENSIONS_MAX {
            // The step satisfies y^(d+1) + y^d = 1 with y = 1/g.
            let y = point(1, dimensions, 0)[0] - point(0, dimensions, 0)[0];
            let y = if y < 0.0 { y + 1.0 } else { y };
            let power = (0..dimensions).fold(1.0, |power, _| power * y);
            assert!((power * y + power - 1.0).abs() < 1e-14, "{dimensions}: {y}");
        }
    }

    /// Boxes get their share of points: the discrepancy of the first 4096 points is far below that of random points.
    #[test]
    fn boxes_get_their_share() {
        for seed in [0, 1, 77] {
            let points: Vec<Vec<f64>> = (0..4096).map(|n| point(n, 4, seed)).collect();
            for axis in 0..4 {
                let share = points.iter().filter(|x| x[axis] < 0.3).count() as f64 / 4096.0;
                assert!((share - 0.3).abs() < 0.002, "{seed} {axis}: {share}");
                let box_share = points.iter().filter(|x| x[axis] < 0.5 && x[(axis + 1) % 4] < 0.5).count() as f64;
                assert!((box_share / 4096.0 - 0.25).abs() < 0.004, "{seed} {axis}");
            }
        }
    }

    /// The numbers that sections of earlier versions began with.
    #[test]
    fn the_square_is_walked_in_the_plastic_numbers_steps() {
        let mut square = Square::new(7);
        assert_eq!(square.position, [0.389_829_748_391_271_5, 0.016_788_294_528_156_11]);
        let points: Vec<[f64; 2]> = (0..4096).map(|_| square.advance()).collect();
        let corner = points.iter().filter(|x| x[0] < 0.5 && x[1] < 0.25).count() as f64 / 4096.0;
        assert!((corner - 0.125).abs() < 0.002, "{corner}");
    }
}
