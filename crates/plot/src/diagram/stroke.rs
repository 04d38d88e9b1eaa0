//! Line styles: solid where all eigenvalues are imaginary, dashed where unstable, dotted where an eigenvalue is zero or
//! nothing is known; curves that coincide run side by side.

use std::collections::BTreeMap;

use plotters::style::RGBColor;

use super::palette::{BranchStyle, is_pole};
use super::panel::Panel;
use super::ranges::l_range;
use crate::page::{Canvas, FAINT_INK, POLE, Path, Pattern, Point, clip_polyline, distance, pattern};
use bifdiag_schema::{AtlasDocument, CurveDocument, CurveKind, Stability, StabilitySpan};

/// Width of every curve in pixels.
pub(super) const WIDTH: f64 = 1.5;
/// Distance of lines that stand for curves upon each other.
pub(super) const APART: f64 = 2.4;

/// A stretch of a curve, or of several upon each other, each drawn in one style.
#[derive(Clone, Debug)]
pub(super) struct Stroke {
    /// Index of the curve that gives the course.
    pub curve: usize,
    /// From this l to that; the upper end may be infinite.
    pub l: [f64; 2],
    /// One for each curve that looks different.
    pub lines: Vec<Line>,
}

/// One of the lines of a stroke.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Line {
    /// Index of its curve.
    pub curve: usize,
    pub pattern: Pattern,
    /// `None` for a line where a pole enters U.
    pub verdict: Option<Verdict>,
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

/// The pattern of a curve.
pub(super) fn curve_pattern(color: RGBColor, verdict: Verdict) -> Pattern {
    match verdict {
        Verdict::Stable => vec![(Some(color), 1.0)],
        Verdict::Open => vec![(Some(color), 1.6), (None, 2.4)],
        Verdict::Unstable => vec![(Some(color), 5.0), (None, 3.0)],
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
    let mut strokes: Vec<Stroke> = Vec::new();
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
    strokes.sort_by_key(|stroke| stroke.lines.iter().all(|line| line.verdict.is_none()));
    strokes
}

/// How the coincident curves of a set are drawn between two of their ends; `None` where none of them runs.
fn stroke(atlas: &AtlasDocument, styles: &BTreeMap<&str, BranchStyle>, set: &[usize], l: [f64; 2]) -> Option<Stroke> {
    let middle = if l[1].is_finite() { l[0] + (l[1] - l[0]) / 2.0 } else { l[0] + 1.0 };
    let runs = |index: &usize| {
        let [from, to] = l_range(atlas.curves[*index].l_range);
        middle >= from && middle <= to
    };
    let mut lines: Vec<Line> = Vec::new();
    for index in set.iter().copied().filter(runs) {
        let curve = &atlas.curves[index];
        let line = if is_pole(curve) {
            Line { curve: index, pattern: pole_pattern(curve.kind), verdict: None }
        } else {
            let verdict = verdict_at(curve, middle);
            let color = styles.get(curve.branch.as_str()).map_or(FAINT_INK, |style| style.color);
            Line { curve: index, pattern: curve_pattern(color, verdict), verdict: Some(verdict) }
        };
        // Two curves that look the same are one line.
        if !lines.iter().any(|other| other.pattern == line.pattern) {
            lines.push(line);
        }
    }
    Some(Stroke { curve: lines.first()?.curve, l, lines })
}

/// The parts of a stroke in a panel, as far as a line beside it may be visible.
fn parts(panel: &Panel, stroke: &Stroke) -> Vec<Vec<Point>> {
    let points = panel.traces[stroke.curve].part(stroke.l[0], stroke.l[1]);
    clip_polyline(&panel.view.positions(&points), &panel.view.rect.grown(stroke.lines.len() as f64 * APART))
}

/// The visible parts of a line so far beside a stroke.
fn visible(panel: &Panel, parts: &[Vec<Point>], shift: f64) -> Vec<Vec<Point>> {
    let beside = |part: &Vec<Point>| if shift == 0.0 { part.clone() } else { shifted(part, shift) };
    parts.iter().flat_map(|part| clip_polyline(&beside(part), &panel.view.rect)).collect()
}

/// Whether anything of a stroke is seen.
pub(super) fn is_drawn(stroke: &Stroke, panels: &[Panel]) -> bool {
    panels.iter().any(|panel| visible(panel, &parts(panel, stroke), 0.0).iter().any(|part| part.len() > 1))
}

/// Draws a stroke in a panel, one path for each of its lines.
pub(super) fn draw(canvas: &Canvas, panel: &Panel, stroke: &Stroke) {
    let parts = parts(panel, stroke);
    for (place, line) in stroke.lines.iter().enumerate() {
        let shift = APART * (place as f64 - (stroke.lines.len() - 1) as f64 / 2.0);
        let mut path = Path::default();
        for part in visible(panel, &parts, shift) {
            path.line(&part, false);
        }
        pattern::draw_path(canvas, &path, &line.pattern, WIDTH);
    }
}

/// A line beside a line.
fn shifted(points: &[Point], by: f64) -> Vec<Point> {
    let last = points.len().saturating_sub(1);
    let place = |index: usize| {
        let (before, after) = (points[index.saturating_sub(1)], points[(index + 1).min(last)]);
        let length = distance(before, after).max(1e-9);
        let [x, y] = [(after[0] - before[0]) / length, (after[1] - before[1]) / length];
        [points[index][0] - by * y, points[index][1] + by * x]
    };
    (0..points.len()).map(place).collect()
}
