//! Borders to the last digits: the function that vanishes there.
//!
//! Near a border the atlas leaves bodies undecided, since its events draw together faster than the parameter. But what
//! happens there is known by then, and with it a function of the parameter that passes through 0 with a slope: a difference
//! of heights, an exact excess. Its zero is found without any atlas.

use super::event::EventLocation;
use super::segment::BodySegment;
use bifdiag_body::{Axis, Frame};
use bifdiag_equilibria::curves::{
    Branch, CriticalSet, Curve, CuspPair, Gap, IntervalId, Point, cusp_at_pitchfork, cusp_pairs,
};
use bifdiag_numbers::root::itp;

/// What vanishes at a border.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Vanishing {
    /// The excess of the pair over this axis of the frame, an exact fraction: its cusp reaches its pitchfork.
    Excess(Axis),
    /// J_r − a of the middle axis, an exact fraction.
    MiddleMoment,
    /// How near a cusp is to the pitchfork of the pair over this axis of the frame, on the curve that it leaves: see
    /// [`cusp_at_pitchfork`].
    CuspAtPitchfork(Axis),
    /// The height of an event over a curve of a branch: of several at one x over that one over which it has about the height
    /// given.
    Height { event: EventOfBranches, curve: Branch, height: f64 },
    /// The square of the distance of two cusps on this interval of the generic family, with the place of their middle, if that
    /// is known; otherwise those that are nearest to each other. See [`cusp_pairs`].
    Swallowtail { interval: IntervalId, middle: Option<f64> },
    /// Nothing that is known.
    Nothing,
}

/// An event that is found again in the diagrams of other bodies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum EventOfBranches {
    /// The cusp of a branch that is nearest to a place.
    Cusp { branch: Branch, near: Neighbourhood },
    /// The pitchfork of the pair over an axis of the frame.
    Pitchfork(Axis),
    /// The crossing of two branches that is nearest to a place.
    Crossing { branches: [Branch; 2], near: Neighbourhood },
}

/// A place in the plane of (l²/2, h) in the body's units, near which an event is sought again.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Neighbourhood {
    pub x: f64,
    pub h: f64,
}

impl Neighbourhood {
    /// For a point in the frame's units.
    pub(crate) fn of(frame: &Frame, x: f64, h: f64) -> Self {
        Self { x: x * frame.momentum_unit * frame.momentum_unit, h: h * frame.energy_unit }
    }

    fn distance(&self, frame: &Frame, x: f64, h: f64) -> f64 {
        let other = Self::of(frame, x, h);
        (other.x - self.x).abs() / self.x + (other.h - self.h).abs() / self.h.abs().max(1e-3 * frame.energy_unit)
    }
}

/// A value of t with an estimate of its error, which is 0 only for an exact zero.
pub(crate) struct ParameterRoot {
    pub t: f64,
    pub error: f64,
}

/// Between two values of t the zero of what vanishes.
pub(super) fn root(segment: &BodySegment, vanishing: &Vanishing, t: [f64; 2]) -> Option<ParameterRoot> {
    match vanishing {
        Vanishing::Nothing => None,
        _ => bisected(|t| Some(vanishing.measured(segment.body(t).frame())?.0), t),
    }
}

/// The point (in the body's units) at which it happens to the body at the border, with a bound on the error of both: a
/// cusp or pitchfork, which that body has for itself.
pub(super) fn place(segment: &BodySegment, vanishing: &Vanishing, root: &ParameterRoot) -> Option<EventLocation> {
    let set = CriticalSet::new(segment.body(root.t).frame()).ok()?;
    let point = match vanishing {
        Vanishing::Excess(axis) => pitchfork(&set, *axis)?,
        Vanishing::Height { event: EventOfBranches::Crossing { .. }, .. } => return None,
        Vanishing::Height { event, .. } => event.followed(&set)?.0,
        _ => return None,
    };
    let frame = &set.frame;
    let l = (2.0 * point.x).sqrt() * frame.momentum_unit;
    let h = point.h() * frame.energy_unit;
    // Between these the point moves by as much as the border is uncertain, and a little.
    let rounding = 64.0 * f64::EPSILON * (l.abs() + h.abs() + point.rho_scale * frame.energy_unit);
    Some(EventLocation { h, l, error: rounding + 1e3 * root.error * (l.abs() + h.abs()) })
}

