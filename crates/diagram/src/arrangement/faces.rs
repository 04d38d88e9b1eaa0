//! Faces of an arrangement from the vertical orders alone: no coordinates enter here.
//!
//! Slab j lies between events j − 1 and j. In a slab with curves order[0] < order[1] < … gap i is the cell below
//! order[i] and above order[i − 1]; gap 0 is below everything (forbidden) and the last gap is unbounded above. Cells of
//! neighbouring slabs are glued unless the event between them separates them (Proposition 8.3 of docs/mathematics.md).
//!
//! The cells of all slabs, glued to faces.

use super::event::Change;
use super::id::{EventId, RegionId, SlabId};
use bifdiag_equilibria::curves::CurveId;
use bifdiag_numbers::table::{Id, Partition, Table};
use thiserror::Error;

/// The orders on both sides of an event do not fit the event.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("the vertical orders on the two sides of {event:?} do not fit it")]
pub struct InconsistentOrder {
    /// Number of the event.
    pub event: EventId,
}

/// How the gaps of one slab continue into the next.
struct Gluing {
    continued: Vec<Continued>,
}

impl Faces {
    /// Glues the cells. `orders[j]` is the vertical order in slab j, `changes[j]` the event between slabs j and j + 1.
    ///
    /// # Errors
    /// [`InconsistentOrder`] when an order does not follow from the one before by the event between them.
    pub fn glue(
        orders: &Table<SlabId, Vec<CurveId>>,
        changes: &Table<EventId, Change>,
    ) -> Result<Self, InconsistentOrder> {
        let mut cells = Cells::new(orders.iter().map(Vec::len));
        for (event, change) in changes.pairs() {
            let slabs = [SlabId::ending_at(event), SlabId::starting_at(event)];
            let [left, right] = slabs.map(|slab| &orders[slab]);
            let gluing = glue_event(left, right, change).ok_or(InconsistentOrder { event })?;
            cells.glue(slabs, gluing.continued);
        }
        Ok(cells.faces())
    }
}

/// Which gaps of two neighbouring slabs are in one face: before and after the event between them, from below.
#[must_use]
pub fn continued(before: &[CurveId], after: &[CurveId], change: &Change) -> Vec<[usize; 2]> {
    let gluing = glue_event(before, after, change);
    let mut gaps: Vec<[usize; 2]> =
        gluing.map_or_else(Vec::new, |gluing| gluing.continued.iter().map(|gap| [gap.before, gap.after]).collect());
    gaps.sort_unstable();
    gaps
}

/// The gluing of the gaps across one event, or `None` when the orders do not fit the event.
fn glue_event(before: &[CurveId], after: &[CurveId], change: &Change) -> Option<Gluing> {
    let at = |order: &[CurveId], curve: CurveId| order.iter().position(|&c| c == curve);
    match *change {
        Change::Swap([a, b]) => {
            let (p, q) = (at(before, a)?, at(before, b)?);
            let low = p.min(q);
            let mut swapped = before.to_vec();
            swapped.swap(p, q);
            if p.abs_diff(q) != 1 || swapped != after {
                return None;
            }
            let kept = (0..=before.len()).filter(|&gap| gap != low + 1);
            Some(Gluing { continued: kept.map(|gap| Continued { before: gap, after: gap }).collect() })
        }
        Change::Birth([a, b]) => inserted(before, after, [at(after, a)?, at(after, b)?]),
        Change::Death([a, b]) => inserted(after, before, [at(before, a)?, at(before, b)?]).map(Gluing::reversed),
        Change::Open { through, pair } => opened(before, after, through, pair),
        Change::Close { through: [first, second], pair } => {
            opened(after, before, [second, first], pair).map(Gluing::reversed)
        }
    }
}

impl Gluing {
    fn reversed(self) -> Self {
        let reversed = |gaps: Continued| Continued { before: gaps.after, after: gaps.before };
        Self { continued: self.continued.into_iter().map(reversed).collect() }
    }

    /// One gap of the smaller order is split by two new curves at positions low, low + 1 of the larger: both outer
    /// parts continue it, the part between is new.
    fn around(small: usize, low: usize) -> Self {
        let below = (0..=low).map(|gap| Continued { before: gap, after: gap });
        let above = (low..=small).map(|gap| Continued { before: gap, after: gap + 2 });
        Self { continued: below.chain(above).collect() }
    }
}

/// Two neighbouring curves are new in the larger order.
fn inserted(small: &[CurveId], large: &[CurveId], positions: [usize; 2]) -> Option<Gluing> {
    let low = positions[0].min(positions[1]);
    if positions[0].abs_diff(positions[1]) != 1 {
        return None;
    }
    let others = large.iter().enumerate().filter(|(k, _)| !positions.contains(k));
    let rest: Vec<CurveId> = others.map(|(_, &c)| c).collect();
    (rest == small).then(|| Gluing::around(small.len(), low))
}

