//! Two curves over one x with all bits: the gap of curves far above it, of which doubles tell nothing.

use dashu_ratio::RBig;

use super::equilibria::Point;
use super::fixed::Fixed;
use super::orders::Orders;
use super::pieces::{Branch, End};
use super::plane::Plane;

/// Newton steps at most towards an x, and the share of it at which they end.
const STEPS: usize = 6;
const NEAR: f64 = 1e-45;
/// An x is that of an end of a curve within this share.
const SAME: f64 = 8.0 * f64::EPSILON;

/// Two curves, the lower one first.
pub(super) struct Heights<'a> {
    orders: &'a Orders<'a>,
    plane: &'a Plane<'a>,
    curves: [usize; 2],
    /// Where each of them ends.
    ends: [Vec<Point>; 2],
}

/// Both curves over one x.
#[derive(Debug)]
pub(super) struct Exact {
    /// The double that was asked for, or the end of a curve next to it.
    pub x: Fixed,
    pub h: [Fixed; 2],
    /// dh/dx = 1/J.
    pub slopes: [Fixed; 2],
}

/// The length of a set, as a double.
fn length(set: &Fixed) -> f64 {
    (&set.upper() - &set.lower()).to_f64()
}

fn is_at(point: &Point, x: f64) -> bool {
    (point.x.to_f64() - x).abs() <= SAME * x
}

impl<'a> Heights<'a> {
    pub fn new(orders: &'a Orders<'a>, plane: &'a Plane<'a>, curves: [usize; 2]) -> Self {
        let end = |curve, side| orders.pieces.end_point(orders.spaces, curve, side);
        let ends = curves.map(|curve| [0, 1].into_iter().filter_map(|side| end(curve, side)).collect());
        Self { orders, plane, curves, ends }
    }

    pub fn over(&self, x: f64) -> Option<Exact> {
        let exactly = match self.ends.iter().flatten().find(|end| is_at(end, x)) {
            Some(end) => end.x.clone(),
            None => self.orders.spaces.set(&RBig::try_from(x).ok()?),
        };
        let [low, high] = [0, 1].map(|which| self.tangent(which, x, &exactly));
        let ([low, to_right], [high, right]) = (low?, high?);
        Some(Exact { x: exactly, h: [low, high], slopes: [to_right, right] })
    }

    /// h of a curve over x, and 1/J. The potential of the equilibrium next to x is the tangent, which leaves the curve by no
    /// more than 1/a of the distance with the least moment a.
    fn tangent(&self, which: usize, near: f64, x: &Fixed) -> Option<[Fixed; 2]> {
        let spaces = self.orders.spaces;
        let piece = &self.orders.pieces.list[self.curves[which]];
        if near == 0.0 && piece.ends.contains(&End::Origin) {
            // A vertical axis along r: the families begin at h = |r| and at h = −|r|.
            let is_highest = matches!(piece.branch, Branch::Generic(0) | Branch::Line(false));
            let h = if is_highest { spaces.norm.clone() } else { -&spaces.norm };
            return Some([h, Fixed::whole(1).over(&spaces.set(&spaces.j_r()))?]);
        }
        let point = match piece.branch {
            Branch::Line(plus) => spaces.line(plus, x)?,
            Branch::Rotation(base) => spaces.rotation(base, x),
            Branch::Generic(_) | Branch::Over(_) => match self.ends[which].iter().find(|end| is_at(end, near)) {
                Some(end) => end.clone(),
                None => self.approached(self.curves[which], near, x)?,
            },
        };
        let aside = (x - &point.x).over(&spaces.list[0].a_set)?;
        let room = aside.hull(&-&aside);
        let h = &(&x.over(&point.j)? - &point.rho) + &room;
        Some([h, Fixed::whole(1).over(&point.j)?])
    }

    /// An equilibrium of a curve over x, or as near as the steps lead.
    fn approached(&self, curve: usize, near: f64, x: &Fixed) -> Option<Point> {
        let Orders { spaces, pieces, .. } = *self.orders;
        let (base, side, y) = self.plane.traces.place(spaces, pieces, curve, near)?;
        let mut y = spaces.set(&RBig::try_from(y).ok()?);
        let mut point = spaces.point(base, side, &y)?;
        for _ in 0..STEPS {
            let aside = &point.x - x;
            if aside.to_f64().abs() <= NEAR * near {
                break;
            }
            let [log_slope, _] = point.slopes.as_ref()?;
            y = (&y - &aside.over(&(&point.x * log_slope))?).middle();
            point = spaces.point(base, side, &y)?;
        }
        Some(point)
    }
}

impl Exact {
    pub fn gap(&self) -> f64 {
        (&self.h[1] - &self.h[0]).to_f64()
    }

    /// How far a gap here may be from that of the curves over the double next to this x.
    pub fn rounding(&self) -> f64 {
        let turn = (&self.slopes[1] - &self.slopes[0]).to_f64().abs();
        self.h.iter().map(length).sum::<f64>() + SAME * (self.x.to_f64() * turn + self.gap().abs())
    }

    /// h − h₀ − (x − x₀)·s of both curves, with h₀ and s of the lower curve over x₀.
    pub fn above(&self, first: &Self) -> [f64; 2] {
        let line = &first.h[0] + &(&(&self.x - &first.x) * &first.slopes[0]);
        self.h.each_ref().map(|h| (h - &line).to_f64())
    }

    /// 1/J − s of both curves.
    pub fn steeper(&self, first: &Self) -> [f64; 2] {
        self.slopes.each_ref().map(|slope| (slope - &first.slopes[0]).to_f64())
    }

    /// h − x/a of both curves.
    pub fn above_axis(&self, a: &Fixed) -> Option<[f64; 2]> {
        let kinetic = self.x.over(a)?;
        Some(self.h.each_ref().map(|h| (h - &kinetic).to_f64()))
    }
}
