//! The angle φ by quadrature, also where γ passes ±e₃.

use super::piece::StepPiece;
use crate::field::{HeavyTop, State, norm};

/// Nodes and weights of Gauss's quadrature of order 24 on [−1, 1], one of each pair. Over a piece, in which the body
/// turns by a radian at most, its error is below rounding.
const GAUSS: [[f64; 2]; 6] = [
    [0.981_560_634_246_719_2, 0.047_175_336_386_511_83],
    [0.904_117_256_370_474_9, 0.106_939_325_995_318_43],
    [0.769_902_674_194_304_7, 0.160_078_328_543_346_23],
    [0.587_317_954_286_617_4, 0.203_167_426_723_065_92],
    [0.367_831_498_998_180_2, 0.233_492_536_538_354_8],
    [0.125_233_408_511_468_9, 0.249_147_045_813_402_8],
];

/// γ is at ±e₃, within rounding, when √(γ₁² + γ₂²) is below this.
const AT_POLE: f64 = 1e-14;

/// φ̇ = (ω₁γ₁ + ω₂γ₂)/(γ₁² + γ₂²); not finite at γ = ±e₃.
#[must_use]
pub fn azimuth_rate(top: &HeavyTop, state: &State) -> f64 {
    horizontal_product(top, state) / (state.gamma[0] * state.gamma[0] + state.gamma[1] * state.gamma[1])
}

/// ω₁γ₁ + ω₂γ₂.
fn horizontal_product(top: &HeavyTop, state: &State) -> f64 {
    let omega = top.angular_velocity(state.l);
    omega[0] * state.gamma[0] + omega[1] * state.gamma[1]
}

/// ψ of γ, in (−π, π]; 0 at ±e₃.
pub(super) fn longitude(gamma: [f64; 3]) -> f64 {
    libm::atan2(gamma[0], gamma[1])
}

/// The change of φ over a piece at whose ends ψ is `psi`, modulo 2π; and whether γ was at ±e₃ within rounding, so that φ
/// and ψ there are one possible choice.
///
/// On the northern half d(φ+ψ)/dt = ω₃ + (ω₁γ₁+ω₂γ₂)/(1+γ₃) is integrated, on the southern half
/// d(φ−ψ)/dt = (ω₁γ₁+ω₂γ₂)/(1−γ₃) − ω₃; both are smooth there. The change of ψ is that of the ends, with the number of
/// turns about the pole that the polynomials of γ₁ and γ₂ show.
pub(super) fn advance(top: &HeavyTop, piece: &StepPiece, coefficients: &[State], psi: [f64; 2]) -> (f64, bool) {
    let pole = if piece.state(0.5).gamma[2] >= 0.0 { 1.0 } else { -1.0 };
    let integrand = |y: f64| {
        let state = piece.state(y);
        let omega_3 = top.angular_velocity(state.l)[2];
        // If the integrator does not keep |γ| = 1, the direction counts.
        horizontal_product(top, &state) / (norm(state.gamma) + pole * state.gamma[2]) + pole * omega_3
    };
    let mut sum = 0.0;
    for [node, weight] in GAUSS {
        sum += weight * (integrand(0.5 - 0.5 * node) + integrand(0.5 + 0.5 * node));
    }
    let combined = 0.5 * piece.duration() * sum;
    let horizontal: Vec<[f64; 2]> = coefficients.iter().map(|c| [c.gamma[0], c.gamma[1]]).collect();
    let (angle, at_pole) = turn(&horizontal, 64);
    let change = psi[1] - psi[0];
    let turns = ((angle - change) / std::f64::consts::TAU).round();
    let psi = change + turns * std::f64::consts::TAU;
    (combined - pole * psi, at_pole)
}

/// The change of the angle atan2(γ₁, γ₂) along Σ c_k yᵏ, y ∈ [0, 1], halving until the curve cannot go round 0; and whether
/// the curve came to 0 within rounding.
fn turn(c: &[[f64; 2]], depth: u32) -> (f64, bool) {
    let size = |v: [f64; 2]| (v[0] * v[0] + v[1] * v[1]).sqrt();
    let start = c[0];
    let reach = c[1..].iter().fold(0.0, |sum, &v| sum + size(v));
    let end = c.iter().rev().fold([0.0; 2], |sum, v| [sum[0] + v[0], sum[1] + v[1]]);
    let clear = reach < size(start);
    let at_pole = !clear && (depth == 0 || reach.max(size(start)) <= AT_POLE);
    if clear || at_pole {
        let angle = libm::atan2(start[1] * end[0] - start[0] * end[1], start[0] * end[0] + start[1] * end[1]);
        return (angle, at_pole);
    }
    let mut first = c.to_vec();
    let mut power = 1.0;
    for v in &mut first {
        *v = v.map(|x| power * x);
        power *= 0.5;
    }
    // p((1 + y)/2): the first half's polynomial, moved by one.
    let mut second = first.clone();
    for i in 0..second.len() {
        for j in (i..second.len() - 1).rev() {
            second[j] = [second[j][0] + second[j + 1][0], second[j][1] + second[j + 1][1]];
        }
    }
    let (first, second) = (turn(&first, depth - 1), turn(&second, depth - 1));
    (first.0 + second.0, first.1 || second.1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turns_are_counted_however_close_the_curve_comes() {
        use std::f64::consts::PI;
        // A straight line past the origin at distance d, from −1 to 1.
        for d in [0.5, 1e-3, 1e-9, 1e-13] {
            // From (−1, d) to (1, d): atan2(γ₁, γ₂) rises.
            let right = turn(&[[-1.0, d], [2.0, 0.0]], 64);
            let left = turn(&[[-1.0, -d], [2.0, 0.0]], 64);
            let expected = 2.0 * libm::atan2(1.0, d);
            assert!((right.0 - expected).abs() < 1e-12 && !right.1, "{d}: {right:?}");
            assert!((left.0 + expected).abs() < 1e-12 && !left.1, "{d}: {left:?}");
        }
        // Straight through the origin there is no definite turn: any whole number of half turns will do.
        let through = turn(&[[-1.0, 0.0], [2.0, 0.0]], 64);
        let halves = through.0 / PI;
        assert!(through.1 && (halves - halves.round()).abs() < 1e-12, "{through:?}");
        let resting = turn(&[[1e-17, 0.0], [-3e-17, 1e-17]], 64);
        assert!(resting.1);
    }
}
