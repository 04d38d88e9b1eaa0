//! Line styles: solid where all eigenvalues are imaginary, dashed where unstable, dotted where an eigenvalue is zero or
//! nothing is known, both colours where curves coincide.

use std::collections::BTreeMap;

use plotters::style::RGBColor;

use super::palette::{BranchStyle, is_pole};
use super::panel::Panel;
use super::ranges::l_range;
use crate::page::{Canvas, FAINT_INK, POLE, Pattern, clip_polyline, pattern};
use schema::{AtlasDocument, CurveDocument, CurveKind, Stability, StabilitySpan};

/// Width of a simple curve in pixels.
pub(super) const WIDTH: f64 = 1.5;
/// Width of a double curve.
pub(super) const DOUBLE_WIDTH: f64 = 2.4;

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
    /// All eigenvalues imaginary.
    Stable,
    /// An eigenvalue zero, or nothing known.
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
        kind if kind.is_unstable() => Verdict::Unstable,
        Stability::Zero => Verdict::Open,
        _ => Verdict::Stable,
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
        let mut ends: Vec<f64> = Vec::new();
        for &index in &set {
            let curve = &atlas.curves[index];
            ends.extend(l_range(curve.l_range));
            ends.extend(curve.stability.iter().map(|span| span.l_from));
        }
        ends.sort_by(f64::total_cmp);
        ends.dedup();
        strokes.extend(ends.windows(2).filter_map(|pair| stroke(atlas, styles, &set, [pair[0], pair[1]])));
    }
    strokes.sort_by_key(|(pole, _)| *pole);
    strokes.into_iter().map(|(_, stroke)| stroke).collect()
}

/// How the coincident curves of a set are drawn between two of their ends, and whether all of them are pole lines;
/// `None` where none of them runs.
fn stroke(
    atlas: &AtlasDocument,
    styles: &BTreeMap<&str, BranchStyle>,
    set: &[usize],
    l: [f64; 2],
) -> Option<(bool, Stroke)> {
    let middle = if l[1].is_finite() { l[0] + (l[1] - l[0]) / 2.0 } else { l[0] + 1.0 };
    let mut active = set.to_vec();
    active.retain(|&index| {
        let [from, to] = l_range(atlas.curves[index].l_range);
        middle >= from && middle <= to
    });
    let first = *active.first()?;
    let mut colors: Vec<RGBColor> = Vec::new();
    let mut verdict: Option<Verdict> = None;
    for curve in active.iter().map(|&index| &atlas.curves[index]) {
        let color = if is_pole(curve) {
            POLE
        } else {
            verdict = verdict.max(Some(verdict_at(curve, middle)));
            styles.get(curve.branch.as_str()).map_or(FAINT_INK, |style| style.color)
        };
        if !colors.contains(&color) {
            colors.push(color);
        }
    }
    let pattern = match verdict {
        Some(verdict) => curve_pattern(&colors, verdict),
        None => pole_pattern(atlas.curves[first].kind),
    };
    let double = active.iter().any(|&index| atlas.curves[index].multiplicity > 1);
    let width = if double { DOUBLE_WIDTH } else { WIDTH };
    Some((verdict.is_none(), Stroke { curve: first, l, pattern, width }))
}

/// Draws a stroke in a panel.
pub(super) fn draw(canvas: &Canvas<'_>, panel: &Panel, stroke: &Stroke) {
    let points = panel.traces[stroke.curve].part(stroke.l[0], stroke.l[1]);
    for part in clip_polyline(&panel.view.positions(&points), &panel.view.rect) {
        pattern::draw(canvas, &part, &stroke.pattern, stroke.width);
    }
}