fn pitchfork(set: &CriticalSet, axis: Axis) -> Option<Point> {
    set.pitchforks.iter().find(|found| found.axis == axis).map(|found| found.point)
}

fn nearest_cusp(set: &CriticalSet, branch: Branch, near: &Neighbourhood) -> Option<Point> {
    let far = |point: &Point| near.distance(&set.frame, point.x, point.h());
    let on_branch = set.cusps.iter().filter(|found| set.curves[found.curves[0]].branch == branch);
    on_branch.map(|found| found.point).min_by(|p, q| far(p).total_cmp(&far(q)))
}

impl Vanishing {
    /// The value of the vanishing function at a body, and the same with its event and its curve if present; `None`
    /// without such an event.
    pub(crate) fn measured(self, frame: Frame) -> Option<(Gap, Self)> {
        let exact = |value: f64| Some((Gap { value, error: 0.0 }, self));
        match self {
            Self::Nothing => None,
            Self::Excess(axis) => exact(frame.symmetric_sums[axis].cusp_excess),
            Self::MiddleMoment => exact(frame.offset[1]),
            Self::CuspAtPitchfork(axis) => {
                let set = CriticalSet::new(frame).ok()?;
                pitchfork(&set, axis)?;
                Some((cusp_at_pitchfork(&set.frame, axis), self))
            }
            Self::Height { event, curve, height } => {
                let set = CriticalSet::new(frame).ok()?;
                let (point, event) = event.followed(&set)?;
                let gap = over(&set, &point, curve, height)?;
                Some((gap, Self::Height { event, curve, height: gap.value }))
            }
            Self::Swallowtail { interval, middle } => {
                let far = |pair: &CuspPair| middle.map_or(pair.square.value, |middle| pair.middle - middle).abs();
                let pair = cusp_pairs(&frame, interval).into_iter().min_by(|p, q| far(p).total_cmp(&far(q)))?;
                Some((pair.square, Self::Swallowtail { interval, middle: Some(pair.middle) }))
            }
        }
    }
}

impl EventOfBranches {
    /// Its point in the diagram of a body, and the same event there.
    fn followed(self, set: &CriticalSet) -> Option<(Point, Self)> {
        let at = |point: &Point| Neighbourhood::of(&set.frame, point.x, point.h());
        match self {
            Self::Cusp { branch, near } => {
                let point = nearest_cusp(set, branch, &near)?;
                Some((point, Self::Cusp { branch, near: at(&point) }))
            }
            Self::Pitchfork(axis) => Some((pitchfork(set, axis)?, self)),
            Self::Crossing { branches, near } => {
                let point = nearest_crossing(set, branches, &near)?;
                Some((point, Self::Crossing { branches, near: at(&point) }))
            }
        }
    }
}

/// The crossing of curves of two branches that is nearest to a place, on the first of them.
fn nearest_crossing(set: &CriticalSet, branches: [Branch; 2], near: &Neighbourhood) -> Option<Point> {
    let frame = &set.frame;
    let of = |branch: Branch| set.curves.pairs().filter(move |(_, curve)| curve.branch == branch);
    let pairs = of(branches[0]).flat_map(|one| of(branches[1]).map(move |other| [one, other]));
    let found = pairs.filter(|[one, other]| one.0 != other.0).filter_map(|[(_, one), (_, other)]| {
        let x = crossing(frame, [one, other], near.x / (frame.momentum_unit * frame.momentum_unit))?;
        Some(one.point(frame, x))
    });
    let far = |point: &Point| near.distance(frame, point.x, point.h());
    found.min_by(|p, q| far(p).total_cmp(&far(q)))
}

/// The x near to a place at which two curves cross: by Newton's method, and where that leaves their range, at growing distances.
fn crossing(frame: &Frame, [one, other]: [&Curve; 2], near: f64) -> Option<f64> {
    const STEPS: u32 = 8;
    /// Ends of curves are cusps and pitchforks, where two of them meet: they are no crossings.
    const END: f64 = 1e-9;
    let range = [one.x()[0].max(other.x()[0]) * (1.0 + END), one.x()[1].min(other.x()[1]) * (1.0 - END)];
    let is_inside = |x: f64| range[0] < x && x < range[1];
    let mut x = near;
    for _ in 0..STEPS {
        if !is_inside(x) {
            break;
        }
        let points = [one, other].map(|curve| curve.point(frame, x));
        let gap = Gap::between(frame, &points[0], &points[1]);
        let next = x - gap.value / Gap::slope(frame, &points[0], &points[1]);
        if gap.value.abs() <= gap.error || next == x {
            return Some(x);
        }
        // Newton's method has left its root.
        if (next - x).abs() > 0.5 * x {
            break;
        }
        x = next;
    }
    bracketed_crossing(frame, [one, other], range, near)
}

