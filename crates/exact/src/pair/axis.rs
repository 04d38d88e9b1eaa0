//! The order of two families over passive moments where r lies on an axis: one family in the moment joins them (Lemma 7.7
//! of docs/mathematics.md), so nothing is evaluated and the two moments may be as close as they like.

use crate::curves::Curve;
use crate::point::Evaluator;
use bifdiag_equilibria::curves::{Branch, CurveId, End};
use bifdiag_numbers::Sign;
use bifdiag_numbers::enclosure::Enclosure;

impl<E: Enclosure> Evaluator<'_, E> {
    /// The sign of h_a − h_b over all of the common range, if r lies on an axis, both curves are families over moments on
    /// the same side of that axis' moment, and both go on to infinity or neither does.
    pub(super) fn ordered_on_axis(&self, curves: [CurveId; 2]) -> Option<Sign> {
        let [active] = self.model.active[..] else { return None };
        let group = |curve: &Curve| match curve.branch {
            Branch::Symmetric(axis) => self.model.axis.iter().position(|&first| first == axis),
            _ => None,
        };
        let [a, b] = curves.map(|curve| &self.curves.list[curve]);
        let (p, q) = (group(a)?, group(b)?);
        let on_one_side = (p < active) == (q < active);
        let alike = (a.ends[1] == End::Infinity) == (b.ends[1] == End::Infinity);
        // The smaller moment lies higher.
        (p != q && on_one_side && alike).then_some(if p < q { Sign::Positive } else { Sign::Negative })
    }
}
