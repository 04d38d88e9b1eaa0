//! A cube around the sphere, cut into boxes.

use super::interval::Interval;

/// The level at which the cube starts.
const START: u8 = 3;
/// Coordinates on a face count as known to this: far more than what they are rounded by, far less than the side of a
/// box.
const ROUNDING: f64 = 1.0 / (1u32 << 30) as f64;

/// A box: a square of side 2/2^level on a face of [−1, 1]³, and the cone over it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Cell {
    face: u8,
    level: u8,
    i: u32,
    j: u32,
}

/// What is proved of a box.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Inside,
    Outside,
    Open,
}

impl Cell {
    /// Number of boxes along an edge.
    fn count(self) -> f64 {
        f64::from(1u32 << self.level)
    }

    /// The axis of the face, and the other two.
    pub fn axes(self) -> [usize; 3] {
        let first = usize::from(self.face / 2);
        [first, (first + 1) % 3, (first + 2) % 3]
    }

    /// The coordinate along the axis of the face.
    fn side(self) -> f64 {
        if self.face.is_multiple_of(2) { 1.0 } else { -1.0 }
    }

    /// Dyadic, so that nothing is rounded.
    fn ends(k: u32, count: f64) -> [f64; 2] {
        [k, k + 1].map(|k| f64::from(k) * (2.0 / count) - 1.0)
    }

    /// The coordinates along the other two axes.
    pub fn ranges(self) -> [Interval; 2] {
        [self.i, self.j].map(|k| {
            let [lo, hi] = Self::ends(k, self.count());
            Interval::between(lo, hi)
        })
    }

    /// The point of the face with these coordinates.
    pub fn vector(self, [u, w]: [Interval; 2]) -> [Interval; 3] {
        let [a, b, c] = self.axes();
        let mut v = [Interval::point(self.side()); 3];
        v[a] = Interval::point(self.side());
        v[b] = u;
        v[c] = w;
        v
    }

    pub fn halves(self) -> [Self; 4] {
        let (i, j, level) = (2 * self.i, 2 * self.j, self.level + 1);
        [(i, j), (i + 1, j), (i, j + 1), (i + 1, j + 1)].map(|(i, j)| Self { level, i, j, ..self })
    }

    /// The direction through a point of the plane of the face.
    fn direction(self, [p, q]: [f64; 2]) -> [f64; 3] {
        let [a, b, c] = self.axes();
        let mut v = [0.0; 3];
        v[a] = self.side();
        v[b] = p;
        v[c] = q;
        v
    }

    /// Directions just beyond the middles of the four edges.
    fn beyond(self) -> [[f64; 3]; 4] {
        let [[u0, u1], [w0, w1]] = [self.i, self.j].map(|k| Self::ends(k, self.count()));
        let step = (u1 - u0) / 256.0;
        let (u, w) = (0.5 * (u0 + u1), 0.5 * (w0 + w1));
        [[u0 - step, w], [u1 + step, w], [u, w0 - step], [u, w1 + step]].map(|point| self.direction(point))
    }
}

/// A box, cut in four or not.
#[derive(Clone, Copy)]
enum Node {
    Leaf(Cell, Kind),
    /// The number of the first part; the others follow in the order of [`Cell::halves`].
    Cut(usize),
}

/// The boxes of a subdivided cube, by number.
pub(super) struct Leaves {
    nodes: Vec<Node>,
    deepest: u8,
}

impl Leaves {
    /// The cube at its first level.
    pub fn new(kind: impl Fn(Cell) -> Kind) -> Self {
        let count = 1 << START;
        let mut nodes = Vec::new();
        for face in 0..6 {
            for i in 0..count {
                for j in 0..count {
                    let cell = Cell { face, level: START, i, j };
                    nodes.push(Node::Leaf(cell, kind(cell)));
                }
            }
        }
        Self { nodes, deepest: START }
    }

    /// Numbers run below this.
    pub fn count(&self) -> usize {
        self.nodes.len()
    }

    pub fn deepest(&self) -> u8 {
        self.deepest
    }

    /// What is proved of a leaf.
    pub fn kind(&self, number: usize) -> Option<Kind> {
        match self.nodes[number] {
            Node::Leaf(_, kind) => Some(kind),
            Node::Cut(_) => None,
        }
    }

    /// The leaves of a kind.
    pub fn of_kind(&self, kind: Kind) -> impl Iterator<Item = usize> {
        (0..self.nodes.len()).filter(move |&number| self.kind(number) == Some(kind))
    }

    /// Cuts the open leaves in four.
    pub fn refine(&mut self, kind: impl Fn(Cell) -> Kind) {
        for number in 0..self.nodes.len() {
            if let Node::Leaf(cell, Kind::Open) = self.nodes[number] {
                self.nodes[number] = Node::Cut(self.nodes.len());
                self.nodes.extend(cell.halves().map(|part| Node::Leaf(part, kind(part))));
            }
        }
        self.deepest += 1;
    }

