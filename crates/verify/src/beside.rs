//! How far two curves side by side are apart over a range of x, by bounds that do not widen with it as those of chords do.

use dashu_ratio::RBig;

use super::equilibria::Point;
use super::fixed::Fixed;
use super::mirror::{self, Both};
use super::node::coordinate;
use super::orders::Orders;
use super::pieces::Branch;
use super::plane::{POINT, Plane};
use super::rules;

/// Two curves, the lower one first.
pub(super) struct Beside<'a> {
    pub orders: &'a Orders<'a>,
    pub plane: &'a Plane<'a>,
    pub curves: [usize; 2],
}

impl Beside<'_> {
    /// The gap is at most this between two x, or from one to infinity.
    pub fn largest_gap(&self, first: f64, last: Option<f64>) -> f64 {
        let mirrored = self.mirrored(first, last).map_or(f64::INFINITY, |gap| gap.to_f64());
        let joint = last.and_then(|last| self.joint(first, last)).map_or(f64::INFINITY, |gap| gap.to_f64());
        mirrored.min(joint)
    }

    /// On both sides of one moment, by the family that joins the curves (Lemma 7.5, Lemma 7.6).
    fn mirrored(&self, first: f64, last: Option<f64>) -> Option<Fixed> {
        let [p, q] = self.curves.map(|curve| self.orders.pieces.list[curve].branch);
        if !matches!((p, q), (Branch::Generic(p), Branch::Generic(q)) if p.abs_diff(q) == 1) {
            return None;
        }
        let last = match last {
            Some(x) => Some(self.both(x)?),
            None => None,
        };
        mirror::largest_gap(self.orders, self.curves, &self.both(first)?, last.as_ref())
    }

    /// Both curves over one x with all bits.
    fn both(&self, x: f64) -> Option<Both> {
        let [low, high] = self.curves.map(|curve| self.exactly(curve, x));
        let (low, high) = (low?, high?);
        let near = |point: &Point| (point.x.to_f64() - x).abs() <= POINT * x;
        (near(&low) && near(&high)).then(|| (low.x.hull(&high.x), [low, high]))
    }

    fn exactly(&self, curve: usize, x: f64) -> Option<Point> {
        let Orders { spaces, pieces, .. } = *self.orders;
        self.plane.traces.exactly(spaces, pieces, curve, x)
    }

    /// From all equilibria of both curves over the range, of which those over one x are compared (Lemma 7.8).
    fn joint(&self, first: f64, last: f64) -> Option<Fixed> {
        let [first, last] = [first * (1.0 - 2.0 * POINT), last * (1.0 + 2.0 * POINT)];
        let range = |curve: usize| {
            let y = self.end(curve, first, 0)?.hull(&self.end(curve, last, 1)?);
            rules::over(self.orders, curve, &y)
        };
        let (low, high) = (range(self.curves[0])?, range(self.curves[1])?);
        let [_, gap] = self.orders.spaces.over_one_x(&high, &low)?;
        let x = self.orders.spaces.set(&RBig::try_from(last).ok()?);
        let gap = (&x * &gap).upper();
        gap.is_positive().then_some(gap)
    }

    /// The coordinate of a curve next to x: before it for the first end of a range, behind it for the last, or where the curve
    /// begins or ends.
    fn end(&self, curve: usize, x: f64, side: usize) -> Option<Fixed> {
        let Orders { spaces, pieces, .. } = *self.orders;
        let bound = spaces.set(&RBig::try_from(if side == 0 { x * (1.0 + POINT) } else { x * (1.0 - POINT) }).ok()?);
        let beyond = |point: &Point| if side == 0 { point.x.below(&bound) } else { bound.below(&point.x) };
        match self.exactly(curve, x).filter(beyond) {
            Some(point) => coordinate(self.orders, curve, &point),
            None => coordinate(self.orders, curve, &pieces.end_point(spaces, curve, side)?),
        }
    }
}
