//! The topology of U by boxes on a cube around the sphere, and Morse theory at exactly known equilibria.
//!
//! Every component of U_hl holds a minimum of U_l, every component of its complement a maximum (Propositions 9.2 and
//! 9.5); all of them are known. Boxes are proved to lie inside or outside U, or are undecided. Minima joined by inside
//! boxes lie in one component, minima that outside boxes keep apart lie in two; likewise maxima. On a sphere the
//! components of U and of the complement, joined where they border each other, form a tree (Proposition 9.5); so when
//! the possible borders are as many as its edges, they are the borders. No sweep, no arcs, no paths.

use std::collections::{BTreeMap, BTreeSet};

use dashu_ratio::RBig;

use super::classes::Classes;
use super::component::Component;
use super::cube::{Cell, Kind, Leaves};
use super::interval::Interval;
use super::spaces::Spaces;

/// Levels to which boxes are halved.
const LEVELS: u8 = 14;
/// Boxes that may be undecided at once.
const LIMIT: usize = 20_000;

/// F = ⟨v,Av⟩(h|v| + ⟨v,r⟩) − x|v|³, positive inside U_hl and negative outside, with numbers enclosed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Function {
    a: [Interval; 3],
    r: [Interval; 3],
    h: Interval,
    x: Interval,
}

/// The minima of U_l in U_hl, its maxima in the complement, and r where there are poles.
pub(super) struct Extrema {
    pub minima: Vec<[f64; 3]>,
    pub maxima: Vec<[f64; 3]>,
    pub pole: Option<[f64; 3]>,
}

/// |v|², |v|, ⟨v,Av⟩ and h|v| + ⟨v,r⟩.
struct Parts {
    square: Interval,
    length: Interval,
    weight: Interval,
    height: Interval,
}

impl Function {
    /// At x and h in the certificate's units.
    pub fn new(spaces: &Spaces, h: &RBig, x: &RBig) -> Self {
        let mut a = [Interval::point(0.0); 3];
        for space in &spaces.list {
            for &axis in &space.axes {
                a[axis] = Interval::of(&space.a);
            }
        }
        Self { a, r: spaces.r.each_ref().map(Interval::of), h: Interval::of(h), x: Interval::of(x) }
    }

    /// Mean value form.
    fn kind(&self, cell: Cell) -> Kind {
        let ranges = cell.ranges();
        let v = cell.vector(ranges);
        let parts = self.parts(&v);
        let [_, b, c] = cell.axes();
        let reach = ranges.map(|range| Interval::between(-0.5, 0.5) * Interval::point(range.width()));
        let centre = cell.vector(ranges.map(|range| Interval::point(range.middle())));
        let mean = self.value(&self.parts(&centre))
            + self.slope(&v, &parts, b) * reach[0]
            + self.slope(&v, &parts, c) * reach[1];
        match mean.sign().or_else(|| self.value(&parts).sign()) {
            Some(1) => Kind::Inside,
            Some(_) => Kind::Outside,
            None => Kind::Open,
        }
    }

    fn parts(&self, v: &[Interval; 3]) -> Parts {
        let squares = v.map(Interval::square);
        let square = squares[0] + squares[1] + squares[2];
        let length = square.sqrt();
        let weight = squares[0] * self.a[0] + squares[1] * self.a[1] + squares[2] * self.a[2];
        let drop = v[0] * self.r[0] + v[1] * self.r[1] + v[2] * self.r[2];
        Parts { square, length, weight, height: self.h * length + drop }
    }

    fn value(&self, parts: &Parts) -> Interval {
        parts.weight * parts.height - self.x * parts.square * parts.length
    }

    /// ∂F/∂v_k = 2 a_k v_k (h|v| + ⟨v,r⟩) + ⟨v,Av⟩ (h v_k/|v| + r_k) − 3x v_k |v|.
    fn slope(&self, v: &[Interval; 3], parts: &Parts, k: usize) -> Interval {
        let first = Interval::point(2.0) * self.a[k] * v[k] * parts.height;
        let second = parts.weight * (self.h * v[k] * parts.length.recip() + self.r[k]);
        first + second - Interval::point(3.0) * self.x * v[k] * parts.length
    }
}

/// The components of U, or `None` when the boxes allowed do not decide.
pub(super) fn components(function: &Function, extrema: &Extrema) -> Option<Vec<Component>> {
    let mut leaves = Leaves::new(|cell| function.kind(cell));
    loop {
        if let Some(found) = decide(&leaves, extrema) {
            return Some(found);
        }
        if leaves.of_kind(Kind::Open).count() > LIMIT || leaves.deepest() == LEVELS {
            return None;
        }
        leaves.refine(|cell| function.kind(cell));
    }
}

/// Unions of neighbouring boxes of a decided kind, and the wider ones that undecided boxes may join.
struct Unions {
    strict: Classes,
    wide: Classes,
}

