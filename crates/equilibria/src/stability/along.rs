//! The linear type along every curve of a body and where it changes: by f64 with bounds, or exactly where these leave
//! something open.
//!
//! At a minimum of U_l both pairs are imaginary, at a saddle one is real and one imaginary (Corollary 13.2 of
//! docs/mathematics.md). So the type changes along maxima only, where b² − 4c changes its sign, and from curve to curve.

use std::cell::OnceCell;

use super::changes::{ChangeKind, StabilityChange, StabilityProfile};
use super::collisions::{Collision, Parameter, Strand, collisions};
use super::exact::ExactBody;
use super::{Constants, LinearType, StabilitySpan};
use crate::curves::{Branch, CriticalSet, Curve, CurveId, End, Mu, MuInterval, Segment, Shape};
use bifdiag_body::{Body, Frame};
use bifdiag_numbers::UNIT_ROUNDOFF;
use bifdiag_numbers::interval::Interval;
use bifdiag_numbers::table::{Id, Table};

/// The linear types along the curves of a body.
#[derive(Debug)]
pub struct LinearTypes<'a> {
    set: &'a CriticalSet,
    way: Way,
}

#[derive(Debug)]
enum Way {
    Quick(Table<CurveId, Along>),
    /// `None`: roots closer than 2^-4000.
    Exact(Option<Box<StabilityProfile>>),
}

/// One curve, by rising x: the type at its start and its collisions; nothing of a pole line.
#[derive(Clone, Debug, Default)]
struct Along {
    first: Option<LinearType>,
    collisions: Vec<Turn>,
}

/// A collision on a curve.
#[derive(Clone, Copy, Debug)]
struct Turn {
    place: [(f64, f64); 2],
    from: LinearType,
    to: LinearType,
    kind: ChangeKind,
}

/// The smallest ratio of the body's numbers with which products of degree 18 stay in the range of `f64`.
const SMALLEST: f64 = 1e-8;

impl<'a> LinearTypes<'a> {
    /// Decides the type along every curve.
    #[must_use]
    pub fn new(body: &Body, set: &'a CriticalSet) -> Self {
        let way =
            quick(body, set).map_or_else(|| Way::Exact(StabilityProfile::new(body, set).map(Box::new)), Way::Quick);
        Self { set, way }
    }

    /// True where f64 with bounds decided everything.
    #[must_use]
    pub fn is_quick(&self) -> bool {
        matches!(self.way, Way::Quick(_))
    }

    /// The types along a curve by rising l, in the body's units; `None` where f64 cut its branch otherwise.
    #[must_use]
    pub fn spans(&self, id: CurveId) -> Option<Vec<StabilitySpan>> {
        let along = match &self.way {
            Way::Quick(along) => &along[id],
            Way::Exact(profile) => return profile.as_ref()?.spans(self.set, id),
        };
        let momentum = |x: f64| (2.0 * x).sqrt() * self.set.frame.momentum_unit;
        let [from, to] = self.set.curves[id].x().map(momentum);
        let Some(first) = along.first else { return Some(Vec::new()) };
        let starts = std::iter::once((from, first));
        let starts: Vec<_> = starts.chain(along.collisions.iter().map(|turn| (turn.place[0].0, turn.to))).collect();
        let ends = starts[1..].iter().map(|(l, _)| Some(*l)).chain([to.is_finite().then_some(to)]);
        let span = |(&(l_from, stability), l_to)| StabilitySpan { l_from, l_to, stability };
        Some(starts.iter().zip(ends).map(span).collect())
    }

    /// Every change of the linear type along a branch, by rising l, then h.
    #[must_use]
    pub fn changes(&self) -> Vec<StabilityChange> {
        let along = match &self.way {
            Way::Quick(along) => along,
            Way::Exact(profile) => return profile.as_ref().map_or_else(Vec::new, |profile| profile.changes(self.set)),
        };
        let mut changes: Vec<StabilityChange> = along
            .pairs()
            .flat_map(|(id, along)| along.collisions.iter().map(move |turn| turn.on(id)))
            .chain(self.ends(along))
            .collect();
        changes.sort_by(|p, q| p.l.total_cmp(&q.l).then(p.h.total_cmp(&q.h)));
        changes
    }

