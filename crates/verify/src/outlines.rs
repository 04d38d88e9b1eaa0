//! The outlines of regions: each edge runs along the border of a cell of its region, which lies on its left, and in each slab
//! they wind once around the cells of their region and around no others.

use schema::{AtlasDocument, CellDocument, EventDocument, RegionDocument, WindowDocument};

use super::Refused;
use super::chords::Chords;
use super::orders::Orders;
use super::plane::{POINT, Plane};
use super::regions::Cell;
use super::slabs::{Level, Slab};

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
        if sight.tells_twice(region, outlines) {
            return Err(refuse("an edge of its outline is told twice"));
        }
        sight.holds(outlines, &document.events, slabs, cells).map_err(refuse)?;
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

    /// An edge is told more often than it is a border of cells: where they are thinner than doubles tell it may be that of
    /// several.
    fn tells_twice(&self, region: &RegionDocument, outlines: &[Vec<[f64; 2]>]) -> bool {
        let mut edges: Vec<&[[f64; 2]]> = outlines.iter().flat_map(|outline| outline.windows(2)).collect();
        edges.retain(|edge| edge[0][1] != edge[1][1]);
        edges.sort_unstable_by_key(|edge| [edge[0][1], edge[0][0], edge[1][1], edge[1][0]].map(f64::to_bits));
        edges.chunk_by(|p, q| p == q).any(|same| same.len() > 1 && same.len() > self.borders(region, same[0]))
    }

    /// How many cells of a region an edge is a border of, on their side of it.
    fn borders(&self, region: &RegionDocument, edge: &[[f64; 2]]) -> usize {
        let is_border = |cell: &&CellDocument| {
            let id = if edge[0][1] < edge[1][1] { Some(&cell.lower) } else { cell.upper.as_ref() };
            id.is_some_and(|id| self.follows(edge, id, range(cell)))
        };
        region.cells.iter().filter(is_border).count()
    }

    /// In each slab the outlines wind once around the cells of the region and not around others: over the l of its sample, and
    /// beside its ends and in its middle as far as it is in view.
    fn holds(
        &self,
        outlines: &[Vec<[f64; 2]>],
        events: &[EventDocument],
        slabs: &[Slab],
        cells: &[Cell],
    ) -> Result<(), &'static str> {
        let samples: Vec<f64> = slabs.iter().map(|slab| self.plane.momentum(&slab.x)).collect();
        for (number, slab) in slabs.iter().enumerate() {
            let is_inside = |position: usize| cells.contains(&(number, position));
            let sample = samples[number];
            if sample < self.view.l[1] {
                let heights: Vec<f64> =
                    slab.levels.iter().map(|level| level.height.to_f64() * self.plane.energy).collect();
                self.holds_over(outlines, sample, &heights, is_inside)?;
            }
            for l in self.beside_ends(number, &samples, events) {
                let height = |level: &Level| Some(self.plane.over(level.curve, l)?.h.middle() * self.plane.energy);
                if let Some(heights) = slab.levels.iter().map(height).collect::<Option<Vec<f64>>>() {
                    self.holds_over(outlines, l, &heights, is_inside)?;
                }
            }
        }
        Ok(())
    }

    /// The outlines hold the middle of each gap between these heights over l that belongs to the region, and of no other.
    fn holds_over(
        &self,
        outlines: &[Vec<[f64; 2]>],
        l: f64,
        heights: &[f64],
        is_inside: impl Fn(usize) -> bool,
    ) -> Result<(), &'static str> {
        for (position, low) in heights.iter().enumerate() {
            let low = low.max(self.view.h[0]);
            let high = heights.get(position + 1).unwrap_or(&self.view.h[1]).min(self.view.h[1]);
            let share = (high - low) / self.height();
            let inside = is_inside(position);
            if inside && share > POINT && outlines.is_empty() {
                return Err("it has no outline");
            }
            if share > CHORD && windings(outlines, [0.5 * (low + high), l]) != i32::from(inside) {
                return Err("its outline holds another part of the plane");
            }
        }
        Ok(())
    }

    /// Places near the ends and in the middle of the part in view of a slab; none where doubles do not tell it from those beside
    /// it.
    fn beside_ends(&self, number: usize, samples: &[f64], events: &[EventDocument]) -> Vec<f64> {
        let sample = samples[number];
        let places = events.iter().map(|event| event.l);
        let from = places.clone().filter(|l| *l <= sample).fold(0.0, f64::max);
        let to = places.filter(|l| *l > sample).fold(f64::INFINITY, f64::min);
        let is_alone = number.checked_sub(1).is_none_or(|before| samples[before] < from)
            && samples.get(number + 1).is_none_or(|after| *after > to);
        let to = to.min(self.view.l[1]);
        let shares = if is_alone && to - from > self.aside() { [0.02, 0.5, 0.98].as_slice() } else { &[] };
        shares.iter().map(|share| from + share * (to - from)).collect()
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
        self.borders(region, edge) > 0
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
                (on - h).abs() <= most || (is_short && self.passes_top(id, l, [from, to]))
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

    /// A curve passes the top of the view within a part of it that is not seen; curves rise with l.
    fn passes_top(&self, id: &str, l: f64, [from, to]: [f64; 2]) -> bool {
        let height = |l: f64| Some(self.plane.height(id, l.max(from).min(to))?[0]);
        let near = CHORD * self.height();
        height(l - self.aside()).is_some_and(|low| low <= self.view.h[1] + near)
            && height(l + self.aside()).is_some_and(|high| high >= self.view.h[1] - near)
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
        let is_above = (from > l) != (to > l) && p + (q - p) * ((l - from) / (to - from)) > h;
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
