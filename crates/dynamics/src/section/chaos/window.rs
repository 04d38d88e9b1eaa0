//! Means over a window of time with a smooth weight.

use super::passed::Passed;
use crate::integrator::taylor::MOMENTS;

/// Squarings that make u(1 − u) the weight (u(1 − u))⁸.
const SQUARINGS: u32 = 3;
/// ∫₀¹ (u(1 − u))⁸ du = 8! 8!/17!.
const INTEGRAL: f64 = 1.0 / 218_790.0;

/// ∫ w(u) x dt / ∫ w(u) dt over [begin, end], u = (t − begin)/(end − begin), w = (u(1 − u))⁸.
///
/// Eight derivatives of the weight vanish at both ends, so that the mean along a quasiperiodic motion converges like the
/// ninth power of 1/T: a weighted Birkhoff average (Das, Sander, Saiki, Yorke, Nonlinearity 30 (2017) 4111–4140). For
/// the lengths of time in question this is nearer than their weight, whose derivatives all vanish.
#[derive(Clone, Copy, Debug)]
pub(super) struct Window {
    begin: f64,
    length: f64,
    gamma: [f64; 3],
    log: f64,
}

/// Coefficients of 1, ε, ε², ….
type Series = [f64; MOMENTS];

impl Window {
    pub fn new(begin: f64, end: f64) -> Self {
        Self { begin, length: end - begin, gamma: [0.0; 3], log: 0.0 }
    }

    /// Goes over a step, on which ln|δ| grew by `growth`.
    #[inline]
    pub fn take(&mut self, step: &Passed, growth: f64) {
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

/// (u(1 − u))⁸ at u + ε.
#[inline]
fn weight(u: f64) -> Series {
    let mut series = [0.0; MOMENTS];
    (series[0], series[1], series[2]) = (u * (1.0 - u), 1.0 - 2.0 * u, -1.0);
    for _ in 0..SQUARINGS {
        series = std::array::from_fn(|n| (0..=n).map(|k| series[k] * series[n - k]).sum());
    }
    series
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Steps of uneven length along γ = (cos t, sin t, cos √2 t)/√3, with the moments by a fine sum.
    fn steps(end: f64) -> Vec<Passed> {
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
            steps.push(Passed { time, length, length_squared: 1.0, power: 0, moments });
        }
        steps
    }

    #[test]
    fn a_quasiperiodic_mean_converges_fast() {
        for (length, error) in [(60.0, 1e-3), (120.0, 1e-6), (480.0, 1e-10)] {
            let mut window = Window::new(3.0, 3.0 + length);
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
}
