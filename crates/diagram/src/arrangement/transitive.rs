//! Orders that follow from other orders: a below c and c below b.

use std::cmp::Ordering;

use super::order::PairOrder;
use bifdiag_equilibria::curves::{CriticalSet, CurveId};

/// Two curves by number, and what is proved of their order.
#[derive(Clone, Debug)]
pub(super) struct ProvedPair {
    pub curves: [CurveId; 2],
    pub order: PairOrder,
}

/// Closes the open ranges of pairs between which a third curve is proved to lie.
pub(super) fn resolve(set: &CriticalSet, pairs: &mut [ProvedPair]) {
    let open: Vec<usize> = (0..pairs.len()).filter(|&k| pairs[k].order.is_open()).collect();
    for k in open {
        let curves = pairs[k].curves;
        let mut order = std::mem::take(&mut pairs[k].order);
        order.fill(|range| through_others(set, pairs, curves, range));
        pairs[k].order = order;
    }
}

/// The order of a and b on a range, from a curve that lies between the two all along it.
fn through_others(set: &CriticalSet, pairs: &[ProvedPair], [a, b]: [CurveId; 2], range: [f64; 2]) -> Option<Ordering> {
    let order = |p: CurveId, q: CurveId| proved(pairs, p, q, range);
    set.curves.ids().filter(|&c| c != a && c != b).find_map(|c| {
        let [from, to] = set.curves[c].x();
        if from > range[0] || to < range[1] {
            return None;
        }
        let first = order(a, c)?;
        (order(c, b) == Some(first)).then_some(first)
    })
}

/// The order of p and q all along a range, if proved.
pub(super) fn proved(pairs: &[ProvedPair], p: CurveId, q: CurveId, range: [f64; 2]) -> Option<Ordering> {
    let pair = pairs.iter().find(|pair| pair.curves == [p.min(q), p.max(q)])?;
    pair.order.order_on(range).map(|order| if p < q { order } else { order.reverse() })
}
