//! The outlines of regions: over every l in the view they hold the cells of their region and nothing else. Edges that run to
//! the right are lower borders of cells, those to the left upper ones, and those over one l hold nothing.

use schema::{AtlasDocument, RegionDocument, WindowDocument};

use super::Refused;
use super::chords::Chords;
use super::orders::Orders;
use super::plane::{POINT, Plane};

/// Edges leave their curves by at most this share of the height of the view.
const CHORD: f64 = 4e-3;

/// Checks the outlines of all regions in the default view.
pub(super) fn check(document: &AtlasDocument, orders: &Orders, plane: &Plane) -> Result<(), Refused> {
    if document.regions.iter().all(|region| region.polygon.is_none()) {
        return Ok(());
    }
    let view = &document.view.everything;
    let sight = Sight { plane, chords: Chords::new(plane, orders), view, off: CHORD * (view.h[1] - view.h[0]) };
    for region in &document.regions {
        let refuse = |why| Refused::Region { region: region.id.clone(), why };
        let outlines = region.polygon.as_ref().ok_or_else(|| refuse("it alone has no outline"))?;
        if !outlines.iter().all(|outline| is_closed(plane, outline))
            || !outlines.is_sorted_by(|p, q| begins_before(p, q))
        {
            return Err(refuse("its outlines are not closed, or not in their order"));
        }
        sight.holds(region, outlines).map_err(refuse)?;
    }
    Ok(())
}

/// It ends where it began, at its smallest l, and moves with each corner; each belongs to an edge that is not over one l, but
/// for rounding at the end.
fn is_closed(plane: &Plane, outline: &[[f64; 2]]) -> bool {
    let over_one_l = |corners: &[[f64; 2]]| corners[0][1] == corners[1][1] && corners[1][1] == corners[2][1];
    let is_at = |corner: &[f64; 2], at: &[f64; 2]| (corner[0] - at[0]).abs() <= POINT * (at[0].abs() + plane.norm);
    outline.len() > 3
        && outline.first() == outline.last()
        && outline[0][1] < outline[1][1]
        && outline.iter().all(|corner| outline[0][1] <= corner[1])
        && outline.windows(2).all(|pair| pair[0] != pair[1])
        && outline.windows(3).enumerate().all(|(number, corners)| {
            !over_one_l(corners) || (number + 3 == outline.len() && is_at(&corners[1], &outline[0]))
        })
}

fn begins_before(p: &[[f64; 2]], q: &[[f64; 2]]) -> bool {
    p[0][1] < q[0][1] || (p[0][1] == q[0][1] && p[0][0] <= q[0][0])
}

/// The view, and the curves in it.
struct Sight<'a> {
    plane: &'a Plane<'a>,
    chords: Chords<'a>,
    view: &'a WindowDocument,
    /// How far in h an edge may lie off its curve.
    off: f64,
}

/// An edge by rising l.
struct Edge {
    l: [f64; 2],
    h: [f64; 2],
    is_lower: bool,
    /// Up to this l it is known to be a border of cells.
    known_to: Option<f64>,
}

/// The lower or the upper border of a cell: a curve over a range of l, or nothing above the highest.
struct Border<'a> {
    curve: Option<&'a String>,
    l: [f64; 2],
    is_lower: bool,
}

