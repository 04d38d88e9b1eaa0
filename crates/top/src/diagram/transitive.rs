//! Orders that follow from other orders: a below c and c below b.

use super::order::PairOrder;
use crate::curves::CriticalSet;

/// Closes the open ranges of pairs between which a third curve is proved to lie.
pub(super) fn resolve(set: &CriticalSet, pairs: &mut [(usize, usize, PairOrder)]) {
    let open: Vec<usize> = (0..pairs.len()).filter(|&k| pairs[k].2.is_open()).collect();
    for k in open {
        let (a, b) = (pairs[k].0, pairs[k].1);
        let mut order = std::mem::take(&mut pairs[k].2);
        order.fill(|range| sign_through_others(set, pairs, [a, b], range));
        pairs[k].2 = order;
    }
}

/// Sign of h_a − h_b on a range, from a curve that lies between the two all along it.
fn sign_through_others(
    set: &CriticalSet,
    pairs: &[(usize, usize, PairOrder)],
    [a, b]: [usize; 2],
    range: [f64; 2],
) -> Option<i8> {
    let sign = |p: usize, q: usize| proved(pairs, p, q, range);
    (0..set.curves.len()).filter(|&c| c != a && c != b).find_map(|c| {
        let [from, to] = set.curves[c].x();
        if from > range[0] || to < range[1] {
            return None;
        }
        let first = sign(a, c)?;
        (sign(c, b) == Some(first)).then_some(first)
    })
}

/// Sign of h_p − h_q all along a range, if proved.
pub(super) fn proved(pairs: &[(usize, usize, PairOrder)], p: usize, q: usize, range: [f64; 2]) -> Option<i8> {
    let (low, high, flip) = if p < q { (p, q, 1) } else { (q, p, -1) };
    let (_, _, order) = pairs.iter().find(|(i, j, _)| (*i, *j) == (low, high))?;
    order.sign_on(range).map(|sign| flip * sign)
}
