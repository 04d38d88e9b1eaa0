//! Which parts are magnified: few windows that together show every region too small to see.

use super::PlotError;
use super::geometry::Rect;
use super::grid::Grid;
use super::panel::{Panel, View};
use super::scene::Scene;
use super::trace::{Trace, trace};
use schema::WindowDocument;

/// A region whose inscribed circle has at least this radius in pixels can be seen and pointed at.
pub(super) const LEGIBLE: f64 = 4.5;
/// The widest window tried for a region shows it with an inscribed circle of at least this radius, the closest with
/// at least that.
const WIDE: f64 = 4.6;
const CLOSE: f64 = 14.0;
/// In the window that stands for it, a region's inscribed circle has at least this radius.
const KEPT: f64 = 5.0;
/// Insets magnified more than this against the main panel are led up to by a window between the two.
const LEAP: f64 = 40.0;
/// The most windows that lead up to others.
const STEPS_MAX: usize = 3;
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

/// What is magnified.
#[derive(Clone, Debug, Default)]
pub(super) struct Magnifications {
    /// The windows, largest first.
    pub windows: Vec<WindowDocument>,
    /// Regions too small for f64.
    pub invisible: Vec<usize>,
    /// Regions outside the main window.
    pub outside: Vec<usize>,
}

/// A window and the radius of the inscribed circles of the regions that it is for.
struct Candidate {
    window: WindowDocument,
    depths: Vec<f64>,
}

/// The extent of a region in h at one l.
#[derive(Clone, Copy)]
struct Station {
    l: f64,
    h: [f64; 2],
}

/// Chooses the windows of the insets of plot size `size` for what the main panel does not show.
/// What lies outside the main window is looked for in `everything`.
pub(super) fn magnifications(
    scene: &Scene<'_>,
    main: &Panel,
    everything: &WindowDocument,
    size: [f64; 2],
) -> Result<Magnifications, PlotError> {
    let mut result = Magnifications::default();
    let mut windows: Vec<WindowDocument> = Vec::new();
    let mut close: Vec<Candidate> = Vec::new();
    let mut hidden: Vec<usize> = Vec::new();
    for (region, depth) in main.grid.depths(scene.cells.len()).into_iter().enumerate() {
        if depth >= LEGIBLE {
            continue;
        }
        let mut found = own_windows(scene, &main.view.window, region, size)?;
        let goes_on = scene.cells[region].iter().any(|cell| cell.l[1] > main.view.window.l[1]);
        if !matches!(found, Found::Windows { .. }) && goes_on && *everything != main.view.window {
            found = own_windows(scene, everything, region, size)?;
        }
        match found {
            Found::Windows { wide, closest } => {
                hidden.push(region);
                windows.push(wide);
                windows.push(closest.window);
                close.push(closest);
            }
            Found::TooSmall => result.invisible.push(region),
            Found::Outside => result.outside.push(region),
        }
    }
    windows.extend(unions(close));
    result.windows = cover(scene, &windows, hidden, size)?;
    lead_up(&mut result.windows, &main.view.window);
    result.windows.sort_by(|a, b| area(b).total_cmp(&area(a)).then(a.l[0].total_cmp(&b.l[0])));
    Ok(result)
}

fn area(window: &WindowDocument) -> f64 {
    (window.h[1] - window.h[0]) * (window.l[1] - window.l[0])
}

/// Windows that together show all of `hidden`: again and again the one that shows most of those left, the larger of
/// two that show as many.
fn cover(
    scene: &Scene<'_>,
    windows: &[WindowDocument],
    mut hidden: Vec<usize>,
    size: [f64; 2],
) -> Result<Vec<WindowDocument>, PlotError> {
    let mut shown: Vec<(WindowDocument, Vec<usize>)> = Vec::with_capacity(windows.len());
    for window in windows {
        let depths = depths_in(scene, window, &hidden, size)?;
        shown.push((*window, hidden.iter().copied().filter(|&region| depths[region] >= LEGIBLE).collect()));
    }
    let mut chosen = Vec::new();
    while !hidden.is_empty() {
        let gain = |regions: &[usize]| regions.iter().filter(|region| hidden.contains(region)).count();
        let best =
            shown.iter().max_by(|(a, of_a), (b, of_b)| gain(of_a).cmp(&gain(of_b)).then(area(a).total_cmp(&area(b))));
        let Some((window, regions)) = best.filter(|(_, regions)| gain(regions) > 0) else { break };
        chosen.push(*window);
        hidden.retain(|region| !regions.contains(region));
    }
    Ok(chosen)
}

enum Found {
    Windows { wide: WindowDocument, closest: Candidate },
    TooSmall,
    Outside,
}

