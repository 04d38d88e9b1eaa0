//! Verdicts along whole curves, and the isolated points at which the hypotheses of Arnold's theorem fail.
//!
//! The resonances are roots of polynomials, isolated exactly. Between them Arnold's determinant is a smooth function of the
//! parameter of the family: Taylor models prove its sign on cells, and where two cells differ bisection by signs at points
//! finds the zero. Beside the ends of a stretch and the resonance 1:2, where the normal form is singular, cells stop at a
//! relative distance of 10^−6 (`NEAR`); single points there are judged as everywhere.

use std::cmp::Ordering;

use dashu_ratio::RBig;

use super::judge::Question;
use super::verdict::Setting;
use crate::curves::{CriticalSet, CurveId};
use crate::stability::exact::{ExactBody, FamilyChart, Part, StabilityProfile, StationKind, compare};
use crate::stability::{Constants, LinearType, LinearTypes, Reduced, State};
use bifdiag_body::Body;
use bifdiag_numbers::Sign;
use bifdiag_numbers::enclosure::{Arithmetic, Enclosure};
use bifdiag_numbers::polynomial::{Polynomial, Root};
use bifdiag_numbers::root::itp;
use bifdiag_numbers::taylor::TaylorModel;
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

/// A stretch of a curve with one verdict, but for isolated points.
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

/// Cells of a part to begin with.
const CELLS: u32 = 4;
/// Evaluations on one part at most: several times what a body needs whose numbers doubles resolve.
const EVALUATIONS: usize = 1000;
/// Relative width at which cells stop.
const NEAR: f64 = 1e-6;
/// Relative width of the fence of a zero at most.
const FINEST: f64 = 1e-12;
/// Bits of roots in intervals of 128 and of 384 bits.
const BITS: [usize; 2] = [112, 352];

impl<'a> Verdicts<'a> {
    /// Judges every curve.
    #[must_use]
    pub fn new(body: &Body, set: &'a CriticalSet) -> Self {
        let types = LinearTypes::new(body, set);
        let mut found = Self { set, types, changes: Vec::new(), is_complete: true };
        let is_integrable = set.frame.is_euler() || set.is_lagrange();
        let has_maxima = || set.curves.iter().any(|curve| curve.is_critical() && curve.index == Some(2));
        if !is_integrable && has_maxima() {
            match StabilityProfile::new(body, set) {
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
        self.is_complete &= self.set.clusters.is_empty();
        for (chart, known, curves) in families {
            if chart.is_circle() {
                continue;
            }
            let pieces = known.pieces(chart.is_reversed);
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
                    // Where two elliptic stretches meet, the one before has it.
                    let is_again = other < Some(k) && other.is_some_and(|n| known.types[n] == LinearType::Elliptic);
                    if matches!(station.kind, StationKind::Collision(_)) && !is_again {
                        let changes = other.is_some_and(|n| known.types[n] != LinearType::Elliptic);
                        self.changes.push(family.resonance(&station.root, Failing::Resonance11, changes));
                    }
                }
                let ends = [before, after].map(|station| station.map(|station| station.root.clone()));
                let is_whole = self.inside(&family, ends).is_some();
                self.is_complete &= is_whole;
            }
        }
    }

    /// Resonances and zeros on an elliptic stretch; `None` where something stays open.
    fn inside(&mut self, family: &OnFamily<'_>, ends: [Option<Root>; 2]) -> Option<()> {
        let [mut from, mut to] = ends;
        let chart = family.chart;
        let mut singular = Vec::new();
        for (n, kind) in [(1, Failing::Resonance12), (2, Failing::Resonance13)] {
            for mut root in chart.roots(&chart.resonances[n])? {
                root.refine(BITS[0]);
                let is_after = from.as_mut().is_none_or(|end| compare(&mut root, end) == Ordering::Greater);
                let is_before = to.as_mut().is_none_or(|end| compare(&mut root, end) == Ordering::Less);
                if is_after && is_before {
                    self.changes.push(family.resonance(&root, kind, false));
                    if n == 1 {
                        singular.push(root);
                    }
                }
            }
        }
        let first = from.map_or(RBig::ZERO, |root| root.hi);
        // A body that stands at rest is a saddle: the last stretch of an unbounded chart is none.
        let last = match to {
            Some(root) => root.lo,
            None if chart.is_bounded() => RBig::ONE,
            None => return None,
        };
        let poles: Vec<Part> = singular.iter().flat_map(|root| chart.parts(family.body, &root.lo, &root.hi)).collect();
        let mut zeros = Some(());
        // The sign before the seam of two parts.
        let mut last_sign = None;
        for part in chart.parts(family.body, &first, &last) {
            let Some(cells) = family.cells(&part) else {
                zeros = None;
                continue;
            };
            let mut signs = cells.iter().filter_map(|cell| cell.2);
            let first_sign = signs.next();
            if last_sign.is_some() && first_sign != last_sign {
                zeros = None;
            }
            last_sign = signs.next_back().or(first_sign);
            // What is undecided lies between two cells.
            for window in cells.windows(3) {
                let [(.., before), (left, right, None), (.., after)] = *window else { continue };
                let is_inside = |x: f64| left.min(right) <= x && x <= left.max(right);
                if poles.iter().any(|pole| pole.measures_like(&part) && is_inside(pole.from)) {
                    continue;
                }
                match (before, after) {
                    (Some(p), Some(q)) if p != q => match family.zero(&part, [left, right], p) {
                        Some(change) => self.changes.push(change),
                        None => zeros = None,
                    },
                    (Some(_), Some(_)) => zeros = None,
                    _ => {}
                }
            }
        }
        zeros
    }
}

