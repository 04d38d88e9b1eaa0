//! The course of a curve: a polyline and the spectral type along it, by Newton continuation; its ends from the limits.

use super::Atlas;
use crate::continuation::{PieceEnd, Start, TrackOptions, track_piece};
use crate::curves::{Branch, Curve, CurveId, End, Orbit, Shape};
use crate::stability::{RelativeEquilibrium, Stability, StabilitySpan, stability_of};

/// How finely curves are drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CourseOptions {
    /// Largest distance between a curve and its polyline, relative to the ranges of h and l of the events.
    pub chord_tolerance: f64,
    /// Curves that go on to infinity are drawn at least up to this l.
    pub l_least: f64,
    /// Whether curves are traced by continuation, which also finds stability; else only their closed form is sampled.
    pub stability: bool,
}

/// A polyline of a curve by rising l, and what is known of stability along it. In the body's units.
#[derive(Clone, Debug, PartialEq)]
pub struct Course {
    /// Points [h, l].
    pub polyline: Vec<[f64; 2]>,
    /// Spectral types by rising l; empty for pole lines, and where it was not asked for.
    pub stability: Vec<StabilitySpan>,
    /// False when continuation did not finish the curve: stability is then missing, the shape is from the closed form.
    pub finished: bool,
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
    /// Curves that go on to infinity are cut here.
    l_max: f64,
    /// Range of h of the events and of both ends.
    h_scale: f64,
}

impl Atlas {
    /// The course of a curve.
    #[must_use]
    pub fn course(&self, curve: CurveId, options: &CourseOptions) -> Course {
        let extent = extent(self, options);
        let curve = &self.arrangement.set.curves[curve];
        let [from, to] = curve.x().map(|x| (2.0 * x).sqrt());
        let to = to.min(extent.l_max);
        let sampled = |finished| {
            let unit = self.arrangement.set.frame.momentum_unit;
            let tolerance = options.chord_tolerance * self.energy(extent.h_scale);
            let polyline = self.sampled(curve, [from, to].map(|l| l * unit), tolerance);
            Course { polyline, stability: Vec::new(), finished }
        };
        if !curve.is_critical() || !options.stability || matches!(curve.orbit, Orbit::Sphere) {
            return sampled(true);
        }
        // The tracker reports why it stopped; a curve is never dropped for that.
        let tracked = tracked(self, curve, to, options, &extent);
        tracked.map_or_else(|| sampled(false), |(polyline, stability)| Course { polyline, stability, finished: true })
    }

    /// μ at both ends of a curve by rising μ, in the units of A; `None` where it is infinite, and for pole lines.
    #[must_use]
    pub fn mu_range(&self, curve: CurveId) -> Option<[Option<f64>; 2]> {
        mu_range(self, &self.arrangement.set.curves[curve])
    }

    /// How a curve goes on to infinity; `None` for one with two finite ends.
    #[must_use]
    pub fn tail(&self, curve: CurveId) -> Option<Tail> {
        tail(self, &self.arrangement.set.curves[curve])
    }
}

fn extent(atlas: &Atlas, options: &CourseOptions) -> Extent {
    let frame = &atlas.arrangement.set.frame;
    let last_event = atlas.arrangement.events.last().map_or(0.0, |event| (2.0 * event.x).sqrt());
    let window = options.l_least / frame.momentum_unit;
    // √(r a) is the momentum at which kinetic and potential energy are alike.
    let natural = 3.0 * (frame.r_norm.max(1.0) * frame.a[2]).sqrt();
    let l_max = (1.6 * last_event).max(window).max(natural);
    let h_scale = 0.5 * l_max * l_max / frame.a[2] + 2.0 * frame.r_norm;
    Extent { l_max, h_scale }
}

