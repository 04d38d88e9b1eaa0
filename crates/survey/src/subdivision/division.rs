//! What is known while a rectangle is divided.

use std::collections::{BTreeMap, BTreeSet};

use super::lattice::{BoundaryStop, CellSide, LabelChange, LatticeCell, LatticeNode, PlanePoint, UNIT, mean};

/// Where what is shown changes on a way: at which share of it, and what is shown before and after.
pub type Changes<L> = Vec<(f64, [L; 2])>;

/// What the points of a plane show.
pub trait LabelledPlane {
    /// What is shown at a point.
    type Label: Clone + PartialEq;

    /// What is shown at these points.
    fn labels(&self, places: &[PlanePoint]) -> Vec<Self::Label>;

    /// Where what is shown changes on these ways from one point to another, in order.
    fn changes(&self, ways: &[[PlanePoint; 2]]) -> Vec<Changes<Self::Label>>;
}

/// What is known while a rectangle is divided.
pub(super) struct Division<'a, P: LabelledPlane> {
    pub plane: &'a P,
    pub axes: [&'a [f64]; 2],
    pub labels: BTreeMap<LatticeNode, P::Label>,
    /// The changes on each side; where both halves of a side are known, theirs count.
    pub sides: BTreeMap<CellSide, Vec<LabelChange<P::Label>>>,
    /// How the changes of a cell are joined, where that can be in several ways.
    pub joined: BTreeMap<(LatticeNode, u32), Vec<usize>>,
    /// What was classified besides the nodes.
    pub seen: Vec<(P::Label, PlanePoint)>,
    /// Where the border of a cell with one chord has a corner.
    pub bends: BTreeMap<LatticeNode, PlanePoint>,
}

