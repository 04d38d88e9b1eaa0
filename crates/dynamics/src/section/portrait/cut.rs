//! Where the two kinds of curves meet: the line of tangency changes its sheet on ∂U, and there Ṡ changes its sign
//! along ∂U.

use super::equations::{SectionEquations, Zero};
use super::linear::{PhaseVector, along, inner, length};
use super::trace::Traced;

/// Meeting points nearer than this are one.
const SAME: f64 = 1e-7;

/// A part of a curve between two meeting points.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct CurvePiece {
    pub points: Vec<PhaseVector>,
    pub closed: bool,
    /// The sign of Δ (line of tangency) or of Ṡ (∂U) on it.
    pub positive: bool,
}

/// A cut: the step of the curve, the share of the step, the point.
type CurveCut = (usize, f64, PhaseVector);

/// The points of ∂U at which Ṡ changes its sign.
pub(super) fn sign_changes(equations: &SectionEquations, boundary: &[Traced]) -> Vec<PhaseVector> {
    let mut meetings = Vec::new();
    for line in boundary {
        let rates: Vec<f64> = line.points.iter().map(|x| equations.rate(&equations.state(x))).collect();
        for (i, j) in line.steps().filter(|&(i, j)| (rates[i] < 0.0) != (rates[j] < 0.0)) {
            let guess = between(&line.points[i], &line.points[j], rates[i] / (rates[i] - rates[j]));
            let meeting = equations.meeting(&guess).or_else(|| equations.polish(Zero::Sheets, &guess));
            meetings.push(meeting.unwrap_or(guess));
        }
    }
    meetings
}

/// The line of tangency cut at ∂U; meeting points that are not known yet are added.
pub(super) fn tangency_pieces(
    equations: &SectionEquations,
    lines: &[Traced],
    meetings: &mut Vec<PhaseVector>,
) -> Vec<CurvePiece> {
    let mut pieces = Vec::new();
    for line in lines {
        let deltas: Vec<f64> = line.points.iter().map(|x| equations.delta(&equations.state(x))).collect();
        let mut cuts = Vec::new();
        for (i, j) in line.steps().filter(|&(i, j)| (deltas[i] < 0.0) != (deltas[j] < 0.0)) {
            let share = deltas[i] / (deltas[i] - deltas[j]);
            let guess = between(&line.points[i], &line.points[j], share);
            let found = equations.meeting(&guess).unwrap_or(guess);
            let known = meetings.iter().find(|known| length(&along(known, -1.0, &found)) < SAME).copied();
            if known.is_none() {
                meetings.push(found);
            }
            cuts.push((i, share, known.unwrap_or(found)));
        }
        pieces.extend(pieces_of(line, cuts, |x| equations.delta(&equations.state(x))));
    }
    pieces
}

/// ∂U cut at the meeting points.
pub(super) fn boundary_pieces(
    equations: &SectionEquations,
    lines: &[Traced],
    meetings: &[PhaseVector],
) -> Vec<CurvePiece> {
    let mut cuts: Vec<Vec<CurveCut>> = vec![Vec::new(); lines.len()];
    for meeting in meetings {
        let mut nearest: Option<(f64, usize, CurveCut)> = None;
        for (index, line) in lines.iter().enumerate() {
            for (i, j) in line.steps() {
                let chord = along(&line.points[j], -1.0, &line.points[i]);
                let offset = along(meeting, -1.0, &line.points[i]);
                let share = (inner(&offset, &chord) / inner(&chord, &chord)).clamp(0.0, 1.0);
                let aside = length(&along(&offset, -share, &chord));
                if nearest.as_ref().is_none_or(|(best, ..)| aside < *best) {
                    nearest = Some((aside, index, (i, share, *meeting)));
                }
            }
        }
        if let Some((_, index, cut)) = nearest {
            cuts[index].push(cut);
        }
    }
    let rate = |x: &PhaseVector| equations.rate(&equations.state(x));
    lines.iter().zip(cuts).flat_map(|(line, cuts)| pieces_of(line, cuts, rate)).collect()
}

fn between(a: &PhaseVector, b: &PhaseVector, share: f64) -> PhaseVector {
    along(a, share, &along(b, -1.0, a))
}

/// The pieces of a line between its cuts, with the sign of `value` on each.
fn pieces_of(line: &Traced, mut cuts: Vec<CurveCut>, value: impl Fn(&PhaseVector) -> f64) -> Vec<CurvePiece> {
    let sign = |points: &[PhaseVector]| {
        let largest = points.iter().map(&value).max_by(|a, b| a.abs().total_cmp(&b.abs()));
        largest.is_some_and(|value| value > 0.0)
    };
    cuts.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let piece = |points: Vec<PhaseVector>, closed: bool| CurvePiece { positive: sign(&points), points, closed };
    let Some((first, ..)) = cuts.first() else {
        return vec![piece(line.points.clone(), line.closed)];
    };
    // From the vertex after the first cut once round, or from the first vertex on.
    let count = line.points.len();
    let offset = if line.closed { first + 1 } else { 0 };
    let mut pieces = Vec::new();
    let mut points: Vec<PhaseVector> = Vec::new();
    let mut close = |points: &mut Vec<PhaseVector>| {
        let finished = std::mem::take(points);
        if finished.len() > 1 {
            pieces.push(piece(finished, false));
        }
    };
    let mut visit = |step: usize, points: &mut Vec<PhaseVector>, skip_first: bool| {
        let here = cuts.iter().enumerate().filter(|(_, cut)| cut.0 == step);
        for (_, (.., x)) in here.filter(|(k, _)| !(skip_first && *k == 0)) {
            points.push(*x);
            close(points);
            points.push(*x);
        }
    };
    if line.closed {
        points.push(cuts[0].2);
        // Further cuts of the first step.
        visit(*first, &mut points, true);
        for k in 0..count {
            let vertex = (offset + k) % count;
            points.push(line.points[vertex]);
            if vertex != *first {
                visit(vertex, &mut points, false);
            }
        }
        points.push(cuts[0].2);
    } else {
        for vertex in 0..count {
            points.push(line.points[vertex]);
            visit(vertex, &mut points, false);
        }
    }
    close(&mut points);
    pieces
}
