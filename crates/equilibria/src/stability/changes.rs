//! Changes of the linear type along curves, however they are found.

use bifdiag_schema::StabilityChangeKind;

use super::LinearType;
use crate::curves::CurveId;

/// A point of a branch at which the linear type changes. In the body's units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StabilityChange {
    /// Vertical angular momentum.
    pub l: f64,
    /// Energy.
    pub h: f64,
    /// Bound on the error of both.
    pub error_bound: f64,
    /// The curve on which it lies; at a cusp or pitchfork the first of the two.
    pub curve: CurveId,
    /// The curve that continues after a cusp or pitchfork.
    pub onto: Option<CurveId>,
    /// Which eigenvalues meet.
    pub kind: StabilityChangeKind,
    /// The type before: at smaller l, or on `curve`.
    pub from: LinearType,
    /// The type after: at larger l, or on `onto`.
    pub to: LinearType,
}

/// A stretch of a curve with one linear type.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StabilitySpan {
    /// From this l …
    pub l_from: f64,
    /// … to this l; `None`: to infinity.
    pub l_to: Option<f64>,
    /// The type there.
    pub stability: LinearType,
}

/// One curve, by rising x: the type at its start and the changes on it; nothing of a pole line.
#[derive(Clone, Debug, Default)]
pub(super) struct Along {
    pub first: Option<LinearType>,
    pub turns: Vec<Turn>,
}

/// A change of the type inside a curve.
#[derive(Clone, Copy, Debug)]
pub(super) struct Turn {
    /// l and h in the body's units, each with a bound on its error.
    pub place: [(f64, f64); 2],
    pub from: LinearType,
    pub to: LinearType,
    pub kind: StabilityChangeKind,
}

impl Along {
    /// The type at the end of larger x.
    pub fn last(&self) -> Option<LinearType> {
        self.turns.last().map(|turn| turn.to).or(self.first)
    }

    /// The types between both ends of the curve, given in l.
    pub fn spans(&self, [from, to]: [f64; 2]) -> Vec<StabilitySpan> {
        let Some(first) = self.first else { return Vec::new() };
        let starts: Vec<(f64, LinearType)> =
            std::iter::once((from, first)).chain(self.turns.iter().map(|turn| (turn.place[0].0, turn.to))).collect();
        let ends = starts[1..].iter().map(|(l, _)| Some(*l)).chain([to.is_finite().then_some(to)]);
        let span = |(&(l_from, stability), l_to)| StabilitySpan { l_from, l_to, stability };
        starts.iter().zip(ends).map(span).collect()
    }
}

impl Turn {
    /// The same change, seen the other way.
    pub fn reversed(self) -> Self {
        Self { from: self.to, to: self.from, ..self }
    }

    /// The change on a curve; with `onto` where the curve goes over into that one.
    pub fn on(&self, curve: CurveId, onto: Option<CurveId>) -> StabilityChange {
        let Self { place: [(l, l_error), (h, h_error)], from, to, kind } = *self;
        StabilityChange { l, h, error_bound: l_error.max(h_error), curve, onto, kind, from, to }
    }
}
