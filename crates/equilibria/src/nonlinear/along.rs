//! Verdicts along whole curves, and the isolated points at which the hypotheses of Arnold's theorem fail.
//!
//! The resonances are roots of polynomials, isolated exactly; so are the zeros of Arnold's determinant, whose polynomial is
//! known by enclosed values (`zeros`).

use std::cell::LazyCell;
use std::cmp::Ordering;

use dashu_ratio::RBig;

use super::judge::{MAXIMUM, Question};
use super::verdict::Setting;
use super::zeros::zeros;
use crate::curves::{CriticalSet, CurveId};
use crate::stability::exact::{ExactBody, FamilyChart, StabilityProfile, StationKind, compare};
use crate::stability::{Constants, LinearType, LinearTypes, Reduced, State};
use bifdiag_body::Body;
use bifdiag_numbers::enclosure::Enclosure;
use bifdiag_numbers::polynomial::{Polynomial, Root};
use bifdiag_numbers::wide::{Interval128, Interval384};
use bifdiag_schema::{Failing, NonlinearVerdict, Reason};

/// An isolated point of a curve at which a hypothesis of Arnold's theorem fails. In the body's units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VerdictChange {
    /// Vertical angular momentum.
    pub l: f64,
    /// Energy.
    pub h: f64,
    /// Bound on the error of both.
    pub error_bound: f64,
    /// Ω, from its own enclosure: near cusps l and h determine it only to a few digits.
    pub omega: f64,
    /// μ = J + ⟨γ, r⟩/Ω².
    pub mu: f64,
    /// Its curve.
    pub curve: CurveId,
    /// What fails.
    pub kind: Failing,
    /// The verdict there.
    pub verdict: NonlinearVerdict,
    /// Its reason.
    pub why: Reason,
    /// The verdicts on its two sides differ.
    pub changes: bool,
    /// The point and the verdict are proved.
    pub proved: bool,
}

/// A stretch of a curve with one verdict, except at isolated points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VerdictSpan {
    /// From this l …
    pub l_from: f64,
    /// … to this l; `None`: to infinity.
    pub l_to: Option<f64>,
    /// The linear type there.
    pub stability: LinearType,
    /// The verdict.
    pub verdict: NonlinearVerdict,
    /// Its reason.
    pub why: Reason,
    /// Whether it survives damping that conserves l.
    pub survives: bool,
}

/// The verdicts along the curves of a body.
#[derive(Debug)]
pub struct Verdicts<'a> {
    set: &'a CriticalSet,
    types: LinearTypes<'a>,
    changes: Vec<VerdictChange>,
    is_complete: bool,
}

/// Bits of roots in intervals of 128 and of 384 bits.
const BITS: [usize; 2] = [112, 352];

impl<'a> Verdicts<'a> {
    /// Judges every curve.
    #[must_use]
    pub fn new(body: &Body, set: &'a CriticalSet) -> Self {
        let mut found = Self { set, types: LinearTypes::new(body, set), changes: Vec::new(), is_complete: true };
        let is_integrable = set.frame.is_euler() || set.is_lagrange();
        let has_maxima = || set.curves.iter().any(|curve| curve.is_critical() && curve.index == Some(2));
        if !is_integrable && has_maxima() {
            match found.types.take_profile(body) {
                Some(profile) => found.along(&profile),
                None => found.is_complete = false,
            }
        }
        found.changes.sort_by(|p, q| p.l.total_cmp(&q.l).then(p.h.total_cmp(&q.h)));
        found
    }

    /// Every isolated point where a hypothesis of Arnold's theorem fails, by rising l, then h.
    #[must_use]
    pub fn changes(&self) -> &[VerdictChange] {
        &self.changes
    }

