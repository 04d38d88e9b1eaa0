//! The topology of U by boxes on a cube around the sphere, and Morse theory at exactly known equilibria.
//!
//! Every component of U_hl holds a minimum of U_l, every component of its complement a maximum; all of them are known.
//! Boxes are proved to lie inside or outside U, or are undecided. Minima joined by inside boxes lie in one component,
//! minima that outside boxes keep apart lie in two; likewise maxima. On a sphere the components of U and of the
//! complement, joined where they border each other, form a tree; so when the possible borders are as many as its edges,
//! they are the borders (Proposition 9.5 of docs/mathematics.md). No sweep, no arcs, no paths.

use std::collections::{BTreeMap, BTreeSet};

use numbers::interval::Interval;
use top::topology::{Component, Poles, sort_components};

/// Levels to which boxes are halved.
const LEVELS: u8 = 14;
/// Boxes that may be undecided at once.
const LIMIT: usize = 20_000;
/// The level at which the cube starts.
const START: u8 = 3;

/// U_hl in the certificate's units.
#[derive(Clone, Copy, Debug)]
pub(super) struct Region {
    pub a: [f64; 3],
    pub r: [f64; 3],
    pub h: f64,
    pub x: f64,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Cell {
    face: u8,
    level: u8,
    i: u32,
    j: u32,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Inside,
    Outside,
    Open,
}

/// A rounded number of known error.
fn near(x: f64) -> Interval {
    Interval::point(x).widened(2.0)
}

impl Region {
    /// F = ⟨v,Av⟩(h|v| + ⟨v,r⟩) − x|v|³ over a cell: its sign tells U from its complement. Mean value form.
    fn kind(&self, cell: Cell) -> Kind {
        let (u, w) = cell.ranges();
        let value = |u: Interval, w: Interval| {
            let v = cell.vector(u, w);
            let (square, length, weight, drop) = self.parts(&v);
            let height = near(self.h) * length + drop;
            weight * height - near(self.x) * square * length
        };
        let middle = |x: Interval| Interval::point(0.5 * (x.lo + x.hi));
        let centre = value(middle(u), middle(w));
        let v = cell.vector(u, w);
        let (_, length, weight, drop) = self.parts(&v);
        let height = near(self.h) * length + drop;
        let axes = cell.axes();
        let slope = |axis: usize| {
            let inverse = length.recip();
            let first = near(2.0 * self.a[axis]) * v[axis] * height;
            let second = weight * (near(self.h) * v[axis] * inverse + near(self.r[axis]));
            let third = near(3.0 * self.x) * v[axis] * length;
            first + second - third
        };
        let reach = Interval::between(-0.5, 0.5) * (u.hi - u.lo);
        let mean = centre + slope(axes[1]) * reach + slope(axes[2]) * reach;
        let direct = value(u, w);
        match (mean.sign().or(direct.sign()), mean.sign()) {
            (Some(1), _) => Kind::Inside,
            (Some(-1), _) => Kind::Outside,
            _ => Kind::Open,
        }
    }

    /// |v|², |v|, ⟨v,Av⟩, ⟨v,r⟩.
    fn parts(&self, v: &[Interval; 3]) -> (Interval, Interval, Interval, Interval) {
        let squares = [v[0].square(), v[1].square(), v[2].square()];
        let square = squares[0] + squares[1] + squares[2];
        let weight = squares[0] * near(self.a[0]) + squares[1] * near(self.a[1]) + squares[2] * near(self.a[2]);
        let drop = v[0] * near(self.r[0]) + v[1] * near(self.r[1]) + v[2] * near(self.r[2]);
        (square, square.sqrt(), weight, drop)
    }
}

impl Cell {
    /// Number of cells along an edge.
    fn count(self) -> f64 {
        f64::from(1u32 << self.level)
    }

    /// The axis of the face, and the other two.
    fn axes(self) -> [usize; 3] {
        let first = usize::from(self.face / 2);
        [first, (first + 1) % 3, (first + 2) % 3]
    }

    /// Dyadic, so that nothing is rounded.
    fn ranges(self) -> (Interval, Interval) {
        let side = 2.0 / self.count();
        let range = |k: u32| Interval { lo: f64::from(k) * side - 1.0, hi: f64::from(k + 1) * side - 1.0 };
        (range(self.i), range(self.j))
    }

