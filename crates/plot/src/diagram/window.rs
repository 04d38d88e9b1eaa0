//! The windows that the panels may show.

use super::scene::Scene;
use super::trace::{Trace, trace, traces};
use crate::page::{PlotError, is_proper};
use schema::WindowDocument;

/// Margin beyond the last event, as a share of its l.
const BEYOND_EVENTS: f64 = 0.25;
/// Curves that start at the top of the energies at l = 0 are followed by at least this share of their range.
const BEYOND_START: f64 = 0.5;
/// Margin at both ends in h, as a share of the range.
const MARGIN: f64 = 0.05;
/// An event at more than so many times the l of the one before would leave the others no room.
const FAR_BEYOND: f64 = 12.0;
/// Without events the window ends in h at most at this multiple of the median of the curves.
const MEDIAN_MULTIPLE: f64 = 4.0;

/// The part of the plane that the main panel shows, and the part that insets may show.
pub(super) struct Windows {
    /// The window that was asked for, or one that shows all events but those that lie far beyond all others.
    pub main: WindowDocument,
    /// The window that was asked for, or one that shows all events and a part of every unbounded region.
    pub everything: WindowDocument,
}

pub(super) fn windows(scene: &Scene<'_>, asked: Option<WindowDocument>) -> Result<Windows, PlotError> {
    let windows = if let Some(window) = asked.or(scene.atlas.window) {
        Windows { main: window, everything: window }
    } else {
        let mut l: Vec<f64> = scene.atlas.events.iter().map(|event| event.l).collect();
        l.sort_by(f64::total_cmp);
        let last = l.last().copied().unwrap_or(0.0);
        // The events up to the first leap; those beyond it are for insets.
        let before_leap = l.windows(2).find(|pair| pair[1] > FAR_BEYOND * pair[0]).map_or(last, |pair| pair[0]);
        let everything = automatic(scene, last)?;
        let main = if before_leap < last { automatic(scene, before_leap)? } else { everything };
        Windows { main, everything }
    };
    let WindowDocument { h, l } = windows.main;
    if is_proper(h) && is_proper(l) { Ok(windows) } else { Err(PlotError::EmptyWindow { h, l }) }
}

/// A window for the events up to `last_event` in l.
fn automatic(scene: &Scene<'_>, last_event: f64) -> Result<WindowDocument, PlotError> {
    let events: Vec<_> = scene.atlas.events.iter().filter(|event| event.l <= last_event).collect();
    let last_point =
        scene.atlas.curves.iter().filter_map(|curve| curve.polyline.last()).map(|point| point[1]).fold(0.0, f64::max);
    // Coarse values are enough to choose a window.
    let coarse = scale(scene, last_event) * 1e-3;
    let l_top = if last_event > 0.0 {
        last_event.max(start_of_positive_energies(scene, last_point.min(FAR_BEYOND * last_event), coarse)?)
            * (1.0 + BEYOND_EVENTS)
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

/// The size of the energies up to an event.
fn scale(scene: &Scene<'_>, last_event: f64) -> f64 {
    let events = scene.atlas.events.iter().filter(|event| event.l <= last_event).map(|event| event.h.abs());
    let starts = scene.atlas.curves.iter().filter_map(|curve| curve.polyline.first()).map(|point| point[0].abs());
    let scale = events.chain(starts).fold(0.0, f64::max);
    if scale > 0.0 { scale } else { 1.0 }
}
