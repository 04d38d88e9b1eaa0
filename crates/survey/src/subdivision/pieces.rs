//! The pieces into which cells are cut.

use super::division::{Division, LabelledPlane};
use super::lattice::{BoundaryStop, LatticeCell, PlanePoint, distance, inward, mean};

/// A rectangle in pieces.
#[derive(Clone, Debug, PartialEq)]
pub struct Subdivision<L> {
    /// What each piece shows, and its corners. The pieces fill the rectangle without overlap.
    pub pieces: Vec<(L, Vec<PlanePoint>)>,
    /// Places that were classified, and what they show.
    pub seen: Vec<(L, PlanePoint)>,
    /// The borders between pieces that show different things, as straight parts.
    pub borders: Vec<[PlanePoint; 2]>,
}

impl<P: LabelledPlane> Division<'_, P> {
    /// The pieces of cells.
    pub(super) fn cut(&self, cells: &[LatticeCell]) -> Subdivision<P::Label> {
        let nodes = self.labels.iter().map(|(node, label)| (label.clone(), self.place(node.map(f64::from))));
        let seen = nodes.chain(self.seen.iter().cloned()).collect();
        let mut subdivision = Subdivision { pieces: Vec::new(), seen, borders: Vec::new() };
        // Cells of a row that show one thing are one piece.
        let mut run: Option<(P::Label, LatticeCell, u32)> = None;
        for &cell in cells {
            let label = &self.labels[&cell.from];
            if cell.sides().iter().any(|side| !self.changes(*side).is_empty()) {
                self.cut_cell(cell, &mut subdivision);
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
                    subdivision.pieces.extend(run.replace((label.clone(), cell, cell.size)).map(|run| self.strip(run)));
                }
            }
        }
        subdivision.pieces.extend(run.map(|run| self.strip(run)));
        subdivision
    }

    pub(super) fn strip(&self, (label, cell, length): (P::Label, LatticeCell, u32)) -> (P::Label, Vec<PlanePoint>) {
        let [x, y] = cell.from;
        let corners = [[x, y], [x + length, y], [x + length, y + cell.size], [x, y + cell.size]];
        (label, corners.map(|node| self.place(node.map(f64::from))).to_vec())
    }

    /// Cuts a cell with changes into parts: along chords between changes of one kind, else from each to where all meet.
    pub(super) fn cut_cell(&self, cell: LatticeCell, subdivision: &mut Subdivision<P::Label>) {
        let round = self.round(cell);
        let changes = changes_of(&round);
        let places = |stops: Vec<PlanePoint>| stops.into_iter().map(|at| self.place(at)).collect::<Vec<_>>();
        let joined = || joinings(&round, &changes).into_iter().next();
        let kept = self.joined.get(&(cell.from, cell.size)).filter(|partners| partners.len() == changes.len());
        let Some(partners) = kept.cloned().or_else(joined) else {
            let at: Vec<PlanePoint> = changes.iter().map(|&k| round[k].at).collect();
            let middle = crossing(&at).unwrap_or_else(|| mean(at.iter().copied()));
            let corners = |number: usize| way(&round, &changes, number).chain([middle]).collect::<Vec<PlanePoint>>();
            let rays: Vec<Vec<PlanePoint>> = (0..changes.len()).map(corners).collect();
            // A side of the rectangle can show what nothing inside does.
            let inner: Vec<PlanePoint> = rays.iter().map(|ray| self.place(mean(ray.iter().copied()))).collect();
            let shown = self.plane.labels(&inner);
            for (number, &from) in changes.iter().enumerate() {
                if shown[number] != shown[(number + changes.len() - 1) % changes.len()] {
                    subdivision.borders.push([round[from].at, middle].map(|at| self.place(at)));
                }
            }
            subdivision.pieces.extend(shown.into_iter().zip(rays.into_iter().map(places)));
            return;
        };
        let bend = self.bends.get(&cell.from).copied().filter(|_| changes.len() == 2);
        for (label, corners) in parts(&round, &changes, &partners, bend) {
            subdivision.pieces.extend(label.map(|label| (label, places(corners))));
        }
        for (first, partner) in partners.iter().copied().enumerate().filter(|(first, partner)| first < partner) {
            let line = places(chord(&round[changes[first]], &round[changes[partner]], bend));
            subdivision.borders.extend(line.windows(2).map(|ends| [ends[0], ends[1]]));
        }
    }
}

/// The places of changes on the way round a cell.
pub(super) fn changes_of<L>(round: &[BoundaryStop<L>]) -> Vec<usize> {
    (0..round.len()).filter(|&k| round[k].after.is_some()).collect()
}

/// The way round from a change to the next one.
fn way<'a, L>(
    round: &'a [BoundaryStop<L>],
    changes: &[usize],
    change: usize,
) -> impl Iterator<Item = PlanePoint> + use<'a, L> {
    let (from, to) = (changes[change], changes[(change + 1) % changes.len()]);
    let length = (to + round.len() - from - 1) % round.len() + 1;
    (from..=from + length).map(|k| round[k % round.len()].at)
}