    /// The linear types, on which they rest.
    #[must_use]
    pub fn types(&self) -> &LinearTypes<'a> {
        &self.types
    }

    /// True where every resonance and every zero of the determinant is known.
    #[must_use]
    pub fn is_complete(&self) -> bool {
        self.is_complete
    }

    /// The verdicts along a curve by rising l, in the body's units; `None` where f64 cut its branch otherwise.
    #[must_use]
    pub fn spans(&self, id: CurveId) -> Option<Vec<VerdictSpan>> {
        let setting = Setting::along(self.set, &self.set.curves[id]);
        let span = |span: crate::stability::StabilitySpan| {
            let setting = setting?;
            let (verdict, why) = setting.verdict(span.stability).unwrap_or((NonlinearVerdict::Stable, Reason::Arnold));
            let (l_from, l_to, stability) = (span.l_from, span.l_to, span.stability);
            Some(VerdictSpan { l_from, l_to, stability, verdict, why, survives: setting.index == 0 })
        };
        Some(self.types.spans(id)?.into_iter().filter_map(span).collect())
    }

    fn along(&mut self, profile: &StabilityProfile) {
        let body = profile.body();
        let families = profile.families(self.set);
        self.is_complete &= self.set.clusters.is_empty() && families.len() == profile.family_count();
        for (chart, known, curves) in families {
            if chart.is_circle() {
                continue;
            }
            let pieces = known.pieces(chart.is_reversed);
            let resonances = LazyCell::new(|| resonances(chart));
            for k in (0..known.types.len()).filter(|&k| known.types[k] == LinearType::Elliptic) {
                let Some(piece) = pieces.iter().position(|piece| piece.contains(&k)) else { continue };
                let curve = curves[piece];
                let family = OnFamily { body, chart, set: self.set, curve };
                if self.set.has_integral(&self.set.curves[curve]) || family.index(&known.samples[k]) != Some(2) {
                    continue;
                }
                let before = k.checked_sub(1).map(|n| &known.stations[n]);
                let after = known.stations.get(k);
                for (station, other) in [(before, k.checked_sub(1)), (after, Some(k + 1))] {
                    let Some(station) = station else { continue };
                    // Where two elliptic stretches meet, the point belongs to the first.
                    let is_again = other < Some(k) && other.is_some_and(|n| known.types[n] == LinearType::Elliptic);
                    if matches!(station.kind, StationKind::Collision(_)) && !is_again {
                        let changes = other.is_some_and(|n| known.types[n] != LinearType::Elliptic);
                        self.changes.push(family.resonance(&station.root, Failing::Resonance11, changes));
                    }
                }
                let ends = [before, after].map(|station| station.map(|station| station.root.clone()));
                let is_whole =
                    resonances.as_ref().and_then(|resonances| self.inside(&family, ends, resonances)).is_some();
                self.is_complete &= is_whole;
            }
        }
    }

    /// Resonances, of these of the family, and zeros on an elliptic stretch; `None` where something stays open.
    fn inside(
        &mut self,
        family: &OnFamily<'_>,
        ends: [Option<Root>; 2],
        resonances: &[(Failing, Vec<Root>)],
    ) -> Option<()> {
        let [mut from, mut to] = ends;
        let chart = family.chart;
        // At ω₁ = 2ω₂ the polynomial of the determinant vanishes if the determinant has no pole.
        let mut poles = Vec::new();
        for (kind, roots) in resonances {
            for mut root in roots.iter().cloned() {
                let is_after = from.as_mut().is_none_or(|end| compare(&mut root, end) == Ordering::Greater);
                let is_before = to.as_mut().is_none_or(|end| compare(&mut root, end) == Ordering::Less);
                if is_after && is_before {
                    self.changes.push(family.resonance(&root, *kind, false));
                    poles.extend((*kind == Failing::Resonance12).then_some(root));
                }
            }
        }
        // A body standing at rest is a saddle: the last stretch of an unbounded chart is not one.
        let last = to.as_ref().map(|root| root.hi.clone()).or_else(|| chart.is_bounded().then_some(RBig::ONE))?;
        let first = from.as_ref().map_or(RBig::ZERO, |root| root.lo.clone());
        let is_inside = |[lo, hi]: &[RBig; 2]| {
            let is_apart = |pole: &Root| pole.hi < *lo || *hi < pole.lo;
            from.as_ref().is_none_or(|end| end.hi < *lo)
                && to.as_ref().is_none_or(|end| *hi < end.lo)
                && poles.iter().all(is_apart)
        };
        let judged =
            |range: &[RBig; 2], is_last: bool| if is_inside(range) { family.zero(range, is_last) } else { None };
        self.changes.extend(zeros(family.body, chart, [&first, &last], judged)?);
        Some(())
    }
}

