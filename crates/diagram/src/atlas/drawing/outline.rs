//! The outlines of the regions in a window.
//!
//! In each slab a region is a column of cells between two curves, over both of which l is a coordinate. An outline runs to
//! the right along the lower curve of a cell and to the left along the upper one; at an event it passes to the cells
//! with which the region continues there, and where it does not continue it turns.

use std::collections::BTreeMap;

use super::Window;
use crate::arrangement::{EventId, RegionId, SlabId, continued};
use crate::atlas::Atlas;
use bifdiag_equilibria::curves::CurveId;
use bifdiag_numbers::UNIT_ROUNDOFF;
use bifdiag_numbers::table::{Id, Table};

/// A closed polygon of points [h, l]; the last is the first.
pub type Outline = Vec<[f64; 2]>;

/// A cell: a slab and the gap above the curve at this position.
type SlabCell = (usize, usize);

/// Edges of cells along which outlines run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Edge {
    /// To the right along the lower curve.
    Lower(SlabCell),
    /// To the left along the upper curve.
    Upper(SlabCell),
}

/// The curves of the slabs that a window shows, as polylines, and how cells continue from slab to slab.
struct Columns {
    /// By rising l; `chains[slab][position]` is the part of the curve at that position, clipped to the window.
    chains: Vec<Vec<Outline>>,
    /// The top of the window over each slab.
    top: Vec<Outline>,
    /// The cells to the right of each cell and of the same region, from below.
    right: BTreeMap<SlabCell, Vec<SlabCell>>,
    /// Those to the left.
    left: BTreeMap<SlabCell, Vec<SlabCell>>,
}

impl Atlas {
    /// For each region the closed outlines of its part inside a window; none for a region outside it. Corners lie on the
    /// curves, neighbours share them, and their number is bounded.
    #[must_use]
    pub fn outlines(&self, window: &Window) -> Table<RegionId, Vec<Outline>> {
        let columns = self.columns(window);
        self.regions
            .iter()
            .map(|region| {
                let cells: Vec<SlabCell> = region
                    .cells
                    .iter()
                    .map(|cell| (cell.slab.index(), cell.position))
                    .filter(|&(slab, _)| columns.chains.get(slab).is_some_and(|chains| !chains.is_empty()))
                    .collect();
                columns.outlines(cells)
            })
            .collect()
    }

    fn columns(&self, window: &Window) -> Columns {
        let slabs = &self.arrangement.slabs;
        let mut columns =
            Columns { chains: Vec::new(), top: Vec::new(), right: BTreeMap::new(), left: BTreeMap::new() };
        for slab in slabs.ids() {
            let l = slabs[slab].x.map(|x| self.momentum(x));
            let l = [l[0].max(window.l[0]), l[1].min(window.l[1])];
            let seen = l[0] <= l[1];
            columns.chains.push(if seen { self.chains(slab, l, window.h) } else { Vec::new() });
            columns.top.push(l.map(|l| [window.h[1], l]).to_vec());
        }
        // Where several events are proved to lie at one l there is no slab between them: the outlines end at this l.
        if slabs.len() == self.arrangement.events.len() + 1 {
            self.arrangement.events.ids().for_each(|event| self.join(event, &mut columns));
        }
        columns
    }

    /// Notes which cells continue across an event that the window shows.
    fn join(&self, event: EventId, columns: &mut Columns) {
        let (before, after) = (SlabId::ending_at(event), SlabId::starting_at(event));
        if [before, after].iter().any(|slab| columns.chains[slab.index()].is_empty()) {
            return;
        }
        let order = |slab: SlabId| self.arrangement.slabs[slab].order.as_slice();
        for [left, right] in continued(order(before), order(after), &self.arrangement.events[event].change) {
            // Gap 0, below all curves, is forbidden.
            let (Some(left), Some(right)) = (left.checked_sub(1), right.checked_sub(1)) else { continue };
            let (left, right) = ((before.index(), left), (after.index(), right));
            columns.right.entry(left).or_default().push(right);
            columns.left.entry(right).or_default().push(left);
        }
    }

