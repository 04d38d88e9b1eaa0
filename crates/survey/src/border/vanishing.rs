//! Borders to the last digits: the function that vanishes there.
//!
//! Near a border the atlas leaves bodies undecided, since its events draw together faster than the parameter. But what
//! happens there is known by then, and with it a function of the parameter that passes through 0 with a slope: a difference
//! of heights, an exact excess. Its zero is found without any atlas.

use super::event::EventLocation;
use super::segment::BodySegment;
use bifdiag_body::{Axis, Frame};
use bifdiag_diagram::arrangement::{Arrangement, Change};
use bifdiag_equilibria::curves::{Branch, CriticalSet, CurveId, Gap, Point};

/// What vanishes at a border.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Vanishing {
    /// The excess of the pair over this axis of the frame, an exact fraction: its cusp reaches its pitchfork.
    Excess(Axis),
    /// J_r − a of the middle axis, an exact fraction.
    MiddleMoment,
    /// The height of a cusp of one branch over a curve of another.
    CuspOnCurve { cusp: Branch, curve: Branch, near: Neighbourhood },
    /// The height of the pitchfork of the pair over an axis over a curve.
    PitchforkOnCurve { axis: Axis, curve: Branch },
    /// The height of a curve over the crossing of two others.
    CurveOnCrossing { crossing: [Branch; 2], curve: Branch, near: Neighbourhood },
    /// The squared difference of J at two cusps of one branch, which exist on one side only.
    TwoCusps { branch: Branch, near: Neighbourhood, above: bool },
    /// Nothing that is known.
    Nothing,
}

/// A place in the plane of (l²/2, h) in the body's units, near which an event is sought again.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Neighbourhood {
    pub x: f64,
    pub h: f64,
}

impl Neighbourhood {
    /// Of a point in the frame's units.
    pub(super) fn of(frame: &Frame, x: f64, h: f64) -> Self {
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
        Vanishing::TwoCusps { branch, near, above } => extrapolated(segment, *branch, near, *above, t),
        _ => bisected(|t| value(segment, vanishing, t), t),
    }
}

/// The point (in the body's units) at which it happens to the body at the border, with a bound on the error of both: a
/// cusp or pitchfork, which that body has for itself.
pub(super) fn place(segment: &BodySegment, vanishing: &Vanishing, root: &ParameterRoot) -> Option<EventLocation> {
    let set = CriticalSet::new(segment.body(root.t).frame()).ok()?;
    let point = match vanishing {
        Vanishing::Excess(axis) | Vanishing::PitchforkOnCurve { axis, .. } => pitchfork(&set, *axis)?,
        Vanishing::CuspOnCurve { cusp, near, .. } => nearest_cusp(&set, *cusp, near)?,
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

fn value(segment: &BodySegment, vanishing: &Vanishing, t: f64) -> Option<Gap> {
    let frame = segment.body(t).frame();
    let exact = |value: f64| Some(Gap { value, error: 0.0 });
    match vanishing {
        Vanishing::Excess(axis) => return exact(frame.symmetric_sums[*axis].cusp_excess),
        Vanishing::MiddleMoment => return exact(frame.offset[1]),
        _ => {}
    }
    let set = CriticalSet::new(frame).ok()?;
    match vanishing {
        Vanishing::CuspOnCurve { cusp, curve, near } => height(&set, &nearest_cusp(&set, *cusp, near)?, *curve),
        Vanishing::PitchforkOnCurve { axis, curve } => height(&set, &pitchfork(&set, *axis)?, *curve),
        Vanishing::CurveOnCrossing { crossing, curve, near } => {
            let arrangement = Arrangement::new(set);
            let set = &arrangement.set;
            let branch = |c: CurveId| set.curves[c].branch;
            let found = arrangement
                .events
                .iter()
                .filter(|event| match event.change {
                    Change::Swap([a, b]) => [branch(a), branch(b)] == *crossing || [branch(b), branch(a)] == *crossing,
                    _ => false,
                })
                .min_by(|p, q| {
                    let far = |x: f64, h: f64| near.distance(&set.frame, x, h);
                    far(p.x, p.h).total_cmp(&far(q.x, q.h))
                })?;
            let Change::Swap([a, _]) = found.change else { return None };
            height(set, &set.curves[a].point(&set.frame, found.x), *curve)
        }
        _ => None,
    }
}

/// h of a point minus that of the nearest curve of a branch at the same x.
fn height(set: &CriticalSet, point: &Point, branch: Branch) -> Option<Gap> {
    set.curves
        .iter()
        .filter(|curve| curve.branch == branch && curve.x()[0] < point.x && point.x < curve.x()[1])
        .map(|curve| Gap::between(&set.frame, point, &curve.point(&set.frame, point.x)))
        .min_by(|p, q| p.value.abs().total_cmp(&q.value.abs()))
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

/// Inverse interpolation of t over f = (J − J')² of the two cusps, beyond the side on which they exist: they part like the
/// root of the distance from the border, so f is smooth there and vanishes with a slope.
fn extrapolated(
    segment: &BodySegment,
    branch: Branch,
    near: &Neighbourhood,
    above: bool,
    t: [f64; 2],
) -> Option<ParameterRoot> {
    const POINTS: usize = 6;
    let width = (t[1] - t[0]).max(1e-7);
    let mut known: Vec<(f64, f64)> = Vec::with_capacity(POINTS);
    for k in 0..POINTS {
        let step = 3.0 * width * k as f64;
        let at = if above { t[1] + step } else { t[0] - step };
        if !(0.0..=1.0).contains(&at) {
            break;
        }
        let set = CriticalSet::new(segment.body(at).frame()).ok()?;
        let mut cusps: Vec<Point> = set
            .cusps
            .iter()
            .filter(|cusp| set.curves[cusp.curves[0]].branch == branch)
            .map(|cusp| cusp.point)
            .collect();
        let far = |point: &Point| near.distance(&set.frame, point.x, point.h());
        cusps.sort_by(|p, q| far(p).total_cmp(&far(q)));
        let [p, q] = cusps.get(..2)? else { break };
        let difference = (p.j - q.j) / set.frame.a[2];
        known.push((difference * difference, at));
    }
    if known.len() < 3 {
        return None;
    }
    let whole = neville(&known);
    let fewer = neville(&known[..known.len() - 1]);
    Some(ParameterRoot { t: whole, error: (whole - fewer).abs() + f64::EPSILON })
}

/// The value at 0 of the polynomial through (f, t).
fn neville(known: &[(f64, f64)]) -> f64 {
    let mut table: Vec<f64> = known.iter().map(|(_, t)| *t).collect();
    for order in 1..known.len() {
        for k in 0..known.len() - order {
            let (from, to) = (known[k].0, known[k + order].0);
            table[k] = (to * table[k] - from * table[k + 1]) / (to - from);
        }
    }
    table[0]
}
