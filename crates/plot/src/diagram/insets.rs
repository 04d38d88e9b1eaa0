//! Which parts are magnified: few windows that together show every region too small to see.

use super::closeup::{Closeup, closeup, depths};
use super::panel::{LEGIBLE, Panel};
use super::plan::Plan;
use super::scene::Scene;
use super::windows::{area, beside, clear, clipped, contains, hull, length, reach_into};
use bifdiag_page::PlotError;
use bifdiag_schema::WindowDocument;

/// In the window chosen for it, a region's inscribed circle has at least this radius.
const KEPT: f64 = 5.0;
/// Insets magnify at least this many times in h and in l.
const LEAST: f64 = 3.0;
/// Insets magnified more than this against the main panel are led up to by a window between the two.
const LEAP: f64 = 40.0;
/// The most windows that lead up to others.
const STEPS_MAX: usize = 3;

/// What is magnified.
#[derive(Clone, Debug, Default)]
pub(super) struct Magnifications {
    /// The windows, largest first.
    pub windows: Vec<WindowDocument>,
    /// Regions too small for f64.
    pub invisible: Vec<usize>,
    /// Regions outside the main window.
    pub outside: Vec<usize>,
    /// Whether there are more parts to magnify than the plan has insets.
    pub crowded: bool,
}

/// A window and the radius of the inscribed circles of the regions that it is for.
struct Candidate {
    window: WindowDocument,
    depths: Vec<f64>,
}

/// Chooses the windows of the insets for what the main panel does not show.
/// What lies outside the main window is looked for in `everything`.
pub(super) fn magnifications(
    scene: &Scene<'_>,
    main: &Panel,
    everything: &WindowDocument,
) -> Result<Magnifications, PlotError> {
    let mut result = Magnifications::default();
    let mut windows: Vec<WindowDocument> = Vec::new();
    let mut candidates: Vec<Candidate> = Vec::new();
    let mut hidden: Vec<usize> = Vec::new();
    let visible = &main.view.window;
    // The scale of the main panel, and that of an overview of everything in the first inset.
    let Plan { main: own, inset, .. } = scene.plan;
    let shown = [(visible, own), (everything, inset)];
    for (region, depth) in main.areas.depths(scene.cells.len()).into_iter().enumerate() {
        if depth >= LEGIBLE {
            continue;
        }
        let mut found = closeup(scene, visible, largest(shown[0], inset), region)?;
        let goes_on = scene.cells[region].iter().any(|cell| cell.l[1] > visible.l[1]);
        if !matches!(found, Closeup::Windows { .. }) && goes_on && everything != visible {
            found = closeup(scene, everything, largest(shown[1], inset), region)?;
        }
        match found {
            Closeup::Windows { wide, close, depth } => {
                hidden.push(region);
                windows.extend([wide, close]);
                candidates.push(Candidate { window: close, depths: vec![depth] });
            }
            Closeup::TooSmall => result.invisible.push(region),
            Closeup::Outside => result.outside.push(region),
        }
    }
    windows.extend(unions(candidates));
    windows.retain(|window| {
        let shown = if contains(visible, window) { shown[0] } else { shown[1] };
        let [h, l] = largest(shown, inset);
        length(window.h) <= h * (1.0 + 1e-9) && length(window.l) <= l * (1.0 + 1e-9)
    });
    // The first inset is an overview of everything.
    let most = scene.plan.insets - usize::from(everything != visible);
    result.crowded = cover(scene, &windows, hidden, most, &mut result.windows)?;
    result.crowded |= lead_up(&mut result.windows, visible, &scene.plan, most);
    result.windows.sort_by(|a, b| area(b).total_cmp(&area(a)).then(a.l[0].total_cmp(&b.l[0])));
    Ok(result)
}

/// The sides of the largest window that an inset magnifies at least [`LEAST`] times against a window shown on a plot area of
/// the given size.
fn largest((window, size): (&WindowDocument, [f64; 2]), inset: [f64; 2]) -> [f64; 2] {
    [length(window.h) * inset[0] / size[0] / LEAST, length(window.l) * inset[1] / size[1] / LEAST]
}