    /// The curves of a slab over a range of l, clipped to a range of h.
    fn chains(&self, slab: SlabId, l: [f64; 2], h: [f64; 2]) -> Vec<Outline> {
        let order = &self.arrangement.slabs[slab].order;
        let mut heights = Heights { atlas: self, order, rows: Vec::new(), known: Vec::new() };
        let rows = l.map(|l| heights.row(l));
        let middle = heights.row(0.5 * (l[0] + l[1]));
        (0..order.len())
            .map(|position| {
                let ends = rows.map(|row| heights.point(row, position));
                let mut chain = vec![ends[0]];
                if l[0] < l[1] {
                    heights.refine(position, middle, ends, h, 0, &mut chain);
                }
                clipped(&chain, h)
            })
            .collect()
    }
}

/// Largest distance of a chord from its curve in h, as a share of the window.
const CHORD: f64 = 1e-3;
/// … and as a share of the gap to the next curve, so that thin regions are not lost.
const GAP_SHARE: f64 = 0.1;
/// A range of l is halved at most this often for thin regions,
const DEPTH: u32 = 8;
/// and this often for a curve that leaves its chord where the window shows it.
const DEEPEST: u32 = 32;

/// Energies of the curves of a slab at the ends, the middle, the quarters, … of a range of l, each computed when it is first
/// asked for.
struct Heights<'a> {
    atlas: &'a Atlas,
    /// The curves of the slab.
    order: &'a [CurveId],
    rows: Vec<HeightRow>,
    /// For each row an energy for each curve, NaN until it is computed.
    known: Vec<f64>,
}

/// Where the energies are.
struct HeightRow {
    l: f64,
    /// The rows in the middle of both halves of the range that this one halves.
    halves: Option<[usize; 2]>,
}

impl Heights<'_> {
    fn row(&mut self, l: f64) -> usize {
        self.known.resize(self.known.len() + self.order.len(), f64::NAN);
        self.rows.push(HeightRow { l, halves: None });
        self.rows.len() - 1
    }

    fn halves(&mut self, middle: usize, [low, high]: [f64; 2]) -> [usize; 2] {
        if let Some(halves) = self.rows[middle].halves {
            return halves;
        }
        let l = self.rows[middle].l;
        let halves = [0.5 * (low + l), 0.5 * (l + high)].map(|l| self.row(l));
        self.rows[middle].halves = Some(halves);
        halves
    }

    fn at(&mut self, row: usize, position: usize) -> f64 {
        let h = &mut self.known[row * self.order.len() + position];
        if h.is_nan() {
            *h = self.atlas.h_at(&self.atlas.arrangement.set.curves[self.order[position]], self.rows[row].l);
        }
        *h
    }

    fn point(&mut self, row: usize, position: usize) -> [f64; 2] {
        [self.at(row, position), self.rows[row].l]
    }

    /// The distance in h to the nearest other curve.
    fn gap(&mut self, row: usize, position: usize) -> f64 {
        let h = self.at(row, position);
        let beside = [position.checked_sub(1), (position + 1 < self.order.len()).then_some(position + 1)];
        beside.into_iter().flatten().fold(f64::INFINITY, |gap, other| gap.min((self.at(row, other) - h).abs()))
    }

    /// Adds the points of a curve after the first end up to and including the second; `middle` is the row between them.
    fn refine(
        &mut self,
        position: usize,
        middle: usize,
        ends: [[f64; 2]; 2],
        window: [f64; 2],
        depth: u32,
        chain: &mut Outline,
    ) {
        let [[from, low], [to, high]] = ends;
        let noise = 64.0 * UNIT_ROUNDOFF * from.abs().max(to.abs());
        let tolerance = (window[1] - window[0]).abs() * CHORD;
        // Curves rise with l.
        if depth >= DEPTH && (to <= window[0] || from >= window[1]) {
            chain.push(ends[1]);
            return;
        }
        let [before, after] = self.halves(middle, [low, high]);
        let straight = depth == DEEPEST
            || [(0.5, middle), (0.25, before), (0.75, after)].iter().all(|&(t, row)| {
                let off = (self.at(row, position) - (from + t * (to - from))).abs();
                off <= noise || (off <= tolerance && (depth >= DEPTH || off <= GAP_SHARE * self.gap(row, position)))
            });
        if straight {
            chain.push(ends[1]);
            return;
        }
        let point = self.point(middle, position);
        self.refine(position, before, [ends[0], point], window, depth + 1, chain);
        self.refine(position, after, [point, ends[1]], window, depth + 1, chain);
    }
}

