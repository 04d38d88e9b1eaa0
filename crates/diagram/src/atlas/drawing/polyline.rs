//! Polylines from the closed form, with a bound on the distance between each chord and its curve.
//!
//! The course of a curve: a polyline over the range of a picture; its ends from the limits.

use crate::atlas::Atlas;
use bifdiag_body::Frame;
use bifdiag_equilibria::curves::{Branch, Curve, CurveId, CurveName, End, Shape};
use bifdiag_numbers::UNIT_ROUNDOFF;

/// How far a chord may leave its curve.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tolerance {
    /// In h, in the frame's units.
    pub h: f64,
    /// Width over height of the picture in whose units the distance is measured across the chord; 0: along h.
    pub aspect: f64,
}

impl Tolerance {
    /// In h, for a chord of this slope.
    fn of_chord(&self, slope: f64) -> f64 {
        let steepness = slope * self.aspect;
        self.h * (1.0 + steepness * steepness).sqrt()
    }
}

/// What a steep chord in a picture may be off in l, as a part of the picture's range.
const STEEP: f64 = 1e-4;

/// A point of a curve in the frame's units.
#[derive(Clone, Copy)]
struct CurvePoint {
    l: f64,
    h: f64,
    /// dh/dx = 1/J, x = l²/2; so dh/dl = l/J.
    slope: f64,
}

impl CurvePoint {
    fn at(frame: &Frame, curve: &Curve, l: f64) -> Self {
        let [from, to] = curve.x();
        // Below this x every curve that starts at l = 0 is at its limit to the last bit.
        let smallest = if from > 0.0 { from } else { 1e-60 };
        let point = curve.point(frame, (0.5 * l * l).max(smallest).min(to));
        Self { l, h: point.h(), slope: point.slope() }
    }
}

impl Atlas {
    /// Points [h, l] of a curve by rising l over the common part of its range and `l`, such that the straight line
    /// between neighbours is off by at most `tolerance` in h. `None` when there is no such curve or no common part.
    #[must_use]
    pub fn polyline(&self, curve: CurveName, l: [f64; 2], tolerance: f64) -> Option<Vec<[f64; 2]>> {
        let h = tolerance / self.arrangement.set.frame.energy_unit;
        self.chords(curve, l, Tolerance { h, aspect: 0.0 })
    }

    /// Likewise for a picture over the range `l`: where the curve is steep, a chord may be off by more in h, if it is off
    /// by at most a ten-thousandth of the range in l. A rod's curves need a number of points that does not grow with
    /// their steepness.
    #[must_use]
    pub fn polyline_to_draw(&self, curve: CurveName, l: [f64; 2], tolerance: f64) -> Option<Vec<[f64; 2]>> {
        let frame = &self.arrangement.set.frame;
        let h = tolerance / frame.energy_unit;
        self.chords(curve, l, Tolerance { h, aspect: STEEP * (l[1] - l[0]) / frame.momentum_unit / h })
    }

    /// The energies of a curve at momenta, at its ends and beyond them the limits; `None` when there is no such curve.
    #[must_use]
    pub fn energies(&self, curve: CurveName, momenta: &[f64]) -> Option<Vec<f64>> {
        let pieces = self.named(curve);
        let first = *pieces.first()?;
        let over =
            |l: f64| pieces.iter().rev().find(|piece| self.momentum(piece.x()[0]) <= l).copied().unwrap_or(first);
        Some(momenta.iter().map(|&l| self.h_at(over(l), l)).collect())
    }

    /// The pieces of a curve by rising l: of a pole line on an axis all those of the axis; none where there is no such curve.
    fn named(&self, name: CurveName) -> Vec<&Curve> {
        let set = &self.arrangement.set;
        let is_named =
            |id: &CurveId| CurveName::of(set, *id) == name || set.curves[*id].pole.map(CurveName::Pole) == Some(name);
        let mut pieces: Vec<&Curve> = set.curves.ids().filter(is_named).map(|id| &set.curves[id]).collect();
        pieces.sort_by(|p, q| p.x()[0].total_cmp(&q.x()[0]));
        pieces
    }

