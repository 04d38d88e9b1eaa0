//! How far a curve leaves the chord between two of its points.

use super::interval::Interval;
use super::orders::Orders;
use super::plane::{Near, POINT, Plane};

/// A chord is halved so many times before its curve is said to leave it.
const HALVINGS: u32 = 8;

/// The chords of curves in the plane of h and l.
pub(super) struct Chords<'a> {
    plane: &'a Plane<'a>,
    /// Where J turns on each curve.
    turns: Vec<Option<Turn>>,
}

/// Where J turns along a curve: x, and the slope 1/J there.
struct Turn {
    x: [f64; 2],
    slope: f64,
}

/// A point of a curve over l.
#[derive(Clone, Copy)]
struct At {
    l: f64,
    near: Near,
}

impl<'a> Chords<'a> {
    pub fn new(plane: &'a Plane<'a>, orders: &Orders) -> Self {
        let turn = |curve: usize| {
            let point = orders.turn_on(curve)?;
            Some(Turn { x: Interval::of(&point.x).ends(), slope: Interval::of(&point.j).recip().middle() })
        };
        Self { plane, turns: (0..orders.pieces.list.len()).map(turn).collect() }
    }

    /// Between two l, over which the curve is `off` by so much in h, it leaves a chord by at most so much, all in the units of the
    /// document.
    pub fn hold(&self, curve: usize, ends: [f64; 2], off: [f64; 2], most: f64) -> bool {
        let at = |l: f64| Some(At { l, near: self.plane.over(curve, l)? });
        let [Some(from), Some(to)] = ends.map(at) else { return false };
        let energy = self.plane.energy;
        self.halved(curve, [from, to], off.map(|off| off / energy), most / energy, HALVINGS)
    }

    /// Likewise for a part of the chord, at whose ends the curve is `off` from the whole: between them it is not further off
    /// than there and from the chord of the part.
    fn halved(&self, curve: usize, [from, to]: [At; 2], off: [f64; 2], most: f64, halvings: u32) -> bool {
        let here = off[0].abs().max(off[1].abs());
        if here + self.sagitta(curve, [from, to]) <= most {
            return true;
        }
        let l = 0.5 * (from.l + to.l);
        if halvings == 0 || here > most || !(from.l < l && l < to.l) {
            return false;
        }
        let Some(near) = self.plane.near(curve, self.plane.abscissa(l)) else { return false };
        let middle = At { l, near };
        let straight = 0.5 * (from.near.h.middle() - off[0] + to.near.h.middle() - off[1]);
        let aside = near.h.middle() - straight;
        self.halved(curve, [from, middle], [off[0], aside], most, halvings - 1)
            && self.halved(curve, [middle, to], [aside, off[1]], most, halvings - 1)
    }

    /// A bound on the distance in h of the curve from its chord.
    ///
    /// Over x the slope is 1/J, and J is monotone (Proposition 3.8): the curve lies between the chord over x and its two
    /// tangents at the ends, which meet at w a b/(a + b) from the chord with the width w and the differences a, b of slopes. The
    /// chord over x lies below that over l, by slope (Δl)²/8. On both sides of the place where J turns J lies between its values
    /// at the ends and there.
    fn sagitta(&self, curve: usize, [from, to]: [At; 2]) -> f64 {
        let x = [from, to].map(|at| self.plane.abscissa(at.l));
        let width = x[1] - x[0];
        if width <= 0.0 {
            return 0.0;
        }
        let room = from.near.room + to.near.room;
        let slope = (to.near.h.middle() - from.near.h.middle()) / width;
        let slopes = [from, to].map(|at| at.near.j.recip().middle());
        let length = to.l - from.l;
        let bow = (slope.abs() + room / width) * 0.25 * self.plane.abscissa(length);
        let apart = |other: f64| (other - slope).abs() + POINT * other.abs() + room / width;
        let turn = self.turns[curve].as_ref().filter(|turn| {
            let aside = POINT * x[1];
            turn.x[0] <= x[1] + aside && x[0] - aside <= turn.x[1]
        });
        if let Some(turn) = turn {
            let all = [slopes[0], slopes[1], turn.slope];
            let [low, high] =
                [all.iter().copied().fold(f64::INFINITY, f64::min), all.iter().copied().fold(0.0, f64::max)];
            return 0.25 * width * apart(high).max(apart(low)).min(high - low + POINT * high)
                + bow
                + room
                + 0.25 * width * (high - low);
        }
        let [a, b] = slopes.map(apart);
        let apex = width * a * b / (a + b);
        (if slopes[0] < slopes[1] { apex + bow } else { apex.max(bow) }) + room
    }
}
