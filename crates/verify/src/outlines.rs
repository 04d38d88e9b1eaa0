//! The outlines of regions: corners lie on the curves around their regions or on the border of the view, and what they hold are
//! the cells of their regions.

use schema::{AtlasDocument, CellDocument, RegionDocument, WindowDocument};

use super::Refused;
use super::plane::{POINT, Plane};
use super::regions::Cell;
use super::slabs::Slab;

/// Chords leave their curves and the border of the window by this share of it; gaps that are narrower are not asked for.
const CHORD: f64 = 4e-3;

/// Checks the outlines of all regions in the default view.
pub(super) fn regions(
    document: &AtlasDocument,
    plane: &Plane,
    slabs: &[Slab],
    cells: &[Vec<Cell>],
) -> Result<(), Refused> {
    let shown = document.regions.iter().filter(|region| region.polygon.is_some()).count();
    if shown == 0 {
        return Ok(());
    }
    let view = &document.view.everything;
    let abscissas: Vec<f64> = slabs.iter().map(|slab| plane.momentum(&slab.x)).collect();
    for (region, cells) in document.regions.iter().zip(cells) {
        let refuse = |why| Refused::Region { region: region.id.clone(), why };
        let outlines = region.polygon.as_ref().ok_or_else(|| refuse("it alone has no outline"))?;
        if !outlines.iter().flatten().all(|point| is_around(plane, region, view, *point)) {
            return Err(refuse("its outline leaves its boundary"));
        }
        let stays = |outline: &Vec<[f64; 2]>| outline.windows(2).any(|pair| pair[0] == pair[1]);
        if outlines.iter().any(|outline| outline.len() < 4 || outline.first() != outline.last() || stays(outline)) {
            return Err(refuse("its outline is not closed"));
        }
        for (number, slab) in slabs.iter().enumerate() {
            let l = abscissas[number];
            if l >= view.l[1] {
                continue;
            }
            for position in 0..slab.levels.len() {
                let heights = [Some(&slab.levels[position]), slab.levels.get(position + 1)];
                let heights = heights.map(|level| level.map(|level| level.height.to_f64() * plane.energy));
                let low = heights[0].unwrap_or(view.h[0]).max(view.h[0]);
                let high = heights[1].unwrap_or(view.h[1]).min(view.h[1]);
                let share = (high - low) / (view.h[1] - view.h[0]);
                let inside = cells.contains(&(number, position));
                if inside && share > POINT && outlines.is_empty() {
                    return Err(refuse("it has no outline"));
                }
                let told = share > CHORD;
                if told && is_inside(outlines, [0.5 * (low + high), l]) != inside {
                    return Err(refuse("its outline holds another part of the plane"));
                }
            }
        }
    }
    Ok(())
}

/// By the even-odd rule, along the line of rising h.
fn is_inside(outlines: &[Vec<[f64; 2]>], [h, l]: [f64; 2]) -> bool {
    let crosses = |pair: &[[f64; 2]]| {
        let [[p, from], [q, to]] = [pair[0], pair[1]];
        (from > l) != (to > l) && p + (q - p) * (l - from) / (to - from) > h
    };
    outlines.iter().flat_map(|outline| outline.windows(2)).filter(|pair| crosses(pair)).count() % 2 == 1
}

/// A corner of an outline lies in the view, on a curve around a cell of the region or between them at the lowest or highest
/// energy of the view.
fn is_around(plane: &Plane, region: &RegionDocument, view: &WindowDocument, [h, l]: [f64; 2]) -> bool {
    let extent = view.h[1] - view.h[0];
    let (room, aside) = (POINT * extent, POINT * view.l[1]);
    let on_border = view.h.iter().any(|border| (h - border).abs() <= room);
    let in_view = (view.h[0] - room..=view.h[1] + room).contains(&h) && (view.l[0]..=view.l[1] + aside).contains(&l);
    let around = |cell: &CellDocument| {
        let [from, to] = [cell.l_range[0].unwrap_or(0.0), cell.l_range[1].unwrap_or(f64::INFINITY)];
        // Where a chord meets the border of the view is a little aside.
        let beside = if on_border { CHORD * view.l[1] } else { aside };
        if l < from - beside || l > to + beside {
            return false;
        }
        let height = |id: &String, l: f64| plane.height(id, l.max(from).min(to));
        let is_on = |id: &String| height(id, l).is_some_and(|[on, its]| (h - on).abs() <= its + room);
        if is_on(&cell.lower) || cell.upper.as_ref().is_some_and(is_on) {
            return true;
        }
        let near = CHORD * extent;
        // Curves rise with l.
        let above = || height(&cell.lower, l - beside).is_some_and(|[low, _]| low <= h + near);
        let below = |upper| height(upper, l + beside).is_some_and(|[high, _]| h <= high + near);
        on_border && above() && cell.upper.as_ref().is_none_or(below)
    };
    in_view && region.cells.iter().any(around)
}