    fn chords(&self, curve: CurveName, l: [f64; 2], tolerance: Tolerance) -> Option<Vec<[f64; 2]>> {
        let unit = self.arrangement.set.frame.momentum_unit;
        let mut found: Vec<[f64; 2]> = Vec::new();
        for piece in self.named(curve) {
            let range = piece.x().map(|x| self.momentum(x));
            let range = [range[0].max(l[0]), range[1].min(l[1])];
            if range[0] < range[1] {
                let mut points = self.sampled(piece, range.map(|l| l / unit), tolerance);
                let last = points.len() - 1;
                (points[0][1], points[last][1]) = (range[0], range[1]);
                // Where a piece begins the one before has ended.
                found.pop();
                found.extend(points);
            }
        }
        (!found.is_empty()).then_some(found)
    }

    /// The polyline of a curve, in the body's units, over a range of l inside its own, in the frame's.
    pub(super) fn sampled(&self, curve: &Curve, [from, to]: [f64; 2], tolerance: Tolerance) -> Vec<[f64; 2]> {
        let frame = &self.arrangement.set.frame;
        let mut nodes = vec![CurvePoint::at(frame, curve, from)];
        for arc in &curve.arcs {
            let end = (2.0 * arc.x[1]).sqrt().min(to);
            if end > nodes[nodes.len() - 1].l {
                extend(&mut nodes, end, tolerance, |l| CurvePoint::at(frame, curve, l));
            }
        }
        nodes.iter().map(|node| [self.energy(node.h), node.l * frame.momentum_unit]).collect()
    }

    /// h of a curve at l, in the body's units; at its ends the limits.
    pub(super) fn h_at(&self, curve: &Curve, l: f64) -> f64 {
        let frame = &self.arrangement.set.frame;
        self.energy(CurvePoint::at(frame, curve, l / frame.momentum_unit).h)
    }
}

/// Adds nodes up to `end`, along an arc, with chords nearly as long as the tolerance allows.
fn extend(nodes: &mut Vec<CurvePoint>, end: f64, tolerance: Tolerance, at: impl Fn(f64) -> CurvePoint) {
    /// Share of the tolerance that is aimed at.
    const AIM: f64 = 0.95;
    /// A chord is not asked to be closer than this many units of roundoff of h, which no more points would mend.
    const ROUNDINGS: f64 = 64.0;
    let mut from = nodes[nodes.len() - 1];
    let last = at(end);
    let mut to = last;
    while from.l < end {
        let width = to.l - from.l;
        let l = from.l + 0.5 * width;
        let noise = ROUNDINGS * UNIT_ROUNDOFF * from.h.abs().max(to.h.abs());
        let allowed = tolerance.of_chord((to.h - from.h) / width).max(noise);
        // Between neighbouring doubles there is nothing to add.
        let divisible = from.l < l && l < to.l;
        let share = if divisible { excursion([from, at(l), to]) / allowed } else { AIM };
        let factor = (AIM / share).sqrt();
        let step = if share <= 1.0 {
            nodes.push(to);
            from = to;
            width * factor.clamp(1.0, 4.0)
        } else {
            width * factor.clamp(0.1, 0.9)
        };
        let next = from.l + step;
        to = if next < end { at(next.max(from.l.next_up())) } else { last };
    }
}

/// A bound on the distance in h between an arc and the chord through its ends, from a third point between them.
///
/// Over x the slope 1/J is monotone along an arc (Proposition 3.8 of docs/algorithms.md), so that between two of its points
/// the arc lies in the triangle of its chord over x and its tangents there. All three are parabolas over l.
fn excursion([from, middle, to]: [CurvePoint; 3]) -> f64 {
    let slope = (to.h - from.h) / (to.l - from.l);
    let off = middle.h - from.h - slope * (middle.l - from.l);
    half([from, middle], [0.0, off], slope).max(half([middle, to], [off, 0.0], slope))
}

