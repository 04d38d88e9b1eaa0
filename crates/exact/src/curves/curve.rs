//! A curve over which x is a coordinate, with the points at which curves end.

use super::place::Place;
use crate::family::Half;
use bifdiag_body::{Axis, Frame};
use bifdiag_equilibria::curves::{Branch, BranchName, CurveId, CurveName, End, Orbit, Pole};
use bifdiag_numbers::Sign;

/// Where a segment ends.
#[derive(Clone, Debug)]
pub(crate) enum Bound {
    /// y → 0: x → ∞ on the generic family, the pitchfork over a group without r.
    Zero,
    /// y → ∞: x → 0 on the generic family, x → ∞ over a group without r.
    Infinity,
    /// A cusp, a pitchfork, or the middle between two moments.
    At(Place),
}

/// A stretch of a piece on one half; x is monotone in y.
#[derive(Clone, Debug)]
pub(crate) struct Segment {
    pub half: Half,
    /// Ends by rising x.
    pub ends: [Bound; 2],
}

impl Segment {
    /// x rises with y.
    pub fn is_rising(&self) -> bool {
        match &self.ends {
            [Bound::Zero, _] | [_, Bound::Infinity] => true,
            [Bound::Infinity, _] | [_, Bound::Zero] => false,
            [Bound::At(from), Bound::At(to)] => from.lo < to.lo,
        }
    }

    /// Where h − x/a goes when the segment ends at infinity on the generic family.
    pub(super) fn limit(&self) -> Option<Limit> {
        match self.half {
            Half::Generic { base, sign } => Some(Limit { group: base, side: sign }),
            Half::Over { .. } => None,
        }
    }
}

/// A curve over which x is a coordinate.
#[derive(Clone, Debug)]
pub(crate) struct Curve {
    pub branch: Branch,
    /// Number of the piece on its branch, from 1, by rising parameter.
    pub piece: usize,
    pub orbit: Orbit,
    pub pole: Option<Pole>,
    pub shape: Shape,
    pub ends: [End; 2],
    /// The group at whose axis it ends for x → ∞.
    pub limit: Option<Limit>,
    /// μ ≥ the largest moment: the global minimum (see the module's head of `certified`).
    pub lowest: bool,
}

/// h − x/a → −`side`·√q for x → ∞.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Limit {
    pub group: usize,
    /// Positive at +e, negative at −e, zero for a group without r.
    pub side: Sign,
}

#[derive(Clone, Debug)]
pub(crate) enum Shape {
    /// By rising x.
    Family(Vec<Segment>),
    /// γ = ± r̂: h = x/J_r ∓ r.
    Pole(Pole),
    /// r = 0: h = x/a.
    Euler { group: usize },
}

/// Two curves end at a common point.
#[derive(Clone, Debug)]
pub(crate) struct Cusp {
    pub place: Place,
    pub curves: [CurveId; 2],
    /// The curves lie at larger x.
    pub opens: bool,
}

/// A pair (or circle) over a group leaves a curve.
#[derive(Clone, Debug)]
pub(crate) struct Pitchfork {
    pub group: usize,
    /// On the generic family; `None` when r lies on an axis.
    pub place: Option<Place>,
    /// The curve before and after, by rising x.
    pub through: [CurveId; 2],
    pub pair: CurveId,
    /// The pair lies at larger x.
    pub opens: bool,
}

impl Curve {
    /// Its name.
    pub fn name(&self, frame: &Frame) -> CurveName {
        CurveName::on(BranchName::of(frame, self.branch), self.piece)
    }
}

pub(super) fn orbit(size: usize, axis: Axis) -> Orbit {
    match size {
        1 => Orbit::Pair(axis),
        2 => Orbit::Circle(axis),
        _ => Orbit::Sphere,
    }
}
