//! Weighted Birkhoff averages: over all terms, and over a window of time while its steps are gone over.

use crate::integrator::taylor::MOMENTS;

/// Squarings that make u(1 − u) the weight (u(1 − u))⁸.
const SQUARINGS: u32 = 3;
/// ∫₀¹ (u(1 − u))⁸ du = 8! 8!/17!.
pub(super) const INTEGRAL: f64 = 1.0 / 218_790.0;

/// ∫ w(u) x dt / ∫ w(u) dt over [begin, end], u = (t − begin)/(end − begin), w = (u(1 − u))⁸.
///
/// Eight derivatives of the weight vanish at both ends, so that the mean along a quasiperiodic motion converges like the
/// ninth power of 1/T: a weighted Birkhoff average (Das, Sander, Saiki, Yorke, Nonlinearity 30 (2017) 4111–4140). For
/// the lengths of time in question this is nearer than their weight, whose derivatives all vanish.
#[derive(Clone, Copy, Debug)]
pub(super) struct MeanWindow {
    begin: f64,
    length: f64,
    gamma: [f64; 3],
    log: f64,
}

impl MeanWindow {
    pub fn new(begin: f64, end: f64) -> Self {
        Self { begin, length: end - begin, gamma: [0.0; 3], log: 0.0 }
    }

    /// Goes over a step, on which ln|δ| grew by `growth`.
    #[inline]
    pub fn take(&mut self, step: &TangentStep, growth: f64) {
        let u = (step.middle() - self.begin) / self.length;
        // Where a step leaves the window the weight is (step/window)⁸ at most.
        if u <= 0.0 || u >= 1.0 {
            return;
        }
        let weight = weight(u);
        let ratio = step.length / self.length;
        let mut power = 1.0;
        for (coefficient, moment) in weight.iter().zip(&step.moments) {
            for (sum, part) in self.gamma.iter_mut().zip(moment) {
                *sum += coefficient * power * part;
            }
            power *= ratio;
        }
        self.log += weight[0] * growth;
    }

    /// The mean of γ.
    pub fn gamma(&self) -> [f64; 3] {
        self.gamma.map(|sum| sum / (self.length * INTEGRAL))
    }

    /// By how much ln|δ| grows in the length of the window at its mean rate.
    pub fn growth(&self) -> f64 {
        self.log / INTEGRAL
    }
}

/// (u(1 − u))⁸ at u + ε: coefficients of 1, ε, ε², ….
#[inline]
fn weight(u: f64) -> [f64; MOMENTS] {
    let mut series = [0.0; MOMENTS];
    (series[0], series[1], series[2]) = (u * (1.0 - u), 1.0 - 2.0 * u, -1.0);
    for _ in 0..SQUARINGS {
        series = std::array::from_fn(|n| (0..=n).map(|k| series[k] * series[n - k]).sum());
    }
    series
}

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

/// What one step of an orbit and its tangent vector is like.
pub(super) struct TangentStep {
    /// Time at its end.
    pub time: f64,
    /// Its length.
    pub length: f64,
    /// |δ|² there.
    pub length_squared: f64,
    /// δ is then scaled by 2^−power.
    pub power: i32,
    /// Of γ: ∫ (ξ − 1/2)ʲ γ dt over it, ξ from 0 to 1.
    pub moments: [[f64; 3]; MOMENTS],
}

impl TangentStep {
    /// The time in its middle.
    pub fn middle(&self) -> f64 {
        self.time - 0.5 * self.length
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Steps of uneven length along γ = (cos t, sin t, cos √2 t)/√3, with the moments by a fine sum.
    fn steps(end: f64) -> Vec<TangentStep> {
        let mut time = 0.0;
        let mut steps = Vec::new();
        while time < end {
            let length = 0.1 + 0.2 * (0.618 * steps.len() as f64).fract();
            let mut moments = [[0.0; 3]; MOMENTS];
            let nodes = 40_u32;
            for n in 0..nodes {
                // Simpson's rule.
                for (part, weight) in [(0.0, 1.0), (0.5, 4.0), (1.0, 1.0)] {
                    let x = (f64::from(n) + part) / f64::from(nodes);
                    let t = time + x * length;
                    let gamma = [libm::cos(t), libm::sin(t), libm::cos(std::f64::consts::SQRT_2 * t)];
                    let mut power = weight * length / f64::from(6 * nodes);
                    for moment in &mut moments {
                        for (sum, gamma) in moment.iter_mut().zip(gamma) {
                            *sum += power * gamma;
                        }
                        power *= x - 0.5;
                    }
                }
            }
            time += length;
            steps.push(TangentStep { time, length, length_squared: 1.0, power: 0, moments });
        }
        steps
    }

    #[test]
    fn a_quasiperiodic_mean_converges_fast() {
        for (length, error) in [(60.0, 1e-3), (120.0, 1e-6), (480.0, 1e-10)] {
            let mut window = MeanWindow::new(3.0, 3.0 + length);
            for step in &steps(length + 5.0) {
                window.take(step, step.length);
            }
            for mean in window.gamma() {
                assert!(mean.abs() < error, "{length}: {mean:e}");
            }
            // d ln|δ|/dt = 1
            assert!((window.growth() / length - 1.0).abs() < 1e-3);
        }
    }

    #[test]
    fn a_quasiperiodic_mean_of_terms_converges_fast() {
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
