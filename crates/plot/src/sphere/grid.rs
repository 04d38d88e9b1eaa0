//! A function on one view, at the nodes of a grid in polar angles, with its level lines and areas.

use std::collections::BTreeMap;
use std::f64::consts::{FRAC_PI_2, TAU};

use super::view::{SphereView, Vector};
use bifdiag_page::{Path, Point};

/// Steps from the middle to the rim, and round it. The second is even, so that the rims of both views share their nodes.
pub(super) const RINGS: usize = 90;
pub(super) const SPOKES: usize = 360;

/// A node: its ring (0 is the middle, `RINGS` the rim) and its spoke.
pub(super) type Node = [usize; 2];

/// Values at the nodes of a view.
pub(super) struct Grid<'a> {
    view: &'a SphereView,
    values: Vec<f64>,
}

impl<'a> Grid<'a> {
    pub fn new(view: &'a SphereView, function: &dyn Fn(Vector) -> f64) -> Self {
        let nodes = (0..=RINGS).flat_map(|ring| (0..SPOKES).map(move |spoke| [ring, spoke]));
        let values = nodes.map(|node| function(Self::gamma_on(view, node))).collect();
        Self { view, values }
    }

    fn gamma_on(view: &SphereView, node: Node) -> Vector {
        let [t, phi] = angles(node);
        view.gamma(t, phi)
    }

    /// The point of the sphere at a node.
    pub fn gamma(&self, node: Node) -> Vector {
        Self::gamma_on(self.view, node)
    }

    /// Where a node lies on the page.
    pub fn place(&self, node: Node) -> Point {
        let [t, phi] = angles(node);
        self.view.place(t, phi)
    }

    pub fn value(&self, [ring, spoke]: Node) -> f64 {
        self.values[ring * SPOKES + spoke % SPOKES]
    }

    /// All values.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// The areas where the value is at most `level` and `chosen` holds for a corner of the cell that is, as one path.
    /// Whole cells along a spoke are one polygon, since its sides are straight.
    pub fn area(&self, level: f64, chosen: impl Fn(Node) -> bool) -> Path {
        let mut path = Path::default();
        for spoke in 0..SPOKES {
            let mut whole: Option<[Node; 4]> = None;
            for cell in (0..RINGS).map(|ring| cell([ring, spoke])) {
                let below = cell.map(|node| self.value(node) <= level);
                if below == [true; 4] && chosen(cell[0]) {
                    let [_, outer, far, _] = cell;
                    whole = Some(whole.map_or(cell, |[first, .., last]| [first, outer, far, last]));
                    continue;
                }
                self.flush(&mut path, whole.take());
                if (0..4).any(|k| below[k] && chosen(cell[k])) {
                    path.line(&self.clipped(cell, level), true);
                }
            }
            self.flush(&mut path, whole);
        }
        path
    }

    fn flush(&self, path: &mut Path, whole: Option<[Node; 4]>) {
        if let Some(corners) = whole {
            path.line(&corners.map(|node| self.place(node)), true);
        }
    }

    /// The part of a cell where the value is at most `level`.
    fn clipped(&self, cell: [Node; 4], level: f64) -> Vec<Point> {
        let mut polygon = Vec::with_capacity(6);
        for k in 0..4 {
            let (a, b) = (cell[k], cell[(k + 1) % 4]);
            if self.value(a) <= level {
                polygon.push(self.place(a));
            }
            if (self.value(a) <= level) != (self.value(b) <= level) {
                polygon.push(self.between(a, b, level));
            }
        }
        polygon
    }

    /// Where the value is `level` between two nodes, by linear interpolation of the angles.
    fn between(&self, a: Node, b: Node, level: f64) -> Point {
        let share = (level - self.value(a)) / (self.value(b) - self.value(a));
        let ([t, phi], [to_t, to_phi]) = (angles(a), angles(b));
        self.view.place(t + share * (to_t - t), phi + share * (to_phi - phi))
    }