    fn vector(self, u: Interval, w: Interval) -> [Interval; 3] {
        let [a, b, c] = self.axes();
        let mut v = [Interval::point(0.0); 3];
        v[a] = Interval::point(if self.face.is_multiple_of(2) { 1.0 } else { -1.0 });
        v[b] = u;
        v[c] = w;
        v
    }

    fn halves(self) -> [Self; 4] {
        let (i, j, level) = (2 * self.i, 2 * self.j, self.level + 1);
        [(i, j), (i + 1, j), (i, j + 1), (i + 1, j + 1)].map(|(i, j)| Self { level, i, j, ..self })
    }

    /// Directions just beyond the middles of the four edges.
    fn beyond(self) -> [[f64; 3]; 4] {
        let (u, w) = self.ranges();
        let step = (u.hi - u.lo) / 256.0;
        let middle = |x: Interval| 0.5 * (x.lo + x.hi);
        let places =
            [(u.lo - step, middle(w)), (u.hi + step, middle(w)), (middle(u), w.lo - step), (middle(u), w.hi + step)];
        let [a, b, c] = self.axes();
        places.map(|(p, q)| {
            let mut v = [0.0; 3];
            v[a] = if self.face.is_multiple_of(2) { 1.0 } else { -1.0 };
            v[b] = p;
            v[c] = q;
            v
        })
    }
}

/// Leaves of the subdivided cube.
struct Leaves {
    kinds: BTreeMap<Cell, Kind>,
    deepest: u8,
}

impl Leaves {
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

/// Union-find over numbers.
struct Classes {
    parent: Vec<usize>,
}

impl Classes {
    fn new(n: usize) -> Self {
        Self { parent: (0..n).collect() }
    }

    fn root(&mut self, mut k: usize) -> usize {
        while self.parent[k] != k {
            self.parent[k] = self.parent[self.parent[k]];
            k = self.parent[k];
        }
        k
    }

