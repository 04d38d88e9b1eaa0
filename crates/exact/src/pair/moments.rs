//! J and the slopes 1/J over a stretch: J is monotone except at one known place.
//!
//! The order of two families over passive moments where r lies on an axis: one family in the moment joins them (Lemma 7.7
//! of docs/algorithms.md), so nothing is evaluated and the two moments may be as close as they like.

use super::node::Node;
use crate::curves::{Curve, Place};
use crate::evaluator::{Evaluator, Point};
use crate::family::Half;
use bifdiag_equilibria::curves::{Branch, CurveId, End};
use bifdiag_numbers::Sign;
use bifdiag_numbers::enclosure::Enclosure;

impl<E: Enclosure> Evaluator<'_, E> {
    /// True when dJ/dμ may vanish between two points of one branch. `None` when that is not decided.
    pub(super) fn bends(&self, curve: CurveId, p: &Point<E>, q: &Point<E>) -> Option<bool> {
        let Some((_, place)) = &self.curves.inflection else { return Some(false) };
        let (p, q) = (p.place.as_ref()?, q.place.as_ref()?);
        let _ = curve;
        if matches!(p.0, Half::Over { .. }) {
            return Some(false);
        }
        let sides = [self.beyond(p, place), self.beyond(q, place)];
        Some(match sides {
            [Some(x), Some(y)] => x != y,
            _ => true,
        })
    }

    /// Whether a point of the generic family lies at larger μ than a place.
    fn beyond(&self, (half, y): &(Half, E), place: &Place) -> Option<bool> {
        let (Half::Generic { base: p, sign: s }, Half::Generic { base: q, sign: t }) = (*half, place.half) else {
            return None;
        };
        if (p, s) == (q, t) {
            let at = self.place(place);
            return if at.is_below(y) {
                Some(s == Sign::Positive)
            } else if y.is_below(&at) {
                Some(s == Sign::Negative)
            } else {
                None
            };
        }
        if p == q { Some(s > t) } else { Some(p > q) }
    }

    /// J between two points of one curve; to infinity when `to` is absent.
    fn moments(&self, curve: CurveId, from: &Point<E>, to: Option<&Point<E>>) -> Option<E> {
        let list = &self.curves.list[curve];
        let end = match (to, list.limit) {
            (Some(point), _) => point.over.j.clone(),
            (None, Some(limit)) => self.c.a[limit.group].clone(),
            (None, None) => return None,
        };
        let range = from.over.j.hull(&end);
        let Some((_, place)) = &self.curves.inflection else { return Some(range) };
        let start = from.place.as_ref()?;
        if matches!(start.0, Half::Over { .. }) {
            return Some(range);
        }
        let other = if let Some(point) = to {
            self.beyond(point.place.as_ref()?, place)
        } else {
            let limit = list.limit?;
            self.beyond(&(Half::Generic { base: limit.group, sign: limit.side }, self.c.small(0)), place)
        };
        // The inflection lies on another interval of the family, or beside the range: J is monotone there.
        match (self.beyond(start, place), other) {
            (Some(x), Some(y)) if x == y => Some(range),
            _ => Some(range.hull(&self.state(place.half, &self.place(place)).j)),
        }
    }

    /// Difference of the slopes between two nodes; to infinity when the second is absent.
    pub(super) fn slopes(&self, curves: [CurveId; 2], from: &Node<E>, to: Option<&Node<E>>) -> Option<E> {
        let range = |which: usize| {
            let j = self.moments(curves[which], &from.at[which], to.map(|node| &node.at[which]))?;
            Some(self.c.small(1) / j)
        };
        Some(range(0)? - range(1)?)
    }

    /// J is monotone from this point to infinity.
    pub(super) fn straight(&self, curve: CurveId, point: &Point<E>) -> bool {
        let Some((_, place)) = &self.curves.inflection else { return true };
        let (Some(start), Some(limit)) = (&point.place, self.curves.list[curve].limit) else { return false };
        if matches!(start.0, Half::Over { .. }) {
            return true;
        }
        let end = (Half::Generic { base: limit.group, sign: limit.side }, self.c.small(0));
        matches!((self.beyond(start, place), self.beyond(&end, place)), (Some(x), Some(y)) if x == y)
    }
}

impl<E: Enclosure> Evaluator<'_, E> {
    /// The sign of h_a − h_b over all of the common range, if r lies on an axis, both curves are families over moments on
    /// the same side of that axis' moment, and both are unbounded or neither is.
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
