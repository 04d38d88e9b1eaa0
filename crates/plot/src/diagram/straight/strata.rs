//! The plane between event momenta: which curves lie above each other there, read from the cells of the document, and how
//! wide the regions between them are, each compared to its own widest place.

use std::collections::BTreeMap;

use super::super::scene::{Cell, Scene, coincidences};
use super::super::trace::trace;
use super::super::windows::l_range;
use bifdiag_page::PlotError;
use bifdiag_schema::EventDocument;

/// Momenta at which a slab is sampled, closer to each other near its ends.
const STATIONS: usize = 64;
/// Widths below this share of the energies are rounding.
const ROUNDING: f64 = 1e-12;
/// A region is half as high as it may be where it has this share of its greatest width.
const SHARP: f64 = 0.15;
/// Where a region continues beyond an event momentum, it is as high there as possible, unless it has less than this
/// share of its greatest widths.
const NARROW: f64 = 0.01;

/// All between two neighbouring event momenta.
pub(super) struct Slab {
    pub l: [f64; 2],
    /// From the lowest curve upwards; the last is unbounded.
    pub layers: Vec<Layer>,
    pub stations: Vec<SlabSlice>,
    pub points: Vec<Vertex>,
}

/// Where a layer ends in the point in which the curves around it cross.
pub(super) struct Vertex {
    pub layer: usize,
    /// At the last station, not at the first.
    pub is_last: bool,
    /// The region that begins there on the other side.
    pub opposite: usize,
}

/// A cell of a region.
pub(super) struct Layer {
    pub region: usize,
    /// The curve below.
    pub lower: usize,
}

/// What a slab holds at one l.
pub(super) struct SlabSlice {
    pub l: f64,
    /// How far from the lower end of the slab to the upper, from 0 to 1.
    pub share: f64,
    /// The energies of the curves below the layers.
    pub h: Vec<f64>,
    /// How high the layers are compared to their greatest heights.
    pub size: Vec<f64>,
}

/// The slabs up to some l; `None` where the cells of the document do not say which curves lie above each other.
pub(super) fn slabs(scene: &Scene<'_>, l_end: f64) -> Result<Option<Vec<Slab>>, PlotError> {
    let Some(stacks) = stacks(scene) else { return Ok(None) };
    let mut slabs = Vec::with_capacity(stacks.len());
    for stack in stacks {
        let l = [stack[0].1.l[0], stack[0].1.l[1].min(l_end)];
        if l[0] >= l[1] {
            return Ok(None);
        }
        slabs.push(slab(scene, l, &stack)?);
    }
    // An event may name another of the curves that coincide there.
    let sets = coincidences(scene.atlas);
    let set_of = |curve: usize| sets.iter().position(|set| set.contains(&curve));
    let is_at = |curve: usize, event: &EventDocument| {
        let own = set_of(curve).map(|set| &sets[set]);
        own.into_iter().flatten().any(|&curve| event.curves.contains(&scene.atlas.curves[curve].id))
    };
    let closes = |slab: &Slab, at: f64| -> Vec<bool> {
        let meet = |pair: &[Layer]| {
            let mut events = scene.atlas.events.iter().filter(|event| event.l == at);
            events.any(|event| pair.iter().all(|layer| is_at(layer.lower, event)))
        };
        slab.layers.windows(2).map(meet).collect()
    };
    let closed: Vec<[Vec<bool>; 2]> = slabs.iter().map(|slab| slab.l.map(|at| closes(slab, at))).collect();
    compare(&mut slabs, &closed, scene.cells.len());
    for (place, pair) in (1..slabs.len()).zip(closed.windows(2)) {
        let [left, right] = [&pair[0][1], &pair[1][0]];
        // The same number of curves on both sides, and all of them meet at the same places: crossings.
        if left == right {
            for layer in (0..left.len()).filter(|layer| left[*layer]) {
                let [before, after] = [place - 1, place].map(|slab| slabs[slab].layers[layer].region);
                slabs[place - 1].points.push(Vertex { layer, is_last: true, opposite: after });
                slabs[place].points.push(Vertex { layer, is_last: false, opposite: before });
            }
        }
    }
    Ok(Some(slabs))
}