impl<P: LabelledPlane> Division<'_, P> {
    /// A point of the lattice in the plane.
    pub(super) fn place(&self, at: PlanePoint) -> PlanePoint {
        let coordinate = |axis: usize| {
            let values = self.axes[axis];
            let position = at[axis] / f64::from(UNIT);
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 0 and their number")]
            let left = (position.floor() as usize).min(values.len() - 2);
            let share = position - left as f64;
            if share == 0.0 { values[left] } else { values[left] + (values[left + 1] - values[left]) * share }
        };
        [coordinate(0), coordinate(1)]
    }

    /// Looks at nodes and sides that are not known.
    pub(super) fn learn_nodes(&mut self, nodes: BTreeSet<LatticeNode>) {
        let new: Vec<LatticeNode> = nodes.into_iter().filter(|node| !self.labels.contains_key(node)).collect();
        let places: Vec<PlanePoint> = new.iter().map(|node| self.place(node.map(f64::from))).collect();
        self.labels.extend(new.into_iter().zip(self.plane.labels(&places)));
    }

    pub(super) fn learn_sides(&mut self, sides: BTreeSet<CellSide>) {
        let new: Vec<CellSide> = sides.into_iter().filter(|side| !self.sides.contains_key(side)).collect();
        let (plain, crossed): (Vec<CellSide>, Vec<CellSide>) =
            new.into_iter().partition(|side| self.labels[&side.from] == self.labels[&side.end()]);
        let ways: Vec<[PlanePoint; 2]> =
            crossed.iter().map(|side| [side.from, side.end()].map(|node| self.place(node.map(f64::from)))).collect();
        let found = self.plane.changes(&ways);
        for (side, found) in crossed.into_iter().zip(found) {
            let change = |(share, labels)| {
                let mut at = side.from.map(f64::from);
                at[side.along] += share * f64::from(side.size);
                LabelChange { at, labels }
            };
            self.sides.insert(side, found.into_iter().map(change).collect());
        }
        self.sides.extend(plain.into_iter().map(|side| (side, Vec::new())));
    }

    /// The changes on a side, from its lower end.
    pub(super) fn changes(&self, side: CellSide) -> Vec<LabelChange<P::Label>> {
        let halves = side.halves();
        if side.size > 1 && halves.iter().all(|half| self.sides.contains_key(half)) {
            return halves.into_iter().flat_map(|half| self.changes(half)).collect();
        }
        self.sides.get(&side).cloned().unwrap_or_default()
    }

    /// Looks at what lies only between two changes on a side, so that a place is known that shows it.
    pub(super) fn look_between(&mut self) {
        let mut known: Vec<&P::Label> = Vec::new();
        for label in self.labels.values().chain(self.seen.iter().map(|(label, _)| label)) {
            if !known.contains(&label) {
                known.push(label);
            }
        }
        let between = self.sides.values().flat_map(|changes| changes.windows(2));
        let unseen = between.filter(|pair| !known.contains(&&pair[0].labels[1]));
        let places: Vec<PlanePoint> =
            unseen.map(|pair| self.place(mean(pair.iter().map(|change| change.at)))).collect();
        self.seen.extend(self.plane.labels(&places).into_iter().zip(places));
    }

    /// True when a cell must be quartered.
    pub(super) fn is_open(&self, cell: LatticeCell) -> bool {
        let counts = cell.sides().map(|side| self.changes(side).len());
        let total: usize = counts.iter().sum();
        let corners = || [[0, 0], [1, 0], [0, 1], [1, 1]].into_iter().map(|[right, up]| cell.node(right, up));
        cell.size > 1
            && (total > 2 || counts.contains(&2) || total > 0 && corners().any(|node| self.is_thin(node, cell.size)))
    }

    /// Whether what is shown at a node is narrower there than cells of this size.
    fn is_thin(&self, node: LatticeNode, size: u32) -> bool {
        (0..2).any(|along| {
            let mut from = node;
            let Some(low) = node[along].checked_sub(size) else { return false };
            from[along] = low;
            let [before, after] = [from, node].map(|from| self.changes(CellSide { from, along, size }));
            let ([.., first], [second, ..]) = (&before[..], &after[..]) else { return false };
            first.labels[0] == second.labels[1] && second.at[along] - first.at[along] < f64::from(size)
        })
    }

    /// Learns what the quarters of cells need.
    pub(super) fn split(&mut self, cells: &[LatticeCell]) {
        let quarters = || cells.iter().flat_map(|cell| cell.quarters());
        self.learn_nodes(
            quarters().flat_map(|cell| [[0, 0], [1, 0], [0, 1], [1, 1]].map(|[x, y]| cell.node(x, y))).collect(),
        );
        // What is known of a side holds for its halves, unless the middle contradicts it.
        for side in cells.iter().flat_map(|cell| cell.sides()) {
            let [low, high] = side.halves();
            if self.sides.contains_key(&low) && self.sides.contains_key(&high) {
                continue;
            }
            let middle = f64::from(high.from[side.along]);
            let (before, after): (Vec<_>, Vec<_>) =
                self.changes(side).into_iter().partition(|change| change.at[side.along] < middle);
            let there = before.last().map_or(&self.labels[&side.from], |change| &change.labels[1]);
            if *there == self.labels[&high.from] {
                self.sides.insert(low, before);
                self.sides.insert(high, after);
            }
        }
        self.learn_sides(quarters().flat_map(LatticeCell::sides).collect());
    }

    /// Corners and changes on the way round a cell, counterclockwise.
    pub(super) fn round(&self, cell: LatticeCell) -> Vec<BoundaryStop<P::Label>> {
        let mut round = Vec::new();
        for (number, side) in cell.sides().into_iter().enumerate() {
            let backwards = number > 1;
            let corner = if backwards { side.end() } else { side.from };
            round.push(BoundaryStop { at: corner.map(f64::from), side: number, after: None });
            let mut changes = self.changes(side);
            if backwards {
                changes.reverse();
            }
            let after = |labels: [P::Label; 2]| {
                let [before, after] = labels;
                if backwards { before } else { after }
            };
            round.extend(changes.into_iter().map(|change| BoundaryStop {
                at: change.at,
                side: number,
                after: Some(after(change.labels)),
            }));
        }
        round
    }
}