/// Up to `most` windows that together show all of `hidden`, if possible: repeatedly the one that shows most of those
/// left, and the larger of two that show equally many. Windows are kept apart while every region stays visible. Returns
/// whether more windows would show more.
fn cover(
    scene: &Scene<'_>,
    windows: &[WindowDocument],
    mut hidden: Vec<usize>,
    most: usize,
    cover: &mut Vec<WindowDocument>,
) -> Result<bool, PlotError> {
    let mut shown: Vec<(WindowDocument, Vec<usize>)> = Vec::with_capacity(windows.len());
    for window in windows {
        let depths = depths(scene, window, &hidden)?;
        shown.push((*window, hidden.iter().copied().filter(|&region| depths[region] >= LEGIBLE).collect()));
    }
    let mut chosen: Vec<(WindowDocument, Vec<usize>)> = Vec::new();
    let mut crowded = false;
    while !hidden.is_empty() {
        let gain = |regions: &[usize]| regions.iter().filter(|region| hidden.contains(region)).count();
        let best =
            shown.iter().max_by(|(a, of_a), (b, of_b)| gain(of_a).cmp(&gain(of_b)).then(area(a).total_cmp(&area(b))));
        let Some((window, regions)) = best.filter(|(_, regions)| gain(regions) > 0) else { break };
        if chosen.len() == most {
            crowded = true;
            break;
        }
        let (mut window, own): (_, Vec<usize>) =
            (*window, regions.iter().copied().filter(|region| hidden.contains(region)).collect());
        for (other, of_other) in &mut chosen {
            if !reach_into(&window, other) {
                continue;
            }
            if let Some(trimmed) = trimmed(scene, &window, other, &own)? {
                window = trimmed;
            } else if let Some(trimmed) = trimmed(scene, other, &window, of_other)? {
                *other = trimmed;
            }
        }
        hidden.retain(|region| !own.contains(region));
        chosen.push((window, own));
    }
    cover.extend(chosen.into_iter().map(|(window, _)| window));
    Ok(crowded)
}

/// The largest part of a window beside another that still shows some regions.
fn trimmed(
    scene: &Scene<'_>,
    window: &WindowDocument,
    other: &WindowDocument,
    regions: &[usize],
) -> Result<Option<WindowDocument>, PlotError> {
    for part in beside(window, other) {
        let depths = depths(scene, &part, regions)?;
        if regions.iter().all(|&region| depths[region] >= LEGIBLE) {
            return Ok(Some(part));
        }
    }
    Ok(None)
}

/// Adds windows half-way (in scale) between the main window and those that are magnified most, up to `most` in all. Tells
/// whether there are more.
fn lead_up(windows: &mut Vec<WindowDocument>, main: &WindowDocument, plan: &Plan, most: usize) -> bool {
    let scales = |inner: &WindowDocument| [length(main.h) / length(inner.h), length(main.l) / length(inner.l)];
    let mut targets: Vec<WindowDocument> = windows.clone();
    targets.sort_by(|a, b| scales(a)[0].total_cmp(&scales(b)[0]));
    let mut added = 0;
    for target in targets {
        let [h, l] = scales(&target);
        // One window on the way is enough, unless it is still far from the target.
        let led = windows
            .iter()
            .any(|other| *other != target && contains(other, &target) && scales(other)[0] * LEAP.sqrt() >= h.sqrt());
        let [least_h, least_l] = [0, 1].map(|side| LEAST * plan.main[side] / plan.inset[side]);
        let magnifies = h.sqrt() >= least_h && l.sqrt() >= least_l;
        if h.min(l) < LEAP || !magnifies || led || added == STEPS_MAX || !contains(main, &target) {
            continue;
        }
        let spread = |side: [f64; 2], scale: f64| {
            let (middle, half) = (f64::midpoint(side[0], side[1]), length(side) / 2.0 * scale.sqrt());
            [middle - half, middle + half]
        };
        let wanted = clipped(&WindowDocument { h: spread(target.h, h), l: spread(target.l, l) }, main);
        if let Some(window) = clear(wanted, &target, windows) {
            if windows.len() == most {
                return true;
            }
            windows.push(window);
            added += 1;
        }
    }
    false
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
    let window = WindowDocument { h: hull(a.window.h, b.window.h), l: hull(a.window.l, b.window.l) };
    let shrunk = |candidate: &Candidate| {
        let own = &candidate.window;
        let scale = (length(own.h) / length(window.h)).min(length(own.l) / length(window.l));
        candidate.depths.iter().map(move |depth| depth * scale).collect::<Vec<f64>>()
    };
    let depths = shrunk(a).into_iter().chain(shrunk(b)).collect();
    Candidate { window, depths }
}
