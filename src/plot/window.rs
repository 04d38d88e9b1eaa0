//! The window of the main panel.

use super::PlotError;
use super::scene::Scene;
use super::trace::{Trace, trace, traces};
use crate::document::{EventDocument, WindowDocument};

/// Margin beyond the last event, as a share of its l.
const BEYOND_EVENTS: f64 = 0.25;
/// Curves that start at the top of the energies at l = 0 are followed by at least this share of their range.
const BEYOND_START: f64 = 0.5;
/// Margin at both ends in h, as a share of the range.
const MARGIN: f64 = 0.05;
/// Without events the window ends in h at most at this multiple of the median of the curves.
const MEDIAN_MULTIPLE: f64 = 4.0;

/// Events so many times farther out in l than the ones before are left to an overview.
const FAR: f64 = 20.0;

/// The windows of the largest panels.
pub(super) struct Windows {
    pub main: WindowDocument,
    /// Everything, where some events lie so far out that a window with them would show nothing of the others.
    pub overview: Option<WindowDocument>,
}

/// The window that was asked for, or one that shows all events (but a few far out) and a part of every unbounded region.
pub(super) fn windows(scene: &Scene<'_>, asked: Option<WindowDocument>) -> Result<Windows, PlotError> {
    let windows = match asked.or(scene.atlas.window) {
        Some(window) => Windows { main: window, overview: None },
        None => match last_near_event(scene) {
            Some(limit) => Windows { main: automatic(scene, limit)?, overview: Some(automatic(scene, f64::INFINITY)?) },
            None => Windows { main: automatic(scene, f64::INFINITY)?, overview: None },
        },
    };
    for WindowDocument { h, l } in [windows.main].into_iter().chain(windows.overview) {
        let fits = |[from, to]: [f64; 2]| from < to && (to - from).is_finite();
        if !(fits(h) && fits(l)) {
            return Err(PlotError::EmptyWindow { h, l });
        }
    }
    Ok(windows)
}

/// The l of the last event before those far out, if there are such and they are fewer than the others.
fn last_near_event(scene: &Scene<'_>) -> Option<f64> {
    let mut places: Vec<f64> = scene.atlas.events.iter().map(|event| event.l).collect();
    places.sort_by(f64::total_cmp);
    let gap = (1..places.len()).rev().find(|&k| places[k] > FAR * places[k - 1])?;
    (2 * gap > places.len()).then(|| places[gap - 1])
}

/// A window that shows the events up to l = `limit`.
fn automatic(scene: &Scene<'_>, limit: f64) -> Result<WindowDocument, PlotError> {
    let events: Vec<&EventDocument> = scene.atlas.events.iter().filter(|event| event.l <= limit).collect();
    let last_event = events.iter().map(|event| event.l).fold(0.0, f64::max);
    let last_point =
        scene.atlas.curves.iter().filter_map(|curve| curve.polyline.last()).map(|point| point[1]).fold(0.0, f64::max);
    // Coarse values are enough to choose a window.
    let coarse = scale(scene, &events) * 1e-3;
    let l_top = if last_event > 0.0 {
        last_event.max(start_of_positive_energies(scene, last_point, coarse)?) * (1.0 + BEYOND_EVENTS)
    } else {
        last_point
    };
    let mut at_top = Vec::new();
    let mut low = f64::INFINITY;
    let mut high = f64::NEG_INFINITY;
    for trace in traces(scene, [0.0, l_top], coarse)? {
        let (Some(first), Some(last)) = (trace.points.first(), trace.points.last()) else { continue };
        low = trace.points.iter().map(|point| point[0]).fold(low, f64::min);
        if first[1] == 0.0 {
            high = high.max(first[0]);
        }
        if last[1] >= l_top {
            at_top.push(last[0]);
        }
    }
    if high.is_finite() {
        high += BEYOND_START * (high - low).max(0.0);
    }
    at_top.sort_by(f64::total_cmp);
    high = events.iter().map(|event| event.h).fold(high, f64::max);
    // What begins at one of the last events must be seen to open.
    for event in events.iter().filter(|event| event.l > 0.7 * last_event) {
        for curve in scene.atlas.curves.iter().filter(|curve| event.curves.contains(&curve.id)) {
            high = high.max(trace(scene, curve, [0.0, l_top], coarse)?.h_at(l_top).unwrap_or(high));
        }
    }
    if let (Some(median), Some(largest)) = (at_top.get(at_top.len() / 2), at_top.last()) {
        high =
            high.max(*median).max(if events.is_empty() { largest.min(MEDIAN_MULTIPLE * median.abs()) } else { high });
    }
    let margin = MARGIN * (high - low);
    Ok(WindowDocument { h: [low - margin, high + margin], l: [0.0, l_top] })
}

/// The l at which the lowest curve from l = 0 reaches h = 0; 0 where it starts there.
fn start_of_positive_energies(scene: &Scene<'_>, l_top: f64, coarse: f64) -> Result<f64, PlotError> {
    let mut lowest: Option<Trace> = None;
    for trace in traces(scene, [0.0, l_top], coarse)? {
        let start = |trace: &Trace| trace.points.first().map_or(f64::INFINITY, |point| point[0]);
        if trace.points.first().is_some_and(|point| point[1] == 0.0)
            && lowest.as_ref().is_none_or(|lowest| start(&trace) < start(lowest))
        {
            lowest = Some(trace);
        }
    }
    let positive = lowest.and_then(|trace| trace.points.into_iter().find(|point| point[0] >= 0.0));
    Ok(positive.map_or(0.0, |point| point[1]))
}

/// The size of the energies of some events and at the curves' beginnings.
fn scale(scene: &Scene<'_>, events: &[&EventDocument]) -> f64 {
    let events = events.iter().map(|event| event.h.abs());
    let starts = scene.atlas.curves.iter().filter_map(|curve| curve.polyline.first()).map(|point| point[0].abs());
    let scale = events.chain(starts).fold(0.0, f64::max);
    if scale > 0.0 { scale } else { 1.0 }
}
