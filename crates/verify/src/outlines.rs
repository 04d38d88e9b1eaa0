//! The outlines of regions: each edge runs along the border of a cell of its region, which lies on its left, and in each slab
//! they wind once around the cells of their region and around no others.

use schema::{AtlasDocument, CellDocument, RegionDocument, WindowDocument};

use super::Refused;
use super::chords::Chords;
use super::orders::Orders;
use super::plane::{POINT, Plane};
use super::regions::Cell;
use super::slabs::Slab;

/// Edges leave their curves by at most this share of the height of the view; gaps that are narrower are not asked for.
const CHORD: f64 = 4e-3;

/// The view, and the curves in it.
struct Sight<'a> {
    plane: &'a Plane<'a>,
    chords: Chords<'a>,
    view: &'a WindowDocument,
}

/// Checks the outlines of all regions in the default view.
pub(super) fn check(
    document: &AtlasDocument,
    orders: &Orders,
    plane: &Plane,
    slabs: &[Slab],
    cells: &[Vec<Cell>],
) -> Result<(), Refused> {
    if document.regions.iter().all(|region| region.polygon.is_none()) {
        return Ok(());
    }
    let sight = Sight { plane, chords: Chords::new(plane, orders), view: &document.view.everything };
    for (region, cells) in document.regions.iter().zip(cells) {
        let refuse = |why| Refused::Region { region: region.id.clone(), why };
        let outlines = region.polygon.as_ref().ok_or_else(|| refuse("it alone has no outline"))?;
        if !outlines.iter().all(|outline| sight.is_closed(outline)) {
            return Err(refuse("its outline is not closed"));
        }
        if !outlines.is_sorted_by(|p, q| sight.begins_before(p, q)) {
            return Err(refuse("its outlines are not in their order"));
        }
        if !outlines.iter().flat_map(|outline| outline.windows(2)).all(|edge| sight.is_edge(region, edge)) {
            return Err(refuse("its outline leaves its boundary"));
        }
        if sight.tells_twice(outlines) {
            return Err(refuse("an edge of its outline is told twice"));
        }
        sight.holds(outlines, slabs, cells).map_err(refuse)?;
    }
    Ok(())
}