    fn join(&mut self, p: usize, q: usize) {
        let (p, q) = (self.root(p), self.root(q));
        self.parent[p.max(q)] = p.min(q);
    }
}

/// The components of U, or `None` when the boxes allowed do not decide.
pub(super) fn components(
    region: &Region,
    minima: &[[f64; 3]],
    maxima: &[[f64; 3]],
    pole: Option<[f64; 3]>,
) -> Option<Vec<Component>> {
    let mut leaves = Leaves { kinds: BTreeMap::new(), deepest: START };
    let mut open = Vec::new();
    for face in 0..6 {
        for i in 0..1 << START {
            for j in 0..1 << START {
                let cell = Cell { face, level: START, i, j };
                let kind = region.kind(cell);
                leaves.kinds.insert(cell, kind);
                if kind == Kind::Open {
                    open.push(cell);
                }
            }
        }
    }
    loop {
        if let Some(found) = decide(&leaves, minima, maxima, pole) {
            return Some(found);
        }
        if open.len() > LIMIT || leaves.deepest == LEVELS {
            return None;
        }
        leaves.deepest += 1;
        let mut next = Vec::new();
        for cell in open {
            leaves.kinds.remove(&cell);
            for part in cell.halves() {
                let kind = region.kind(part);
                leaves.kinds.insert(part, kind);
                if kind == Kind::Open {
                    next.push(part);
                }
            }
        }
        open = next;
    }
}

/// Points in classes of a decided kind, and the wider classes that hold undecided boxes too: `Some` when both tell the
/// same.
fn grouped(numbers: &[usize], strict: &mut Classes, wide: &mut Classes) -> Option<BTreeMap<usize, usize>> {
    // Wide class → strict class.
    let mut groups: BTreeMap<usize, usize> = BTreeMap::new();
    for &number in numbers {
        let (p, q) = (wide.root(number), strict.root(number));
        if *groups.entry(p).or_insert(q) != q {
            return None;
        }
    }
    Some(groups)
}

fn decide(leaves: &Leaves, minima: &[[f64; 3]], maxima: &[[f64; 3]], pole: Option<[f64; 3]>) -> Option<Vec<Component>> {
    let cells: Vec<(Cell, Kind)> = leaves.kinds.iter().map(|(cell, kind)| (*cell, *kind)).collect();
    let number = |cell: Cell| cells.binary_search_by(|probe| probe.0.cmp(&cell)).ok();
    let place = |v: &[f64; 3], kind: Kind| {
        let number = number(leaves.at(*v)?)?;
        (cells[number].1 == kind).then_some(number)
    };
    let minima: Vec<usize> = minima.iter().map(|v| place(v, Kind::Inside)).collect::<Option<_>>()?;
    let maxima: Vec<usize> = maxima.iter().map(|v| place(v, Kind::Outside)).collect::<Option<_>>()?;
    let mut poles = [None, None];
    if let Some(pole) = pole {
        for (which, sign) in [(0, 1.0), (1, -1.0)] {
            let number = number(leaves.at(pole.map(|c| sign * c))?)?;
            match cells[number].1 {
                Kind::Inside => poles[which] = Some(number),
                Kind::Outside => {}
                Kind::Open => return None,
            }
        }
    }
    let n = cells.len();
    // Inside; inside and undecided; outside; outside and undecided.
    let (mut inner, mut inner_wide) = (Classes::new(n), Classes::new(n));
    let (mut outer, mut outer_wide) = (Classes::new(n), Classes::new(n));
    for (p, (cell, kind)) in cells.iter().enumerate() {
        for v in cell.beyond() {
            let q = number(leaves.at(v)?)?;
            let other = cells[q].1;
            if *kind != Kind::Outside && other != Kind::Outside {
                inner_wide.join(p, q);
                if *kind == Kind::Inside && other == Kind::Inside {
                    inner.join(p, q);
                }
            }
            if *kind != Kind::Inside && other != Kind::Inside {
                outer_wide.join(p, q);
                if *kind == Kind::Outside && other == Kind::Outside {
                    outer.join(p, q);
                }
            }
        }
    }
    let inside = grouped(&minima, &mut inner, &mut inner_wide)?;
    let outside = grouped(&maxima, &mut outer, &mut outer_wide)?;
    let mut borders: BTreeSet<(usize, usize)> = BTreeSet::new();
    for (p, (_, kind)) in cells.iter().enumerate() {
        if *kind == Kind::Open {
            let (i, o) = (inner_wide.root(p), outer_wide.root(p));
            if inside.contains_key(&i) && outside.contains_key(&o) {
                borders.insert((i, o));
            }
        }
    }
    if borders.len() + 1 != inside.len() + outside.len() {
        return None;
    }
    let mut found: Vec<Component> = inside
        .iter()
        .map(|(wide, strict)| {
            let circles = borders.iter().filter(|(i, _)| i == wide).count();
            let mut holds = |which: usize| poles[which].is_some_and(|number| inner.root(number) == *strict);
            let poles = pole.map(|_| Poles { plus: holds(0), minus: holds(1) });
            Component { boundary_circles: u32::try_from(circles).unwrap_or(u32::MAX), poles }
        })
        .collect();
    // A pole inside U but in no component that was found would be a contradiction.
    let placed = found.iter().filter_map(|c| c.poles).map(Poles::count).sum::<u32>();
    if placed != u32::try_from(poles.iter().flatten().count()).unwrap_or(u32::MAX) {
        return None;
    }
    sort_components(&mut found);
    Some(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Euler's body below its saddle: two discs about ±e₁, with the complement an annulus.
    #[test]
    fn two_discs_of_a_free_body() {
        let region = Region { a: [2.0, 1.5, 1.0], r: [0.0; 3], h: 0.289_062_5, x: 0.5 };
        let minima = [[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]];
        let maxima = [[0.0, 0.0, 1.0], [0.0, 0.0, -1.0]];
        let found = components(&region, &minima, &maxima, None).unwrap();
        assert_eq!(found, [Component { boundary_circles: 1, poles: None }; 2]);
    }

    #[test]
    fn cells_lie_beside_their_neighbours() {
        let kinds = (0..6)
            .flat_map(|face| (0..8).flat_map(move |i| (0..8).map(move |j| Cell { face, level: START, i, j })))
            .map(|cell| (cell, Kind::Open))
            .collect();
        let leaves = Leaves { kinds, deepest: START };
        let centre = |cell: Cell| {
            let (u, w) = cell.ranges();
            let v = cell.vector(Interval::point(0.5 * (u.lo + u.hi)), Interval::point(0.5 * (w.lo + w.hi)));
            let n = v.iter().map(|c| c.lo * c.lo).sum::<f64>().sqrt();
            v.map(|c| c.lo / n)
        };
        for &cell in leaves.kinds.keys() {
            for v in cell.beyond() {
                let (p, q) = (centre(cell), centre(leaves.at(v).unwrap()));
                let distance = (0..3).map(|k| (p[k] - q[k]) * (p[k] - q[k])).sum::<f64>().sqrt();
                assert!(distance > 1e-3 && distance < 0.3, "{cell:?} {:?} {distance}", leaves.at(v));
            }
        }
    }
}
