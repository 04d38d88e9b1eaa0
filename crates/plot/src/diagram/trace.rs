//! The curves of one window as polylines, dense enough for its magnification.

use super::scene::Scene;
use super::windows::{common, l_range};
use bifdiag_page::PlotError;
use bifdiag_schema::{CurveDocument, TailDocument};

/// Points added at most between two points of a document's polyline.
const SUBDIVISIONS_MAX: f64 = 400.0;

/// A curve as points [h, l] by rising l.
#[derive(Clone, Debug, Default)]
pub(super) struct Trace {
    pub points: Vec<[f64; 2]>,
}

impl Trace {
    /// The energy at `l`, held constant beyond the ends; `None` for a trace without points.
    pub(super) fn h_at(&self, l: f64) -> Option<f64> {
        let (first, last) = (self.points.first()?, self.points.last()?);
        if l <= first[1] {
            return Some(first[0]);
        }
        if l >= last[1] {
            return Some(last[0]);
        }
        let next = self.points.partition_point(|point| point[1] <= l);
        let (a, b) = (self.points[next - 1], self.points[next]);
        Some(a[0] + (b[0] - a[0]) * ((l - a[1]) / (b[1] - a[1])))
    }

    /// The points with l in `[from, to]`, both ends included; empty where the trace does not reach.
    pub(super) fn part(&self, from: f64, to: f64) -> Vec<[f64; 2]> {
        let (Some(first), Some(last)) = (self.points.first(), self.points.last()) else { return Vec::new() };
        if from > last[1] || to < first[1] {
            return Vec::new();
        }
        let (from, to) = (from.max(first[1]), to.min(last[1]));
        let start = self.points.partition_point(|point| point[1] <= from);
        let end = self.points.partition_point(|point| point[1] < to);
        let mut part = Vec::with_capacity(end.saturating_sub(start) + 2);
        part.extend(self.h_at(from).map(|h| [h, from]));
        part.extend(self.points.get(start..end.max(start)).unwrap_or_default());
        part.extend(self.h_at(to).map(|h| [h, to]));
        part
    }
}

/// Every curve of the atlas within `l`, off by at most `tolerance` in h where the source allows.
pub(super) fn traces(scene: &Scene<'_>, l: [f64; 2], tolerance: f64) -> Result<Vec<Trace>, PlotError> {
    scene.atlas.curves.iter().map(|curve| trace(scene, curve, l, tolerance)).collect()
}

/// One curve within `l`.
pub(super) fn trace(scene: &Scene<'_>, curve: &CurveDocument, l: [f64; 2], tolerance: f64) -> Result<Trace, PlotError> {
    let l = common(l, l_range(curve.l_range));
    if l[0] > l[1] {
        return Ok(Trace::default());
    }
    if let Some(points) = scene.source.and_then(|source| source.polyline(&curve.id, l, tolerance)) {
        return Ok(Trace { points: increasing(points) });
    }
    let drawn = scene.atlas.polyline(&curve.id);
    if drawn.is_empty() {
        return Err(PlotError::NoPolyline { curve: curve.id.clone() });
    }
    let document = Trace { points: increasing(drawn.to_vec()) };
    let mut points = refine(&document.part(l[0], l[1]), tolerance);
    if let (Some(tail), Some(last)) = (&curve.tail, document.points.last()) {
        continue_tail(&mut points, *last, tail, l, tolerance);
    }
    Ok(Trace { points })
}

/// Drops points that do not rise in l or are not finite.
fn increasing(points: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    let mut kept: Vec<[f64; 2]> = Vec::with_capacity(points.len());
    for point in points {
        if point[0].is_finite() && point[1].is_finite() && kept.last().is_none_or(|last| point[1] > last[1]) {
            kept.push(point);
        }
    }
    kept
}

/// Points between the given ones, on h linear in l²: what a rotation about a fixed axis does.
fn refine(points: &[[f64; 2]], tolerance: f64) -> Vec<[f64; 2]> {
    let mut refined = Vec::with_capacity(points.len());
    for pair in points.windows(2) {
        let ([ha, la], [hb, lb]) = (pair[0], pair[1]);
        refined.push(pair[0]);
        let slope = (hb - ha) / (lb * lb - la * la);
        let pieces = ((lb - la) * (slope.abs() / (4.0 * tolerance)).sqrt()).ceil().clamp(1.0, SUBDIVISIONS_MAX);
        let mut piece = 1.0;
        while slope.is_finite() && piece < pieces {
            let l = la + (lb - la) * (piece / pieces);
            refined.push([ha + slope * (l - la) * (l + la), l]);
            piece += 1.0;
        }
    }
    refined.extend(points.last());
    increasing(refined)
}

/// Goes on from the last point of the document by h = l²/(2J) + h0 + c/l², c such that it starts there.
fn continue_tail(points: &mut Vec<[f64; 2]>, last: [f64; 2], tail: &TailDocument, l: [f64; 2], tolerance: f64) {
    let [h_last, l_last] = last;
    let start = l[0].max(l_last);
    if start >= l[1] {
        return;
    }
    let straight = |l: f64| l * l / (2.0 * tail.moment) + tail.h_offset;
    let correction = (h_last - straight(l_last)) * l_last * l_last;
    let pieces = ((l[1] - start) * (1.0 / (8.0 * tail.moment * tolerance)).sqrt()).ceil().clamp(8.0, 4000.0);
    let mut piece = 0.0;
    while piece <= pieces {
        let at = start + (l[1] - start) * (piece / pieces);
        let shift = if at > 0.0 { correction / (at * at) } else { 0.0 };
        points.push([straight(at) + shift, at]);
        piece += 1.0;
    }
    *points = increasing(std::mem::take(points));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn refined_points_lie_on_the_parabola_through_their_neighbours() {
        let points = refine(&[[1.0, 1.0], [16.0, 4.0]], 1e-3);
        assert!(points.len() > 20);
        assert!(points.iter().all(|[h, l]| (h - l * l).abs() < 1e-12));
    }

    #[test]
    fn the_tail_starts_at_the_last_point_and_ends_on_the_asymptote() {
        let tail = TailDocument { moment: 2.0, h_offset: -1.0 };
        let mut points = vec![[0.0, 2.0]];
        continue_tail(&mut points, [0.1, 2.0], &tail, [0.0, 200.0], 1e-3);
        let trace = Trace { points };
        assert_eq!(trace.points[0], [0.0, 2.0]);
        let h = trace.h_at(200.0).expect("the trace has points");
        assert!((h - 9999.0).abs() < 1e-4, "{h}");
    }
}
