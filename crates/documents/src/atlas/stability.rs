//! The linear type along the curves of an atlas, and where it changes.

use std::cell::OnceCell;

use bifdiag_diagram::atlas::{Atlas, Window};
use bifdiag_equilibria::critical::RelativeEquilibria;
use bifdiag_equilibria::curves::{CurveId, CurveName};
use bifdiag_equilibria::nonlinear::{Setting, VerdictChange, Verdicts};
use bifdiag_equilibria::stability::LinearTypes;
use bifdiag_numbers::Number;
use bifdiag_schema::{
    FrictionDocument, NonlinearDocument, NonlinearVerdict, Reason, StabilityChangeDocument, StabilitySpan,
    UndecidedDocument, VerdictChangeDocument,
};

use crate::stability::damped;

/// What is known of the stability of a body's curves.
pub(super) struct Stability<'a> {
    atlas: &'a Atlas,
    types: LinearTypes<'a>,
    /// Made where a normal form decides.
    equilibria: OnceCell<Option<RelativeEquilibria<'a>>>,
}

/// Places on a stretch, relative to its length or, without end, its beginning.
const INSIDE: [f64; 3] = [0.5, 0.41, 0.63];

impl<'a> Stability<'a> {
    pub fn new(atlas: &'a Atlas) -> Self {
        let types = LinearTypes::new(atlas.body(), &atlas.arrangement().set);
        Self { atlas, types, equilibria: OnceCell::new() }
    }

    fn equilibria(&self) -> Option<&RelativeEquilibria<'a>> {
        self.equilibria.get_or_init(|| RelativeEquilibria::new(self.atlas.body()).ok()).as_ref()
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
        let Some(setting) = Setting::along(set, &set.curves[id]) else { return Vec::new() };
        let document = |span: &bifdiag_equilibria::stability::StabilitySpan| {
            let known =
                setting.verdict(span.stability).map(|(verdict, why)| NonlinearDocument::along(verdict, why, true));
            let inside = || self.inside(id, [span.l_from, span.l_to.unwrap_or(f64::INFINITY)]);
            StabilitySpan {
                l_from: span.l_from,
                l_to: span.l_to,
                stability: span.stability.term(),
                nonlinear: known.unwrap_or_else(inside),
                friction: FrictionDocument {
                    conserving_l: Some(damped(setting.index == 0)),
                    growing: setting.index,
                    rates: Vec::new(),
                },
            }
        };
        spans.iter().map(document).collect()
    }

    /// The verdict along a stretch of a curve with two imaginary pairs at index 2: that at one point, since D₄ is an analytic
    /// function along the curve, which vanishes at isolated points only.
    fn inside(&self, id: CurveId, [from, to]: [f64; 2]) -> NonlinearDocument {
        let name = CurveName::of(&self.atlas.arrangement().set, id);
        let points = INSIDE.iter().filter_map(|part| {
            let l = if to.is_finite() { from + part * (to - from) } else { (from + self.atlas.momentum(1.0)) / part };
            self.equilibria()?.verdict_on(name, &Number::from_f64(l).ok()?).ok()?
        });
        let mut first = None;
        let found = points.inspect(|found| first = first.or(Some(*found))).find(|found| found.why == Reason::Arnold);
        let (verdict, why) =
            found.or(first).map_or((NonlinearVerdict::Open, Reason::Degenerate), |at| (at.verdict, at.why));
        NonlinearDocument::along(verdict, why, found.is_some_and(|found| found.proved))
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
            kind: found.kind,
            from: found.from.term(),
            to: found.to.term(),
            error_bound: found.error_bound,
        })
        .collect()
    }
}

/// Every isolated point of the curves at which a hypothesis of Arnold's theorem fails, by rising l, then h; `None` where not all
/// of them were found.
#[must_use]
pub fn verdict_changes(atlas: &Atlas) -> Option<Vec<VerdictChangeDocument>> {
    let set = &atlas.arrangement().set;
    let verdicts = Verdicts::new(atlas.body(), set);
    let document = |found: &VerdictChange| VerdictChangeDocument {
        l: found.l,
        h: found.h,
        curve: CurveName::of(set, found.curve).to_string(),
        kind: found.kind,
        verdict: found.verdict,
        why: found.why,
        changes: found.changes,
        error_bound: found.error_bound,
        proved: found.proved,
    };
    verdicts.is_complete().then(|| verdicts.changes().iter().map(document).collect())
}