/// Windows around the widest place of a region: the largest in which it can be seen, and one in which it is seen easily.
fn own_windows(scene: &Scene<'_>, visible: &WindowDocument, region: usize, size: [f64; 2]) -> Result<Found, PlotError> {
    let document = &scene.atlas.regions[region];
    let width = document.h_width.unwrap_or(f64::INFINITY).min((visible.h[1] - visible.h[0]) / size[0]);
    if width < NARROWEST * (visible.h[1] - visible.h[0]) {
        return Ok(Found::TooSmall);
    }
    let Some(stations) = stations(scene, visible, region, width * 1e-3)? else { return Ok(Found::Outside) };
    let extent = |station: &Station| station.h[1] - station.h[0];
    let Some(widest) = stations.iter().max_by(|a, b| extent(a).total_cmp(&extent(b))) else {
        return Ok(Found::Outside);
    };
    // A strip that never ends is widest far out; the atlas' sample lies where it has something to show.
    let (sample, extent_max) = (document.sample.l, extent(widest));
    let near_sample = stations.iter().min_by(|a, b| (a.l - sample).abs().total_cmp(&(b.l - sample).abs()));
    let endless = scene.cells[region].iter().any(|cell| cell.l[1].is_infinite());
    let widest = near_sample.filter(|station| endless && extent(station) >= 0.3 * extent_max).unwrap_or(widest);
    let cells = scene.cells[region].iter().filter(|cell| cell.l[0] < visible.l[1] && cell.l[1] > visible.l[0]);
    let ends = cells.fold([f64::INFINITY, 0.0_f64], |ends, cell| [ends[0].min(cell.l[0]), ends[1].max(cell.l[1])]);
    let ends = [ends[0].max(visible.l[0]), ends[1].min(visible.l[1])];
    let mut wide: Option<WindowDocument> = None;
    let mut best: Option<Candidate> = None;
    let mut reach = (widest.l - ends[0]).max(ends[1] - widest.l);
    loop {
        let l = [ends[0].max(widest.l - reach), ends[1].min(widest.l + reach)];
        let inner = WindowDocument { h: [f64::NEG_INFINITY, f64::INFINITY], l };
        let Some(near) = self::stations(scene, &clipped(&inner, visible), region, width * 1e-3)? else { break };
        let h = [
            near.iter().map(|station| station.h[0]).fold(f64::INFINITY, f64::min),
            near.iter().map(|station| station.h[1]).fold(f64::NEG_INFINITY, f64::max),
        ];
        let window = clipped(&around(h, l), visible);
        let resolved = |[from, to]: [f64; 2]| to - from > RESOLUTION * from.abs().max(to.abs());
        if !(resolved(window.h) && resolved(window.l)) {
            break;
        }
        let depth = depths_in(scene, &window, &[region], size)?[region];
        if depth >= WIDE && wide.is_none() {
            wide = Some(window);
        }
        if best.as_ref().is_none_or(|best| depth > best.depths[0]) {
            best = Some(Candidate { window, depths: vec![depth] });
        }
        if depth >= CLOSE {
            break;
        }
        reach *= if depth < FAR_FROM_VISIBLE { 0.5 } else { SHRINK };
    }
    Ok(match best.filter(|best| best.depths[0] >= LEGIBLE) {
        Some(closest) => Found::Windows { wide: wide.unwrap_or(closest.window), closest },
        None => Found::TooSmall,
    })
}

/// `window` with its infinite sides replaced by those of `outer`.
fn clipped(window: &WindowDocument, outer: &WindowDocument) -> WindowDocument {
    let clip = |a: [f64; 2], b: [f64; 2]| [a[0].max(b[0]), a[1].min(b[1])];
    WindowDocument { h: clip(window.h, outer.h), l: clip(window.l, outer.l) }
}

/// A window with free space around, not below l = 0.
fn around(h: [f64; 2], l: [f64; 2]) -> WindowDocument {
    let (dh, dl) = (AROUND * (h[1] - h[0]), AROUND * (l[1] - l[0]));
    WindowDocument { h: [h[0] - dh, h[1] + dh], l: [(l[0] - dl).max(0.0), l[1] + dl] }
}

