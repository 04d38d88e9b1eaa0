//! r on a principal axis: the order of a symmetric pair and the straight lines γ = ±r̂ in closed form
//! (Proposition 5.5 of docs/mathematics.md).
//!
//! With a the moment of the axis, d = a_i − a, σ = ±1 for the line γ = σ r̂ and g = σ⟨γ, r̂⟩ on the pair over a_i:
//! h_pair − h_line = −σ r (1 − g)² (a + d (1 + g)²)/(2 a g). Away from the pitchfork g = 1 it vanishes only for d < 0,
//! σ = −1 at g = √(a/|d|) − 1, which is below 1 when a_i < ¾ a: beyond the pair's cusp. Beside a_i = ¾ a the cusp, the crossing and
//! the pitchfork draw together like the square of the distance, and the gap between them is below the rounding of h.

use std::cmp::Ordering;

use crate::arrangement::order::{PairCrossing, PairOrder};
use bifdiag_body::Frame;
use bifdiag_equilibria::curves::{Branch, Curve, End, Pole, Shape};
use bifdiag_numbers::UNIT_ROUNDOFF;

/// The order of a line γ = ±r̂ (first) and a pair; `None` when the curves are not these.
pub(super) fn line_and_pair(frame: &Frame, line: &Curve, pair: &Curve, common: [f64; 2]) -> Option<PairOrder> {
    let (Branch::Axis(pole), Branch::Symmetric(i)) = (line.branch, pair.branch) else { return None };
    let Shape::Straight { gamma, .. } = line.arcs[0].shape else { return None };
    let axis = (0..3).find(|&k| gamma[k] != 0.0)?;
    let d = frame.diff[i][axis];
    let settled = |order: Ordering| Some(PairOrder::constant(common, order));
    if d > 0.0 {
        return settled(Ordering::Greater);
    }
    match (pole, pair.ends) {
        // γ = −r̂ and the piece of the pair between cusp and pitchfork: below the line.
        (Pole::Minus, [End::Cusp(_), End::Pitchfork(_)]) => return settled(Ordering::Greater),
        // The piece beyond the cusp: below the line at first, then above.
        (Pole::Minus, [End::Cusp(_), _]) => {}
        _ => return settled(Ordering::Less),
    }
    let (a, k) = (frame.a[axis], -d);
    // √(a/k) − 1 without cancellation.
    let g = frame.a[i] / (k * ((a / k).sqrt() + 1.0));
    let moment = frame.a[i] + k * g * g;
    let x = 0.5 * frame.r[axis] / (k * g) * moment * moment;
    if x <= common[0] {
        return settled(Ordering::Less);
    }
    if x >= common[1] {
        return settled(Ordering::Greater);
    }
    let h = x / a + frame.r[axis];
    let crossing = PairCrossing { x, x_error: 32.0 * UNIT_ROUNDOFF * x, h, h_error: 40.0 * UNIT_ROUNDOFF * h };
    let mut order = PairOrder::default();
    order.push_crossing(common, Ordering::Greater, crossing);
    Some(order)
}
