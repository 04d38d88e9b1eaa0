//! Downhill arcs along circles of latitude about r̂.
//!
//! On the circle ⟨γ, r̂⟩ = c the potential is x/J − r c, so U falls exactly where J rises, and J is a trigonometric
//! polynomial of degree 2. Such arcs follow ring-shaped valleys (bodies close to Lagrange's) in which straight steps
//! would be tiny.

use bifdiag_numbers::UNIT_ROUNDOFF;

use super::super::potential::{Potential, Vector, combination};
use bifdiag_numbers::vector::{cross, dot, normalised};

/// A circle of latitude through a point, and J' on it as a quartic in w = tan(ψ/2).
struct Latitude {
    center: Vector,
    /// Radius times unit vectors: towards the point, and 90° further.
    arms: [Vector; 2],
    /// J'(ψ)(1 + w²)² = Σ c_k w^k.
    quartic: [f64; 5],
}

impl Latitude {
    /// `None` at the poles.
    fn through(potential: &Potential, gamma: Vector, turn: f64) -> Option<Self> {
        let r_hat = normalised(potential.frame.r);
        let c = dot(gamma, r_hat);
        let across = cross(r_hat, gamma);
        let radius = dot(across, across).sqrt();
        if radius < 1e-8 {
            return None;
        }
        let second = across.map(|x| turn * x / radius);
        let first = cross(second, r_hat).map(|x| turn * x);
        let (a_first, a_second) = (potential.inertia(first), potential.inertia(second));
        let b = [dot(r_hat, a_first), dot(r_hat, a_second)].map(|b| 2.0 * c * radius * b);
        let mixed = 2.0 * radius * radius * dot(first, a_second);
        let difference = radius * radius * (dot(second, a_second) - dot(first, a_first));
        Some(Self {
            center: r_hat.map(|x| c * x),
            arms: [first.map(|x| radius * x), second.map(|x| radius * x)],
            quartic: [
                b[1] + mixed,
                -2.0 * b[0] + 4.0 * difference,
                -6.0 * mixed,
                -2.0 * b[0] - 4.0 * difference,
                mixed - b[1],
            ],
        })
    }

    /// The point at w = tan(ψ/2).
    fn point(&self, w: f64) -> Vector {
        let n = 1.0 + w * w;
        let on_circle = combination((1.0 - w * w) / n, self.arms[0], 2.0 * w / n, self.arms[1]);
        normalised(combination(1.0, self.center, 1.0, on_circle))
    }

    /// True when J' ≥ 0 is proved on [0, w] by Bernstein coefficients.
    fn rises_until(&self, w: f64) -> bool {
        const WEIGHTS: [[f64; 5]; 5] = [
            [1.0, 0.0, 0.0, 0.0, 0.0],
            [1.0, 0.25, 0.0, 0.0, 0.0],
            [1.0, 0.5, 1.0 / 6.0, 0.0, 0.0],
            [1.0, 0.75, 0.5, 0.25, 0.0],
            [1.0, 1.0, 1.0, 1.0, 1.0],
        ];
        let mut scaled = self.quartic;
        let mut power = 1.0;
        for coefficient in &mut scaled {
            *coefficient *= power;
            power *= w;
        }
        // The first coefficient is J' at the start itself; the others are sums of rounded terms.
        scaled[0] >= 0.0
            && WEIGHTS[1..].iter().all(|row| {
                let terms = row.iter().zip(&scaled).map(|(weight, c)| weight * c);
                terms.clone().sum::<f64>() >= 16.0 * UNIT_ROUNDOFF * terms.map(f64::abs).sum::<f64>()
            })
    }

    /// The farthest of the points w = 1, ½, ¼, … up to which J rises.
    fn slide(&self) -> Option<Vector> {
        let mut w = 1.0;
        for _ in 0..40 {
            if self.rises_until(w) {
                return Some(self.point(w));
            }
            w *= 0.5;
        }
        None
    }
}

/// A point further down along the circle of latitude through γ.
pub(super) fn slide(potential: &Potential, gamma: Vector) -> Option<Vector> {
    let ahead = Latitude::through(potential, gamma, 1.0)?;
    if ahead.quartic[0] >= 0.0 { ahead.slide() } else { Latitude::through(potential, gamma, -1.0)?.slide() }
}

/// Points on both sides of a saddle that is a ridge of its circle of latitude (J minimal on the circle).
pub(super) fn sides_of_ridge(potential: &Potential, saddle: Vector) -> Option<[Vector; 2]> {
    let side = |turn: f64| {
        let mut circle = Latitude::through(potential, saddle, turn)?;
        // At a critical point J' vanishes exactly.
        circle.quartic[0] = 0.0;
        let end = circle.slide()?;
        let fall = potential.value(saddle) - potential.value(end);
        (fall > 2.0 * potential.value_error(saddle)).then_some(end)
    };
    Some([side(1.0)?, side(-1.0)?])
}
