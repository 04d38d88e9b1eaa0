//! Line styles: solid where stable, dashed where not, dotted where the spectrum does not tell, both colours where curves
//! coincide.

use std::collections::BTreeMap;

use plotters::style::RGBColor;

use super::PlotError;
use super::canvas::{Canvas, Ink, Point};
use super::geometry::{between, clip_polyline, distance};
use super::palette::{BranchStyle, FAINT_INK, POLE, is_pole};
use super::panel::Panel;
use super::trace::l_range;
use schema::{AtlasDocument, CurveDocument, CurveKind, Stability, StabilitySpan};

/// Width of a simple curve in pixels.
pub(super) const WIDTH: f64 = 1.5;
/// Width of a double curve.
pub(super) const DOUBLE_WIDTH: f64 = 2.4;

/// A repeating sequence of lengths in pixels, each with its colour or empty.
pub(super) type Pattern = Vec<(Option<RGBColor>, f64)>;

/// A stretch of a curve drawn in one style.
#[derive(Clone, Debug)]
pub(super) struct Stroke {
    /// Index of the curve that gives the course.
    pub curve: usize,
    /// From this l to that; the upper end may be infinite.
    pub l: [f64; 2],
    pub pattern: Pattern,
    pub width: f64,
}

/// What the spectrum says of the stability of a curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Verdict {
    /// Elliptic.
    Stable,
    /// An eigenvalue zero or a double pair within rounding, or nothing known.
    Open,
    /// A real or complex eigenvalue.
    Unstable,
}

/// The verdict at `l`.
fn verdict_at(curve: &CurveDocument, l: f64) -> Verdict {
    let span = curve.stability.iter().find(|span| l >= span.l_from && span.l_to.is_none_or(|to| l <= to));
    span.map_or(Verdict::Open, verdict)
}

/// The verdict of a stretch.
pub(super) fn verdict(span: &StabilitySpan) -> Verdict {
    match span.stability {
        Stability::Elliptic => Verdict::Stable,
        Stability::Degenerate => Verdict::Open,
        Stability::SaddleCentre | Stability::Saddle | Stability::Complex => Verdict::Unstable,
    }
}

/// The pattern of a curve in `colors` that coincide.
pub(super) fn curve_pattern(colors: &[RGBColor], verdict: Verdict) -> Pattern {
    let gapped = |on: f64, off: f64| colors.iter().flat_map(|color| [(Some(*color), on), (None, off)]).collect();
    match (colors, verdict) {
        ([color], Verdict::Stable) => vec![(Some(*color), 1.0)],
        (_, Verdict::Stable) => colors.iter().map(|color| (Some(*color), 9.0)).collect(),
        (_, Verdict::Open) => gapped(1.6, 2.4),
        (_, Verdict::Unstable) => gapped(5.0, 3.0),
    }
}

/// The pattern of a pole line: dash and dot for P+, dash and two dots for P−.
pub(super) fn pole_pattern(kind: CurveKind) -> Pattern {
    let dash = [(Some(POLE), 9.0), (None, 2.5)];
    let dot = [(Some(POLE), 1.8), (None, 2.5)];
    let dots = if kind == CurveKind::PolePlus { 1 } else { 2 };
    dash.into_iter().chain(std::iter::repeat_n(dot, dots).flatten()).collect()
}

/// The sets of curves with the same (h, l), by index, each set once.
pub(super) fn coincidences(atlas: &AtlasDocument) -> Vec<Vec<usize>> {
    let mut set_of: Vec<usize> = (0..atlas.curves.len()).collect();
    for (index, curve) in atlas.curves.iter().enumerate() {
        for other in &curve.coincides_with {
            let Some(other) = atlas.curves.iter().position(|candidate| candidate.id == *other) else { continue };
            let (keep, drop) = (set_of[index].min(set_of[other]), set_of[index].max(set_of[other]));
            set_of.iter_mut().filter(|set| **set == drop).for_each(|set| *set = keep);
        }
    }
    let mut sets: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for (index, set) in set_of.into_iter().enumerate() {
        sets.entry(set).or_default().push(index);
    }
    sets.into_values().collect()
}

