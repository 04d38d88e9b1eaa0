//! A rectangle divided by what its points show, along borders that are found on the sides of a grid.
//!
//! A cell whose sides the borders cross twice is cut along the chord of the two crossings; where more come together it is
//! quartered, until what is left is a star about their middle. Borders are exact on the sides of cells, and straight between.

use std::collections::{BTreeMap, BTreeSet};

/// How often a cell is halved.
const DEPTH: u32 = 3;
/// Steps of the finest lattice in a cell of the grid.
const UNIT: u32 = 1 << DEPTH;

/// A point of the plane.
pub type Place = [f64; 2];

/// What the points of a plane show.
pub trait Plane {
    /// What is shown at a point.
    type Label: Clone + PartialEq;

    /// What is shown at these points.
    fn labels(&self, places: &[Place]) -> Vec<Self::Label>;

    /// Where what is shown changes on these ways from one point to another, in order: at which share of the way, and what
    /// is shown before and after it.
    fn changes(&self, ways: &[[Place; 2]]) -> Vec<Vec<(f64, [Self::Label; 2])>>;
}

/// A rectangle in pieces.
#[derive(Clone, Debug, PartialEq)]
pub struct Mosaic<L> {
    /// What each piece shows, and its corners. The pieces fill the rectangle without overlap.
    pub pieces: Vec<(L, Vec<Place>)>,
    /// The borders between pieces that show different things, as straight parts.
    pub borders: Vec<[Place; 2]>,
}

/// A point of the finest lattice.
type Node = [u32; 2];

/// A side of a cell, to the right (`along` 0) or upwards (1).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Side {
    from: Node,
    along: usize,
    size: u32,
}

impl Side {
    fn end(self) -> Node {
        let mut end = self.from;
        end[self.along] += self.size;
        end
    }

    fn halves(self) -> [Self; 2] {
        let half = Self { size: self.size / 2, ..self };
        [half, Self { from: half.end(), ..half }]
    }
}

/// A change on a side: where on the lattice, and what is shown on both sides of it.
#[derive(Clone, Debug, PartialEq)]
struct Change<L> {
    at: Place,
    labels: [L; 2],
}

/// A square of the lattice.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Cell {
    from: Node,
    size: u32,
}

impl Cell {
    fn node(self, right: u32, up: u32) -> Node {
        [self.from[0] + right * self.size, self.from[1] + up * self.size]
    }

    /// Below, right, above, left; the last two are walked backwards on the way round.
    fn sides(self) -> [Side; 4] {
        let size = self.size;
        let side = |from, along| Side { from, along, size };
        [side(self.node(0, 0), 0), side(self.node(1, 0), 1), side(self.node(0, 1), 0), side(self.node(0, 0), 1)]
    }

    fn quarters(self) -> [Self; 4] {
        let half = Self { size: self.size / 2, ..self };
        [[0, 0], [1, 0], [0, 1], [1, 1]].map(|[right, up]| Self { from: half.node(right, up), ..half })
    }
}

/// Divides the rectangle of a grid with these values of the two coordinates and what is shown at its points, row by row
/// from below.
pub fn divide<P: Plane>(plane: &P, axes: [&[f64]; 2], shown: &[P::Label]) -> Mosaic<P::Label> {
    let [columns, rows] = axes.map(|values| u32::try_from(values.len().saturating_sub(1)).unwrap_or(0));
    let mut division = Division { plane, axes, labels: BTreeMap::new(), sides: BTreeMap::new() };
    let nodes = (0..=rows).flat_map(|row| (0..=columns).map(move |column| [column * UNIT, row * UNIT]));
    division.labels = nodes.zip(shown.iter().cloned()).collect();
    let cell = |row, column| Cell { from: [column * UNIT, row * UNIT], size: UNIT };
    let mut cells: Vec<Cell> = (0..rows).flat_map(|row| (0..columns).map(move |column| cell(row, column))).collect();
    division.learn_sides(cells.iter().flat_map(|cell| cell.sides()).collect());
    loop {
        let (open, mut done): (Vec<Cell>, Vec<Cell>) = cells.iter().partition(|cell| division.is_open(**cell));
        if open.is_empty() {
            break;
        }
        division.split(&open);
        done.extend(open.into_iter().flat_map(Cell::quarters));
        cells = done;
    }
    cells.sort_by_key(|cell| [cell.from[1], cell.from[0]]);
    division.cut(&cells)
}

/// What is known while a rectangle is divided.
struct Division<'a, P: Plane> {
    plane: &'a P,
    axes: [&'a [f64]; 2],
    labels: BTreeMap<Node, P::Label>,
    /// The changes on each side; where both halves of a side are known, theirs count.
    sides: BTreeMap<Side, Vec<Change<P::Label>>>,
}