/// The cells between each pair of neighbouring event momenta with their regions, from the lowest upwards; `None` where a curve
/// is in none of them.
fn stacks(scene: &Scene<'_>) -> Option<Vec<Vec<(usize, Cell)>>> {
    let mut by_start: BTreeMap<u64, Vec<(usize, Cell)>> = BTreeMap::new();
    for (region, cell) in
        scene.cells.iter().enumerate().flat_map(|(region, cells)| cells.iter().map(move |c| (region, c)))
    {
        // Bits of numbers that are not negative are ordered as these are.
        by_start.entry((cell.l[0] + 0.0).to_bits()).or_default().push((region, *cell));
    }
    let mut stacks = Vec::with_capacity(by_start.len());
    for mut left in by_start.into_values() {
        let is_lowest = |place: &usize| left.iter().all(|(_, cell)| cell.upper != Some(left[*place].1.lower));
        let mut next = (0..left.len()).find(is_lowest);
        let mut stack: Vec<(usize, Cell)> = Vec::with_capacity(left.len());
        while let Some(place) = next {
            let (region, cell) = left.swap_remove(place);
            stack.push((region, cell));
            next = cell.upper.and_then(|upper| left.iter().position(|(_, cell)| cell.lower == upper));
        }
        let l = stack.first()?.1.l;
        if !left.is_empty() || stack.last()?.1.upper.is_some() || stack.iter().any(|(_, cell)| cell.l != l) {
            return None;
        }
        stacks.push(stack);
    }
    let joined = stacks.windows(2).all(|pair| pair[0][0].1.l[1] == pair[1][0].1.l[0]);
    let is_whole = stacks.first()?[0].1.l[0] == 0.0 && stacks.last()?[0].1.l[1].is_infinite();
    (joined && is_whole && is_drawn(scene, &stacks)).then_some(stacks)
}

/// Whether every curve, or one that it coincides with, bounds a cell wherever it runs.
fn is_drawn(scene: &Scene<'_>, stacks: &[Vec<(usize, Cell)>]) -> bool {
    let range = |curve: usize| l_range(scene.atlas.curves[curve].l_range);
    coincidences(scene.atlas).iter().all(|set| {
        stacks.iter().all(|stack| {
            let l = stack[0].1.l;
            let runs = set.iter().any(|&curve| range(curve)[0] < l[1] && range(curve)[1] > l[0]);
            !runs || stack.iter().any(|(_, cell)| set.contains(&cell.lower))
        })
    })
}

fn slab(scene: &Scene<'_>, ends: [f64; 2], stack: &[(usize, Cell)]) -> Result<Slab, PlotError> {
    let at = |step: usize| {
        let share = 0.5 - 0.5 * libm::cos(std::f64::consts::PI * step as f64 / STATIONS as f64);
        if step == STATIONS { ends[1] } else { ends[0] + (ends[1] - ends[0]) * share }
    };
    let momenta: Vec<f64> = (0..=STATIONS).map(at).collect();
    let mut stations: Vec<SlabSlice> = momenta
        .iter()
        .map(|&l| SlabSlice {
            l,
            share: (l - ends[0]) / (ends[1] - ends[0]),
            h: Vec::with_capacity(stack.len()),
            size: Vec::new(),
        })
        .collect();
    for (_, cell) in stack {
        for (station, h) in stations.iter_mut().zip(energies(scene, cell.lower, &momenta)?) {
            // Curves do not cross inside of a slab.
            let below = station.h.last().copied().unwrap_or(f64::NEG_INFINITY);
            station.h.push(h.max(below));
        }
    }
    let layers = stack.iter().map(|(region, cell)| Layer { region: *region, lower: cell.lower }).collect();
    Ok(Slab { l: ends, layers, stations, points: Vec::new() })
}

/// The energies of a curve at rising momenta: of its source exactly there, else between the points of the document.
pub(super) fn energies(scene: &Scene<'_>, curve: usize, momenta: &[f64]) -> Result<Vec<f64>, PlotError> {
    let document = &scene.atlas.curves[curve];
    let (Some(first), Some(last)) = (momenta.first(), momenta.last()) else { return Ok(Vec::new()) };
    if let Some(exact) = scene.source.and_then(|source| source.energies(&document.id, momenta)) {
        return Ok(exact);
    }
    let drawn = trace(scene, document, [*first, *last], f64::INFINITY)?;
    let missing = || PlotError::NoPolyline { curve: document.id.clone() };
    momenta.iter().map(|l| drawn.h_at(*l).ok_or_else(missing)).collect()
}

/// 1 at an end of a slab, 0 at the other.
pub(super) fn near(far: f64) -> f64 {
    1.0 - far * far * (3.0 - 2.0 * far)
}