/// A curve continues as another with a pair next to it.
fn opened(before: &[CurveId], after: &[CurveId], through: [CurveId; 2], pair: CurveId) -> Option<Gluing> {
    let old = before.iter().position(|&c| c == through[0])?;
    let (new, beside) = (after.iter().position(|&c| c == through[1])?, after.iter().position(|&c| c == pair)?);
    let low = new.min(beside);
    let mut expected = before.to_vec();
    expected.splice(old..=old, if new < beside { [through[1], pair] } else { [pair, through[1]] });
    if new.abs_diff(beside) != 1 || expected != after {
        return None;
    }
    // The gaps below and above the curve continue; the one between curve and pair is new.
    let below = (0..=low).map(|gap| Continued { before: gap, after: gap });
    let above = (low + 1..=before.len()).map(|gap| Continued { before: gap, after: gap + 1 });
    Some(Gluing { continued: below.chain(above).collect() })
}

/// A gap of one slab and a gap of the next that are in one face. Gap k lies below the k-th curve of its slab; the last one is
/// unbounded above.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Continued {
    /// The gap in the slab at smaller x.
    pub before: usize,
    /// The gap in the next one.
    pub after: usize,
}

/// The cells, while they are glued.
#[derive(Clone, Debug)]
pub struct Cells {
    /// How many curves there are in each slab, and the number of its lowest cell.
    slabs: Table<SlabId, (usize, usize)>,
    joined: Partition,
}

/// The faces, which are the diagram's regions: for each slab, the region of each gap but the lowest.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Faces {
    /// `above[slab][i]` is the region above the i-th curve of the slab.
    pub above: Table<SlabId, Vec<RegionId>>,
    /// Number of regions.
    pub count: usize,
}

impl Cells {
    /// The cells of slabs with these numbers of curves, all separate.
    pub fn new(curves: impl IntoIterator<Item = usize>) -> Self {
        let mut slabs = Table::new();
        let mut count = 0;
        for curves in curves {
            slabs.push((curves, count));
            count += curves + 1;
        }
        Self { slabs, joined: Partition::new(count) }
    }

    /// Glues gaps of two slabs.
    pub fn glue(&mut self, [before, after]: [SlabId; 2], continued: impl IntoIterator<Item = Continued>) {
        let first = [before, after].map(|slab| self.slabs[slab].1);
        for gaps in continued {
            self.joined.unite(first[0] + gaps.before, first[1] + gaps.after);
        }
    }

    /// The faces, numbered as they first appear: by slab, then from below. The lowest gaps, which are forbidden, have none.
    #[must_use]
    pub fn faces(mut self) -> Faces {
        let mut numbers: Vec<Option<RegionId>> = Vec::new();
        let mut count = 0;
        let mut above = Table::new();
        for &(curves, first) in &self.slabs {
            numbers.resize(first + curves + 1, None);
            let region = |gap| {
                let number = &mut numbers[self.joined.find(first + gap)];
                *number.get_or_insert_with(|| {
                    count += 1;
                    RegionId::at(count - 1)
                })
            };
            above.push((1..=curves).map(region).collect());
        }
        Faces { above, count }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curve(index: usize) -> CurveId {
        CurveId::at(index)
    }

    /// The regions above the curves of two slabs, and their number.
    fn glued(before: &[usize], after: &[usize], change: Change) -> Result<(Vec<Vec<usize>>, usize), InconsistentOrder> {
        let orders = [before, after].map(|order| order.iter().map(|&c| curve(c)).collect::<Vec<_>>());
        let faces = Faces::glue(&orders.into_iter().collect(), &[change].into_iter().collect())?;
        let above = faces.above.iter().map(|regions| regions.iter().map(|region| region.index()).collect());
        Ok((above.collect(), faces.count))
    }

    #[test]
    fn a_crossing_closes_one_face_and_opens_another() {
        assert_eq!(glued(&[0, 1], &[1, 0], Change::Swap([curve(0), curve(1)])), Ok((vec![vec![0, 1], vec![2, 1]], 3)));
    }

    #[test]
    fn a_cusp_opens_one_face_inside_another() {
        let found = glued(&[0, 1], &[0, 2, 3, 1], Change::Birth([curve(3), curve(2)]));
        assert_eq!(found, Ok((vec![vec![0, 1], vec![0, 2, 0, 1]], 3)));
    }

    #[test]
    fn a_cusp_that_closes_is_the_mirror_image() {
        let found = glued(&[0, 2, 3, 1], &[0, 1], Change::Death([curve(2), curve(3)]));
        assert_eq!(found, Ok((vec![vec![0, 1, 0, 2], vec![0, 2]], 3)));
    }

    #[test]
    fn a_pitchfork_opens_one_face_against_the_curve() {
        let found = glued(&[0, 1], &[0, 3, 2], Change::Open { through: [curve(1), curve(2)], pair: curve(3) });
        assert_eq!(found, Ok((vec![vec![0, 1], vec![0, 2, 1]], 3)));
    }

    #[test]
    fn orders_that_do_not_fit_are_refused() {
        let refused = Err(InconsistentOrder { event: EventId::at(0) });
        assert_eq!(glued(&[0, 1, 2], &[2, 1, 0], Change::Swap([curve(0), curve(2)])), refused);
        assert_eq!(glued(&[0], &[0, 1], Change::Birth([curve(0), curve(1)])), refused);
    }
}