    /// The changes at cusps and pitchforks.
    fn ends<'b>(&'b self, along: &'b Table<CurveId, Along>) -> impl Iterator<Item = StabilityChange> + 'b {
        let set = self.set;
        let cusps = set.cusps.pairs().map(|(id, cusp)| (End::Cusp(id), &cusp.point, cusp.curves));
        let pitchforks = set.pitchforks.pairs().map(|(id, fork)| (End::Pitchfork(id), &fork.point, fork.through));
        cusps.chain(pitchforks).filter_map(move |(end, point, mut curves)| {
            curves.sort_by_key(|&id| set.curves[id].piece);
            let at_end = |id: CurveId| {
                let Along { first, collisions } = &along[id];
                if set.curves[id].ends[0] == end { *first } else { collisions.last().map(|turn| turn.to).or(*first) }
            };
            let (from, to) = (at_end(curves[0])?, at_end(curves[1])?);
            // As for events: x is right to its rounding, and dl = dx/l.
            let x_error = 64.0 * UNIT_ROUNDOFF * point.x;
            let l = (2.0 * point.x).sqrt();
            let l_error = x_error / l * set.frame.momentum_unit;
            let h_error = (point.h_error() + x_error * point.slope()) * set.frame.energy_unit;
            (from != to).then(|| StabilityChange {
                l: l * set.frame.momentum_unit,
                h: point.h() * set.frame.energy_unit,
                error_bound: l_error.max(h_error),
                curve: curves[0],
                onto: Some(curves[1]),
                kind: ChangeKind::Zero,
                from,
                to,
            })
        })
    }
}

/// The types along all curves of a body with three distinct moments, r on no axis, if f64 decides them.
fn quick(body: &Body, set: &CriticalSet) -> Option<Table<CurveId, Along>> {
    let frame = &set.frame;
    let active = frame.active();
    if frame.group != [0, 1, 2] || active.len() < 2 || !set.clusters.is_empty() || is_extreme(frame) {
        return None;
    }
    let constants = Constants::rounded(frame);
    let exact_body = OnceCell::new();
    let exact = || exact_body.get_or_init(|| ExactBody::new(body, frame)).constants(());
    let mut along: Table<CurveId, Along> = set.curves.iter().map(|_| Along::default()).collect();
    let mut maxima: Vec<(Branch, Vec<CurveId>)> = Vec::new();
    for (id, curve) in set.curves.pairs().filter(|(_, curve)| curve.is_critical()) {
        match curve.index? {
            0 => along[id].first = Some(LinearType::Elliptic),
            1 => along[id].first = Some(LinearType::SaddleCentre),
            _ => match maxima.iter_mut().find(|(branch, _)| *branch == curve.branch) {
                Some((_, curves)) => curves.push(id),
                None => maxima.push((curve.branch, vec![id])),
            },
        }
    }
    for (branch, curves) in maxima {
        let strand = match (branch, &set.curves[curves[0]].arcs[0].shape) {
            (Branch::Generic(n), _) => Strand::Generic(MuInterval::numbered(&active, n.index())),
            (_, Shape::Symmetric { family, .. }) => Strand::Over(*family),
            _ => return None,
        };
        if matches!(strand, Strand::Generic(interval) if interval.right.is_none()) {
            return None;
        }
        let found = collisions(frame, &constants, &exact, &strand)?;
        let mut placed = 0;
        for id in curves {
            let (first, turns) = types_along(&set.curves[id], &strand, &constants, &found)?;
            placed += turns.len();
            along[id] = Along { first: Some(first), collisions: turns };
        }
        if placed != found.len() {
            return None;
        }
    }
    Some(along)
}

/// Products leave the range of `f64`.
fn is_extreme(frame: &Frame) -> bool {
    let small = |x: f64, scale: f64| x != 0.0 && x.abs() < SMALLEST * scale;
    let diff = frame.diff.iter().flatten();
    frame.r.iter().any(|&r| small(r, frame.r_norm)) || frame.a.iter().chain(diff).any(|&a| small(a, frame.a[2]))
}