    /// Pairs of leaves that share a part of an edge: of two sizes the smaller finds the larger.
    pub fn neighbours(&self) -> impl Iterator<Item = [usize; 2]> {
        let leaves = self.nodes.iter().enumerate().filter_map(|(number, node)| match node {
            Node::Leaf(cell, _) => Some((number, *cell)),
            Node::Cut(_) => None,
        });
        leaves.flat_map(|(number, cell)| cell.beyond().map(|v| [number, self.at(v)]))
    }

    /// The leaf in this direction.
    pub fn at(&self, v: [f64; 3]) -> usize {
        let ([first, second, third], scale) = face_axes(&v);
        let coordinates = [second, third].map(|k| (v[k] / scale).clamp(-1.0, 1.0));
        let side = usize::from(v[first] < 0.0);
        let mut level = START;
        let [i, j] = coordinates.map(|t| index(t, level));
        let mut number = ((2 * first + side) << (2 * START)) + (i << START) + j;
        while let Node::Cut(parts) = self.nodes[number] {
            level += 1;
            let [i, j] = coordinates.map(|t| index(t, level));
            // The order of Cell::halves.
            number = parts + i % 2 + 2 * (j % 2);
        }
        number
    }

    /// Leaves that hold every direction within rounding of this one: those at the corners of a square around it on its
    /// face. The square is smaller than any leaf, so that a leaf which it meets holds one of its corners.
    pub fn around(&self, v: [f64; 3]) -> [usize; 4] {
        let ([first, second, third], scale) = face_axes(&v);
        let [p, q] = [v[second] / scale, v[third] / scale];
        [(-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0)].map(|(s, t)| {
            let mut corner = [0.0; 3];
            corner[first] = v[first].signum();
            corner[second] = p + s * ROUNDING;
            corner[third] = q + t * ROUNDING;
            self.at(corner)
        })
    }
}

/// The axis of the face in this direction and the other two, and the coordinate along the first.
fn face_axes(v: &[f64; 3]) -> ([usize; 3], f64) {
    let mut first = 0;
    for k in 1..3 {
        if v[k].abs() >= v[first].abs() {
            first = k;
        }
    }
    ([first, (first + 1) % 3, (first + 2) % 3], v[first].abs())
}

/// Number of the box of a level that holds a coordinate.
fn index(t: f64, level: u8) -> usize {
    let count = f64::from(1u32 << level);
    // Between 0 and 2^level − 1.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    let k = (0.5 * (t + 1.0) * count).clamp(0.0, count - 1.0) as usize;
    k
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn centre(cell: Cell) -> [f64; 3] {
        let v = cell.vector(cell.ranges()).map(Interval::middle);
        let n = v.iter().map(|c| c * c).sum::<f64>().sqrt();
        v.map(|c| c / n)
    }

    fn cell(leaves: &Leaves, number: usize) -> Cell {
        match leaves.nodes[number] {
            Node::Leaf(cell, _) => cell,
            Node::Cut(_) => panic!("{number} is no leaf"),
        }
    }

    /// Cut unevenly: more often near one corner of the cube.
    fn uneven() -> Leaves {
        let near = |cell: Cell| {
            let v = centre(cell);
            if v[0] + v[1] + v[2] > 1.6 || v[2] < -0.99 { Kind::Open } else { Kind::Inside }
        };
        let mut leaves = Leaves::new(near);
        for _ in 0..4 {
            leaves.refine(near);
        }
        leaves
    }

    #[test]
    fn boxes_lie_beside_their_neighbours() {
        for leaves in [Leaves::new(|_| Kind::Open), uneven()] {
            for [p, q] in leaves.neighbours() {
                let (p, q) = (cell(&leaves, p), cell(&leaves, q));
                let (v, w) = (centre(p), centre(q));
                let distance = (0..3).map(|k| (v[k] - w[k]) * (v[k] - w[k])).sum::<f64>().sqrt();
                let sizes = 1.0 / p.count() + 1.0 / q.count();
                assert!(distance > 0.4 * sizes && distance < 1.6 * sizes, "{p:?} {q:?} {distance}");
            }
        }
    }

    #[test]
    fn a_leaf_is_found_in_every_direction_through_it() {
        let leaves = uneven();
        for number in (0..leaves.count()).filter(|&number| leaves.kind(number).is_some()) {
            let v = centre(cell(&leaves, number));
            assert_eq!(leaves.at(v), number);
            assert_eq!(leaves.around(v), [number; 4]);
        }
    }

    proptest! {
        #[test]
        fn the_leaves_around_a_direction_hold_all_that_is_near(
            v in [-1.0..1.0f64, -1.0..1.0, -1.0..1.0], on_edge in 0..4u8, shift in [-1.0..1.0f64, -1.0..1.0, -1.0..1.0],
        ) {
            // Many directions on the edges of boxes and of the cube.
            let steps = [0.0, 4.0, 64.0, 1.0][usize::from(on_edge)];
            let v = if steps > 0.0 { v.map(|c| (c * steps).round() / steps) } else { v };
            prop_assume!(v.iter().any(|c| *c != 0.0));
            let leaves = uneven();
            let near = [0, 1, 2].map(|k| v[k] + 1e-14 * shift[k]);
            prop_assert!(leaves.around(v).contains(&leaves.at(near)), "{v:?} {near:?}");
        }
    }
}