/// How every curve of the atlas is drawn, pole lines last.
pub(super) fn strokes(atlas: &AtlasDocument, styles: &BTreeMap<&str, BranchStyle>) -> Vec<Stroke> {
    let mut strokes: Vec<(bool, Stroke)> = Vec::new();
    for set in coincidences(atlas) {
        let members: Vec<(usize, &CurveDocument)> = set.iter().map(|&index| (index, &atlas.curves[index])).collect();
        let mut ends: Vec<f64> = members
            .iter()
            .flat_map(|(_, curve)| {
                let spans = curve.stability.iter().map(|span| span.l_from);
                l_range(curve).into_iter().chain(spans).collect::<Vec<f64>>()
            })
            .collect();
        ends.sort_by(f64::total_cmp);
        ends.dedup();
        for pair in ends.windows(2) {
            let middle = if pair[1].is_finite() { pair[0] + (pair[1] - pair[0]) / 2.0 } else { pair[0] + 1.0 };
            let here = |curve: &CurveDocument| {
                let [from, to] = l_range(curve);
                middle >= from && middle <= to
            };
            let active: Vec<(usize, &CurveDocument)> =
                members.iter().filter(|(_, curve)| here(curve)).copied().collect();
            let Some(&(index, first)) = active.first() else { continue };
            let critical: Vec<&CurveDocument> =
                active.iter().map(|(_, curve)| *curve).filter(|curve| !is_pole(curve)).collect();
            let mut colors: Vec<RGBColor> = Vec::new();
            for (_, curve) in &active {
                let color = if is_pole(curve) {
                    POLE
                } else {
                    styles.get(curve.branch.as_str()).map_or(FAINT_INK, |style| style.color)
                };
                if !colors.contains(&color) {
                    colors.push(color);
                }
            }
            let pattern = if critical.is_empty() {
                pole_pattern(first.kind)
            } else {
                let verdicts = critical.iter().map(|curve| verdict_at(curve, middle));
                curve_pattern(&colors, verdicts.max().unwrap_or(Verdict::Open))
            };
            let double = active.iter().any(|(_, curve)| curve.multiplicity > 1);
            let width = if double { DOUBLE_WIDTH } else { WIDTH };
            strokes.push((critical.is_empty(), Stroke { curve: index, l: [pair[0], pair[1]], pattern, width }));
        }
    }
    strokes.sort_by_key(|(pole, _)| *pole);
    strokes.into_iter().map(|(_, stroke)| stroke).collect()
}

/// Draws a stroke in a panel.
pub(super) fn draw(canvas: &Canvas<'_>, panel: &Panel, stroke: &Stroke) -> Result<(), PlotError> {
    let points = panel.traces[stroke.curve].part(stroke.l[0], stroke.l[1]);
    for part in clip_polyline(&panel.view.positions(&points), &panel.view.rect) {
        line(canvas, &part, &stroke.pattern, stroke.width)?;
    }
    Ok(())
}

/// Draws a polyline in a pattern.
pub(super) fn line(canvas: &Canvas<'_>, points: &[Point], pattern: &Pattern, width: f64) -> Result<(), PlotError> {
    for (color, dash) in dashes(points, pattern) {
        canvas.path(&dash, Ink { color, width })?;
    }
    Ok(())
}

/// Cuts a polyline into the coloured pieces of a pattern.
fn dashes(points: &[Point], pattern: &Pattern) -> Vec<(RGBColor, Vec<Point>)> {
    if let [(Some(color), _)] = pattern[..] {
        return vec![(color, points.to_vec())];
    }
    let mut pieces = Vec::new();
    let Some(&start) = points.first() else { return pieces };
    let mut phase = pattern.iter().cycle();
    let Some(&(mut color, mut left)) = phase.next() else { return pieces };
    let mut piece = vec![start];
    for pair in points.windows(2) {
        let length = distance(pair[0], pair[1]);
        let mut done = 0.0;
        while done + left < length {
            done += left;
            let end = between(pair[0], pair[1], done / length);
            piece.push(end);
            if let Some(color) = color {
                pieces.push((color, std::mem::take(&mut piece)));
            }
            piece = vec![end];
            if let Some(next) = phase.next() {
                (color, left) = *next;
            }
        }
        left -= length - done;
        piece.push(pair[1]);
    }
    if let Some(color) = color {
        pieces.push((color, piece));
    }
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dashes_fill_the_line_in_turn() {
        let pattern = vec![(Some(POLE), 4.0), (None, 2.0)];
        let pieces = dashes(&[[0.0, 0.0], [3.0, 0.0], [3.0, 10.0]], &pattern);
        let lengths: Vec<f64> =
            pieces.iter().map(|(_, piece)| piece.windows(2).map(|pair| distance(pair[0], pair[1])).sum()).collect();
        assert_eq!(lengths, [4.0, 4.0, 1.0]);
        assert_eq!(pieces[0].1, [[0.0, 0.0], [3.0, 0.0], [3.0, 1.0]]);
    }
}
