//! Integrals of powers against powers, for means along a step.

use super::series::ROWS;

/// Moments of a step that are computed: of the orders 0 to this number − 1.
pub(crate) const MOMENTS: usize = 6;

/// ∫₀¹ (ξ − 1/2)ʲ ξᵏ dξ.
pub(crate) struct Moments {
    pub(super) of_powers: [[f64; MOMENTS]; ROWS],
}

impl Moments {
    pub fn new() -> Self {
        let mut of_powers = [[0.0; MOMENTS]; ROWS];
        for (k, row) in of_powers.iter_mut().enumerate() {
            for (j, entry) in row.iter_mut().enumerate() {
                // (ξ − 1/2)ʲ = Σ C(j,i) (−1/2)^{j−i} ξⁱ
                let mut coefficient = (0..j).fold(1.0, |power, _| -0.5 * power);
                for i in 0..=j {
                    *entry += coefficient / (k + i + 1) as f64;
                    coefficient *= -2.0 * (j - i) as f64 / (i + 1) as f64;
                }
            }
        }
        Self { of_powers }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn moments_are_those_of_a_fine_sum() {
        let moments = Moments::new();
        for (k, row) in moments.of_powers.iter().enumerate() {
            for (j, moment) in row.iter().enumerate() {
                let nodes = 20_000;
                let sum: f64 = (0..nodes)
                    .map(|n| {
                        let x = (f64::from(n) + 0.5) / f64::from(nodes);
                        let power = |base: f64, times: usize| (0..times).fold(1.0, |product, _| product * base);
                        power(x - 0.5, j) * power(x, k)
                    })
                    .sum();
                assert!((sum / f64::from(nodes) - moment).abs() < 1e-6, "{j} {k}");
            }
        }
        // ∫₀¹ (ξ − 1/2)² dξ
        assert!((moments.of_powers[0][2] - 1.0 / 12.0).abs() < 1e-16);
    }
}