/// All resonances 1:2 and 1:3 of a family; `None` where their roots are too close.
fn resonances(chart: &FamilyChart) -> Option<Vec<(Failing, Vec<Root>)>> {
    let narrow = |mut root: Root| {
        root.refine(BITS[0]);
        root
    };
    let [_, two, three] = &chart.resonances;
    let of = |kind, polynomial| Some((kind, chart.roots(polynomial)?.into_iter().map(narrow).collect()));
    Some(vec![of(Failing::Resonance12, two)?, of(Failing::Resonance13, three)?])
}

/// A curve on its family.
struct OnFamily<'a> {
    body: &'a ExactBody,
    chart: &'a FamilyChart,
    set: &'a CriticalSet,
    curve: CurveId,
}

impl OnFamily<'_> {
    /// Morse index at a rational t.
    fn index(&self, t: &RBig) -> Option<u8> {
        let mut root = Root::exact(&Polynomial::from_rationals(&[-t, RBig::ONE]), t.clone());
        let c: Constants<Interval128> = self.body.constants(());
        let state: State<Interval128> = self.chart.state(self.body, &c, &mut root, BITS[0]);
        Reduced::new(&c, &state).index(state.hessian_trace(&c).sign())
    }

    /// The point at an exact resonance.
    fn resonance(&self, root: &Root, kind: Failing, changes: bool) -> VerdictChange {
        let narrow = self.judged::<Interval128>(root, kind, BITS[0], changes);
        if narrow.proved { narrow } else { self.judged::<Interval384>(root, kind, BITS[1], changes) }
    }

    fn judged<E: Enclosure<Precision = ()>>(
        &self,
        root: &Root,
        kind: Failing,
        bits: usize,
        changes: bool,
    ) -> VerdictChange {
        let c: Constants<E> = self.body.constants(());
        let state: State<E> = self.chart.state(self.body, &c, &mut root.clone(), bits);
        let reduced = Reduced::new(&c, &state);
        let is_double = kind == Failing::Resonance11;
        let kind_there = if is_double { LinearType::DoubleElliptic } else { LinearType::Elliptic };
        let question = Question { c: &c, state: &state, reduced: &reduced, kind: kind_there, setting: MAXIMUM };
        let exact = [Failing::Resonance12, Failing::Resonance13].map(|resonance| Some(kind == resonance));
        let found = question.verdict(exact).unwrap_or_else(|| question.undecided(exact));
        self.change((&c, &state), kind, (found.verdict, found.why), (changes, found.proved))
    }

    fn change<E: Enclosure>(
        &self,
        (c, state): (&Constants<E>, &State<E>),
        kind: Failing,
        (verdict, why): (NonlinearVerdict, Reason),
        (changes, proved): (bool, bool),
    ) -> VerdictChange {
        let [(l, l_error), (h, h_error)] = state.place(c, &self.set.frame);
        let [omega, mu] = state.on_family(c, &self.set.frame);
        let error_bound = l_error.max(h_error);
        VerdictChange { l, h, error_bound, omega, mu, curve: self.curve, kind, verdict, why, changes, proved }
    }

    /// The equilibria over a range of t.
    fn over(&self, [lo, hi]: &[RBig; 2]) -> (Constants<Interval384>, State<Interval384>) {
        let c = self.body.constants(());
        let state = self.chart.state_over(self.body, &c, [lo, hi]);
        (c, state)
    }

    /// The point at a zero of the determinant; `None` if a narrower range exists and may decide more.
    fn zero(&self, range: &[RBig; 2], is_last: bool) -> Option<VerdictChange> {
        let (c, state) = self.over(range);
        if !is_last && !state.is_sharp(&c) {
            return None;
        }
        let reduced = Reduced::new(&c, &state);
        let (kind, setting) = (LinearType::Elliptic, MAXIMUM);
        let sixth = Question { c: &c, state: &state, reduced: &reduced, kind, setting }.sixth();
        let verdict = match sixth.and_then(|value| value.strict_sign()) {
            Some(_) => (NonlinearVerdict::Stable, Reason::Arnold),
            None if !is_last => return None,
            None => (NonlinearVerdict::Open, Reason::Degenerate),
        };
        Some(self.change((&c, &state), Failing::Determinant, verdict, (false, true)))
    }
}
