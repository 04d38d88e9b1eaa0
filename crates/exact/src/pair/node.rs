//! Both curves of a pair over one x.
//!
//! What is proved of a pair of curves.

use crate::evaluator::{Evaluator, Point};
use crate::plane::rounded;
use bifdiag_equilibria::curves::CurveId;
use bifdiag_numbers::Sign;
use bifdiag_numbers::enclosure::Enclosure;
use dashu_ratio::RBig;

/// Both curves over one x.
#[derive(Clone, Debug)]
pub(super) struct Node<E: Enclosure> {
    pub x: E,
    /// One of the two curves ends here.
    pub is_end: bool,
    pub at: [Point<E>; 2],
    pub sign: Option<Sign>,
    pub gap: E,
}

impl<E: Enclosure> Node<E> {
    pub(super) fn mark(&self) -> StretchEnd {
        let at = self.x.exact_bounds().filter(|_| !self.is_end);
        at.map_or(StretchEnd::End, |[at, _]| StretchEnd::At(at))
    }
}

impl<E: Enclosure> Evaluator<'_, E> {
    pub(super) fn node_of(&self, x: E, is_end: bool, at: [Point<E>; 2]) -> Node<E> {
        let gap = self.gap(&at[0], &at[1]);
        Node { x, is_end, sign: gap.sign(), gap, at }
    }

    /// A node at which the curves are known to meet.
    pub(super) fn meeting(&self, node: Node<E>) -> Node<E> {
        Node { sign: Some(Sign::Zero), gap: self.c.small(0), ..node }
    }

    /// The node over this x.
    pub(super) fn node(&self, curves: [CurveId; 2], x: &E) -> Option<Node<E>> {
        let at = [self.point(curves[0], x)?, self.point(curves[1], x)?];
        Some(self.node_of(x.clone(), false, at))
    }

    /// The node over a number with few bits near low + t (high − low).
    pub(super) fn node_within(&self, curves: [CurveId; 2], low: &E, high: &E, t: f64) -> Option<Node<E>> {
        self.node(curves, &self.place_within(low, high, t)?)
    }

    /// A number with few bits near low + t (high − low), strictly between the two and not much nearer to either.
    fn place_within(&self, low: &E, high: &E, t: f64) -> Option<E> {
        let precision = self.c.precision;
        let place = (low.clone() + (high.clone() - low.clone()) * E::double(t, precision)).middle();
        let double = place.bounds().into_iter().sum::<f64>() * 0.5;
        let few = E::double(few_bits(double), precision);
        let inside = |x: &E| (low.is_below(x) && x.is_below(high)) || (high.is_below(x) && x.is_below(low));
        let size = |difference: E| difference.bounds().map(f64::abs).into_iter().fold(0.0, f64::max);
        let room = size(place.clone() - low.clone()).min(size(high.clone() - place.clone()));
        if inside(&few) && 2.0 * size(few.clone() - place.clone()) < room {
            return Some(few);
        }
        let short = place.exact_bounds().zip(low.exact_bounds().zip(high.exact_bounds()));
        let short = short.map(|([place, _], ([low, _], [high, _]))| {
            let room = [&place - low, high - &place].map(|d| if d < RBig::ZERO { -d } else { d });
            let room = room.into_iter().min().unwrap_or(RBig::ONE);
            E::rational(&rounded(place, &room), precision)
        });
        let is_point = |x: &E| x.exact_bounds().is_some_and(|[lo, hi]| lo == hi);
        short.into_iter().chain([place]).find(|x| is_point(x) && inside(x))
    }
}

/// A double near this one with few bits.
pub(super) fn few_bits(x: f64) -> f64 {
    const DROPPED: u32 = 30;
    f64::from_bits((x.to_bits() >> DROPPED) << DROPPED)
}

/// How many points of curves the order of two curves may cost in one precision: a count of work, so that the answer does
/// not depend on the machine.
pub(crate) const POINTS: u32 = 4000;

/// What ends a stretch.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum StretchEnd {
    /// The lower or upper end of the common range.
    End,
    /// This x.
    At(RBig),
}

/// A stretch with a proved sign of h_a − h_b, or with one crossing.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Stretch {
    pub x: [StretchEnd; 2],
    /// Sign at the lower end.
    pub sign: Sign,
    pub proof: Proof,
}

#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Proof {
    /// One sign all along.
    Constant,
    /// The gap is monotone and vanishes once, between these two.
    Crossing([RBig; 2]),
}

/// Everything about one pair.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct PairProof {
    pub curves: [CurveId; 2],
    pub stretches: Vec<Stretch>,
}

/// What was not proved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Open {
    pub x: [f64; 2],
}
