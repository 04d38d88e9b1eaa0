//! The linear type along every curve of a body and where it changes: by f64 with bounds, or exactly where these leave
//! something open.
//!
//! At a minimum of U_l both pairs are imaginary, at a saddle one is real and one imaginary (Corollary 13.2 of
//! docs/mathematics.md). So the type changes along maxima only, where b² − 4c changes its sign, and from curve to curve.

use std::cell::OnceCell;

use bifdiag_schema::StabilityChangeKind;

use super::changes::{Along, StabilityChange, StabilitySpan, Turn};
use super::collisions::{Collision, CollisionFamily, Parameter, collisions};
use super::exact::{ExactBody, StabilityProfile};
use super::{Constants, LinearType};
use crate::curves::{Branch, CriticalSet, Curve, CurveId, End, Mu, MuInterval, Point, Segment, Shape};
use bifdiag_body::{Body, Frame};
use bifdiag_numbers::UNIT_ROUNDOFF;
use bifdiag_numbers::interval::Interval;
use bifdiag_numbers::table::{Id, Table};

/// The linear types along the curves of a body.
#[derive(Debug)]
pub struct LinearTypes<'a> {
    set: &'a CriticalSet,
    /// `None` where f64 cut the curve's branch otherwise than the exact roots do.
    along: Table<CurveId, Option<Along>>,
    /// Where one curve goes over into another.
    between: Vec<StabilityChange>,
    /// The exact roots, where f64 left something open.
    profile: Option<StabilityProfile>,
    is_quick: bool,
}

/// The smallest ratio of the body's numbers with which products of degree 18 stay in the range of `f64`.
const SMALLEST: f64 = 1e-8;

impl<'a> LinearTypes<'a> {
    /// Decides the type along every curve.
    #[must_use]
    pub fn new(body: &Body, set: &'a CriticalSet) -> Self {
        let Some(along) = quick(body, set) else { return Self::exact(body, set) };
        let between = between(set, &along);
        Self { set, between, along: along.into_iter().map(Some).collect(), profile: None, is_quick: true }
    }

    /// Decides the type along every curve by exact roots alone; nothing where roots are closer than 2^-4000.
    #[must_use]
    pub fn exact(body: &Body, set: &'a CriticalSet) -> Self {
        let profile = StabilityProfile::new(body, set);
        let unknown = || (set.curves.map(|_| None), Vec::new());
        let (along, between) = profile.as_ref().map_or_else(unknown, |profile| profile.along(set));
        Self { set, along, between, profile, is_quick: false }
    }

    /// The exact roots, isolated on first use.
    pub(crate) fn take_profile(&mut self, body: &Body) -> Option<StabilityProfile> {
        if self.is_quick { StabilityProfile::new(body, self.set) } else { self.profile.take() }
    }

    /// True where f64 with bounds decided everything.
    #[must_use]
    pub fn is_quick(&self) -> bool {
        self.is_quick
    }

    /// The types along a curve by rising l, in the body's units; `None` where f64 cut its branch otherwise.
    #[must_use]
    pub fn spans(&self, id: CurveId) -> Option<Vec<StabilitySpan>> {
        let momentum = |x: f64| (2.0 * x).sqrt() * self.set.frame.momentum_unit;
        Some(self.along[id].as_ref()?.spans(self.set.curves[id].x().map(momentum)))
    }

    /// Every change of the linear type along a branch, by rising l, then h.
    #[must_use]
    pub fn changes(&self) -> Vec<StabilityChange> {
        let inside = self.along.pairs().flat_map(|(id, along)| {
            along.iter().flat_map(move |along| along.turns.iter().map(move |turn| turn.on(id, None)))
        });
        let mut changes: Vec<StabilityChange> = inside.chain(self.between.iter().copied()).collect();
        changes.sort_by(|p, q| p.l.total_cmp(&q.l).then(p.h.total_cmp(&q.h)));
        changes
    }
}

