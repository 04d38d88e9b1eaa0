//! The windows around one region that is too small to be seen.

use super::panel::{LEGIBLE, areas};
use super::scene::Scene;
use super::trace::{Trace, trace};
use super::windows::{View, clipped, common, hull, length};
use bifdiag_page::{PlotError, Rect};
use bifdiag_schema::WindowDocument;

/// The widest window tried for a region shows it with an inscribed circle of at least this radius, the closest with
/// at least that.
const WIDE: f64 = 4.6;
const CLOSE: f64 = 14.0;
/// Windows narrower than this, relative to their position, are beyond f64.
const RESOLUTION: f64 = 1e-12;
/// Regions narrower than this share of the energies in view are not looked for: curves that resolve them over the whole
/// view would have too many points.
const NARROWEST: f64 = 2e-9;
/// Free space around a region, as a share of its extent.
const AROUND: f64 = 0.16;
/// Each trial window reaches this share as far from the region's widest place as the one before.
const SHRINK: f64 = 0.9;
/// Where a region shows less than this, the next trial window may be much smaller.
const FAR_FROM_VISIBLE: f64 = 0.3 * WIDE;
/// Pixels of a trial, in those of the panel.
const COARSE: f64 = 2.0;
/// Places at which the extent of a cell is measured.
const STATIONS: usize = 96;

/// What was found for a region.
pub(super) enum Closeup {
    /// The largest window in which it can be seen, and one in which it is seen easily, with the radius of its inscribed
    /// circle there.
    Windows {
        wide: WindowDocument,
        close: WindowDocument,
        depth: f64,
    },
    TooSmall,
    Outside,
}

/// The extent of a region in h at one l.
#[derive(Clone, Copy)]
struct RegionExtent {
    l: f64,
    h: [f64; 2],
}

/// Windows around the widest place of a region, with sides of `largest` (in h and l) at most.
pub(super) fn closeup(
    scene: &Scene<'_>,
    visible: &WindowDocument,
    largest: [f64; 2],
    region: usize,
) -> Result<Closeup, PlotError> {
    let id = &scene.atlas.regions[region].id;
    let width = scene.atlas.h_width(id).unwrap_or(f64::INFINITY).min(length(visible.h) / scene.plan.inset[0]);
    if width < NARROWEST * length(visible.h) {
        return Ok(Closeup::TooSmall);
    }
    let Some(RegionExtent { l: widest, h: there }) =
        widest(scene, region, &stations(scene, visible, region, width * 1e-3)?)
    else {
        return Ok(Closeup::Outside);
    };
    let middle = [f64::midpoint(there[0], there[1]), widest];
    let cells = scene.cells[region].iter().filter(|cell| cell.l[0] < visible.l[1] && cell.l[1] > visible.l[0]);
    let ends = common(cells.map(|cell| cell.l).fold([f64::INFINITY, 0.0], hull), visible.l);
    let mut wide: Option<WindowDocument> = None;
    let mut best: Option<(WindowDocument, f64)> = None;
    let mut reach = (widest - ends[0]).max(ends[1] - widest).min(largest[1] / 2.0);
    loop {
        let l = common(ends, [widest - reach, widest + reach]);
        let strip = WindowDocument { h: visible.h, l: common(l, visible.l) };
        let near = stations(scene, &strip, region, width * 1e-3)?;
        if near.is_empty() {
            break;
        }
        let h = near.iter().map(|station| station.h).fold([f64::INFINITY, f64::NEG_INFINITY], hull);
        let window = clipped(&cropped(&around(h, l), middle, largest), visible);
        let resolved = |[from, to]: [f64; 2]| to - from > RESOLUTION * from.abs().max(to.abs());
        if !(resolved(window.h) && resolved(window.l)) {
            break;
        }
        let depth = depths(scene, &window, &[region])?[region];
        if depth >= WIDE && wide.is_none() {
            wide = Some(window);
        }
        if best.is_none_or(|(_, most)| depth > most) {
            best = Some((window, depth));
        }
        if depth >= CLOSE {
            break;
        }
        reach *= if depth < FAR_FROM_VISIBLE { 0.5 } else { SHRINK };
    }
    Ok(match best.filter(|(_, depth)| *depth >= LEGIBLE) {
        Some((close, depth)) => Closeup::Windows { wide: wide.unwrap_or(close), close, depth },
        None => Closeup::TooSmall,
    })
}

