//! Weighted Birkhoff averages.

/// The weight exp(−1/(u(1−u))) of u ∈ (0, 1), 0 outside.
///
/// All its derivatives vanish at both ends. Averages along a quasiperiodic orbit then converge faster than any power
/// of the number of terms (Das, Sander, Saiki, Yorke, Nonlinearity 30 (2017) 4111–4140).
pub(super) fn bump(u: f64) -> f64 {
    let product = u * (1.0 - u);
    if product > 0.0 { libm::exp(-1.0 / product) } else { 0.0 }
}

/// Σ w_n x_n / Σ w_n with w_n = w((n + 1)/(N + 1)); NaN for no terms.
pub(super) fn weighted_mean(values: &[f64]) -> f64 {
    let size = (values.len() + 1) as f64;
    let (mut sum, mut weights) = (0.0, 0.0);
    for (n, x) in values.iter().enumerate() {
        let weight = bump((n + 1) as f64 / size);
        sum += weight * x;
        weights += weight;
    }
    sum / weights
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_quasiperiodic_mean_converges_fast() {
        // x = 1/(2 − cos θ) has the mean 1/√3 over the circle.
        let golden = 0.618_033_988_749_894_9;
        let values: Vec<f64> =
            (0..2000).map(|n| 1.0 / (2.0 - libm::cos(std::f64::consts::TAU * golden * f64::from(n)))).collect();
        let exact = 1.0 / 3.0_f64.sqrt();
        assert!((weighted_mean(&values[..200]) - exact).abs() < 1e-6);
        assert!((weighted_mean(&values) - exact).abs() < 1e-14);
        let plain = values.iter().sum::<f64>() / 2000.0;
        assert!((plain - exact).abs() > 1e-6, "the weight is what does it");
        assert!(weighted_mean(&[]).is_nan());
    }
}
