//! Orders that hold whatever the numbers are.

use std::cmp::Ordering;

use bifdiag_equilibria::curves::{Branch, Curve, End, IntervalId, Orbit, Pole};
use bifdiag_numbers::table::Id;

/// The order of a and b that holds by structure, whatever the rounding (Proposition 4.3 and Proposition 5.2).
///
/// - The piece that reaches +r̂ at l = 0 (μ above every moment) is the global minimum throughout.
/// - The piece of the leftmost interval that starts at −r̂ has slope above 1/J_r and starts on P−: it stays above P−.
/// - P− lies 2r above P+.
/// - A symmetric pair has a cusp only when R̂ < 0; then J = a_i − R̂/s² falls with s, and of the two arms that start at
///   the cusp the one that goes to s = ∞ has the larger slope 1/J: it lies above.
pub(super) fn structural_order(a: &Curve, b: &Curve) -> Option<Ordering> {
    let is_minimum =
        |c: &Curve| c.is_critical() && c.index == Some(0) && c.ends[0] == End::Origin && c.orbit == Orbit::Point;
    let leftmost = Branch::Generic(IntervalId::at(0));
    let from_south = |c: &Curve| c.branch == leftmost && c.ends[0] == End::Origin;
    let line = |c: &Curve| match c.orbit {
        Orbit::Pole(pole) => Some(pole),
        _ => None,
    };
    if is_minimum(a) {
        return Some(Ordering::Less);
    }
    if is_minimum(b) {
        return Some(Ordering::Greater);
    }
    // The arms of a symmetric pair's cusp share the family on which J falls towards infinity.
    if let (Branch::Symmetric(i), Branch::Symmetric(j)) = (a.branch, b.branch) {
        let born_together = matches!(a.ends[0], End::Cusp(_)) && a.ends[0] == b.ends[0];
        if i == j && born_together {
            return match (a.ends[1], b.ends[1]) {
                (End::Infinity, _) => Some(Ordering::Greater),
                (_, End::Infinity) => Some(Ordering::Less),
                _ => None,
            };
        }
    }
    match (line(a), line(b)) {
        (Some(Pole::Plus), Some(Pole::Minus)) => Some(Ordering::Less),
        (Some(Pole::Minus), Some(Pole::Plus)) => Some(Ordering::Greater),
        (Some(Pole::Minus), None) if from_south(b) => Some(Ordering::Less),
        (None, Some(Pole::Minus)) if from_south(a) => Some(Ordering::Greater),
        _ => None,
    }
}
