//! The linear type along the curves of an atlas, and where it changes.

use bifdiag_diagram::atlas::{Atlas, Window};
use bifdiag_equilibria::curves::{CurveId, CurveName};
use bifdiag_equilibria::stability::LinearTypes;
use bifdiag_schema::{StabilityChangeDocument, StabilitySpan, UndecidedDocument};

use crate::critical::{change, stability};

/// What is known of the stability of a body's curves.
pub(super) struct Stability<'a> {
    atlas: &'a Atlas,
    types: LinearTypes<'a>,
}

impl<'a> Stability<'a> {
    pub fn new(atlas: &'a Atlas) -> Self {
        Self { atlas, types: LinearTypes::new(atlas.body(), &atlas.arrangement().set) }
    }

    /// The types along a curve; what is missing is entered as undecided.
    pub fn spans(&self, id: CurveId, undecided: &mut Vec<UndecidedDocument>) -> Vec<StabilitySpan> {
        let set = &self.atlas.arrangement().set;
        let Some(spans) = self.types.spans(id) else {
            let curve = &set.curves[id];
            let [from, to] = curve.x();
            let x = if to.is_finite() { 0.5 * (from + to) } else { 2.0 * from.max(1.0) };
            undecided.push(UndecidedDocument {
                what: "the stability along a curve: f64 does not count the cusps of its branch".to_owned(),
                l: self.atlas.momentum(x),
                h: self.atlas.energy(curve.point(&set.frame, x).h()),
                curves: vec![CurveName::of(set, id).to_string()],
            });
            return Vec::new();
        };
        let document = |span: &bifdiag_equilibria::stability::StabilitySpan| StabilitySpan {
            l_from: span.l_from,
            l_to: span.l_to,
            stability: stability(span.stability),
        };
        spans.iter().map(document).collect()
    }

    /// Every change of the linear type along a branch.
    pub fn changes(&self, window: Option<&Window>) -> Vec<StabilityChangeDocument> {
        let set = &self.atlas.arrangement().set;
        let changes = self.types.changes();
        let seen = changes.iter().filter(|found| window.is_none_or(|window| window.contains(found.h, found.l)));
        seen.map(|found| StabilityChangeDocument {
            l: found.l,
            h: found.h,
            curve: CurveName::of(set, found.curve).to_string(),
            onto: found.onto.map(|id| CurveName::of(set, id).to_string()),
            kind: change(found.kind),
            from: stability(found.from),
            to: stability(found.to),
            error_bound: found.error_bound,
        })
        .collect()
    }
}