/// The type at the start of a curve of maxima, and the collisions on it by rising x.
fn types_along(
    curve: &Curve,
    strand: &Strand,
    constants: &Constants<Interval>,
    found: &[Collision],
) -> Option<(LinearType, Vec<Turn>)> {
    let mut turns = Vec::new();
    for collision in found {
        match spot(curve, &collision.at) {
            Spot::Elsewhere => {}
            Spot::NearEnd => return None,
            Spot::On { rising } => turns.push(Turn::new(collision, rising)),
        }
    }
    turns.sort_by(|p, q| p.place[0].0.total_cmp(&q.place[0].0));
    let apart = |[(p, p_error), _]: [(f64, f64); 2], [(q, q_error), _]: [(f64, f64); 2]| p + p_error < q - q_error;
    if turns.windows(2).any(|pair| pair[0].to != pair[1].from || !apart(pair[0].place, pair[1].place)) {
        return None;
    }
    let first = match turns.first() {
        Some(turn) => turn.from,
        None => strand.reduced(constants, sample(curve)?).linear_type()?,
    };
    Some((first, turns))
}

impl Turn {
    /// `rising`: x rises with |δ|, or z.
    fn new(collision: &Collision, rising: bool) -> Self {
        let (apart, kind) = if collision.is_imaginary {
            (LinearType::Elliptic, ChangeKind::HamiltonianHopf)
        } else {
            (LinearType::Saddle, ChangeKind::RealCollision)
        };
        let apart_after = collision.apart_above == rising;
        let (from, to) = if apart_after { (LinearType::Complex, apart) } else { (apart, LinearType::Complex) };
        Self { place: collision.place, from, to, kind }
    }

    fn on(&self, curve: CurveId) -> StabilityChange {
        let Self { place: [(l, l_error), (h, h_error)], from, to, kind } = *self;
        StabilityChange { l, h, error_bound: l_error.max(h_error), curve, onto: None, kind, from, to }
    }
}

/// Where a parameter stands to a curve.
enum Spot {
    Elsewhere,
    /// Rounding may leave it open on which side of an end it is.
    NearEnd,
    /// On it; x rises with |δ|, or z.
    On {
        rising: bool,
    },
}

fn spot(curve: &Curve, at: &Parameter) -> Spot {
    const NEAR: f64 = 1e-9;
    let near = |y: f64, ends: [f64; 2]| ends.iter().any(|end| (end - y).abs() <= NEAR * y);
    let between = |y: f64, [from, to]: [f64; 2]| from.min(to) <= y && y <= from.max(to);
    for (n, arc) in curve.arcs.iter().enumerate() {
        match (&arc.shape, *at) {
            (Shape::Generic(segments), Parameter::Mu(mu)) => {
                let same = |s: &&Segment| s.base == mu.base && (s.sign > 0.0) == (mu.delta > 0.0);
                for (k, segment) in segments.iter().enumerate().filter(|(_, segment)| same(segment)) {
                    let y = mu.delta.abs();
                    let is_first = n == 0 && k == 0;
                    let is_last = n + 1 == curve.arcs.len() && k + 1 == segments.len();
                    let [from, to] = segment.distance;
                    if near(y, [if is_first { from } else { 0.0 }, if is_last { to } else { 0.0 }]) {
                        return Spot::NearEnd;
                    }
                    if between(y, segment.distance) {
                        return Spot::On { rising: from < to };
                    }
                }
            }
            (Shape::Symmetric { family, t }, Parameter::Z(z)) => {
                let s = 1.0 / z.sqrt();
                let ends = t.map(|t| family.s_pitchfork + t);
                if near(s, ends) {
                    return Spot::NearEnd;
                }
                if between(s, ends) {
                    return Spot::On { rising: t[0] > t[1] };
                }
            }
            _ => {}
        }
    }
    Spot::Elsewhere
}

/// A parameter inside a curve.
fn sample(curve: &Curve) -> Option<Parameter> {
    let inside = |[from, to]: [f64; 2], unit: f64| {
        let (small, large) = (from.min(to), from.max(to));
        if large.is_finite() { 0.5 * (small + large) } else { small + small.max(unit) }
    };
    match &curve.arcs[0].shape {
        Shape::Generic(segments) => {
            let Segment { base, sign, distance, .. } = *segments.first()?;
            Some(Parameter::Mu(Mu { base, delta: sign * inside(distance, 1.0) }))
        }
        Shape::Symmetric { family, t } => {
            let s = family.s_pitchfork + inside(*t, family.s_pitchfork);
            Some(Parameter::Z(1.0 / (s * s)))
        }
        Shape::Straight { .. } => None,
    }
}
