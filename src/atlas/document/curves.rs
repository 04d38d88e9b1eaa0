//! Curves of an atlas document: polylines, index and stability from the tracker, tails from the limits.

use super::super::Atlas;
use super::super::names::{branch_name, curve_name};
use super::DocumentOptions;
use crate::continuation::{PieceEnd, Start, TrackOptions, track_piece};
use crate::document::{Accuracy, CurveDocument, CurveKind, Stability, StabilitySpan, TailDocument, UndecidedDocument};
use crate::equilibria::{Branch, Curve, End, Orbit, Pole, Shape};
use crate::stability::{RelativeEquilibrium, stability_of};

/// Ranges of the picture for which the polylines are made, in the frame's units.
struct Extent {
    /// Curves that go on to infinity are cut here.
    l_max: f64,
    /// Range of h of the events and of both ends.
    h_scale: f64,
}

pub(super) fn documents(
    atlas: &Atlas,
    options: &DocumentOptions,
    undecided: &mut Vec<UndecidedDocument>,
) -> Vec<CurveDocument> {
    let set = &atlas.arrangement.set;
    let extent = extent(atlas, options);
    let mut documents: Vec<CurveDocument> =
        (0..set.curves.len()).map(|c| document(atlas, c, options, &extent, undecided)).collect();
    for (pole, name) in [(Pole::Plus, "P+"), (Pole::Minus, "P-")] {
        let on_axis: Vec<usize> = (0..set.curves.len())
            .filter(|&c| set.curves[c].pole == Some(pole) && set.curves[c].is_critical())
            .collect();
        if on_axis.is_empty() {
            continue;
        }
        let pieces: Vec<String> = on_axis.iter().map(|&c| curve_name(set, c)).collect();
        for &c in &on_axis {
            documents[c].coincides_with.push(name.to_owned());
        }
        documents.push(coincident_pole_line(name, &pieces, &documents));
    }
    documents
}

/// A pole line that runs on critical curves: their union.
fn coincident_pole_line(name: &str, pieces: &[String], documents: &[CurveDocument]) -> CurveDocument {
    let parts: Vec<&CurveDocument> = documents.iter().filter(|d| pieces.contains(&d.id)).collect();
    let mut by_l = parts.clone();
    by_l.sort_by(|p, q| p.l_range[0].unwrap_or(0.0).total_cmp(&q.l_range[0].unwrap_or(0.0)));
    let mut polyline: Vec<[f64; 2]> = Vec::new();
    for part in by_l {
        let skip = usize::from(polyline.last() == part.polyline.first() && !polyline.is_empty());
        polyline.extend(part.polyline.iter().skip(skip));
    }
    CurveDocument {
        id: name.to_owned(),
        kind: if name == "P+" { CurveKind::PolePlus } else { CurveKind::PoleMinus },
        branch: name.to_owned(),
        index: None,
        multiplicity: 1,
        coincides_with: pieces.to_vec(),
        mu_range: None,
        l_range: [Some(0.0), None],
        stability: Vec::new(),
        polyline,
        tail: parts.iter().find_map(|part| part.tail.clone()),
    }
}

fn extent(atlas: &Atlas, options: &DocumentOptions) -> Extent {
    let frame = &atlas.arrangement.set.frame;
    let last_event = atlas.arrangement.events.last().map_or(0.0, |event| (2.0 * event.x).sqrt());
    let window = options.window.map_or(0.0, |window| window.l[1] / frame.momentum_unit);
    // √(r a) is the momentum at which kinetic and potential energy are alike.
    let natural = 3.0 * (frame.r_norm.max(1.0) * frame.a[2]).sqrt();
    let l_max = (1.6 * last_event).max(window).max(natural);
    let h_scale = 0.5 * l_max * l_max / frame.a[2] + 2.0 * frame.r_norm;
    Extent { l_max, h_scale }
}

fn document(
    atlas: &Atlas,
    number: usize,
    options: &DocumentOptions,
    extent: &Extent,
    undecided: &mut Vec<UndecidedDocument>,
) -> CurveDocument {
    let set = &atlas.arrangement.set;
    let frame = &set.frame;
    let curve = &set.curves[number];
    let x = curve.x();
    let l_range = x.map(|x| x.is_finite().then(|| atlas.momentum(x)));
    let mut document = CurveDocument {
        id: curve_name(set, number),
        kind: kind(curve),
        branch: branch_name(frame, curve.branch),
        index: curve.index,
        multiplicity: if matches!(curve.orbit, Orbit::Pair(_)) { 2 } else { 1 },
        coincides_with: Vec::new(),
        mu_range: mu_range(atlas, curve),
        l_range,
        stability: Vec::new(),
        polyline: Vec::new(),
        tail: tail(atlas, curve),
    };
    let low = (2.0 * x[0]).sqrt();
    let seen = options.window.is_none_or(|window| {
        low * frame.momentum_unit <= window.l[1] && (2.0 * x[1]).sqrt() * frame.momentum_unit >= window.l[0]
    });
    if !options.polylines || !seen {
        return document;
    }
    let to = (2.0 * x[1]).sqrt().min(extent.l_max);
    let in_units = [low, to].map(|l| l * frame.momentum_unit);
    let tolerance = options.chord_tolerance * atlas.energy(extent.h_scale);
    if !curve.is_critical() || options.accuracy == Accuracy::Draft || matches!(curve.orbit, Orbit::Sphere) {
        document.polyline = atlas.sampled(curve, in_units, tolerance);
        return document;
    }
    if let Some((polyline, stability)) = tracked(atlas, curve, to, options, extent) {
        document.polyline = polyline;
        document.stability = stability;
    } else {
        // The tracker reports why it stopped; a curve is never dropped for that.
        document.polyline = atlas.sampled(curve, in_units, tolerance);
        undecided.push(UndecidedDocument {
            what: "the stability along a curve that continuation did not finish; its shape is from the closed form"
                .to_owned(),
            l: document.polyline[0][1],
            h: document.polyline[0][0],
            curves: vec![document.id.clone()],
        });
    }
    document
}

/// Polyline and stability by Newton continuation from a point inside the curve.
fn tracked(
    atlas: &Atlas,
    curve: &Curve,
    l_end: f64,
    options: &DocumentOptions,
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

fn kind(curve: &Curve) -> CurveKind {
    match (curve.orbit, curve.branch) {
        (Orbit::Pole(Pole::Plus), _) => CurveKind::PolePlus,
        (Orbit::Pole(Pole::Minus), _) => CurveKind::PoleMinus,
        (Orbit::Sphere, _) => CurveKind::Sphere,
        (Orbit::Circle(_), _) => CurveKind::Circle,
        (Orbit::Pair(_), _) => CurveKind::Pair,
        (Orbit::Point, Branch::Axis(_)) => CurveKind::Axis,
        (Orbit::Point, _) => CurveKind::Generic,
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
fn tail(atlas: &Atlas, curve: &Curve) -> Option<TailDocument> {
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
    Some(TailDocument { moment: moment * unit, h_offset: atlas.energy(0.0 - rho) })
}
