//! A cube around the sphere, cut into boxes.

use std::collections::BTreeMap;

use super::interval::Interval;

/// The level at which the cube starts.
pub(super) const START: u8 = 3;

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
    /// The boxes of the cube at its first level.
    pub fn first() -> impl Iterator<Item = Self> {
        let count = 1 << START;
        (0..6).flat_map(move |face| {
            (0..count).flat_map(move |i| (0..count).map(move |j| Self { face, level: START, i, j }))
        })
    }

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

    /// Directions just beyond the middles of the four edges.
    fn beyond(self) -> [[f64; 3]; 4] {
        let [[u0, u1], [w0, w1]] = [self.i, self.j].map(|k| Self::ends(k, self.count()));
        let step = (u1 - u0) / 256.0;
        let (u, w) = (0.5 * (u0 + u1), 0.5 * (w0 + w1));
        let [a, b, c] = self.axes();
        [(u0 - step, w), (u1 + step, w), (u, w0 - step), (u, w1 + step)].map(|(p, q)| {
            let mut v = [0.0; 3];
            v[a] = self.side();
            v[b] = p;
            v[c] = q;
            v
        })
    }
}

/// The boxes of a subdivided cube.
pub(super) struct Leaves {
    kinds: BTreeMap<Cell, Kind>,
    deepest: u8,
}

impl Leaves {
    /// The cube at its first level.
    pub fn new(kind: impl Fn(Cell) -> Kind) -> Self {
        Self { kinds: Cell::first().map(|cell| (cell, kind(cell))).collect(), deepest: START }
    }

    pub fn deepest(&self) -> u8 {
        self.deepest
    }

    pub fn open(&self) -> Vec<Cell> {
        self.kinds.iter().filter(|(_, kind)| **kind == Kind::Open).map(|(cell, _)| *cell).collect()
    }

    /// Cuts the open boxes in four.
    pub fn refine(&mut self, open: &[Cell], kind: impl Fn(Cell) -> Kind) {
        self.deepest += 1;
        for cell in open {
            self.kinds.remove(cell);
            self.kinds.extend(cell.halves().map(|part| (part, kind(part))));
        }
    }

    /// All boxes in order, so that they have numbers.
    pub fn numbered(&self) -> Numbered<'_> {
        Numbered { leaves: self, cells: self.kinds.iter().map(|(cell, kind)| (*cell, *kind)).collect() }
    }

    /// The leaf in this direction.
    fn at(&self, v: [f64; 3]) -> Option<Cell> {
        let first = (0..3).max_by(|&p, &q| v[p].abs().total_cmp(&v[q].abs()))?;
        let face = u8::try_from(2 * first).ok()? + u8::from(v[first] < 0.0);
        let scale = v[first].abs();
        let axes = [(first + 1) % 3, (first + 2) % 3].map(|k| (v[k] / scale).clamp(-1.0, 1.0));
        (START..=self.deepest).find_map(|level| {
            let count = f64::from(1u32 << level);
            let index = |t: f64| {
                let k = (0.5 * (t + 1.0) * count).floor().clamp(0.0, count - 1.0);
                // Between 0 and 2¹⁴.
                #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
                let k = k as u32;
                k
            };
            let cell = Cell { face, level, i: index(axes[0]), j: index(axes[1]) };
            self.kinds.contains_key(&cell).then_some(cell)
        })
    }
}

/// The leaves by number.
pub(super) struct Numbered<'a> {
    leaves: &'a Leaves,
    pub cells: Vec<(Cell, Kind)>,
}

impl Numbered<'_> {
    /// The number of the leaf in this direction.
    pub fn at(&self, v: [f64; 3]) -> Option<usize> {
        let cell = self.leaves.at(v)?;
        self.cells.binary_search_by(|probe| probe.0.cmp(&cell)).ok()
    }

    /// Pairs of leaves that share a part of an edge, some of them twice; of two sizes the smaller finds the larger.
    pub fn neighbours(&self) -> Option<Vec<[usize; 2]>> {
        let mut pairs = Vec::with_capacity(4 * self.cells.len());
        for (p, (cell, _)) in self.cells.iter().enumerate() {
            for v in cell.beyond() {
                pairs.push([p, self.at(v)?]);
            }
        }
        Some(pairs)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn boxes_lie_beside_their_neighbours() {
        let leaves = Leaves::new(|_| Kind::Open);
        let centre = |cell: Cell| {
            let v = cell.vector(cell.ranges()).map(Interval::middle);
            let n = v.iter().map(|c| c * c).sum::<f64>().sqrt();
            v.map(|c| c / n)
        };
        let numbered = leaves.numbered();
        assert_eq!(numbered.cells.len(), 6 * 64);
        for [p, q] in numbered.neighbours().unwrap() {
            let (p, q) = (centre(numbered.cells[p].0), centre(numbered.cells[q].0));
            let distance = (0..3).map(|k| (p[k] - q[k]) * (p[k] - q[k])).sum::<f64>().sqrt();
            assert!(distance > 1e-3 && distance < 0.3, "{p:?} {q:?} {distance}");
        }
    }

    #[test]
    fn parts_of_a_box_take_its_place() {
        let mut leaves = Leaves::new(|_| Kind::Open);
        let first = leaves.open()[0];
        leaves.refine(&[first], |_| Kind::Inside);
        assert_eq!(leaves.open().len(), 6 * 64 - 1);
        for part in first.halves() {
            let v = part.vector(part.ranges()).map(Interval::middle);
            assert_eq!(leaves.at(v), Some(part));
        }
    }
}