/// Adds windows half-way (in scale) between the main window and those that are magnified most.
fn lead_up(windows: &mut Vec<WindowDocument>, main: &WindowDocument) {
    let length = |side: [f64; 2]| side[1] - side[0];
    let scales = |outer: &WindowDocument, inner: &WindowDocument| {
        [length(outer.h) / length(inner.h), length(outer.l) / length(inner.l)]
    };
    let contains = |outer: &WindowDocument, inner: &WindowDocument| {
        let within = |outer: [f64; 2], inner: [f64; 2]| outer[0] <= inner[0] && inner[1] <= outer[1];
        within(outer.h, inner.h) && within(outer.l, inner.l)
    };
    let mut targets: Vec<WindowDocument> = windows.clone();
    targets.sort_by(|a, b| scales(main, a)[0].total_cmp(&scales(main, b)[0]));
    let mut added = 0;
    for target in targets {
        let [h, l] = scales(main, &target);
        // One window on the way is enough, unless it is still far from the target.
        let led = windows.iter().any(|other| {
            *other != target && contains(other, &target) && scales(main, other)[0] * LEAP.sqrt() >= h.sqrt()
        });
        if h.min(l) < LEAP || led || added == STEPS_MAX || !contains(main, &target) {
            continue;
        }
        let spread = |side: [f64; 2], scale: f64| {
            let (middle, half) = (f64::midpoint(side[0], side[1]), length(side) / 2.0 * scale.sqrt());
            [middle - half, middle + half]
        };
        windows.push(clipped(&WindowDocument { h: spread(target.h, h), l: spread(target.l, l) }, main));
        added += 1;
    }
}

/// The extents of a region inside a window by cells; `None` where it has none.
fn stations(
    scene: &Scene<'_>,
    window: &WindowDocument,
    region: usize,
    tolerance: f64,
) -> Result<Option<Vec<Station>>, PlotError> {
    let mut stations = Vec::new();
    for cell in &scene.cells[region] {
        let (from, to) = (cell.l[0].max(window.l[0]), cell.l[1].min(window.l[1]));
        if from >= to {
            continue;
        }
        let course = |curve: usize| trace(scene, &scene.atlas.curves[curve], [from, to], tolerance);
        let lower = course(cell.lower)?;
        let upper = cell.upper.map(course).transpose()?;
        for step in 0..=STATIONS {
            let l = from + (to - from) * (step as f64 / STATIONS as f64);
            let Some(low) = lower.h_at(l) else { continue };
            let high = upper.as_ref().map_or(Some(window.h[1]), |upper| upper.h_at(l));
            let h = [low.max(window.h[0]), high.unwrap_or(low).min(window.h[1])];
            if h[0] <= h[1] {
                stations.push(Station { l, h });
            }
        }
    }
    Ok((!stations.is_empty()).then_some(stations))
}

/// Radii in pixels of the largest circles in some regions that a panel of plot size `size` would show, 0 for all
/// others; measured on pixels twice as large.
fn depths_in(
    scene: &Scene<'_>,
    window: &WindowDocument,
    regions: &[usize],
    size: [f64; 2],
) -> Result<Vec<f64>, PlotError> {
    let rect = Rect { x: 0.0, y: 0.0, width: size[0] / COARSE, height: size[1] / COARSE };
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
    let depths = Grid::of_regions(scene, &view, &traces, regions).depths(scene.cells.len());
    Ok(depths.into_iter().map(|depth| COARSE * depth).collect())
}

/// All windows met while the two that lose least by it are united, as long as every region stays visible.
///
/// A region's inscribed circle shrinks at most by the larger of the two changes of scale, so no window has to be
/// drawn to be judged.
fn unions(mut candidates: Vec<Candidate>) -> Vec<WindowDocument> {
    let mut met = Vec::new();
    loop {
        let mut best: Option<(usize, usize, Candidate, f64)> = None;
        for i in 0..candidates.len() {
            for j in 0..i {
                let united = unite(&candidates[i], &candidates[j]);
                let least = united.depths.iter().copied().fold(f64::INFINITY, f64::min);
                if least >= KEPT && best.as_ref().is_none_or(|(.., most)| least > *most) {
                    best = Some((i, j, united, least));
                }
            }
        }
        let Some((i, j, united, _)) = best else { return met };
        met.push(united.window);
        candidates.swap_remove(i);
        candidates[j] = united;
    }
}

fn unite(a: &Candidate, b: &Candidate) -> Candidate {
    let hull = |a: [f64; 2], b: [f64; 2]| [a[0].min(b[0]), a[1].max(b[1])];
    let window = WindowDocument { h: hull(a.window.h, b.window.h), l: hull(a.window.l, b.window.l) };
    let length = |side: [f64; 2]| side[1] - side[0];
    let shrunk = |candidate: &Candidate| {
        let h = length(candidate.window.h) / length(window.h);
        let l = length(candidate.window.l) / length(window.l);
        let scale = h.min(l);
        candidate.depths.iter().map(move |depth| depth * scale).collect::<Vec<f64>>()
    };
    let depths = shrunk(a).into_iter().chain(shrunk(b)).collect();
    Candidate { window, depths }
}
