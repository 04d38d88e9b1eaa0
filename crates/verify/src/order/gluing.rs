//! Faces: cells of neighbouring slabs that continue each other (Proposition 8.3).

use super::events::Events;
use super::slabs::Slab;
use crate::Refused;

/// Most events of one transition that are ordered by trial.
const MOST_EVENTS: usize = 6;

/// The faces named in the slabs are those that gluing gives: cells of neighbouring slabs are one face unless they end
/// or begin inside the run of curves that meet.
pub(crate) fn check(transitions: &[Vec<usize>], events: &Events, slabs: &[Slab]) -> Result<(), Refused> {
    // Number of the first cell of each slab; cell k of a slab lies above its curve k.
    let mut offsets = Vec::new();
    let mut count = 0;
    for slab in slabs {
        offsets.push(count);
        count += slab.levels.len();
    }
    let mut faces = Classes::new(count);
    for (t, group) in transitions.iter().enumerate() {
        let refuse = |event, why| Refused::entry("event", event, why);
        let order = |slab: usize| slabs[slab].levels.iter().map(|level| level.curve).collect::<Vec<_>>();
        let blocks: Vec<&[usize]> = group.iter().map(|&event| events.curves[event].as_slice()).collect();
        for (k, block) in blocks.iter().enumerate() {
            if blocks[..k].iter().any(|other| other.iter().any(|c| block.contains(c))) {
                return Err(refuse(group[k], "another event on its curves is not distinguished from it"));
            }
        }
        let pairs = continuations(&order(t), &order(t + 1), &blocks)
            .ok_or_else(|| refuse(group[0], "the orders on its two sides do not fit it"))?;
        for (p, q) in pairs {
            faces.join(offsets[t] + p, offsets[t + 1] + q);
        }
    }
    one_name_each(slabs, &offsets, &mut faces)
}

/// Names and faces correspond one to one, and the names are R1, R2, … as the faces first appear with l, then h, rising.
fn one_name_each(slabs: &[Slab], offsets: &[usize], faces: &mut Classes) -> Result<(), Refused> {
    let mut names: Vec<(usize, &str)> = Vec::new();
    for (number, slab) in slabs.iter().enumerate() {
        for (cell, name) in slab.faces.iter().enumerate() {
            let face = faces.root(offsets[number] + cell);
            match names.iter().find(|(f, n)| *f == face || *n == name) {
                Some((f, n)) if *f == face && *n == name => {}
                Some(_) => {
                    return Err(Refused::entry("slab", number, "a cell is given to another region than it belongs to"));
                }
                None if *name == format!("R{}", names.len() + 1) => names.push((face, name)),
                None => {
                    return Err(Refused::entry("slab", number, "a region has not the name of its place"));
                }
            }
        }
    }
    Ok(())
}

/// Pairs of cells that continue each other across events on disjoint runs of curves, numbered from 0 above the lowest
/// curve. The events are passed one by one, in the first sequence that leads from one order to the other.
fn continuations(before: &[usize], after: &[usize], blocks: &[&[usize]]) -> Option<Vec<(usize, usize)>> {
    sequences(blocks.len()).into_iter().find_map(|sequence| {
        let mut line = Line::new(before);
        for number in sequence {
            line.pass(blocks[number], after)?;
        }
        (line.curves == after).then(|| line.pairs())
    })
}

/// A vertical line that moves across events.
struct Line {
    /// The curves that it meets, by rising height.
    curves: Vec<usize>,
    /// For each gap between them the gaps of the beginning that continue into it; gap 0 lies below every curve.
    origins: Vec<Vec<usize>>,
}

/// A run of consecutive curves.
#[derive(Clone, Copy)]
struct Run {
    first: usize,
    size: usize,
}

impl Run {
    /// The position of the curves of a block in an order: `Some(None)` if none does, `None` if they are no run.
    #[allow(clippy::option_option)]
    fn of(block: &[usize], order: &[usize]) -> Option<Option<Self>> {
        let Some(first) = order.iter().position(|c| block.contains(c)) else {
            return Some(None);
        };
        let size = order[first..].iter().take_while(|c| block.contains(c)).count();
        let all = order.iter().filter(|c| block.contains(c)).count();
        (all == size).then_some(Some(Self { first, size }))
    }
}

impl Line {
    fn new(before: &[usize]) -> Self {
        Self { curves: before.to_vec(), origins: (0..=before.len()).map(|gap| vec![gap]).collect() }
    }

