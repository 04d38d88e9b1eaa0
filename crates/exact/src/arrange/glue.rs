//! Faces: the cells between the curves, glued across events.

use super::event::{Event, Undecided};
use super::slab::Slab;
use crate::id::TransitionId;
use bifdiag_diagram::arrangement::{Cells, Continued, EventId, SlabId};
use bifdiag_equilibria::curves::CurveId;
use bifdiag_numbers::table::Table;

/// Glues cells to regions: across an event the curves that meet are a run of neighbours before and after; the cells
/// inside the runs end and begin there, all others continue; where there was nothing before (or is nothing after), the
/// surrounding cell continues on both sides. The number of regions.
pub(super) fn glue(
    events: &Table<EventId, Event>,
    transitions: &Table<TransitionId, Vec<EventId>>,
    slabs: &mut Table<SlabId, Slab>,
) -> Result<usize, Vec<Undecided>> {
    let mut cells = Cells::new(slabs.iter().map(|slab| slab.order.len()));
    for (transition, group) in transitions.pairs() {
        let blocks: Vec<&[CurveId]> = group.iter().map(|&event| events[event].curves.as_slice()).collect();
        let sides = [transition.before(), transition.after()];
        let [before, after] = sides.map(|slab| &slabs[slab].order);
        let continued = continuation(before, after, &blocks)
            .ok_or_else(|| vec![Undecided::Gluing { x: events[group[0]].x[0].to_f64().value() }])?;
        cells.glue(sides, continued);
    }
    let faces = cells.faces();
    for (slab, above) in slabs.iter_mut().zip(faces.above) {
        slab.region_above = above;
    }
    Ok(faces.count)
}

/// The gaps that continue across events on disjoint runs of curves. Gap k lies below curve k.
/// `None` when the orders do not fit.
fn continuation(before: &[CurveId], after: &[CurveId], blocks: &[&[CurveId]]) -> Option<Vec<Continued>> {
    permutations(blocks.len()).into_iter().find_map(|sequence| {
        let origins = (0..=before.len()).map(|gap| vec![gap]).collect();
        let mut now = Progress { order: before.to_vec(), origins };
        for &number in &sequence {
            now = across(&now, after, blocks[number])?;
        }
        (now.order == after).then(|| {
            let pairs = now.origins.into_iter().enumerate();
            pairs.flat_map(|(gap, from)| from.into_iter().map(move |before| Continued { before, after: gap })).collect()
        })
    })
}

/// The vertical order after some of the events of a transition.
struct Progress {
    order: Vec<CurveId>,
    /// For each gap now: the gaps of the beginning that continue into it.
    origins: Vec<Vec<usize>>,
}

/// One event: its run of curves is replaced by the run after it.
fn across(now: &Progress, after: &[CurveId], block: &[CurveId]) -> Option<Progress> {
    let Progress { order, origins } = now;
    let run = |list: &[CurveId]| -> Option<(usize, Vec<CurveId>)> {
        let places: Vec<usize> = (0..list.len()).filter(|&k| block.contains(&list[k])).collect();
        let first = places.first().copied();
        let contiguous = places.windows(2).all(|pair| pair[1] == pair[0] + 1);
        contiguous.then(|| (first.unwrap_or(usize::MAX), places.iter().map(|&k| list[k]).collect()))
    };
    // The curves between this event and the later ones.
    let after: Vec<CurveId> = after.iter().copied().filter(|c| order.contains(c) || block.contains(c)).collect();
    let (mut first, old) = run(order)?;
    let (place, new) = run(&after)?;
    if old.is_empty() {
        // Born in the cell above the curve below it.
        if new.is_empty() {
            return None;
        }
        first = match place.checked_sub(1) {
            None => 0,
            Some(below) => order.iter().position(|&c| c == after[below])? + 1,
        };
    }
    let mut next = order[..first].to_vec();
    next.extend(&new);
    next.extend(&order[first + old.len()..]);
    let mut gaps: Vec<Vec<usize>> = origins[..=first].to_vec();
    match (old.len(), new.len()) {
        (0, _) => {
            gaps.extend((1..new.len()).map(|_| Vec::new()));
            gaps.push(origins[first].clone());
        }
        (_, 0) => {
            let joined = origins[first + old.len()].clone();
            if let Some(last) = gaps.last_mut() {
                last.extend(joined);
            }
        }
        _ => {
            gaps.extend((1..new.len()).map(|_| Vec::new()));
            gaps.push(origins[first + old.len()].clone());
        }
    }
    gaps.extend(origins[first + old.len() + 1..].iter().cloned());
    Some(Progress { order: next, origins: gaps })
}

fn permutations(n: usize) -> Vec<Vec<usize>> {
    if n > 6 {
        return vec![(0..n).collect()];
    }
    let mut all = vec![Vec::new()];
    for _ in 0..n {
        all = all
            .into_iter()
            .flat_map(|start: Vec<usize>| {
                let free: Vec<usize> = (0..n).filter(|k| !start.contains(k)).collect();
                free.into_iter().map(|k| [start.as_slice(), &[k]].concat()).collect::<Vec<_>>()
            })
            .collect();
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use bifdiag_numbers::table::Id;

    /// Pairs (gap before, gap after) that continue, for curves by number.
    fn glued(before: &[usize], after: &[usize], blocks: &[&[usize]]) -> Option<Vec<(usize, usize)>> {
        let ids = |list: &[usize]| list.iter().map(|&c| CurveId::at(c)).collect::<Vec<_>>();
        let blocks: Vec<Vec<CurveId>> = blocks.iter().map(|block| ids(block)).collect();
        let blocks: Vec<&[CurveId]> = blocks.iter().map(Vec::as_slice).collect();
        let gaps = continuation(&ids(before), &ids(after), &blocks)?;
        Some(gaps.into_iter().map(|gaps| (gaps.before, gaps.after)).collect())
    }

    #[test]
    fn a_birth_splits_the_cell_around_it_and_joins_it_at_the_sides() {
        let found = glued(&[0, 1], &[0, 2, 3, 1], &[&[2, 3]]).unwrap();
        assert_eq!(found, [(0, 0), (1, 1), (1, 3), (2, 4)]);
        let found = glued(&[0, 2, 3, 1], &[0, 1], &[&[2, 3]]).unwrap();
        assert_eq!(found, [(0, 0), (1, 1), (3, 1), (4, 2)]);
        let found = glued(&[0, 1], &[1, 0], &[&[0, 1]]).unwrap();
        assert_eq!(found, [(0, 0), (2, 2)]);
        // A swap, and a birth in the new cell: only one sequence fits.
        assert!(glued(&[0, 1], &[1, 2, 3, 0], &[&[2, 3], &[0, 1]]).is_some());
        assert!(glued(&[0, 1, 2], &[2, 1, 0], &[&[0, 2]]).is_none());
    }
}