    /// The lines where the value is `level`.
    pub fn level_lines(&self, level: f64) -> Vec<Vec<Point>> {
        let mut links: BTreeMap<Edge, Vec<Edge>> = BTreeMap::new();
        for cell in cells() {
            let crossed: Vec<Edge> = (0..4)
                .map(|k| [cell[k], cell[(k + 1) % 4]])
                .filter(|[a, b]| (self.value(*a) <= level) != (self.value(*b) <= level))
                .map(ordered)
                .collect();
            for pair in crossed.chunks_exact(2) {
                links.entry(pair[0]).or_default().push(pair[1]);
                links.entry(pair[1]).or_default().push(pair[0]);
            }
        }
        let mut lines = Vec::new();
        // Open lines begin where only one link is; what is left are closed ones.
        let ends: Vec<Edge> = links.iter().filter(|(_, to)| to.len() == 1).map(|(edge, _)| *edge).collect();
        for start in ends {
            lines.extend(follow(&mut links, start));
        }
        while let Some(start) = links.keys().next().copied() {
            lines.extend(follow(&mut links, start));
        }
        lines.iter().map(|line| line.iter().map(|&[a, b]| self.between(a, b, level)).collect()).collect()
    }
}

/// A side of a cell, by its ends.
type Edge = [Node; 2];

/// The same for both cells of a side.
fn ordered([a, b]: Edge) -> Edge {
    // The seam keeps its direction: its second spoke is SPOKES, which is the first one again.
    let same = |node: Node| [node[0], node[1] % SPOKES];
    let seam = [a, b].iter().any(|node| node[1] == SPOKES) && a[0] == b[0];
    let [a, b] = if seam { [a, b] } else { [same(a), same(b)] };
    if a <= b { [a, b] } else { [b, a] }
}

/// Takes the line through `start` out of the links, if it is still there.
fn follow(links: &mut BTreeMap<Edge, Vec<Edge>>, start: Edge) -> Option<Vec<Edge>> {
    let mut line = vec![start];
    let mut at = start;
    loop {
        let next = links.get_mut(&at).and_then(Vec::pop);
        if links.get(&at).is_some_and(Vec::is_empty) {
            links.remove(&at);
        }
        let Some(next) = next else { break };
        if let Some(back) = links.get_mut(&next) {
            if let Some(place) = back.iter().position(|edge| *edge == at) {
                back.swap_remove(place);
            }
            if back.is_empty() {
                links.remove(&next);
            }
        }
        line.push(next);
        at = next;
    }
    (line.len() > 1).then_some(line)
}

/// The angle from the middle of the view, and the direction on the page.
fn angles([ring, spoke]: Node) -> [f64; 2] {
    [FRAC_PI_2 * ring as f64 / RINGS as f64, TAU * spoke as f64 / SPOKES as f64]
}

/// The corners of every cell, in order round it; those at the middle coincide. The second spoke of the last cells is
/// `SPOKES`, so that angles may be interpolated.
fn cells() -> impl Iterator<Item = [Node; 4]> {
    (0..RINGS).flat_map(|ring| (0..SPOKES).map(move |spoke| cell([ring, spoke])))
}

/// The corners of the cell outside of a node.
fn cell([ring, spoke]: Node) -> [Node; 4] {
    [[ring, spoke], [ring + 1, spoke], [ring + 1, spoke + 1], [ring, spoke + 1]]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn front() -> SphereView {
        let [front, _] = SphereView::pair([0.0, 0.0, 1.0], Some([0.0, -1.0, 0.0]), [[0.0, 0.0], [0.0, 0.0]], 100.0);
        front
    }

    #[test]
    fn a_cap_has_one_closed_line_round_it() {
        let view = front();
        let center = [0.48, 0.36, 0.8];
        let grid = Grid::new(&view, &|g: Vector| -(g[0] * center[0] + g[1] * center[1] + g[2] * center[2]));
        let lines = grid.level_lines(-0.9);
        assert_eq!(lines.len(), 1);
        assert_eq!(lines[0].first(), lines[0].last());
    }

    #[test]
    fn a_great_circle_across_the_seam_is_one_open_line() {
        let view = front();
        let grid = Grid::new(&view, &|g: Vector| g[0] - 0.3001 * g[2]);
        let lines = grid.level_lines(0.0);
        assert_eq!(lines.len(), 1);
        let ends = [lines[0][0], lines[0][lines[0].len() - 1]];
        assert!(ends.iter().all(|[x, y]| ((x * x + y * y).sqrt() - 100.0).abs() < 1e-9), "{ends:?}");
    }
}