impl Unions {
    fn new(leaves: &Leaves, decided: Kind) -> Self {
        let mut unions = Self { strict: Classes::new(leaves.count()), wide: Classes::new(leaves.count()) };
        for [p, q] in leaves.neighbours() {
            let [Some(first), Some(second)] = [p, q].map(|number| leaves.kind(number)) else { continue };
            if [first, second].iter().all(|kind| [decided, Kind::Open].contains(kind)) {
                unions.wide.join(p, q);
            }
            if [first, second] == [decided; 2] {
                unions.strict.join(p, q);
            }
        }
        unions
    }

    /// Wide union → strict union of the boxes that hold the points. Points of one strict union lie in one component,
    /// points of two wide unions in two; so when both tell the same, each union found is one component. `None` when
    /// they do not.
    fn components(&mut self, boxes: &[usize]) -> Option<BTreeMap<usize, usize>> {
        let mut found = BTreeMap::new();
        for &number in boxes {
            let (wide, strict) = (self.wide.root(number), self.strict.root(number));
            if *found.entry(wide).or_insert(strict) != strict {
                return None;
            }
        }
        Some(found)
    }
}

/// The components, if these boxes tell them.
fn decide(leaves: &Leaves, extrema: &Extrema) -> Option<Vec<Component>> {
    let place =
        |v: &[f64; 3], kind: Kind| decided(leaves, *v).filter(|(_, found)| *found == kind).map(|(box_of, _)| box_of);
    let minima: Vec<usize> = extrema.minima.iter().map(|v| place(v, Kind::Inside)).collect::<Option<_>>()?;
    let maxima: Vec<usize> = extrema.maxima.iter().map(|v| place(v, Kind::Outside)).collect::<Option<_>>()?;
    let poles = poles(leaves, extrema.pole)?;
    let mut inner = Unions::new(leaves, Kind::Inside);
    let mut outer = Unions::new(leaves, Kind::Outside);
    let inside = inner.components(&minima)?;
    let outside = outer.components(&maxima)?;
    let mut borders: BTreeSet<(usize, usize)> = BTreeSet::new();
    for number in leaves.of_kind(Kind::Open) {
        let border = (inner.wide.root(number), outer.wide.root(number));
        if inside.contains_key(&border.0) && outside.contains_key(&border.1) {
            borders.insert(border);
        }
    }
    // A tree has one edge less than vertices.
    if borders.len() + 1 != inside.len() + outside.len() {
        return None;
    }
    let mut found = Vec::new();
    for (wide, strict) in &inside {
        let circles = borders.iter().filter(|(i, _)| i == wide).count();
        let mut holds = |pole: Option<usize>| pole.is_some_and(|number| inner.strict.root(number) == *strict);
        let poles = extrema.pole.map(|_| poles.map(&mut holds));
        found.push(Component { boundary_circles: u32::try_from(circles).ok()?, poles });
    }
    // A pole inside U but in no component that was found is not placed yet.
    let placed = found.iter().filter_map(|c| c.poles).flatten().filter(|holds| *holds).count();
    (placed == poles.iter().flatten().count()).then_some(found)
}

/// A box in a rounded direction and its kind, if all boxes that the exact direction may lie in are of one decided kind.
/// They are neighbours, so that they lie in one union.
fn decided(leaves: &Leaves, v: [f64; 3]) -> Option<(usize, Kind)> {
    let around = leaves.around(v);
    let kind = leaves.kind(around[0]).filter(|kind| *kind != Kind::Open)?;
    around.iter().all(|&number| leaves.kind(number) == Some(kind)).then_some((around[0], kind))
}

/// The boxes of r̂ and −r̂ that lie inside U; `None` when that of one is undecided.
fn poles(leaves: &Leaves, pole: Option<[f64; 3]>) -> Option<[Option<usize>; 2]> {
    let Some(r) = pole else { return Some([None, None]) };
    let mut found = [None, None];
    for (which, v) in [r, r.map(|c| -c)].into_iter().enumerate() {
        let (number, kind) = decided(leaves, v)?;
        found[which] = (kind == Kind::Inside).then_some(number);
    }
    Some(found)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::body::Body;

    /// Euler's body below its saddle: two discs about ±e₁, with the complement an annulus.
    #[test]
    fn two_discs_of_a_free_body() {
        let half = |n: i32| RBig::from(n) / RBig::from(2);
        let body = Body { moments: [half(4), half(3), half(2)], center: [RBig::ZERO, RBig::ZERO, RBig::ZERO] };
        let spaces = Spaces::new(&body, &RBig::ONE, &RBig::ONE).unwrap();
        let function = Function::new(&spaces, &RBig::try_from(0.289_062_5).unwrap(), &half(1));
        let minima = vec![[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]];
        let maxima = vec![[0.0, 0.0, 1.0], [0.0, 0.0, -1.0]];
        let found = components(&function, &Extrema { minima, maxima, pole: None }).unwrap();
        assert_eq!(found, [Component { boundary_circles: 1, poles: None }; 2]);
    }
}
