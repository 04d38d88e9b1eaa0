//! The attitude over a piece of a step: q̇ = ½ q ω by power series.

use super::piece::Piece;
use super::quaternion::Quaternion;
use crate::field::{HeavyTop, State, add};

/// Terms after which the series is cut: far more than are needed where the body turns by a radian.
const MOST_TERMS: usize = 80;
/// Terms smaller than this are rounding.
const SMALL: f64 = 1.0 / (1u64 << 60) as f64;

/// q at the end of a piece, from q at its start; `coefficients` are those of the piece.
///
/// With ω = Σ ω_k yᵏ the solution is q = Σ q_k yᵏ, q_{k+1} = D/(2(k+1)) Σ_j q_j ω_{k−j}, D the piece's duration.
pub(super) fn advance(top: &HeavyTop, piece: &Piece, coefficients: &[State], start: Quaternion) -> Quaternion {
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
