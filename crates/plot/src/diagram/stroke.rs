//! Line styles: solid where stable, thin where stable only without friction; dashed where unstable, dotted where
//! neither is known; coincident curves are one line that alternates between the colours and dashes of each.

use std::collections::BTreeMap;

use plotters::style::RGBColor;

use super::palette::{BranchStyle, is_pole};
use super::panel::Panel;
use super::scene::coincidences;
use super::windows::l_range;
use bifdiag_page::{Canvas, Dash, FAINT_INK, POLE, POLE_MINUS, Path, Point};
use bifdiag_schema::{AtlasDocument, CurveDocument, CurveKind, Damped, NonlinearVerdict, StabilitySpan};

/// Width of a curve in pixels.
pub(super) const WIDTH: f64 = 1.5;
/// Width of one that is stable without friction only.
const THIN: f64 = 0.75;
/// Length of a solid line between the dashes of others that coincide with it.
const SOLID: f64 = 9.0;

/// A stretch of a curve, or of several coincident ones, each drawn in one style.
#[derive(Clone, Debug)]
pub(super) struct Stroke {
    /// Index of the curve that gives the points.
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
    pub pattern: Vec<Dash>,
    /// `None` for a line where a pole enters U.
    pub verdict: Option<Verdict>,
}

/// What is known of the stability of a curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Verdict {
    /// Stable, also with friction that conserves l.
    Lasting,
    /// Stable as long as there is no friction.
    Frictionless,
    /// Neither is known.
    Open,
    /// Unstable.
    Unstable,
}

/// The verdict at `l`.
fn verdict_at(curve: &CurveDocument, l: f64) -> Verdict {
    let span = curve.stability.iter().find(|span| l >= span.l_from && span.l_to.is_none_or(|to| l <= to));
    span.map_or(Verdict::Open, verdict)
}

/// The verdict of a stretch.
pub(super) fn verdict(span: &StabilitySpan) -> Verdict {
    match span.nonlinear.verdict {
        NonlinearVerdict::Stable if span.friction.conserving_l == Some(Damped::Survives) => Verdict::Lasting,
        NonlinearVerdict::Stable => Verdict::Frictionless,
        NonlinearVerdict::Open => Verdict::Open,
        NonlinearVerdict::Unstable => Verdict::Unstable,
    }
}

/// The width of a curve.
pub(super) fn curve_width(verdict: Option<Verdict>) -> f64 {
    if verdict == Some(Verdict::Frictionless) { THIN } else { WIDTH }
}

/// The pattern of a curve.
pub(super) fn curve_pattern(color: RGBColor, verdict: Verdict) -> Vec<Dash> {
    match verdict {
        Verdict::Lasting | Verdict::Frictionless => vec![(Some(color), 1.0)],
        Verdict::Open => vec![(Some(color), 1.6), (None, 2.4)],
        Verdict::Unstable => vec![(Some(color), 5.0), (None, 3.0)],
    }
}

/// The pattern of a pole line: dash and dot for P+, long and short dashes for P−.
pub(super) fn pole_pattern(kind: CurveKind) -> Vec<Dash> {
    let (color, lengths) = match kind {
        CurveKind::PolePlus => (POLE, [9.0, 1.8]),
        _ => (POLE_MINUS, [14.0, 4.5]),
    };
    lengths.into_iter().flat_map(|length| [(Some(color), length), (None, 2.7)]).collect()
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
        let same =
            |other: &Line| other.pattern == line.pattern && curve_width(other.verdict) == curve_width(line.verdict);
        if !lines.iter().any(same) {
            lines.push(line);
        }
    }
    Some(Stroke { curve: lines.first()?.curve, l, lines })
}

/// The parts of a stroke that a panel shows.
fn parts(panel: &Panel, stroke: &Stroke) -> Vec<Vec<Point>> {
    panel.curve(stroke.curve, stroke.l)
}

/// True for a stroke that is partly visible in a panel.
pub(super) fn is_drawn(stroke: &Stroke, panels: &[Panel]) -> bool {
    panels.iter().any(|panel| parts(panel, stroke).iter().any(|part| part.len() > 1))
}

/// Draws a stroke in a panel as one line.
pub(super) fn draw(canvas: &Canvas, panel: &Panel, stroke: &Stroke) {
    let mut path = Path::default();
    for part in parts(panel, stroke) {
        path.line(&part, false);
    }
    canvas.draw_dashed(&path, &in_turn(&stroke.lines), width(&stroke.lines));
}

/// Coincident lines are as wide as the widest of them.
pub(super) fn width(lines: &[Line]) -> f64 {
    lines.iter().map(|line| curve_width(line.verdict)).fold(0.0, f64::max)
}

/// The patterns of alternating lines.
pub(super) fn in_turn(lines: &[Line]) -> Vec<Dash> {
    turns(lines).flat_map(|(_, dashes)| dashes).collect()
}

/// The same, empty where it is not one of these lines' turn.
pub(super) fn turn_of(lines: &[Line], own: usize) -> Vec<Dash> {
    let only = |(number, dashes): (usize, Vec<Dash>)| {
        dashes.into_iter().map(move |(color, length)| (color.filter(|_| number == own), length))
    };
    turns(lines).flat_map(only).collect()
}

/// What each line has of the pattern.
fn turns(lines: &[Line]) -> impl Iterator<Item = (usize, Vec<Dash>)> {
    let own = |line: &Line| match line.pattern[..] {
        [(color, _)] if lines.len() > 1 => vec![(color, SOLID)],
        _ => line.pattern.clone(),
    };
    lines.iter().map(own).enumerate()
}