impl<P: Plane> Division<'_, P> {
    /// A point of the lattice in the plane.
    fn place(&self, at: Place) -> Place {
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
    fn learn_nodes(&mut self, nodes: BTreeSet<Node>) {
        let new: Vec<Node> = nodes.into_iter().filter(|node| !self.labels.contains_key(node)).collect();
        let places: Vec<Place> = new.iter().map(|node| self.place(node.map(f64::from))).collect();
        self.labels.extend(new.into_iter().zip(self.plane.labels(&places)));
    }

    fn learn_sides(&mut self, sides: BTreeSet<Side>) {
        let new: Vec<Side> = sides.into_iter().filter(|side| !self.sides.contains_key(side)).collect();
        let (plain, crossed): (Vec<Side>, Vec<Side>) =
            new.into_iter().partition(|side| self.labels[&side.from] == self.labels[&side.end()]);
        let ways: Vec<[Place; 2]> =
            crossed.iter().map(|side| [side.from, side.end()].map(|node| self.place(node.map(f64::from)))).collect();
        let found = self.plane.changes(&ways);
        for (side, found) in crossed.into_iter().zip(found) {
            let change = |(share, labels)| {
                let mut at = side.from.map(f64::from);
                at[side.along] += share * f64::from(side.size);
                Change { at, labels }
            };
            self.sides.insert(side, found.into_iter().map(change).collect());
        }
        self.sides.extend(plain.into_iter().map(|side| (side, Vec::new())));
    }

    /// The changes on a side, from its lower end.
    fn changes(&self, side: Side) -> Vec<Change<P::Label>> {
        let halves = side.halves();
        if side.size > 1 && halves.iter().all(|half| self.sides.contains_key(half)) {
            return halves.into_iter().flat_map(|half| self.changes(half)).collect();
        }
        self.sides.get(&side).cloned().unwrap_or_default()
    }

    /// Must a cell be quartered?
    fn is_open(&self, cell: Cell) -> bool {
        let counts = cell.sides().map(|side| self.changes(side).len());
        let total: usize = counts.iter().sum();
        cell.size > 1 && (total > 2 || counts.contains(&2))
    }

    /// Learns what the quarters of cells need.
    fn split(&mut self, cells: &[Cell]) {
        let quarters = || cells.iter().flat_map(|cell| cell.quarters());
        self.learn_nodes(
            quarters().flat_map(|cell| [[0, 0], [1, 0], [0, 1], [1, 1]].map(|[x, y]| cell.node(x, y))).collect(),
        );
        // What is known of a side holds for its halves, unless the middle tells otherwise.
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
        self.learn_sides(quarters().flat_map(Cell::sides).collect());
    }

    /// The pieces of cells.
    fn cut(&self, cells: &[Cell]) -> Mosaic<P::Label> {
        let mut mosaic = Mosaic { pieces: Vec::new(), borders: Vec::new() };
        // Cells of a row that show one thing are one piece.
        let mut run: Option<(P::Label, Cell, u32)> = None;
        for &cell in cells {
            let round = self.round(cell);
            let label = &self.labels[&cell.from];
            if round.iter().any(|(_, change)| change.is_some()) {
                self.cut_cell(&round, &mut mosaic);
                continue;
            }
            match &mut run {
                Some((shown, first, length))
                    if shown == label
                        && first.size == cell.size
                        && [first.from[0] + *length, first.from[1]] == cell.from =>
                {
                    *length += cell.size;
                }
                _ => {
                    mosaic.pieces.extend(run.replace((label.clone(), cell, cell.size)).map(|run| self.strip(run)));
                }
            }
        }
        mosaic.pieces.extend(run.map(|run| self.strip(run)));
        mosaic
    }

    fn strip(&self, (label, cell, length): (P::Label, Cell, u32)) -> (P::Label, Vec<Place>) {
        let [x, y] = cell.from;
        let corners = [[x, y], [x + length, y], [x + length, y + cell.size], [x, y + cell.size]];
        (label, corners.map(|node| self.place(node.map(f64::from))).to_vec())
    }

    /// Corners and changes on the way round a cell, counterclockwise; a change with what is shown after it.
    fn round(&self, cell: Cell) -> Vec<(Place, Option<P::Label>)> {
        let mut round = Vec::new();
        for (number, side) in cell.sides().into_iter().enumerate() {
            let backwards = number > 1;
            let corner = if backwards { side.end() } else { side.from };
            round.push((corner.map(f64::from), None));
            let mut changes = self.changes(side);
            if backwards {
                changes.reverse();
            }
            let after = |labels: [P::Label; 2]| {
                let [before, after] = labels;
                if backwards { before } else { after }
            };
            round.extend(changes.into_iter().map(|change| (change.at, Some(after(change.labels)))));
        }
        round
    }

    /// Cuts a cell with changes into the parts between two of them: along the chord where there are two, else to the middle
    /// of all.
    fn cut_cell(&self, round: &[(Place, Option<P::Label>)], mosaic: &mut Mosaic<P::Label>) {
        let changes: Vec<usize> = (0..round.len()).filter(|&k| round[k].1.is_some()).collect();
        let middle = {
            let sum = changes.iter().fold([0.0; 2], |sum, &k| [sum[0] + round[k].0[0], sum[1] + round[k].0[1]]);
            sum.map(|x| x / changes.len() as f64)
        };
        let is_chord = changes.len() == 2;
        for (number, &from) in changes.iter().enumerate() {
            let to = changes[(number + 1) % changes.len()];
            let length = (to + round.len() - from - 1) % round.len() + 1;
            let mut corners: Vec<Place> =
                (from..=from + length).map(|k| self.place(round[k % round.len()].0)).collect();
            if !is_chord {
                corners.push(self.place(middle));
                mosaic.borders.push([round[from].0, middle].map(|at| self.place(at)));
            }
            mosaic.pieces.extend(round[from].1.clone().map(|label| (label, corners)));
        }
        if is_chord {
            mosaic.borders.push([changes[0], changes[1]].map(|k| self.place(round[k].0)));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Three lands: a disc, and beside it left and right of a slanted line.
    struct Lands;

    fn land([x, y]: Place) -> u8 {
        if (x - 0.4) * (x - 0.4) + (y - 0.55) * (y - 0.55) < 0.07 {
            0
        } else if x + 0.3 * y < 0.57 {
            1
        } else {
            2
        }
    }

    impl Plane for Lands {
        type Label = u8;

        fn labels(&self, places: &[Place]) -> Vec<u8> {
            places.iter().copied().map(land).collect()
        }

        fn changes(&self, ways: &[[Place; 2]]) -> Vec<Vec<(f64, [u8; 2])>> {
            let on = |[p, q]: &[Place; 2], t: f64| [p[0] + (q[0] - p[0]) * t, p[1] + (q[1] - p[1]) * t];
            let of = |way: &[Place; 2]| {
                let at = |k: u32| f64::from(k) / 4096.0;
                let pair = |k: u32| [land(on(way, at(k))), land(on(way, at(k + 1)))];
                (0..4096).map(|k| (at(k) + 0.5 / 4096.0, pair(k))).filter(|(_, [p, q])| p != q).collect()
            };
            ways.iter().map(of).collect()
        }
    }

    fn area(corners: &[Place]) -> f64 {
        let next = corners.iter().cycle().skip(1);
        0.5 * corners.iter().zip(next).map(|(p, q)| p[0] * q[1] - p[1] * q[0]).sum::<f64>()
    }

    fn holds(corners: &[Place], [x, y]: Place) -> bool {
        let next = corners.iter().cycle().skip(1);
        let crossed = |(p, q): &(&Place, &Place)| {
            (p[1] > y) != (q[1] > y) && x < p[0] + (y - p[1]) / (q[1] - p[1]) * (q[0] - p[0])
        };
        corners.iter().zip(next).filter(crossed).count() % 2 == 1
    }

    #[test]
    fn pieces_fill_the_rectangle_and_show_what_is_there() {
        // A cell is wider than what is between the lands at their meeting points.
        let axes: [Vec<f64>; 2] =
            [17, 13].map(|count| (0..count).map(|k| f64::from(k) / f64::from(count - 1)).collect());
        let shown: Vec<u8> = axes[1].iter().flat_map(|&y| axes[0].iter().map(move |&x| land([x, y]))).collect();
        let mosaic = divide(&Lands, [&axes[0], &axes[1]], &shown);
        let total: f64 = mosaic.pieces.iter().map(|(_, corners)| area(corners)).sum();
        assert!((total - 1.0).abs() < 1e-9, "{total}");
        let disc: f64 = mosaic.pieces.iter().filter(|(label, _)| *label == 0).map(|(_, corners)| area(corners)).sum();
        // Chords of a sixteenth in a circle of radius 0.26 leave out 1 % of it.
        assert!((disc / (0.07 * std::f64::consts::PI) - 1.0).abs() < 0.03, "{disc}");
        let mut wrong = 0;
        for k in 0..10_000_u32 {
            let at = [0.754_877_666_246_692_8, 0.569_840_290_998_053_3].map(|step| (f64::from(k) * step).fract());
            let found: Vec<u8> =
                mosaic.pieces.iter().filter(|(_, piece)| holds(piece, at)).map(|(label, _)| *label).collect();
            assert_eq!(found.len(), 1, "{at:?}");
            wrong += u32::from(found[0] != land(at));
        }
        assert!(wrong < 100, "{wrong} of 10000 points lie in a piece that shows another land");
        assert!(!mosaic.borders.is_empty());
    }

    #[test]
    fn one_land_has_no_border() {
        struct Sea;
        impl Plane for Sea {
            type Label = ();
            fn labels(&self, places: &[Place]) -> Vec<()> {
                vec![(); places.len()]
            }
            fn changes(&self, ways: &[[Place; 2]]) -> Vec<Vec<(f64, [(); 2])>> {
                vec![Vec::new(); ways.len()]
            }
        }
        let values = [0.0, 1.0, 2.0];
        let mosaic = divide(&Sea, [&values, &values], &[(); 9]);
        assert_eq!((mosaic.pieces.len(), mosaic.borders.len()), (2, 0), "a strip for each row");
    }
}
