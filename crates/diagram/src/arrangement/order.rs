//! The order of two curves over their common range of x: where it is proved, where it changes, where it is open.
//!
//! Orders that follow from other orders: a below c and c below b.

use std::cmp::Ordering;

use bifdiag_equilibria::curves::{CriticalSet, CurveId};

/// A transversal crossing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PairCrossing {
    /// x = l²/2.
    pub x: f64,
    /// Bound on the error of `x`.
    pub x_error: f64,
    /// h.
    pub h: f64,
    /// Bound on the error of `h`.
    pub h_error: f64,
}

/// A range of x with the order of a and b all along it, if proved.
#[derive(Clone, Copy, Debug, PartialEq)]
struct OrderedRange {
    x: [f64; 2],
    order: Option<Ordering>,
}

/// What is proved of the order of two curves a and b, by rising x.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PairOrder {
    stretches: Vec<OrderedRange>,
    located: Vec<PairCrossing>,
    /// Points of curves that were computed.
    pub evaluations: u32,
}

impl PairOrder {
    /// One order all along.
    pub(super) fn constant(x: [f64; 2], order: Ordering) -> Self {
        Self { stretches: vec![OrderedRange { x, order: Some(order) }], ..Self::default() }
    }

    /// Adds the next range.
    pub(super) fn push(&mut self, x: [f64; 2], order: Option<Ordering>) {
        self.stretches.push(OrderedRange { x, order });
    }

    /// Adds the next range, in which the order changes once, from `before`.
    pub(super) fn push_crossing(&mut self, x: [f64; 2], before: Ordering, crossing: PairCrossing) {
        self.push([x[0], crossing.x], Some(before));
        self.push([crossing.x, x[1]], Some(before.reverse()));
        self.located.push(crossing);
    }

    /// Joins the order on the next pair of arcs.
    pub(super) fn append(&mut self, next: Self) {
        self.stretches.extend(next.stretches);
        self.located.extend(next.located);
        self.evaluations += next.evaluations;
    }

    /// True when some range is open.
    pub(super) fn is_open(&self) -> bool {
        self.stretches.iter().any(|stretch| stretch.order.is_none())
    }

    /// The order all along a range, if proved.
    pub(super) fn order_on(&self, x: [f64; 2]) -> Option<Ordering> {
        let mut inside = self.stretches.iter().filter(|s| s.x[0] < x[1] && s.x[1] > x[0]);
        let first = inside.next()?.order?;
        inside.all(|s| s.order == Some(first)).then_some(first)
    }

    /// Fills open ranges with what is known from elsewhere.
    pub(super) fn fill(&mut self, known: impl Fn([f64; 2]) -> Option<Ordering>) {
        for stretch in self.stretches.iter_mut().filter(|stretch| stretch.order.is_none()) {
            stretch.order = known(stretch.x);
        }
    }

    /// The order just right of the lower end of the common range; the first proved one when that is open.
    #[must_use]
    pub fn initial(&self) -> Ordering {
        self.stretches.iter().find_map(|stretch| stretch.order).unwrap_or(Ordering::Greater)
    }

    /// Crossings by rising x. Where an open range separates opposite orders there is at least one crossing: its
    /// position is the middle of the range, with half its width as the error; `height` gives h and its error bound at
    /// x.
    #[must_use]
    pub fn crossings(&self, height: impl Fn(f64) -> (f64, f64)) -> Vec<PairCrossing> {
        let mut found = Vec::new();
        let mut last: Option<(Ordering, f64)> = None;
        for OrderedRange { x, order } in &self.stretches {
            let Some(order) = *order else { continue };
            if let Some((_, at)) = last.filter(|(before, _)| *before != order) {
                let located = self.located.iter().find(|crossing| crossing.x == at && at == x[0]);
                found.push(located.copied().unwrap_or_else(|| {
                    let middle = 0.5 * (at + x[0]);
                    let (h, h_error) = height(middle);
                    PairCrossing { x: middle, x_error: x[0] - middle, h, h_error }
                }));
            }
            last = Some((order, x[1]));
        }
        found
    }

    /// Ranges in which rounding hides the order; neighbouring ones are joined.
    #[must_use]
    pub fn open_ranges(&self) -> Vec<[f64; 2]> {
        let mut ranges: Vec<[f64; 2]> = Vec::new();
        for stretch in self.stretches.iter().filter(|stretch| stretch.order.is_none()) {
            match ranges.last_mut() {
                Some(range) if range[1] == stretch.x[0] => range[1] = stretch.x[1],
                _ => ranges.push(stretch.x),
            }
        }
        ranges
    }
}

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

#[cfg(test)]
mod tests {
    use super::*;
    use Ordering::{Greater, Less};

    #[test]
    fn opposite_orders_around_an_open_range_are_one_crossing() {
        let mut order = PairOrder::constant([0.0, 1.0], Less);
        order.push([1.0, 1.5], None);
        order.push([1.5, 2.0], None);
        order.push([2.0, 4.0], Some(Greater));
        let crossings = order.crossings(|x| (x, 0.1));
        assert_eq!(crossings, [PairCrossing { x: 1.5, x_error: 0.5, h: 1.5, h_error: 0.1 }]);
        assert_eq!(order.open_ranges(), [[1.0, 2.0]]);
        assert_eq!(
            (order.initial(), order.order_on([1.2, 3.0]), order.order_on([2.5, 3.0])),
            (Less, None, Some(Greater))
        );
    }

    #[test]
    fn a_range_filled_from_elsewhere_is_no_longer_open() {
        let mut order = PairOrder::constant([0.0, 1.0], Greater);
        order.push([1.0, 2.0], None);
        order.fill(|_| Some(Greater));
        assert!(!order.is_open());
        assert!(order.crossings(|x| (x, 0.0)).is_empty());
    }
}
