//! The pieces into which cells are cut.

use super::chords::{chord, joinings};
use super::division::{Division, Plane};
use super::lattice::{Cell, Place, Stop, mean};

/// A rectangle in pieces.
#[derive(Clone, Debug, PartialEq)]
pub struct Mosaic<L> {
    /// What each piece shows, and its corners. The pieces fill the rectangle without overlap.
    pub pieces: Vec<(L, Vec<Place>)>,
    /// Places that were looked at, and what they show.
    pub seen: Vec<(L, Place)>,
    /// The borders between pieces that show different things, as straight parts.
    pub borders: Vec<[Place; 2]>,
}

impl<P: Plane> Division<'_, P> {
    /// The pieces of cells.
    pub(super) fn cut(&self, cells: &[Cell]) -> Mosaic<P::Label> {
        let nodes = self.labels.iter().map(|(node, label)| (label.clone(), self.place(node.map(f64::from))));
        let seen = nodes.chain(self.seen.iter().cloned()).collect();
        let mut mosaic = Mosaic { pieces: Vec::new(), seen, borders: Vec::new() };
        // Cells of a row that show one thing are one piece.
        let mut run: Option<(P::Label, Cell, u32)> = None;
        for &cell in cells {
            let label = &self.labels[&cell.from];
            if cell.sides().iter().any(|side| !self.changes(*side).is_empty()) {
                self.cut_cell(cell, &mut mosaic);
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

    pub(super) fn strip(&self, (label, cell, length): (P::Label, Cell, u32)) -> (P::Label, Vec<Place>) {
        let [x, y] = cell.from;
        let corners = [[x, y], [x + length, y], [x + length, y + cell.size], [x, y + cell.size]];
        (label, corners.map(|node| self.place(node.map(f64::from))).to_vec())
    }

    /// Cuts a cell with changes into parts: along chords between changes of one kind, else from each to where all meet.
    pub(super) fn cut_cell(&self, cell: Cell, mosaic: &mut Mosaic<P::Label>) {
        let round = self.round(cell);
        let changes = changes_of(&round);
        let places = |stops: Vec<Place>| stops.into_iter().map(|at| self.place(at)).collect::<Vec<_>>();
        let joined = || joinings(&round, &changes).into_iter().next();
        let kept = self.joined.get(&(cell.from, cell.size)).filter(|partners| partners.len() == changes.len());
        let Some(partners) = kept.cloned().or_else(joined) else {
            let at: Vec<Place> = changes.iter().map(|&k| round[k].at).collect();
            let middle = crossing(&at).unwrap_or_else(|| mean(at.iter().copied()));
            for (number, &from) in changes.iter().enumerate() {
                let corners = places(way(&round, &changes, number).chain([middle]).collect());
                mosaic.borders.push([round[from].at, middle].map(|at| self.place(at)));
                mosaic.pieces.extend(round[from].after.clone().map(|label| (label, corners)));
            }
            return;
        };
        let bend = self.bends.get(&cell.from).copied().filter(|_| changes.len() == 2);
        for (label, corners) in parts(&round, &changes, &partners, bend) {
            mosaic.pieces.extend(label.map(|label| (label, places(corners))));
        }
        for (first, partner) in partners.iter().copied().enumerate().filter(|(first, partner)| first < partner) {
            let line = places(chord(&round[changes[first]], &round[changes[partner]], bend));
            mosaic.borders.extend(line.windows(2).map(|ends| [ends[0], ends[1]]));
        }
    }
}

/// The places of changes on the way round a cell.
pub(super) fn changes_of<L>(round: &[Stop<L>]) -> Vec<usize> {
    (0..round.len()).filter(|&k| round[k].after.is_some()).collect()
}

/// The way round from a change to the next one.
fn way<'a, L>(round: &'a [Stop<L>], changes: &[usize], change: usize) -> impl Iterator<Item = Place> + use<'a, L> {
    let (from, to) = (changes[change], changes[(change + 1) % changes.len()]);
    let length = (to + round.len() - from - 1) % round.len() + 1;
    (from..=from + length).map(|k| round[k % round.len()].at)
}

/// What each part of a cell shows, and its corners.
pub(super) fn parts<L: Clone>(
    round: &[Stop<L>],
    changes: &[usize],
    partners: &[usize],
    bend: Option<Place>,
) -> Vec<(Option<L>, Vec<Place>)> {
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
fn crossing(at: &[Place]) -> Option<Place> {
    let [a, b, c, d] = at else { return None };
    let ([ux, uy], [vx, vy]) = ([c[0] - a[0], c[1] - a[1]], [d[0] - b[0], d[1] - b[1]]);
    let across = ux * vy - uy * vx;
    let t = ((b[0] - a[0]) * vy - (b[1] - a[1]) * vx) / across;
    (0.0..=1.0).contains(&t).then_some([a[0] + t * ux, a[1] + t * uy])
}