/// The largest distance of such a triangle from a chord of this slope, given those of its two points on the arc.
fn half([from, to]: [CurvePoint; 2], off: [f64; 2], slope: f64) -> f64 {
    let width = to.l - from.l;
    let x_width = 0.5 * width * (to.l + from.l);
    let rise = to.h - from.h;
    // Where the tangents meet: over x, from the first point, and then over l. On a straight arc: nowhere.
    let meeting = (rise - to.slope * x_width) / (from.slope - to.slope);
    let meeting = if meeting > 0.0 { meeting.min(x_width) } else { 0.0 };
    let corner = if meeting > 0.0 { 2.0 * meeting / (from.l + (from.l * from.l + 2.0 * meeting).sqrt()) } else { 0.0 };
    let corner = corner.min(width);
    let chord = rise / x_width;
    let first = Parabola { off: off[0], slope: from.slope * from.l - slope, bend: from.slope };
    let second = Parabola { off: off[1], slope: to.slope * to.l - slope, bend: to.slope };
    let between = Parabola { off: off[0], slope: chord * from.l - slope, bend: chord };
    first.largest([0.0, corner]).max(second.largest([corner - width, 0.0])).max(between.largest([0.0, width]))
}

/// off + slope t + bend t²/2, bend > 0.
struct Parabola {
    off: f64,
    slope: f64,
    bend: f64,
}

impl Parabola {
    /// The largest absolute value over a range.
    fn largest(&self, [from, to]: [f64; 2]) -> f64 {
        let lowest = (-self.slope / self.bend).clamp(from, to);
        let value = |t: f64| (self.off + t * (self.slope + 0.5 * self.bend * t)).abs();
        value(from).max(value(to)).max(value(lowest))
    }
}

/// How finely curves are drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PolylineOptions {
    /// Largest distance between a curve and its polyline, relative to the ranges of h and l of the events.
    pub chord_tolerance: f64,
    /// Unbounded curves are drawn at least up to this l.
    pub l_least: f64,
}

/// h = l²/(2 J) + h0 + O(l⁻²) as l → ∞.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tail {
    /// J: the moment of inertia of the limiting axis.
    pub moment: f64,
    /// h0.
    pub h_offset: f64,
}

/// Ranges for which polylines are made, in the frame's units.
struct Extent {
    /// Unbounded curves are cut here.
    l_max: f64,
    /// Range of h of the events and of both ends.
    h_scale: f64,
}

impl Atlas {
    /// A polyline of a curve by rising l: points [h, l] in the body's units.
    #[must_use]
    pub fn polyline_of(&self, curve: CurveId, options: &PolylineOptions) -> Vec<[f64; 2]> {
        let extent = extent(self, options);
        let curve = &self.arrangement.set.curves[curve];
        let [from, to] = curve.x().map(|x| (2.0 * x).sqrt());
        let tolerance =
            Tolerance { h: options.chord_tolerance * extent.h_scale, aspect: extent.l_max / extent.h_scale };
        self.sampled(curve, [from, to.min(extent.l_max)], tolerance)
    }

    /// μ at both ends of a curve by rising μ, in the units of A; `None` where it is infinite, and for pole lines.
    #[must_use]
    pub fn mu_range(&self, curve: CurveId) -> Option<[Option<f64>; 2]> {
        mu_range(self, &self.arrangement.set.curves[curve])
    }

    /// The asymptote of a curve; `None` for one with two finite ends.
    #[must_use]
    pub fn tail(&self, curve: CurveId) -> Option<Tail> {
        tail(self, &self.arrangement.set.curves[curve])
    }
}

