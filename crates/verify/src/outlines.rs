//! The outlines of regions: each edge runs along the border of a cell of its region, which lies on its left; in each slab
//! they wind once around the cells of their region and around no others; and they go on over an event where the region does.

use schema::{AtlasDocument, CellDocument, EventDocument, RegionDocument, WindowDocument};

use super::Refused;
use super::borders::{Borders, Edge, have_partners, range};
use super::chords::Chords;
use super::gluing::Joins;
use super::orders::Orders;
use super::plane::{POINT, Plane};
use super::regions::Cell;
use super::slabs::{Level, Slab};

/// Edges leave their curves by at most this share of the height of the view.
const CHORD: f64 = 4e-3;

/// What is looked at over one l.
struct Cut<'a> {
    slab: usize,
    l: f64,
    /// Of all curves there.
    heights: &'a [f64],
    /// So far from the events around it that edges of other slabs do not reach it.
    is_apart: bool,
}

/// The view, and the curves in it.
struct Sight<'a> {
    plane: &'a Plane<'a>,
    chords: Chords<'a>,
    view: &'a WindowDocument,
    /// Cells that continue each other, if outlines go on over the l of events: not where several are at one l.
    joins: Option<&'a Joins>,
}

/// Checks the outlines of all regions in the default view.
pub(super) fn check(
    document: &AtlasDocument,
    orders: &Orders,
    plane: &Plane,
    slabs: &[Slab],
    cells: &[Vec<Cell>],
    joins: &Joins,
) -> Result<(), Refused> {
    if document.regions.iter().all(|region| region.polygon.is_none()) {
        return Ok(());
    }
    let joins = (slabs.len() == document.events.len() + 1).then_some(joins);
    let sight = Sight { plane, chords: Chords::new(plane, orders), view: &document.view.everything, joins };
    for (region, cells) in document.regions.iter().zip(cells) {
        let refuse = |why| Refused::Region { region: region.id.clone(), why };
        let outlines = region.polygon.as_ref().ok_or_else(|| refuse("it alone has no outline"))?;
        sight.compare(region, outlines, &document.events, slabs, cells).map_err(refuse)?;
    }
    Ok(())
}