/// A curve on its family.
struct OnFamily<'a> {
    body: &'a ExactBody,
    chart: &'a FamilyChart,
    set: &'a CriticalSet,
    curve: CurveId,
}

/// A cell and the sign of the determinant on it.
type Cell = (f64, f64, Option<Sign>);

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
        self.change(state.place(&c, &self.set.frame), kind, (found.verdict, found.why), (changes, found.proved))
    }

    fn change(
        &self,
        [(l, l_error), (h, h_error)]: [(f64, f64); 2],
        kind: Failing,
        (verdict, why): (NonlinearVerdict, Reason),
        (changes, proved): (bool, bool),
    ) -> VerdictChange {
        let error_bound = l_error.max(h_error);
        VerdictChange { l, h, error_bound, curve: self.curve, kind, verdict, why, changes, proved }
    }

    /// A part in cells on which the determinant has one sign, and narrow ones on which it is open; `None` where doubles do not
    /// resolve the body.
    fn cells(&self, part: &Part) -> Option<Vec<Cell>> {
        let c: Constants<TaylorModel> = self.body.constants(());
        let scale = part.from.abs().max(part.to.abs());
        let at = |n: u32| match n {
            0 => part.from,
            CELLS => part.to,
            _ => part.from + (part.to - part.from) * f64::from(n) / f64::from(CELLS),
        };
        let mut open: Vec<(f64, f64)> = (0..CELLS).rev().map(|n| (at(n), at(n + 1))).collect();
        let mut cells: Vec<Cell> = Vec::new();
        let mut evaluations = 0;
        while let Some((x0, x1)) = open.pop() {
            evaluations += 1;
            if evaluations > EVALUATIONS {
                return None;
            }
            let sign = sign_over(&c, part, x0, x1);
            let size = x0.abs().max(x1.abs());
            let middle = 0.5 * (x0 + x1);
            let is_narrow = (x1 - x0).abs() <= NEAR * size || size <= NEAR * scale || middle == x0 || middle == x1;
            match (sign, cells.last_mut()) {
                (None, _) if !is_narrow => open.extend([(middle, x1), (x0, middle)]),
                (sign, Some(last)) if last.2 == sign => last.1 = x1,
                (sign, _) => cells.push((x0, x1, sign)),
            }
        }
        Some(cells)
    }

    /// The zero of the determinant between two points of different signs: the secant of the ends finds it, and signs on both
    /// sides of where it leads fence it.
    fn zero(&self, part: &Part, ends: [f64; 2], before: Sign) -> Option<VerdictChange> {
        let c: Constants<Interval128> = self.body.constants(());
        let value = |x: f64| {
            let state = part.state(&c, &Interval128::double(x, ()));
            let reduced = Reduced::new(&c, &state);
            determinant(&c, &state, &reduced)
        };
        let middle = |x: f64| value(x).map_or(f64::NAN, |found| found.middle().bounds()[0]);
        let [first, last] = ends;
        let (low, high) = (middle(first), middle(last));
        if low.is_nan() || high.is_nan() || (low > 0.0) == (high > 0.0) {
            return None;
        }
        let (mut from, mut to, signs) =
            if first < last { (first, last, [low, high]) } else { (last, first, [high, low]) };
        let root = itp(from, to, signs[0], signs[1], 0.0, middle);
        let sign = |x: f64| value(x).and_then(|found| found.strict_sign());
        let before = if first < last { before } else { -before };
        for reach in [4.0, 64.0, 1024.0].map(|units| units * f64::EPSILON * root.abs()) {
            let around = [(root - reach).max(from), (root + reach).min(to)];
            if around.map(sign) == [Some(before), Some(-before)] {
                [from, to] = around;
                break;
            }
        }
        let is_narrow = to - from <= FINEST * root.abs();
        let state = part.state(&c, &Interval128::double(from, ()).hull(&Interval128::double(to, ())));
        let verdict = (NonlinearVerdict::Open, Reason::Degenerate);
        is_narrow.then(|| self.change(state.place(&c, &self.set.frame), Failing::Determinant, verdict, (false, true)))
    }
}

/// What the verdicts on an elliptic stretch need: index 2 and no integral.
const MAXIMUM: Setting = Setting { index: 2, minimum: None, integral: false };

/// The sign of Arnold's determinant on a range of the coordinate.
fn sign_over(c: &Constants<TaylorModel>, part: &Part, x0: f64, x1: f64) -> Option<Sign> {
    let state = part.state(c, &TaylorModel::variable(x0, x1));
    sign_of(c, &state, &Reduced::new(c, &state))
}

/// Its sign from the normal form; beside ω₁ = ω₂, where that is singular, from the numerator.
fn sign_of<E: Enclosure>(c: &Constants<E>, state: &State<E>, reduced: &Reduced<E>) -> Option<Sign> {
    if reduced.discriminant().strict_sign().is_some() {
        return determinant(c, state, reduced)?.strict_sign();
    }
    // c > 0, and b² − 4c > 0 on the stretch.
    reduced.coefficients()[1].strict_sign().filter(|sign| *sign == Sign::Positive)?;
    Question { c, state, reduced, kind: LinearType::Elliptic, setting: MAXIMUM }.numerator()?.strict_sign()
}

fn determinant<E: Enclosure>(c: &Constants<E>, state: &State<E>, reduced: &Reduced<E>) -> Option<E> {
    let question = Question { c, state, reduced, kind: LinearType::Elliptic, setting: MAXIMUM };
    Some(question.normal_form()?.arnold)
}