impl Atlas {
    /// The l up to which unbounded curves are drawn by default.
    pub(super) fn drawn_up_to(&self) -> f64 {
        let options = PolylineOptions { chord_tolerance: 0.0, l_least: 0.0 };
        extent(self, &options).l_max * self.arrangement.set.frame.momentum_unit
    }
}

fn extent(atlas: &Atlas, options: &PolylineOptions) -> Extent {
    let frame = &atlas.arrangement.set.frame;
    let last_event = atlas.arrangement.events.last().map_or(0.0, |event| (2.0 * event.x).sqrt());
    let window = options.l_least / frame.momentum_unit;
    // √(r a) is the momentum at which kinetic and potential energy are alike.
    let natural = 3.0 * (frame.r_norm.max(1.0) * frame.a[2]).sqrt();
    let l_max = (1.6 * last_event).max(window).max(natural);
    let h_scale = 0.5 * l_max * l_max / frame.a[2] + 2.0 * frame.r_norm;
    Extent { l_max, h_scale }
}

/// μ at both ends by rising μ, in the units of A; `None` where it is infinite.
fn mu_range(atlas: &Atlas, curve: &Curve) -> Option<[Option<f64>; 2]> {
    let frame = &atlas.arrangement.set.frame;
    let unit = frame.momentum_unit * frame.momentum_unit / frame.energy_unit;
    let mut ends: Vec<f64> = Vec::new();
    for arc in &curve.arcs {
        match &arc.shape {
            Shape::Generic(segments) => {
                for segment in segments {
                    ends.extend(segment.distance.map(|d| frame.a[segment.base] + segment.sign * d));
                }
            }
            Shape::Symmetric { family, .. } => ends.push(frame.a[family.axis]),
            Shape::Straight { gamma, j } => {
                if !matches!(curve.branch, Branch::Axis(_)) {
                    return None;
                }
                // μ = a ± r/s with s = 2x/a².
                let side: f64 = gamma.iter().sum();
                ends.extend(arc.x.map(|x| j + side * frame.r_norm * j * j / (2.0 * x)));
            }
        }
    }
    let mut range =
        [ends.iter().copied().fold(f64::INFINITY, f64::min), ends.iter().copied().fold(f64::NEG_INFINITY, f64::max)];
    // A pitchfork lies at a moment, which is known to all its digits, whatever moment the family is measured from.
    let forks = curve.ends.iter().filter_map(|end| match end {
        End::Pitchfork(number) => Some(frame.a[atlas.arrangement.set.pitchforks[*number].axis]),
        _ => None,
    });
    match forks.collect::<Vec<f64>>()[..] {
        [p, q] => range = [p.min(q), p.max(q)],
        [p] => range[usize::from((range[1] - p).abs() < (range[0] - p).abs())] = p,
        _ => {}
    }
    Some(range.map(|mu| mu.is_finite().then_some(mu * unit)))
}

/// J and h0 of h = l²/(2J) + h0 as l → ∞.
fn tail(atlas: &Atlas, curve: &Curve) -> Option<Tail> {
    let frame = &atlas.arrangement.set.frame;
    if curve.x()[1].is_finite() {
        return None;
    }
    let last = &curve.arcs[curve.arcs.len() - 1];
    let (moment, rho) = match &last.shape {
        Shape::Straight { gamma, j } => (*j, (0..3).map(|k| gamma[k] * frame.r[k]).sum()),
        Shape::Generic(segments) => {
            let segment = segments[segments.len() - 1];
            (frame.a[segment.base], segment.sign * frame.r[segment.base])
        }
        Shape::Symmetric { family, .. } => (frame.a[family.axis], 0.0),
    };
    let unit = frame.momentum_unit * frame.momentum_unit / frame.energy_unit;
    // 0 − ρ, so that ρ = 0 gives 0 and not −0.
    Some(Tail { moment: moment * unit, h_offset: atlas.energy(0.0 - rho) })
}
