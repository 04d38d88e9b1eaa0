//! Cells of a lattice, their sides, and changes on them.

/// A point of the plane.
pub type PlanePoint = [f64; 2];

/// How often a cell is halved.
pub(super) const DEPTH: u32 = 3;
/// Steps of the finest lattice in a cell of the grid.
pub(super) const UNIT: u32 = 1 << DEPTH;

/// A point of the finest lattice.
pub(super) type LatticeNode = [u32; 2];

/// A side of a cell, to the right (`along` 0) or upwards (1).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct CellSide {
    pub from: LatticeNode,
    pub along: usize,
    pub size: u32,
}

impl CellSide {
    pub(super) fn end(self) -> LatticeNode {
        let mut end = self.from;
        end[self.along] += self.size;
        end
    }

    pub(super) fn halves(self) -> [Self; 2] {
        let half = Self { size: self.size / 2, ..self };
        [half, Self { from: half.end(), ..half }]
    }
}

/// A change on a side: where on the lattice, and what is shown on both sides of it.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct LabelChange<L> {
    pub at: PlanePoint,
    pub labels: [L; 2],
}

/// A corner of a cell, or a change on the way round it with what is shown after it.
pub(super) struct BoundaryStop<L> {
    pub at: PlanePoint,
    /// The number of the side that begins here or on which the change lies.
    pub side: usize,
    pub after: Option<L>,
}

/// A square of the lattice.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct LatticeCell {
    pub from: LatticeNode,
    pub size: u32,
}

impl LatticeCell {
    pub(super) fn node(self, right: u32, up: u32) -> LatticeNode {
        [self.from[0] + right * self.size, self.from[1] + up * self.size]
    }

    /// Below, right, above, left; the last two are walked backwards on the way round.
    pub(super) fn sides(self) -> [CellSide; 4] {
        let size = self.size;
        let side = |from, along| CellSide { from, along, size };
        [side(self.node(0, 0), 0), side(self.node(1, 0), 1), side(self.node(0, 1), 0), side(self.node(0, 0), 1)]
    }

    /// The cell of the same size beyond a side; none beyond the lower ends of the lattice.
    pub(super) fn beyond(self, side: usize) -> Option<Self> {
        let [x, y] = self.from;
        let from = match side {
            0 => [Some(x), y.checked_sub(self.size)],
            1 => [Some(x + self.size), Some(y)],
            2 => [Some(x), Some(y + self.size)],
            _ => [x.checked_sub(self.size), Some(y)],
        };
        Some(Self { from: [from[0]?, from[1]?], ..self })
    }

    pub(super) fn quarters(self) -> [Self; 4] {
        let half = Self { size: self.size / 2, ..self };
        [[0, 0], [1, 0], [0, 1], [1, 1]].map(|[right, up]| Self { from: half.node(right, up), ..half })
    }
}

/// The way into a cell through a side.
pub(super) fn inward(side: usize) -> PlanePoint {
    [[0.0, 1.0], [-1.0, 0.0], [0.0, -1.0], [1.0, 0.0]][side]
}

pub(super) fn mean(points: impl Iterator<Item = PlanePoint>) -> PlanePoint {
    let (sum, count) = points.fold(([0.0; 2], 0.0), |(sum, count), at| ([sum[0] + at[0], sum[1] + at[1]], count + 1.0));
    sum.map(|x| x / count)
}

/// The area within corners, negative where these run clockwise.
pub(super) fn area(corners: &[PlanePoint]) -> f64 {
    let next = corners.iter().cycle().skip(1);
    0.5 * corners.iter().zip(next).map(|(p, q)| p[0] * q[1] - p[1] * q[0]).sum::<f64>()
}

pub(super) fn distance(a: PlanePoint, b: PlanePoint) -> f64 {
    ((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1])).sqrt()
}