/// A chain along which h rises, with what lies outside the range of h moved to its border.
fn clipped(chain: &[[f64; 2]], h: [f64; 2]) -> Outline {
    let mut clipped: Outline = Vec::with_capacity(chain.len() + 2);
    for (i, &[to, l_to]) in chain.iter().enumerate() {
        if let Some(&[from, l_from]) = i.checked_sub(1).and_then(|before| chain.get(before)) {
            for border in h.into_iter().filter(|border| from < *border && *border < to) {
                clipped.push([border, l_from + (l_to - l_from) * ((border - from) / (to - from))]);
            }
        }
        clipped.push([to.clamp(h[0], h[1]), l_to]);
    }
    clipped
}

impl Columns {
    /// The outlines around these cells, which are all cells of a region that the window shows.
    fn outlines(&self, cells: Vec<SlabCell>) -> Vec<Outline> {
        let mut open: std::collections::BTreeSet<Edge> = cells.into_iter().map(Edge::Lower).collect();
        let mut outlines = Vec::new();
        while let Some(start) = open.first().copied() {
            let mut outline = Vec::new();
            let mut edge = start;
            loop {
                open.remove(&edge);
                self.follow(edge, &mut outline);
                edge = self.next(edge);
                if edge == start {
                    break;
                }
            }
            outlines.extend(closed(outline));
        }
        outlines
    }

    fn follow(&self, edge: Edge, outline: &mut Outline) {
        match edge {
            Edge::Lower((slab, position)) => outline.extend(&self.chains[slab][position]),
            Edge::Upper((slab, position)) => {
                outline.extend(self.chains[slab].get(position + 1).unwrap_or(&self.top[slab]).iter().rev());
            }
        }
    }

    /// Where the outline continues at the end of an edge.
    fn next(&self, edge: Edge) -> Edge {
        let of = |side: &BTreeMap<SlabCell, Vec<SlabCell>>, cell| side.get(&cell).cloned().unwrap_or_default();
        match edge {
            Edge::Lower(cell) => {
                let Some(&right) = of(&self.right, cell).first() else { return Edge::Upper(cell) };
                let beside = of(&self.left, right);
                let at = beside.iter().position(|&c| c == cell).unwrap_or(0);
                if at == 0 { Edge::Lower(right) } else { Edge::Upper(beside[at - 1]) }
            }
            Edge::Upper(cell) => {
                let Some(&left) = of(&self.left, cell).last() else { return Edge::Lower(cell) };
                let beside = of(&self.right, left);
                let at = beside.iter().position(|&c| c == cell).unwrap_or(0);
                if at + 1 == beside.len() { Edge::Upper(left) } else { Edge::Lower(beside[at + 1]) }
            }
        }
    }
}

/// The polygon without repeated points, points in the middle of straight border lines, and closed; `None` if it has no
/// inside.
fn closed(points: Outline) -> Option<Outline> {
    let first = *points.first()?;
    let mut outline: Outline = Vec::with_capacity(points.len() + 1);
    for point in points.into_iter().chain([first]) {
        let on_border = |k: usize, p: [f64; 2], q: [f64; 2]| p[k] == q[k] && q[k] == point[k];
        if let [.., p, q] = outline[..]
            && (on_border(0, p, q) || on_border(1, p, q))
        {
            outline.pop();
        }
        if outline.last() != Some(&point) {
            outline.push(point);
        }
    }
    let extent = |k: usize| outline.iter().any(|point| point[k] != first[k]);
    (extent(0) && extent(1) && outline.len() > 3).then_some(outline)
}
