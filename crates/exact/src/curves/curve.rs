//! A curve over which x is a coordinate, with the points at which curves end.
//!
//! The curves of a body.
//!
//! Every curve of a body, once.

use super::place::{IsolationError, Place, ROOT_BITS};
use crate::family::Half;
use crate::model::Model;
use bifdiag_body::{Axis, Frame};
use bifdiag_equilibria::curves::{Branch, BranchName, CurveId, CurveName, CuspId, End, Orbit, PitchforkId, Pole};
use bifdiag_numbers::Sign;
use bifdiag_numbers::table::Table;

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

/// The curves of a body.
#[derive(Clone, Debug)]
pub(crate) struct Curves {
    pub list: Table<CurveId, Curve>,
    pub cusps: Table<CuspId, Cusp>,
    pub pitchforks: Table<PitchforkId, Pitchfork>,
    /// The one place where dJ/dμ = 0 on the generic family.
    pub inflection: Option<(usize, Place)>,
    /// Degenerate points that are no cusp (roots of even multiplicity) or that coincide with a pitchfork.
    pub degenerate: Vec<Place>,
}

impl Curves {
    /// The curves of a body, with the bits of a proof.
    pub fn of(model: &Model) -> Result<Self, IsolationError> {
        Self::new(model, ROOT_BITS)
    }

    /// Isolates all cusps (to `bits` bits) and cuts the families.
    pub fn new(model: &Model, bits: usize) -> Result<Self, IsolationError> {
        let mut curves = Self {
            list: Table::new(),
            cusps: Table::new(),
            pitchforks: Table::new(),
            inflection: None,
            degenerate: Vec::new(),
        };
        match model.active.len() {
            0 => curves.add_euler(model),
            1 => curves.add_lines(model),
            _ => curves.add_generic(model, bits)?,
        }
        curves.add_pairs(model);
        if model.active.len() > 1 {
            curves.add_pole_lines();
        }
        Ok(curves)
    }
}