impl Sight<'_> {
    fn compare(
        &self,
        region: &RegionDocument,
        outlines: &[Vec<[f64; 2]>],
        events: &[EventDocument],
        slabs: &[Slab],
        cells: &[Cell],
    ) -> Result<(), &'static str> {
        if !outlines.iter().all(|outline| self.is_closed(outline)) {
            return Err("its outline is not closed");
        }
        if !outlines.is_sorted_by(|p, q| self.begins_before(p, q)) {
            return Err("its outlines are not in their order");
        }
        let edges: Option<Vec<Vec<Edge>>> = outlines.iter().map(|outline| self.edges(region, outline)).collect();
        let edges = edges.ok_or("its outline leaves its boundary")?;
        if tells_twice(&edges) {
            return Err("an edge of its outline is told twice");
        }
        let none = Joins::new();
        let joins = self.joins.unwrap_or(&none);
        let borders = Borders { described: &region.cells, cells, joins, aside: self.aside() };
        if !edges.iter().all(|outline| borders.are_followed(outline)) {
            return Err("its outline does not go on where its region does");
        }
        self.holds(outlines, &edges, events, slabs, cells)
    }

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

    /// The cells of a region that an edge is a border of, on their side of it.
    fn borders(&self, region: &RegionDocument, corners: &[[f64; 2]]) -> Vec<usize> {
        let is_border = |cell: &usize| {
            let cell = &region.cells[*cell];
            let id = if corners[0][1] < corners[1][1] { Some(&cell.lower) } else { cell.upper.as_ref() };
            id.is_some_and(|id| self.follows(corners, id, range(cell)))
        };
        (0..region.cells.len()).filter(is_border).collect()
    }

    /// In each slab the outlines wind once around the cells of the region and not around others: over the l of its sample, and
    /// beside its ends and in its middle as far as it is in view.
    fn holds(
        &self,
        outlines: &[Vec<[f64; 2]>],
        edges: &[Vec<Edge>],
        events: &[EventDocument],
        slabs: &[Slab],
        cells: &[Cell],
    ) -> Result<(), &'static str> {
        let samples: Vec<f64> = slabs.iter().map(|slab| self.plane.momentum(&slab.x)).collect();
        let look = |cut: &Cut| {
            self.winds_around(outlines, cut, cells)?;
            if cut.is_apart && !self.is_bordered(edges, cut, cells) {
                return Err("its outline leaves out a part of its boundary, or tells one twice");
            }
            Ok(())
        };
        for (number, slab) in slabs.iter().enumerate() {
            let [from, to] = Self::ends(samples[number], events);
            let is_apart = |l: f64| (l - from).min(to - l) > 2.0 * self.aside();
            let sample = samples[number];
            if sample < self.view.l[1] {
                let heights: Vec<f64> =
                    slab.levels.iter().map(|level| level.height.to_f64() * self.plane.energy).collect();
                look(&Cut { slab: number, l: sample, heights: &heights, is_apart: is_apart(sample) })?;
            }
            for l in self.beside_ends(number, &samples, [from, to]) {
                let height = |level: &Level| Some(self.plane.over(level.curve, l)?.h.middle() * self.plane.energy);
                if let Some(heights) = slab.levels.iter().map(height).collect::<Option<Vec<f64>>>() {
                    look(&Cut { slab: number, l, heights: &heights, is_apart: is_apart(l) })?;
                }
            }
        }
        Ok(())
    }

    /// The outlines hold the middle of each gap between the heights over l that belongs to the region, and of no other.
    fn winds_around(&self, outlines: &[Vec<[f64; 2]>], cut: &Cut, cells: &[Cell]) -> Result<(), &'static str> {
        for position in 0..cut.heights.len() {
            let [low, high] = self.gap(cut, position);
            let share = (high - low) / self.height();
            let inside = cells.contains(&(cut.slab, position));
            if inside && share > POINT && outlines.is_empty() {
                return Err("it has no outline");
            }
            if share > CHORD && windings(outlines, [0.5 * (low + high), cut.l]) != i32::from(inside) {
                return Err("its outline holds another part of the plane");
            }
        }
        Ok(())
    }

    /// The part in view of the gap above a curve.
    fn gap(&self, cut: &Cut, position: usize) -> [f64; 2] {
        let high = cut.heights.get(position + 1).unwrap_or(&self.view.h[1]).min(self.view.h[1]);
        [cut.heights[position].max(self.view.h[0]), high]
    }

    /// However thin they are, the cells of the region over l that are in view and wider than rounding have an edge below them and
    /// one above, each its own, and no edge is left over. Edges that leave their curves by more than a cell is wide may
    /// cross: they are told apart by the curves that they follow.
    fn is_bordered(&self, edges: &[Vec<Edge>], cut: &Cut, cells: &[Cell]) -> bool {
        let there: Vec<usize> = cells.iter().filter(|(slab, _)| *slab == cut.slab).map(|(_, at)| *at).collect();
        let (top, near) = (self.view.h[1], CHORD * self.height());
        let is_seen = |position: usize| {
            let [low, high] = self.gap(cut, position);
            let energies = low.abs().max(high.abs()) + self.plane.norm;
            low < top - near && high - low > 2.0 * self.room() + 4.0 * POINT * energies
        };
        [true, false].into_iter().all(|rises| {
            let spanning = edges.iter().flatten().filter(|edge| edge.rises() == rises && edge.spans(cut.l));
            let of_edge = |edge: &Edge| -> Vec<usize> {
                if self.is_along_top(edge.corners) {
                    let reaches = |position: &&usize| {
                        let above = cut.heights.get(*position + 1);
                        cut.heights[**position] <= top + near && above.is_none_or(|high| *high >= top - near)
                    };
                    return there.iter().filter(reaches).copied().collect();
                }
                let in_slab = edge.cells.iter().map(|cell| cells[*cell]).filter(|(slab, _)| *slab == cut.slab);
                in_slab.map(|(_, position)| position).collect()
            };
            let by_edge: Vec<Vec<usize>> = spanning.map(of_edge).collect();
            let edges_of = |position: usize| -> Vec<usize> {
                (0..by_edge.len()).filter(|edge| by_edge[*edge].contains(&position)).collect()
            };
            let seen = there.iter().copied().filter(|position| is_seen(*position));
            have_partners(&by_edge) && have_partners(&seen.map(edges_of).collect::<Vec<_>>())
        })
    }

    fn is_along_top(&self, corners: &[[f64; 2]]) -> bool {
        corners.iter().all(|corner| corner[0] == self.view.h[1])
    }

    /// The events around a slab, by the l of its sample.
    fn ends(sample: f64, events: &[EventDocument]) -> [f64; 2] {
        let places = events.iter().map(|event| event.l);
        let from = places.clone().filter(|l| *l <= sample).fold(0.0, f64::max);
        [from, places.filter(|l| *l > sample).fold(f64::INFINITY, f64::min)]
    }

    /// Places near the ends and in the middle of the part in view of a slab; none where doubles do not tell it from those beside
    /// it.
    fn beside_ends(&self, number: usize, samples: &[f64], [from, to]: [f64; 2]) -> Vec<f64> {
        let is_alone = number.checked_sub(1).is_none_or(|before| samples[before] < from)
            && samples.get(number + 1).is_none_or(|after| *after > to);
        let to = to.min(self.view.l[1]);
        let shares = if is_alone && to - from > self.aside() { [0.02, 0.5, 0.98].as_slice() } else { &[] };
        shares.iter().map(|share| from + share * (to - from)).collect()
    }

    fn edges<'e>(&self, region: &RegionDocument, outline: &'e [[f64; 2]]) -> Option<Vec<Edge<'e>>> {
        outline.windows(2).map(|corners| self.edge(region, corners)).collect()
    }

    /// An edge that runs to the right along the lower curve of a cell or to the left along the upper one, to the left along the
    /// top of the view, or over an end of the view; between events no wall is, and over one only where outlines end there.
    fn edge<'e>(&self, region: &RegionDocument, corners: &'e [[f64; 2]]) -> Option<Edge<'e>> {
        let [[h, l], [h_to, l_to]] = [corners[0], corners[1]];
        let in_view = (0.0..=self.view.l[1] + self.aside()).contains(&l) && h <= self.view.h[1] && h >= self.view.h[0];
        let all = &region.cells;
        if !in_view {
            return None;
        }
        if l == l_to {
            let is_end = |end: f64| (l - end).abs() <= self.aside();
            let is_wall = self.joins.is_none() || (h - h_to).abs() <= 2.0 * self.room();
            let is_right = is_end(0.0)
                || is_end(self.view.l[1])
                || (is_wall && all.iter().flat_map(|cell| cell.l_range).flatten().any(is_end));
            return is_right.then_some(Edge { corners, cells: Vec::new() });
        }
        if self.is_along_top(corners) {
            let reaches = |cell: &usize, l: f64| self.reaches_top(&all[*cell], l);
            let is_right = l_to < l && [l, l_to].into_iter().all(|l| (0..all.len()).any(|cell| reaches(&cell, l)));
            let cells = (0..all.len()).filter(|cell| [l, l_to].into_iter().any(|l| reaches(cell, l)));
            return is_right.then(|| Edge { corners, cells: cells.collect() });
        }
        let cells = self.borders(region, corners);
        (!cells.is_empty()).then_some(Edge { corners, cells })
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

/// An edge is told more often than it is a border of cells: where they are thinner than doubles tell it may be that of
/// several.
fn tells_twice(outlines: &[Vec<Edge>]) -> bool {
    let mut edges: Vec<&Edge> = outlines.iter().flatten().filter(|edge| !edge.is_wall()).collect();
    edges.sort_unstable_by_key(|edge| {
        let [p, q] = [edge.corners[0], edge.corners[1]];
        [p[1], p[0], q[1], q[0]].map(f64::to_bits)
    });
    edges.chunk_by(|p, q| p.corners == q.corners).any(|same| same.len() > 1 && same.len() > same[0].cells.len())
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