/// Where a region is widest. A strip that never ends is widest far out; the atlas' sample lies where it has something to
/// show, and is preferred if it is wide there, too.
fn widest(scene: &Scene<'_>, region: usize, stations: &[RegionExtent]) -> Option<RegionExtent> {
    let width = |station: &RegionExtent| length(station.h);
    let widest = stations.iter().max_by(|a, b| width(a).total_cmp(&width(b)))?;
    let from_sample = |station: &RegionExtent| (station.l - scene.atlas.regions[region].sample.l).abs();
    let near_sample = stations.iter().min_by(|a, b| from_sample(a).total_cmp(&from_sample(b)))?;
    let endless = scene.cells[region].iter().any(|cell| cell.l[1].is_infinite());
    Some(if endless && width(near_sample) >= 0.3 * width(widest) { *near_sample } else { *widest })
}

/// A window with free space around, not below l = 0.
fn around(h: [f64; 2], l: [f64; 2]) -> WindowDocument {
    let (dh, dl) = (AROUND * length(h), AROUND * length(l));
    WindowDocument { h: [h[0] - dh, h[1] + dh], l: [(l[0] - dl).max(0.0), l[1] + dl] }
}

/// The part of a window at most half of `largest` from a point.
fn cropped(window: &WindowDocument, [h, l]: [f64; 2], largest: [f64; 2]) -> WindowDocument {
    let crop = |side, at: f64, largest: f64| common(side, [at - largest / 2.0, at + largest / 2.0]);
    WindowDocument { h: crop(window.h, h, largest[0]), l: crop(window.l, l, largest[1]) }
}

/// The extents of a region inside a window by cells.
fn stations(
    scene: &Scene<'_>,
    window: &WindowDocument,
    region: usize,
    tolerance: f64,
) -> Result<Vec<RegionExtent>, PlotError> {
    let mut stations = Vec::new();
    for cell in &scene.cells[region] {
        let [from, to] = common(cell.l, window.l);
        if from >= to {
            continue;
        }
        let points = |curve: usize| trace(scene, &scene.atlas.curves[curve], [from, to], tolerance);
        let lower = points(cell.lower)?;
        let upper = cell.upper.map(points).transpose()?;
        for step in 0..=STATIONS {
            let l = from + (to - from) * (step as f64 / STATIONS as f64);
            let Some(low) = lower.h_at(l) else { continue };
            let high = upper.as_ref().map_or(Some(window.h[1]), |upper| upper.h_at(l));
            let h = common([low, high.unwrap_or(low)], window.h);
            if h[0] <= h[1] {
                stations.push(RegionExtent { l, h });
            }
        }
    }
    Ok(stations)
}

/// Radii in pixels of the largest circles in some regions that an inset would show, 0 for all others; measured on
/// pixels twice as large.
pub(super) fn depths(scene: &Scene<'_>, window: &WindowDocument, regions: &[usize]) -> Result<Vec<f64>, PlotError> {
    let rect = Rect { x: 0.0, y: 0.0, width: scene.plan.inset[0] / COARSE, height: scene.plan.inset[1] / COARSE };
    let view = View { window: *window, rect };
    let tolerance = 0.1 * view.h_per_pixel();
    let mut traces: Vec<Trace> = vec![Trace::default(); scene.atlas.curves.len()];
    for cell in regions.iter().flat_map(|&region| &scene.cells[region]) {
        for curve in std::iter::once(cell.lower).chain(cell.upper) {
            if traces[curve].points.is_empty() {
                traces[curve] = trace(scene, &scene.atlas.curves[curve], window.l, tolerance)?;
            }
        }
    }
    let depths = areas(scene, &view, &traces, regions.iter().copied()).depths(scene.cells.len());
    Ok(depths.into_iter().map(|depth| COARSE * depth).collect())
}
