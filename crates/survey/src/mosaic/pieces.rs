//! The pieces into which cells are cut.

use super::chords::{chord, partners};
use super::division::{Division, Plane};
use super::lattice::{Cell, Node, Place, Stop, mean};

/// A rectangle in pieces.
#[derive(Clone, Debug, PartialEq)]
pub struct Mosaic<L> {
    /// What each piece shows, and its corners. The pieces fill the rectangle without overlap.
    pub pieces: Vec<(L, Vec<Place>)>,
    /// The borders between pieces that show different things, as straight parts.
    pub borders: Vec<[Place; 2]>,
}

impl<P: Plane> Division<'_, P> {
    /// Looks at the middles of cells in which four changes can be joined in two ways.
    pub(super) fn learn_middles(&mut self, cells: &[Cell]) {
        let changes = |cell: &Cell| {
            let changes: Vec<Place> =
                cell.sides().iter().flat_map(|side| self.changes(*side)).map(|change| change.at).collect();
            (cell.size == 1 && changes.len() == 4).then(|| (cell.from, self.place(mean(changes.into_iter()))))
        };
        let (nodes, places): (Vec<Node>, Vec<Place>) = cells.iter().filter_map(changes).unzip();
        self.middles = nodes.into_iter().zip(self.plane.labels(&places)).collect();
    }

    /// The pieces of cells.
    pub(super) fn cut(&self, cells: &[Cell]) -> Mosaic<P::Label> {
        let mut mosaic = Mosaic { pieces: Vec::new(), borders: Vec::new() };
        // Cells of a row that show one thing are one piece.
        let mut run: Option<(P::Label, Cell, u32)> = None;
        for &cell in cells {
            let round = self.round(cell);
            let label = &self.labels[&cell.from];
            if round.iter().any(|stop| stop.after.is_some()) {
                self.cut_cell(&round, self.middles.get(&cell.from), &mut mosaic);
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

    /// Cuts a cell with changes into parts: along chords between changes of one kind, else from each to the middle of all.
    pub(super) fn cut_cell(&self, round: &[Stop<P::Label>], shown: Option<&P::Label>, mosaic: &mut Mosaic<P::Label>) {
        let changes: Vec<usize> = (0..round.len()).filter(|&k| round[k].after.is_some()).collect();
        let next = |change: usize| (change + 1) % changes.len();
        let places = |stops: Vec<Place>| stops.into_iter().map(|at| self.place(at)).collect::<Vec<_>>();
        // The way round from a change to the next one.
        let part = |change: usize| {
            let (from, to) = (changes[change], changes[next(change)]);
            let length = (to + round.len() - from - 1) % round.len() + 1;
            (from..=from + length).map(|k| round[k % round.len()].at)
        };
        let Some(partners) = partners(round, &changes, shown) else {
            let middle = mean(changes.iter().map(|&k| round[k].at));
            for (number, &from) in changes.iter().enumerate() {
                let corners = places(part(number).chain([middle]).collect());
                mosaic.borders.push([round[from].at, middle].map(|at| self.place(at)));
                mosaic.pieces.extend(round[from].after.clone().map(|label| (label, corners)));
            }
            return;
        };
        let chord = |from: usize| chord(&round[changes[from]], &round[changes[partners[from]]]);
        let mut walked = vec![false; changes.len()];
        for first in 0..changes.len() {
            let mut corners = Vec::new();
            let mut at = first;
            while !walked[at] {
                walked[at] = true;
                corners.extend(part(at));
                let met = next(at);
                let line = chord(met);
                corners.extend(&line[1..line.len() - 1]);
                at = partners[met];
            }
            if !corners.is_empty() {
                let label = round[changes[first]].after.clone();
                mosaic.pieces.extend(label.map(|label| (label, places(corners))));
            }
            if first < partners[first] {
                let line = places(chord(first));
                mosaic.borders.extend(line.windows(2).map(|ends| [ends[0], ends[1]]));
            }
        }
    }
}