impl Sight<'_> {
    /// Each edge is a part of the border of cells, and they make up all borders that the view shows.
    fn holds(&self, region: &RegionDocument, outlines: &[Vec<[f64; 2]>]) -> Result<(), &'static str> {
        let mut edges: Vec<Edge> =
            outlines.iter().flat_map(|outline| outline.windows(2)).filter_map(Edge::new).collect();
        edges.sort_by(|p, q| p.l[0].total_cmp(&q.l[0]));
        for cell in &region.cells {
            let to = cell.l_range[1].unwrap_or(f64::INFINITY).min(self.view.l[1]);
            let l = [cell.l_range[0].unwrap_or(0.0), to];
            let lower = Border { curve: Some(&cell.lower), l, is_lower: true };
            let upper = Border { curve: cell.upper.as_ref(), l, is_lower: false };
            self.is_followed([&lower, &upper], 0, &mut edges)?;
            self.is_followed([&lower, &upper], 1, &mut edges)?;
        }
        let is_known = |edge: &Edge| edge.known_to.is_some_and(|l| l == edge.l[1] || self.is_level(edge));
        if edges.iter().all(is_known) { Ok(()) } else { Err("its outline leaves its boundary") }
    }

    /// Edges follow one border of a cell from its first to its last l in the view.
    fn is_followed(&self, borders: [&Border; 2], which: usize, edges: &mut [Edge]) -> Result<(), &'static str> {
        const UNKNOWN: &str = "its boundary is not told by doubles";
        let border = borders[which];
        let [mut reached, to] = border.l;
        while reached < to {
            let fits = |edge: &Edge, from: f64| {
                let is_free = self.is_level(edge) || edge.known_to.is_none_or(|l| l <= from);
                edge.is_lower == border.is_lower && is_free && self.follows(border, edge)
            };
            // Where several borders begin at one point, each has the edge that ends next to it.
            let off = |edge: &Edge| {
                let at = edge.l[1].min(to);
                self.height(border, at).map_or(f64::INFINITY, |[on, _]| (on - edge.height(at)).abs())
            };
            let goes_on = |edge: &&mut Edge| edge.l[0] <= reached && reached < edge.l[1] && fits(edge, reached);
            let nearest = edges.iter_mut().filter(goes_on).min_by(|p, q| off(p).total_cmp(&off(q)));
            if let Some(edge) = nearest {
                reached = edge.l[1].min(to);
                edge.known_to = Some(reached);
                continue;
            }
            let below = |border: &Border, l: f64| Some(self.height(border, l)?[0] <= self.view.h[0] + self.off);
            if self.height(borders[0], reached).ok_or(UNKNOWN)?[0] >= self.view.h[1] - self.off {
                // The cell has left the view.
                return Ok(());
            }
            // It comes into view later.
            let next = edges.iter().find(|edge| edge.l[0] > reached && fits(edge, edge.l[0]));
            let next = next.map_or(to, |edge| edge.l[0].min(to));
            if !self.is_thin(borders, [reached, next]) && !below(borders[1], next).ok_or(UNKNOWN)? {
                return Err("its outline leaves out a part of its boundary");
            }
            reached = next;
        }
        Ok(())
    }

    /// Between two l a cell is too thin for doubles: at both, in the middle, and its borders are straight.
    fn is_thin(&self, [lower, upper]: [&Border; 2], l: [f64; 2]) -> bool {
        let is_closed = |l: f64| {
            let [Some([low, room]), Some([high, its])] = [lower, upper].map(|border| self.height(border, l)) else {
                return false;
            };
            high - low <= room + its
        };
        let is_straight = |border: &Border| {
            let curve = border.curve.and_then(|id| self.plane.curve(id, l[0]));
            curve.is_some_and(|curve| self.chords.hold(curve, l, [0.0; 2], self.off))
        };
        [l[0], 0.5 * (l[0] + l[1]), l[1]].into_iter().all(is_closed) && is_straight(lower) && is_straight(upper)
    }

    /// The height of a border over an l of it, and how far a double may be from it.
    fn height(&self, border: &Border, l: f64) -> Option<[f64; 2]> {
        border.curve.map_or(Some([f64::INFINITY, 0.0]), |id| self.plane.height(id, l.max(border.l[0]).min(border.l[1])))
    }

    /// An edge at the lowest or highest energy of the view.
    fn is_level(&self, edge: &Edge) -> bool {
        edge.h[0] == edge.h[1] && self.view.h.contains(&edge.h[0])
    }

    /// The part of an edge over a cell follows its border: a curve, or the border of the view beyond which the curve is. Curves
    /// rise with l.
    fn follows(&self, border: &Border, edge: &Edge) -> bool {
        let l = [edge.l[0].max(border.l[0]), edge.l[1].min(border.l[1])];
        if self.is_level(edge) {
            let at_top = edge.h[0] == self.view.h[1];
            let beyond = |[h, _]: [f64; 2]| {
                if at_top { h >= edge.h[0] - self.off } else { h <= edge.h[0] + self.off }
            };
            return self.height(border, l[usize::from(!at_top)]).is_some_and(beyond);
        }
        let off = |end: usize| {
            let [on, room] = self.height(border, l[end])?;
            let off = on - edge.height(l[end]);
            // Where a chord meets the border of the view, or goes on over another cell, it is off its curve.
            let is_on = l[end] == edge.l[end] && !self.view.h.contains(&edge.h[end]);
            (off.abs() <= if is_on { room } else { self.off }).then_some(off)
        };
        let (Some(id), Some(p), Some(q)) = (border.curve, off(0), off(1)) else { return false };
        l[0] < l[1] && self.plane.curve(id, l[0]).is_some_and(|curve| self.chords.hold(curve, l, [p, q], self.off))
    }
}

impl Edge {
    /// `None` over one l.
    fn new(pair: &[[f64; 2]]) -> Option<Self> {
        let [[h, l], [h_to, l_to]] = [pair[0], pair[1]];
        if l < l_to {
            Some(Self { l: [l, l_to], h: [h, h_to], is_lower: true, known_to: None })
        } else {
            (l_to < l).then_some(Self { l: [l_to, l], h: [h_to, h], is_lower: false, known_to: None })
        }
    }

    fn height(&self, l: f64) -> f64 {
        let share = (l - self.l[0]) / (self.l[1] - self.l[0]);
        if share >= 1.0 { self.h[1] } else { self.h[0] + (self.h[1] - self.h[0]) * share }
    }
}