/// Polyline and stability by Newton continuation from a point inside the curve.
fn tracked(
    atlas: &Atlas,
    curve: &Curve,
    l_end: f64,
    options: &CourseOptions,
    extent: &Extent,
) -> Option<(Vec<[f64; 2]>, Vec<StabilitySpan>)> {
    let frame = &atlas.arrangement.set.frame;
    let [from, to] = curve.x();
    let x_end = 0.5 * l_end * l_end;
    let x = if from == 0.0 { 0.25 * to.min(x_end) } else { from + 0.5 * (to.min(x_end.max(4.0 * from)) - from) };
    let point = curve.point(frame, x);
    let start = Start::on(frame, RelativeEquilibrium::new(frame, point.gamma, (2.0 * x).sqrt() / point.j));
    let end = |end: End, limit: f64| match end {
        End::Cusp(_) => PieceEnd::Cusp(limit),
        End::Pitchfork(_) => PieceEnd::Pitchfork(limit),
        End::Origin | End::Infinity => PieceEnd::Momentum(limit),
    };
    let [l_from, l_to] = curve.x().map(|x| (2.0 * x).sqrt());
    let cut = l_end.max(1.25 * (2.0 * from).sqrt());
    let ends = [end(curve.ends[0], l_from), end(curve.ends[1], l_to.min(cut))];
    let track_options = TrackOptions {
        chord_tolerance: options.chord_tolerance,
        h_scale: extent.h_scale,
        l_scale: extent.l_max,
        ..TrackOptions::default()
    };
    let track = track_piece(frame, &start, ends, &track_options).ok().filter(|track| track.complete)?;
    let (energy, momentum) = (frame.energy_unit, frame.momentum_unit);
    let polyline = track.polyline().into_iter().map(|[h, l]| [h * energy, l * momentum]).collect();
    let mut spans: Vec<StabilitySpan> = track
        .stability
        .iter()
        .map(|span| StabilitySpan { l_from: span.l_from * momentum, l_to: span.l_to.map(|l| l * momentum), ..*span })
        .collect();
    fill_gaps(atlas, curve, [l_from, l_to.min(cut)], &mut spans);
    if to.is_infinite() {
        continue_stability(atlas, curve, cut, &mut spans);
    }
    Some((polyline, spans))
}

/// Stability by the closed form at l in the frame's units.
fn stability_at(atlas: &Atlas, curve: &Curve, l: f64) -> Stability {
    let frame = &atlas.arrangement.set.frame;
    let point = curve.point(frame, 0.5 * l * l);
    stability_of(frame, point.gamma, l / point.j)
}

/// Stretches that the tracker left open, because the type is degenerate all along them, are filled by the closed form.
fn fill_gaps(atlas: &Atlas, curve: &Curve, l_range: [f64; 2], spans: &mut Vec<StabilitySpan>) {
    let unit = atlas.arrangement.set.frame.momentum_unit;
    let mut filled: Vec<StabilitySpan> = Vec::new();
    let mut reached = l_range[0] * unit;
    let end = StabilitySpan { l_from: l_range[1] * unit, l_to: None, stability: Stability::Degenerate };
    for span in spans.drain(..).chain(std::iter::once(end)) {
        if span.l_from > reached * (1.0 + 1e-9) {
            let stability = stability_at(atlas, curve, 0.5 * (reached + span.l_from) / unit);
            filled.push(StabilitySpan { l_from: reached, l_to: Some(span.l_from), stability });
        }
        reached = span.l_to.unwrap_or(f64::INFINITY);
        filled.push(span);
    }
    // The sentinel.
    filled.pop();
    for span in filled {
        match spans.last_mut() {
            Some(last) if last.stability == span.stability => last.l_to = span.l_to,
            _ => spans.push(span),
        }
    }
}

/// Stability beyond the cut: looked up at growing l by the closed form, changes found by bisection.
fn continue_stability(atlas: &Atlas, curve: &Curve, cut: f64, spans: &mut Vec<StabilitySpan>) {
    const DOUBLINGS: u32 = 12;
    let unit = atlas.arrangement.set.frame.momentum_unit;
    let at = |l: f64| stability_at(atlas, curve, l);
    let mut l = cut;
    let mut last = spans.last().map_or(Stability::Degenerate, |span| span.stability);
    for _ in 0..DOUBLINGS {
        let next = at(2.0 * l);
        if next != last && next != Stability::Degenerate {
            let (mut low, mut high) = (l, 2.0 * l);
            while high - low > 4.0 * f64::EPSILON * high {
                let middle = 0.5 * (low + high);
                if middle <= low || middle >= high {
                    break;
                }
                if at(middle) == last { low = middle } else { high = middle }
            }
            let l_from = high * unit;
            if let Some(span) = spans.last_mut() {
                span.l_to = Some(l_from);
            }
            spans.push(StabilitySpan { l_from, l_to: None, stability: next });
            last = next;
        }
        l *= 2.0;
    }
    if let Some(span) = spans.last_mut() {
        span.l_to = None;
    }
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
    let low = ends.iter().copied().fold(f64::INFINITY, f64::min);
    let high = ends.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    Some([low, high].map(|mu| mu.is_finite().then_some(mu * unit)))
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