impl Sight<'_> {
    /// It ends where it began, at its smallest l, from where it runs to the right, and moves with each corner; no two edges in a
    /// row are over one l or along the top of the view.
    fn is_closed(&self, outline: &[[f64; 2]]) -> bool {
        let turns = |corners: &[[f64; 2]]| {
            let is_along = |k: usize, at: f64| corners.iter().all(|corner| corner[k] == at);
            corners.windows(2).all(|pair| pair[0] != pair[1])
                && !is_along(1, corners[0][1])
                && !is_along(0, self.view.h[1])
        };
        outline.len() > 3
            && outline.first() == outline.last()
            && outline.windows(3).all(turns)
            && outline.iter().all(|corner| outline[0][1] <= corner[1])
            // Two events may be at one l to rounding.
            && (outline[0][1] < outline[1][1] || (outline[0][0] - outline[1][0]).abs() <= self.room())
    }

    /// Outlines stand in the order of the l, then the h, at which they begin.
    fn begins_before(&self, p: &[[f64; 2]], q: &[[f64; 2]]) -> bool {
        p != q && (p[0][1] < q[0][1] || (p[0][1] == q[0][1] && p[0][0] <= q[0][0] + self.room()))
    }

    /// How far in h and in l a corner may lie aside.
    fn room(&self) -> f64 {
        POINT * self.height()
    }

    fn aside(&self) -> f64 {
        POINT * self.view.l[1]
    }

    fn height(&self) -> f64 {
        self.view.h[1] - self.view.h[0]
    }

    /// An edge is told more than once oftener than its reverse: cells that are thinner than doubles tell have edges to and fro.
    /// Those that span nothing of the view may differ from their reverse by rounding.
    fn tells_twice(&self, outlines: &[Vec<[f64; 2]>]) -> bool {
        let by_rising_l = |edge: &[[f64; 2]]| {
            let [[h, l], [h_to, l_to]] = [edge[0], edge[1]];
            if l < l_to {
                ([l, h, l_to, h_to].map(f64::to_bits), 1)
            } else {
                ([l_to, h_to, l, h].map(f64::to_bits), -1)
            }
        };
        let edges = outlines.iter().flat_map(|outline| outline.windows(2));
        let edges = edges.filter(|edge| (edge[0][1] - edge[1][1]).abs() > self.aside());
        let mut edges: Vec<([u64; 4], i32)> = edges.map(by_rising_l).collect();
        edges.sort_unstable();
        edges.chunk_by(|p, q| p.0 == q.0).any(|same| same.iter().map(|edge| edge.1).sum::<i32>().abs() > 1)
    }

    /// In each slab the outlines wind once around the cells of the region and not around others.
    fn holds(&self, outlines: &[Vec<[f64; 2]>], slabs: &[Slab], cells: &[Cell]) -> Result<(), &'static str> {
        for (number, slab) in slabs.iter().enumerate() {
            let l = self.plane.momentum(&slab.x);
            if l >= self.view.l[1] {
                continue;
            }
            for position in 0..slab.levels.len() {
                let heights = [Some(&slab.levels[position]), slab.levels.get(position + 1)];
                let heights = heights.map(|level| level.map(|level| level.height.to_f64() * self.plane.energy));
                let low = heights[0].unwrap_or(self.view.h[0]).max(self.view.h[0]);
                let high = heights[1].unwrap_or(self.view.h[1]).min(self.view.h[1]);
                let share = (high - low) / self.height();
                let inside = cells.contains(&(number, position));
                if inside && share > POINT && outlines.is_empty() {
                    return Err("it has no outline");
                }
                if share > CHORD && windings(outlines, [0.5 * (low + high), l]) != i32::from(inside) {
                    return Err("its outline holds another part of the plane");
                }
            }
        }
        Ok(())
    }

    /// An edge runs to the right along the lower curve of a cell or to the left along the upper one, to the left along the top
    /// of the view, or over an end of cells or of the view.
    fn is_edge(&self, region: &RegionDocument, edge: &[[f64; 2]]) -> bool {
        let [[h, l], [h_to, l_to]] = [edge[0], edge[1]];
        let in_view = (0.0..=self.view.l[1] + self.aside()).contains(&l) && h <= self.view.h[1] && h >= self.view.h[0];
        let cells = &region.cells;
        if !in_view {
            return false;
        }
        if l == l_to {
            let is_end = |end: f64| (l - end).abs() <= self.aside();
            return is_end(0.0)
                || is_end(self.view.l[1])
                || cells.iter().flat_map(|cell| cell.l_range).flatten().any(is_end);
        }
        if h == h_to && h == self.view.h[1] {
            return l_to < l && [l, l_to].into_iter().all(|l| cells.iter().any(|cell| self.reaches_top(cell, l)));
        }
        cells.iter().any(|cell| {
            let border = if l < l_to { Some(&cell.lower) } else { cell.upper.as_ref() };
            border.is_some_and(|id| self.follows(edge, id, range(cell)))
        })
    }

    /// An edge follows a curve over a range of l. Where it meets the top of the view it is the chord to a point beyond it, and so
    /// it is over less than a part of the view that is not seen.
    fn follows(&self, edge: &[[f64; 2]], id: &str, [from, to]: [f64; 2]) -> bool {
        let (p, q) = if edge[0][1] < edge[1][1] { (edge[0], edge[1]) } else { (edge[1], edge[0]) };
        if p[1] < from - self.aside() || q[1] > to + self.aside() {
            return false;
        }
        let (is_short, most) = (q[1] - p[1] <= self.aside(), CHORD * self.height());
        let off = |[h, l]: [f64; 2]| {
            let [on, room] = self.plane.height(id, l.max(from).min(to))?;
            let is_on = if h == self.view.h[1] {
                is_short || (on - h).abs() <= most
            } else {
                (on - h).abs() <= room + self.room()
            };
            is_on.then_some(on - h)
        };
        let (Some(first), Some(last)) = (off(p), off(q)) else { return false };
        is_short
            || self
                .plane
                .curve(id, 0.5 * (p[1] + q[1]))
                .is_some_and(|curve| self.chords.hold(curve, [p[1], q[1]], [first, last], most))
    }

    /// Over an l the top of the view lies in a cell, or beside it.
    fn reaches_top(&self, cell: &CellDocument, l: f64) -> bool {
        let [from, to] = range(cell);
        // Where a chord meets the border of the view is a little aside.
        let beside = CHORD * self.view.l[1];
        let height = |id: &String, l: f64| Some(self.plane.height(id, l.max(from).min(to))?[0]);
        let (top, near) = (self.view.h[1], CHORD * self.height());
        // Curves rise with l.
        l >= from - beside
            && l <= to + beside
            && height(&cell.lower, l - beside).is_some_and(|low| low <= top + near)
            && cell.upper.as_ref().is_none_or(|id| height(id, l + beside).is_some_and(|high| top <= high + near))
    }
}

fn range(cell: &CellDocument) -> [f64; 2] {
    [cell.l_range[0].unwrap_or(0.0), cell.l_range[1].unwrap_or(f64::INFINITY)]
}

/// How often outlines wind around a point, by their edges above it: those that run to the left have their inside below them.
fn windings(outlines: &[Vec<[f64; 2]>], [h, l]: [f64; 2]) -> i32 {
    let winds = |pair: &[[f64; 2]]| {
        let [[p, from], [q, to]] = [pair[0], pair[1]];
        let is_above = (from > l) != (to > l) && p + (q - p) * (l - from) / (to - from) > h;
        if !is_above {
            0
        } else if from > to {
            1
        } else {
            -1
        }
    };
    outlines.iter().flat_map(|outline| outline.windows(2)).map(winds).sum()
}