/// The changes at cusps and pitchforks.
fn between(set: &CriticalSet, along: &Table<CurveId, Along>) -> Vec<StabilityChange> {
    let cusps = set.cusps.pairs().map(|(id, cusp)| (End::Cusp(id), &cusp.point, cusp.curves));
    let pitchforks = set.pitchforks.pairs().map(|(id, fork)| (End::Pitchfork(id), &fork.point, fork.through));
    let change = |(end, point, mut curves): (End, &Point, [CurveId; 2])| {
        curves.sort_by_key(|&id| set.curves[id].piece);
        let at_end = |id: CurveId| if set.curves[id].ends[0] == end { along[id].first } else { along[id].last() };
        let (from, to) = (at_end(curves[0])?, at_end(curves[1])?);
        // As for events: x is right to its rounding, and dl = dx/l.
        let x_error = 64.0 * UNIT_ROUNDOFF * point.x;
        let l = (2.0 * point.x).sqrt();
        let h_error = point.h_error() + x_error * point.slope();
        let (l_unit, h_unit) = (set.frame.momentum_unit, set.frame.energy_unit);
        let place = [(l * l_unit, x_error / l * l_unit), (point.h() * h_unit, h_error * h_unit)];
        (from != to).then(|| Turn { place, from, to, kind: StabilityChangeKind::Zero }.on(curves[0], Some(curves[1])))
    };
    cusps.chain(pitchforks).filter_map(change).collect()
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
        let family = match (branch, &set.curves[curves[0]].arcs[0].shape) {
            (Branch::Generic(n), _) => CollisionFamily::Generic(MuInterval::numbered(&active, n.index())),
            (_, Shape::Symmetric { family, .. }) => CollisionFamily::Over(*family),
            _ => return None,
        };
        if matches!(family, CollisionFamily::Generic(interval) if interval.right.is_none()) {
            return None;
        }
        let found = collisions(frame, &constants, &exact, &family)?;
        let mut placed = 0;
        for id in curves {
            let (first, turns) = types_along(&set.curves[id], &family, &constants, &found)?;
            placed += turns.len();
            along[id] = Along { first: Some(first), turns };
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
    family: &CollisionFamily,
    constants: &Constants<Interval>,
    found: &[Collision],
) -> Option<(LinearType, Vec<Turn>)> {
    let mut turns = Vec::new();
    for collision in found {
        match spot(curve, &collision.at) {
            Spot::Elsewhere => {}
            Spot::NearEnd => return None,
            Spot::On { rising } => turns.push(turn(collision, rising)),
        }
    }
    turns.sort_by(|p, q| p.place[0].0.total_cmp(&q.place[0].0));
    let apart = |[(p, p_error), _]: [(f64, f64); 2], [(q, q_error), _]: [(f64, f64); 2]| p + p_error < q - q_error;
    if turns.windows(2).any(|pair| pair[0].to != pair[1].from || !apart(pair[0].place, pair[1].place)) {
        return None;
    }
    let first = match turns.first() {
        Some(turn) => turn.from,
        None => family.reduced(constants, sample(curve)?).linear_type()?,
    };
    Some((first, turns))
}

/// `rising`: x rises with |δ|, or z.
fn turn(collision: &Collision, rising: bool) -> Turn {
    let (apart, kind) = if collision.is_imaginary {
        (LinearType::Elliptic, StabilityChangeKind::HamiltonianHopf)
    } else {
        (LinearType::Saddle, StabilityChangeKind::RealCollision)
    };
    let apart_after = collision.apart_above == rising;
    let (from, to) = if apart_after { (LinearType::Complex, apart) } else { (apart, LinearType::Complex) };
    Turn { place: collision.place, from, to, kind }
}

/// Where a parameter lies relative to a curve.
enum Spot {
    Elsewhere,
    /// So near to an end that rounding leaves the side open.
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