/// What each part of a cell shows, and its corners.
pub(super) fn parts<L: Clone>(
    round: &[BoundaryStop<L>],
    changes: &[usize],
    partners: &[usize],
    bend: Option<PlanePoint>,
) -> Vec<(Option<L>, Vec<PlanePoint>)> {
    let mut walked = vec![false; changes.len()];
    let mut parts = Vec::new();
    for first in 0..changes.len() {
        let mut corners = Vec::new();
        let mut at = first;
        while !walked[at] {
            walked[at] = true;
            corners.extend(way(round, changes, at));
            let met = (at + 1) % changes.len();
            let line = chord(&round[changes[met]], &round[changes[partners[met]]], bend);
            corners.extend(&line[1..line.len() - 1]);
            at = partners[met];
        }
        if !corners.is_empty() {
            parts.push((round[changes[first]].after.clone(), corners));
        }
    }
    parts
}

/// Where two lines cross that join every second of four places.
fn crossing(at: &[PlanePoint]) -> Option<PlanePoint> {
    let [a, b, c, d] = at else { return None };
    let ([ux, uy], [vx, vy]) = ([c[0] - a[0], c[1] - a[1]], [d[0] - b[0], d[1] - b[1]]);
    let across = ux * vy - uy * vx;
    let t = ((b[0] - a[0]) * vy - (b[1] - a[1]) * vx) / across;
    (0.0..=1.0).contains(&t).then_some([a[0] + t * ux, a[1] + t * uy])
}

/// How far a strip that ends reaches into a cell of the finest lattice.
const TIP: f64 = 0.4;

/// The most changes round a cell that are paired.
pub(super) const PAIRED_MAX: usize = 8;

/// The ways to join the changes on the way round a cell by borders that do not cross, as the other end of each: those on which
/// fewest borders return to the side from which they come, the shortest first. None where there is no way, as where three
/// things meet.
pub(super) fn joinings<L: PartialEq>(round: &[BoundaryStop<L>], changes: &[usize]) -> Vec<Vec<usize>> {
    if !changes.len().is_multiple_of(2) || changes.len() > PAIRED_MAX {
        return Vec::new();
    }
    let after = |change: usize| &round[changes[change]].after;
    let before = |change: usize| after((change + changes.len() - 1) % changes.len());
    let agree = |one: usize, other: usize| before(one) == after(other) && after(one) == before(other);
    let cost = |pairs: &Vec<[usize; 2]>| {
        let stops = |pair: &[usize; 2]| pair.map(|change| &round[changes[change]]);
        let returns = pairs.iter().filter(|pair| stops(pair)[0].side == stops(pair)[1].side).count();
        (returns, pairs.iter().map(|pair| distance(stops(pair)[0].at, stops(pair)[1].at)).sum::<f64>())
    };
    let all = pairings(&(0..changes.len()).collect::<Vec<_>>(), &agree);
    let mut all: Vec<_> = all.into_iter().map(|pairs| (cost(&pairs), pairs)).collect();
    all.sort_by(|(p, _), (q, _)| p.0.cmp(&q.0).then(p.1.total_cmp(&q.1)));
    let fewest = all.first().map_or(0, |(cost, _)| cost.0);
    let partners = |pairs: Vec<[usize; 2]>| {
        let mut partners = vec![0; changes.len()];
        for [one, other] in pairs {
            (partners[one], partners[other]) = (other, one);
        }
        partners
    };
    all.into_iter().filter(|(cost, _)| cost.0 == fewest).map(|(_, pairs)| partners(pairs)).collect()
}

/// All ways to pair points on a circle by chords that do not cross.
pub(super) fn pairings(points: &[usize], agree: &impl Fn(usize, usize) -> bool) -> Vec<Vec<[usize; 2]>> {
    let Some((first, rest)) = points.split_first() else { return vec![Vec::new()] };
    let mut all = Vec::new();
    for (place, other) in rest.iter().enumerate().step_by(2).filter(|(_, other)| agree(*first, **other)) {
        for within in pairings(&rest[..place], agree) {
            for beyond in pairings(&rest[place + 1..], agree) {
                all.push([vec![[*first, *other]], within.clone(), beyond].concat());
            }
        }
    }
    all
}

/// The line from one change to another: straight, over a bend, or round a tip where both lie on one side.
pub(super) fn chord<L>(from: &BoundaryStop<L>, to: &BoundaryStop<L>, bend: Option<PlanePoint>) -> Vec<PlanePoint> {
    let mut line = vec![from.at, to.at];
    if let Some(bend) = bend {
        line.insert(1, bend);
    } else if from.side == to.side {
        let ([x, y], [dx, dy]) = (mean([from.at, to.at].into_iter()), inward(from.side));
        line.insert(1, [x + TIP * dx, y + TIP * dy]);
    }
    line
}
