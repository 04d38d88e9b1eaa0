//! Strips narrower than a cell, followed straight on from side to side.

use std::collections::BTreeSet;

use super::division::{Changes, Division, LabelledPlane};
use super::lattice::{CellSide, LabelChange, LatticeCell, LatticeNode, PlanePoint, distance, inward, mean};
use super::pieces::joinings;

impl<P: LabelledPlane> Division<'_, P> {
    /// Looks for strips that end at a side of a cell of the finest lattice: on the far sides, straight on. True if one
    /// continues.
    pub(super) fn follow(&mut self, cells: &[LatticeCell], followed: &mut BTreeSet<LatticeNode>) -> bool {
        let ends = cells.iter().filter(|cell| cell.size == 1 && !followed.contains(&cell.from));
        let ends: Vec<(LatticeCell, StripEnd<P::Label>)> =
            ends.filter_map(|cell| Some((*cell, self.strip_end(*cell)?))).collect();
        followed.extend(ends.iter().map(|(cell, _)| cell.from));
        let mut goes_on = false;
        let mut left = ends;
        for shift in PROBES {
            let places: Vec<PlanePoint> = left.iter().map(|(_, end)| self.place(end.probe(shift))).collect();
            let shown = self.plane.labels(&places);
            self.seen.extend(shown.iter().cloned().zip(places));
            let (met, missed): (Vec<_>, Vec<_>) =
                left.into_iter().zip(shown).partition(|((_, end), shown)| *shown == end.inside);
            for (side, changes) in self.edges(met.into_iter().map(|((_, end), _)| end).collect(), shift) {
                self.sides.insert(side, changes);
                goes_on = true;
            }
            left = missed.into_iter().map(|(end, _)| end).collect();
        }
        goes_on
    }

    /// The sides on which strips were met, with the changes at both edges of the strip.
    fn edges(&self, met: Vec<StripEnd<P::Label>>, shift: f64) -> Vec<(CellSide, Vec<LabelChange<P::Label>>)> {
        let ways = |end: &StripEnd<P::Label>| {
            let [from, to] = [end.side.from, end.side.end()].map(|node| node.map(f64::from));
            [[from, end.probe(shift)], [end.probe(shift), to]]
        };
        let drawn: Vec<[PlanePoint; 2]> = met.iter().flat_map(ways).map(|way| way.map(|at| self.place(at))).collect();
        let found = self.plane.changes(&drawn);
        let changes = |(found, [from, to]): (&Changes<P::Label>, [PlanePoint; 2])| {
            let at = |share: f64| [0, 1].map(|axis| from[axis] + share * (to[axis] - from[axis]));
            found
                .iter()
                .map(|(share, labels)| LabelChange { at: at(*share), labels: labels.clone() })
                .collect::<Vec<_>>()
        };
        let side = |(end, found): (StripEnd<P::Label>, &[Changes<P::Label>])| {
            let [before, after] = &found.iter().zip(ways(&end)).map(changes).collect::<Vec<_>>()[..] else {
                return None;
            };
            let leaves = before.first().is_some_and(|change| change.labels[0] == end.outside)
                && after.last().is_some_and(|change| change.labels[1] == end.outside);
            leaves.then(|| (end.side, [&before[..], &after[..]].concat()))
        };
        met.into_iter().zip(found.chunks(2)).filter_map(side).collect()
    }

    /// A strip that comes into a cell through one of its sides or corners and leaves it nowhere.
    fn strip_end(&self, cell: LatticeCell) -> Option<StripEnd<P::Label>> {
        let round = self.round(cell);
        let ends: Vec<usize> = (0..round.len()).filter(|&k| round[k].after.is_some()).collect();
        let [mut first, mut second] = ends[..] else { return None };
        // What lies between the two, counterclockwise, holds one corner or none.
        if second - first > 2 {
            (first, second) = (second, first);
        }
        let corners = (second + round.len() - first) % round.len() - 1;
        let [first, second] = [&round[first], &round[second]];
        let (here, width) = (mean([first.at, second.at].into_iter()), distance(first.at, second.at));
        if corners > 1 {
            return None;
        }
        let walls = [first.side, second.side];
        let ends = [first.at, second.at];
        let (before, width_before) = match corners {
            0 => self.strip_before(cell, walls[0], ends),
            _ => (self.beyond_corner(cell, walls[1], ends)?, width),
        };
        // Straight on, to where the way leaves the cell.
        let along = [here[0] - before[0], here[1] - before[1]];
        let [x, y] = cell.from.map(f64::from);
        let reach = |axis: usize, low: f64| {
            let wall = if along[axis] > 0.0 { low + 1.0 } else { low };
            if along[axis] == 0.0 { f64::INFINITY } else { (wall - here[axis]) / along[axis] }
        };
        // The wall through which it came does not count.
        let [right, up] = [reach(0, x), reach(1, y)].map(|t| if t > 1e-9 { t } else { f64::INFINITY });
        let t = right.min(up);
        if !t.is_finite() {
            return None;
        }
        let far = match (right < up, along) {
            (true, [dx, _]) => {
                if dx > 0.0 {
                    1
                } else {
                    3
                }
            }
            (false, [_, dy]) => {
                if dy > 0.0 {
                    2
                } else {
                    0
                }
            }
        };
        let side = cell.sides()[far];
        let is_plain = !walls.contains(&far) && self.sides.get(&side).is_some_and(Vec::is_empty);
        let at = [here[0] + t * along[0], here[1] + t * along[1]];
        // As much narrower as it became on the way before.
        let width = (width + (width - width_before) * t).max(0.1 * width);
        let [inside, outside] = [first, second].map(|end| end.after.clone());
        let (inside, outside) = (inside?, outside?);
        is_plain.then_some(StripEnd { side, at, width, inside, outside })
    }

    /// The middle of what else of a strip is met round the corner of a cell at which a side begins.
    fn beyond_corner(&self, cell: LatticeCell, side: usize, ends: [PlanePoint; 2]) -> Option<PlanePoint> {
        let one = cell.beyond(side)?;
        let other = cell.beyond((side + 3) % 4)?;
        let cells = [one, other, one.beyond((side + 3) % 4)?];
        let changes = cells.iter().flat_map(|cell| cell.sides()).flat_map(|side| self.changes(side));
        let mut others: Vec<PlanePoint> = changes.map(|change| change.at).filter(|at| !ends.contains(at)).collect();
        others.sort_by(|p, q| p[0].total_cmp(&q[0]).then(p[1].total_cmp(&q[1])));
        others.dedup();
        (!others.is_empty()).then(|| mean(others.into_iter()))
    }

    /// The middle and the width of a strip on the other side of the cell from which it comes.
    pub(super) fn strip_before(&self, cell: LatticeCell, number: usize, ends: [PlanePoint; 2]) -> (PlanePoint, f64) {
        let here = mean(ends.into_iter());
        let width = distance(ends[0], ends[1]);
        let inward = inward(number);
        let across = ([here[0] - inward[0], here[1] - inward[1]], width);
        let Some(before) =
            cell.beyond(number).filter(|cell| cell.sides().iter().all(|side| self.sides.contains_key(side)))
        else {
            return across;
        };
        let round = self.round(before);
        let changes: Vec<usize> = (0..round.len()).filter(|&k| round[k].after.is_some()).collect();
        let others = || changes.iter().map(|&k| round[k].at).filter(|at| !ends.contains(at));
        if others().next().is_none() {
            return across;
        }
        let Some(partners) = joinings(&round, &changes).into_iter().next() else { return (mean(others()), width) };
        let partner = |end: PlanePoint| {
            let own = changes.iter().position(|&k| round[k].at == end)?;
            Some(round[changes[partners[own]]].at).filter(|at| !ends.contains(at))
        };
        match ends.map(partner) {
            [Some(one), Some(other)] => (mean([one, other].into_iter()), distance(one, other)),
            _ => across,
        }
    }
}

/// The place on a side where a strip is looked for.
pub(super) struct StripEnd<L> {
    side: CellSide,
    at: PlanePoint,
    width: f64,
    inside: L,
    outside: L,
}

/// Where a strip is looked for besides straight on, in its widths.
pub(super) const PROBES: [f64; 5] = [0.0, 0.3, -0.3, 0.7, -0.7];

impl<L> StripEnd<L> {
    pub(super) fn probe(&self, shift: f64) -> PlanePoint {
        let mut at = self.at;
        let along = self.side.along;
        let low = f64::from(self.side.from[along]);
        at[along] = (at[along] + shift * self.width).clamp(low + 1e-3, low + 1.0 - 1e-3);
        at
    }
}