    /// Passes the event of a block: its run becomes the run that it has afterwards. The gaps below and above continue,
    /// those inside the run end, and those inside the new run begin; without a new run below and above become one gap.
    fn pass(&mut self, block: &[usize], after: &[usize]) -> Option<()> {
        let later: Vec<usize> =
            after.iter().copied().filter(|c| self.curves.contains(c) || block.contains(c)).collect();
        let new = Run::of(block, &later)?;
        let old = match (Run::of(block, &self.curves)?, new) {
            (Some(old), _) => old,
            (None, None) => return None,
            // The curves begin here, above the one that is below them afterwards.
            (None, Some(new)) => {
                let first = match new.first.checked_sub(1) {
                    Some(below) => self.curves.iter().position(|&c| c == later[below])? + 1,
                    None => 0,
                };
                Run { first, size: 0 }
            }
        };
        let inside = new.map_or(&[][..], |run| &later[run.first..run.first + run.size]);
        let (below, above) = (self.origins[old.first].clone(), self.origins[old.first + old.size].clone());
        let mut gaps = vec![Vec::new(); inside.len() + 1];
        gaps[0] = below;
        gaps[inside.len()].extend(above);
        self.origins.splice(old.first..=old.first + old.size, gaps);
        self.curves.splice(old.first..old.first + old.size, inside.iter().copied());
        Some(())
    }

    /// Cells of the beginning with the cells that continue them. The gap below every curve is no cell.
    fn pairs(&self) -> Vec<(usize, usize)> {
        let gaps = self.origins.iter().enumerate().skip(1);
        gaps.flat_map(|(gap, origins)| origins.iter().filter(|&&o| o > 0).map(move |&o| (o - 1, gap - 1))).collect()
    }
}

/// Every sequence of n events; none for more than [`MOST_EVENTS`].
fn sequences(n: usize) -> Vec<Vec<usize>> {
    if n > MOST_EVENTS {
        return Vec::new();
    }
    (0..n).fold(vec![Vec::new()], |all, _| {
        let longer = |start: Vec<usize>| {
            let free: Vec<usize> = (0..n).filter(|k| !start.contains(k)).collect();
            free.into_iter().map(move |k| [start.clone(), vec![k]].concat())
        };
        all.into_iter().flat_map(longer).collect()
    })
}

/// Disjoint classes of 0 … n − 1, each named by its least member.
pub(crate) struct Classes {
    parent: Vec<usize>,
}

impl Classes {
    pub fn new(n: usize) -> Self {
        Self { parent: (0..n).collect() }
    }

    pub fn root(&mut self, mut k: usize) -> usize {
        while self.parent[k] != k {
            self.parent[k] = self.parent[self.parent[k]];
            k = self.parent[k];
        }
        k
    }

    pub fn join(&mut self, p: usize, q: usize) {
        let (p, q) = (self.root(p), self.root(q));
        self.parent[p.max(q)] = p.min(q);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_crossing_ends_one_cell_and_begins_one() {
        let pairs = continuations(&[0, 1, 2, 3], &[0, 2, 1, 3], &[&[1, 2]]).unwrap();
        assert_eq!(pairs, [(0, 0), (2, 2), (3, 3)]);
    }

    #[test]
    fn a_cusp_begins_a_cell_and_its_end_joins_two() {
        // Cell 0 continues below and above the two curves; cell 1 between them begins.
        let begins: &[&[usize]] = &[&[5, 6]];
        assert_eq!(continuations(&[0], &[0, 5, 6], begins).unwrap(), [(0, 0), (0, 2)]);
        assert_eq!(continuations(&[0, 5, 6], &[0], begins).unwrap(), [(0, 0), (2, 0)]);
        assert_eq!(continuations(&[], &[5, 6], begins).unwrap(), []);
    }

    #[test]
    fn a_pitchfork_exchanges_one_curve_for_two() {
        assert_eq!(continuations(&[0, 1], &[0, 2, 3], &[&[1, 2, 3]]).unwrap(), [(0, 0), (1, 2)]);
    }

    #[test]
    fn events_of_one_transition_are_passed_in_any_sequence() {
        // The second event moves its curves next to the first one's.
        let blocks: &[&[usize]] = &[&[2, 3], &[1, 4]];
        assert_eq!(continuations(&[0, 1, 2, 3, 4], &[0, 4, 1], blocks).unwrap(), [(0, 0), (4, 2)]);
        assert_eq!(continuations(&[0, 1], &[1, 0], &[]), None);
        assert_eq!(continuations(&[0, 1, 2], &[0, 2, 1], &[&[0, 1]]), None);
    }

    #[test]
    fn classes_are_named_by_their_least_member() {
        let mut classes = Classes::new(6);
        for (p, q) in [(4, 2), (5, 4), (1, 3)] {
            classes.join(p, q);
        }
        assert_eq!((0..6).map(|k| classes.root(k)).collect::<Vec<_>>(), [0, 1, 2, 1, 2, 2]);
    }
}