/// The first x at which two curves cross, looked for at growing distances from a place.
fn bracketed_crossing(frame: &Frame, [one, other]: [&Curve; 2], [low, high]: [f64; 2], near: f64) -> Option<f64> {
    /// The first step, by how much the steps grow, and how many there are.
    const STEP: f64 = 1e-3;
    const GROWTH: f64 = 2.0;
    const STEPS: u32 = 12;
    if low >= high {
        return None;
    }
    let above = |x: f64| Gap::between(frame, &one.point(frame, x), &other.point(frame, x)).value;
    let start = near.clamp(low, high);
    let mut ends = [(start, above(start)); 2];
    let mut step = STEP;
    for _ in 0..STEPS {
        for (end, factor) in ends.iter_mut().zip([1.0 / (1.0 + step), 1.0 + step]) {
            let (from, from_value) = *end;
            let to = (from * factor).clamp(low, high);
            if to == from {
                continue;
            }
            let to_value = above(to);
            if (to_value > 0.0) != (from_value > 0.0) {
                return Some(itp(from, to, from_value, to_value, 0.0, above));
            }
            *end = (to, to_value);
        }
        step *= GROWTH;
    }
    None
}

/// h of a point minus that of a curve of a branch at the same x, of several that which is nearest to a height.
fn over(set: &CriticalSet, point: &Point, branch: Branch, height: f64) -> Option<Gap> {
    set.curves
        .iter()
        .filter(|curve| curve.branch == branch && curve.x()[0] < point.x && point.x < curve.x()[1])
        .map(|curve| Gap::between(&set.frame, point, &curve.point(&set.frame, point.x)))
        .min_by(|p, q| (p.value - height).abs().total_cmp(&(q.value - height).abs()))
}

/// The zero between two signs, until rounding hides it: two steps of false position (Illinois), then one of bisection.
fn bisected(value: impl Fn(f64) -> Option<Gap>, [mut low, mut high]: [f64; 2]) -> Option<ParameterRoot> {
    const STEPS: usize = 200;
    let is_zero = |gap: &Gap| *gap == Gap { value: 0.0, error: 0.0 };
    let (first, last) = (value(low)?, value(high)?);
    if let Some((_, t)) = [(&first, low), (&last, high)].into_iter().find(|(gap, _)| is_zero(gap)) {
        return Some(ParameterRoot { t, error: 0.0 });
    }
    if first.order()? == last.order()? {
        return None;
    }
    let slope = (last.value - first.value) / (high - low);
    let (mut below, mut above) = (first.value, last.value);
    // Which end stayed in the step before.
    let mut stayed = None;
    for step in 0..STEPS {
        let middle = 0.5 * (low + high);
        let chord = low + (high - low) * below / (below - above);
        let t = if step % 3 != 2 && low < chord && chord < high { chord } else { middle };
        if t <= low || t >= high {
            break;
        }
        let found = value(t)?;
        match found.order() {
            Some(order) if Some(order) == first.order() => {
                (low, below) = (t, found.value);
                above *= if stayed == Some(Stayed::High) { 0.5 } else { 1.0 };
                stayed = Some(Stayed::High);
            }
            Some(_) => {
                (high, above) = (t, found.value);
                below *= if stayed == Some(Stayed::Low) { 0.5 } else { 1.0 };
                stayed = Some(Stayed::Low);
            }
            None => {
                if is_zero(&found) {
                    return Some(ParameterRoot { t, error: 0.0 });
                }
                let t = t - found.value / slope;
                return Some(ParameterRoot { t, error: 2.0 * found.error / slope.abs() + f64::EPSILON * t.abs() });
            }
        }
    }
    Some(ParameterRoot { t: 0.5 * (low + high), error: high - low })
}

/// The end of an interval that a step did not move.
#[derive(Clone, Copy, PartialEq)]
enum Stayed {
    Low,
    High,
}
