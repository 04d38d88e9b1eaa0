//! The attitude as a unit quaternion, and over a piece of a step: q̇ = ½ q ω by power series.

use super::piece::StepPiece;
use crate::field::{HeavyTop, State, add, dot};

/// Terms after which the series is cut: far more than are needed where the body turns by a radian.
const MOST_TERMS: usize = 80;
/// Terms smaller than this are rounding.
const SMALL: f64 = 1.0 / (1u64 << 60) as f64;

/// q at the end of a piece, from q at its start; `coefficients` are those of the piece.
///
/// With ω = Σ ω_k yᵏ the solution is q = Σ q_k yᵏ, q_{k+1} = D/(2(k+1)) Σ_j q_j ω_{k−j}, D the piece's duration.
pub(super) fn advance(top: &HeavyTop, piece: &StepPiece, coefficients: &[State], start: Quaternion) -> Quaternion {
    let omega: Vec<[f64; 3]> = coefficients.iter().map(|c| top.angular_velocity(c.l)).collect();
    let half = 0.5 * piece.duration();
    let mut terms = vec![start];
    let mut sum = Quaternion { w: 0.0, v: [0.0; 3] };
    for k in 0..MOST_TERMS {
        let mut next = Quaternion { w: 0.0, v: [0.0; 3] };
        for (j, term) in terms.iter().enumerate().skip((k + 1).saturating_sub(omega.len())) {
            let product = term.times(omega[k - j]);
            next = Quaternion { w: next.w + product.w, v: add(next.v, product.v) };
        }
        let factor = half / (k + 1) as f64;
        next = Quaternion { w: factor * next.w, v: next.v.map(|x| factor * x) };
        let done = next.norm() <= SMALL && k + 1 >= omega.len();
        terms.push(next);
        if done {
            break;
        }
    }
    // The small terms first.
    for term in terms.iter().rev() {
        sum = Quaternion { w: sum.w + term.w, v: add(sum.v, term.v) };
    }
    sum.normalised()
}

/// w + x i + y j + z k, of length 1 if it represents a rotation; q and −q are the same rotation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quaternion {
    /// Real part.
    pub w: f64,
    /// Imaginary part.
    pub v: [f64; 3],
}

impl Quaternion {
    /// R_z(φ) R_x(ϑ) R_z(ψ).
    #[must_use]
    pub fn of_angles(theta: f64, psi: f64, phi: f64) -> Self {
        let (sin, cos) = libm::sincos(0.5 * theta);
        let (sin_sum, cos_sum) = libm::sincos(0.5 * (phi + psi));
        let (sin_difference, cos_difference) = libm::sincos(0.5 * (phi - psi));
        Self { w: cos * cos_sum, v: [sin * cos_difference, sin * sin_difference, cos * sin_sum] }
    }

    /// [w, x, y, z].
    #[must_use]
    pub fn components(self) -> [f64; 4] {
        [self.w, self.v[0], self.v[1], self.v[2]]
    }

    /// |q|.
    #[must_use]
    pub fn norm(self) -> f64 {
        (self.w * self.w + dot(self.v, self.v)).sqrt()
    }

    /// q/|q|.
    #[must_use]
    pub fn normalised(self) -> Self {
        let norm = self.norm();
        Self { w: self.w / norm, v: self.v.map(|x| x / norm) }
    }

    /// q ω for an imaginary ω.
    #[must_use]
    pub fn times(self, omega: [f64; 3]) -> Self {
        let Self { w, v: [x, y, z] } = self;
        let [a, b, c] = omega;
        Self { w: -(x * a + y * b + z * c), v: [w * a + y * c - z * b, w * b + z * a - x * c, w * c + x * b - y * a] }
    }

    /// The vertical e_z of space seen from the body, Rᵀ e_z: γ.
    #[must_use]
    pub fn vertical(self) -> [f64; 3] {
        let Self { w, v: [x, y, z] } = self;
        [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), w * w - x * x - y * y + z * z]
    }

    /// R u: a vector of the body, in space.
    #[must_use]
    pub fn rotate(self, u: [f64; 3]) -> [f64; 3] {
        let Self { w, v: [x, y, z] } = self;
        let rows = [
            [w * w + x * x - y * y - z * z, 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
            [2.0 * (x * y + w * z), w * w - x * x + y * y - z * z, 2.0 * (y * z - w * x)],
            [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), w * w - x * x - y * y + z * z],
        ];
        rows.map(|row| dot(row, u))
    }

    /// The angle of the rotation that takes one attitude to the other, as long as it is small: 2 min |q ∓ p|.
    #[must_use]
    pub fn distance(self, other: Self) -> f64 {
        let gap = |sign: f64| {
            let p = other.components();
            let q = self.components();
            (0..4).fold(0.0, |sum: f64, i| sum + (q[i] - sign * p[i]) * (q[i] - sign * p[i]))
        };
        2.0 * gap(1.0).min(gap(-1.0)).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn close(u: [f64; 3], v: [f64; 3]) -> bool {
        (0..3).all(|i| (u[i] - v[i]).abs() < 1e-15 * 4.0)
    }

    #[test]
    fn angles_give_the_papers_vertical() {
        let (theta, psi, phi) = (0.7, 2.1, -1.3);
        let q = Quaternion::of_angles(theta, psi, phi);
        let gamma = [libm::sin(psi) * libm::sin(theta), libm::cos(psi) * libm::sin(theta), libm::cos(theta)];
        assert!((q.norm() - 1.0).abs() < 1e-15);
        assert!(close(q.vertical(), gamma));
        assert!(close(q.rotate(gamma), [0.0, 0.0, 1.0]));
        // R_z(φ) alone turns e_x towards e_y.
        let turn = Quaternion::of_angles(0.0, 0.0, 0.5);
        assert!(close(turn.rotate([1.0, 0.0, 0.0]), [libm::cos(0.5), libm::sin(0.5), 0.0]));
    }

    #[test]
    fn the_distance_is_the_angle_between_rotations() {
        let p = Quaternion::of_angles(0.7, 0.2, 0.3);
        let q = Quaternion::of_angles(0.7, 0.2, 0.3 + 1e-6);
        assert!((p.distance(q) - 1e-6).abs() < 1e-15);
        let opposite = Quaternion { w: -q.w, v: q.v.map(|x| -x) };
        assert!((p.distance(opposite) - 1e-6).abs() < 1e-15);
    }
}