/// Sets the sizes of all layers; `closed` says for both ends of each slab which layers end there in a point.
fn compare(slabs: &mut [Slab], closed: &[[Vec<bool>; 2]], regions: usize) {
    let widths: Vec<Vec<Vec<f64>>> = slabs.iter().zip(closed).map(|(slab, closed)| widths(slab, closed)).collect();
    // The width of each region, all of its layers together.
    let together: Vec<Vec<Vec<f64>>> = slabs
        .iter()
        .zip(&widths)
        .map(|(slab, widths)| {
            let sum = |own: &Vec<f64>| {
                let mut sums = vec![0.0; regions];
                slab.layers.iter().zip(own).for_each(|(layer, width)| sums[layer.region] += width);
                sums
            };
            widths.iter().map(sum).collect()
        })
        .collect();
    let most = |slab: usize, region: usize| together[slab].iter().map(|sums| sums[region]).fold(0.0, f64::max);
    let greatest: Vec<Vec<f64>> =
        (0..slabs.len()).map(|slab| (0..regions).map(|region| most(slab, region)).collect()).collect();
    let is_here = |slab: usize, region: usize| greatest.get(slab).is_some_and(|all| all[region] > 0.0);
    // With what a width is compared: in the middle of a slab with the greatest there, at an end with itself, unless it is
    // small compared to the greatest on both sides.
    let at_end = |slab: usize, other: usize, step: usize, region: usize| {
        let [own, there] = [slab, other].map(|slab| greatest[slab][region]);
        together[slab][step][region].max(NARROW * (own * there).sqrt())
    };
    let measure = |slab: usize, region: usize, step: usize| {
        let own = greatest[slab][region];
        let share = slabs[slab].stations[step].share;
        let end = match (share < 0.5, slab.checked_sub(1)) {
            (true, Some(before)) if is_here(before, region) => at_end(slab, before, 0, region),
            (true, None) => at_end(slab, slab, 0, region),
            (false, _) if is_here(slab + 1, region) => at_end(slab, slab + 1, STATIONS, region),
            (false, _) if slab + 1 == slabs.len() => at_end(slab, slab, STATIONS, region),
            _ => own,
        };
        let away = (2.0 * share - 1.0) * (2.0 * share - 1.0);
        own * libm::exp(libm::log(end / own) * away)
    };
    let compared = |slab: usize, region: usize, step: usize| {
        let own = together[slab][step][region];
        if own > 0.0 { own / measure(slab, region, step) } else { 0.0 }
    };
    // What makes both sides of an event momentum say the same where widths are as small as their errors.
    let joint = |slab: usize, region: usize, step: usize| {
        let far = slabs[slab].stations[step].share;
        let [own, other] = [compared(slab, region, 0), compared(slab, region, STATIONS)];
        let before = slab.checked_sub(1).filter(|before| is_here(*before, region));
        let before = before.map_or(0.0, |before| compared(before, region, STATIONS) - own);
        let after = if is_here(slab + 1, region) { compared(slab + 1, region, 0) - other } else { 0.0 };
        0.5 * (before * near(far) + after * near(1.0 - far))
    };
    let sizes: Vec<Vec<Vec<f64>>> = (0..slabs.len())
        .map(|place| {
            let size = |layer: usize, step: usize| {
                let region = slabs[place].layers[layer].region;
                let Some(own) = widths[place][step].get(layer) else { return 1.0 };
                let all = together[place][step][region];
                if all > 0.0 {
                    let height = (compared(place, region, step) + joint(place, region, step)).max(0.0);
                    (1.0 + SHARP) * height / (height + SHARP) * own / all
                } else {
                    0.0
                }
            };
            let layers = slabs[place].layers.len();
            (0..=STATIONS).map(|step| (0..layers).map(|layer| size(layer, step)).collect()).collect()
        })
        .collect();
    for (slab, sizes) in slabs.iter_mut().zip(sizes) {
        slab.stations.iter_mut().zip(sizes).for_each(|(station, size)| station.size = size);
    }
}

/// The widths of the bounded layers of a slab at its stations; where all of them are rounding, a shape with the same ends.
fn widths(slab: &Slab, closed: &[Vec<bool>; 2]) -> Vec<Vec<f64>> {
    let mut widths: Vec<Vec<f64>> =
        slab.stations.iter().map(|station| station.h.windows(2).map(|pair| pair[1] - pair[0]).collect()).collect();
    for layer in 0..slab.layers.len() - 1 {
        let [closes, opens] = [closed[0][layer], closed[1][layer]];
        let most = widths.iter().map(|own| own[layer]).fold(0.0, f64::max);
        let scale = slab.stations.iter().map(|station| station.h[layer].abs()).fold(0.0, f64::max);
        for (step, own) in widths.iter_mut().enumerate() {
            let share = slab.stations[step].share;
            if most <= ROUNDING * scale {
                let ends = [if closes { share } else { 1.0 }, if opens { 1.0 - share } else { 1.0 }];
                own[layer] = ROUNDING * scale.max(f64::MIN_POSITIVE) * ends[0].min(ends[1]);
            } else if (step == 0 && closes) || (step == STATIONS && opens) {
                own[layer] = 0.0;
            }
        }
    }
    widths
}
