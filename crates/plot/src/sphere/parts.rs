//! Which nodes of the two views belong to which component of U.

use super::grid::{Grid, Node, RINGS, SPOKES};
use super::view::Vector;

/// A node of one of the views.
type ViewNode = (usize, Node);

/// For each accessible node of each view, the component to which it belongs.
pub(super) struct Parts {
    of: [Vec<Option<usize>>; 2],
    /// The deepest node of each component that is seen, as a place for its number.
    pub deepest: Vec<(usize, ViewNode)>,
}

impl Parts {
    /// Connects neighbouring accessible nodes, across the common rim too, and asks once for each part to which component
    /// it belongs. A part too small to hold a node is not seen.
    pub fn new(grids: &[Grid<'_>; 2], component_of: &dyn Fn(Vector) -> Option<usize>) -> Self {
        let nodes = (RINGS + 1) * SPOKES;
        let mut parts = Self { of: [vec![None; nodes], vec![None; nodes]], deepest: Vec::new() };
        let mut seen = [vec![false; nodes], vec![false; nodes]];
        for view in 0..2 {
            for node in (0..=RINGS).flat_map(|ring| (0..SPOKES).map(move |spoke| [ring, spoke])) {
                if seen[view][index(node)] || grids[view].value(node) > 0.0 {
                    continue;
                }
                let members = flood(grids, &mut seen, (view, node));
                let value = |&(view, node): &ViewNode| grids[view].value(node);
                let Some(deepest) = members.iter().copied().min_by(|a, b| value(a).total_cmp(&value(b))) else {
                    continue;
                };
                let Some(component) = component_of(grids[deepest.0].gamma(deepest.1)) else { continue };
                for (view, node) in members {
                    parts.of[view][index(node)] = Some(component);
                }
                parts.deepest.push((component, deepest));
            }
        }
        parts
    }

    /// The component of a node.
    pub fn component(&self, view: usize, node: Node) -> Option<usize> {
        self.of[view][index(node)]
    }
}

fn index([ring, spoke]: Node) -> usize {
    ring * SPOKES + spoke % SPOKES
}

/// The accessible nodes connected with one of them.
fn flood(grids: &[Grid<'_>; 2], seen: &mut [Vec<bool>; 2], start: ViewNode) -> Vec<ViewNode> {
    let mut members = Vec::new();
    let mut open = vec![start];
    seen[start.0][index(start.1)] = true;
    while let Some(place) = open.pop() {
        members.push(place);
        for (view, node) in neighbours(place) {
            if !seen[view][index(node)] && grids[view].value(node) <= 0.0 {
                seen[view][index(node)] = true;
                open.push((view, node));
            }
        }
    }
    members
}

/// The nodes beside a node; the middle has all of its ring beside it, the rim its double in the other view.
fn neighbours((view, [ring, spoke]): ViewNode) -> Vec<ViewNode> {
    let mut beside = vec![(view, [ring, (spoke + 1) % SPOKES]), (view, [ring, (spoke + SPOKES - 1) % SPOKES])];
    if ring > 0 {
        beside.push((view, [ring - 1, spoke]));
    }
    if ring < RINGS {
        beside.push((view, [ring + 1, spoke]));
    } else {
        beside.push((1 - view, [ring, (SPOKES / 2 + SPOKES - spoke) % SPOKES]));
    }
    beside
}
