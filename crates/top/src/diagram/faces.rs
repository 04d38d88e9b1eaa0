//! Faces of an arrangement from the vertical orders alone: no coordinates enter here.
//!
//! Slab j lies between events j − 1 and j. In a slab with curves order[0] < order[1] < … gap i is the cell below
//! order[i] and above order[i − 1]; gap 0 is below everything (forbidden) and the last gap is unbounded above. Cells of
//! neighbouring slabs are glued unless the event between them separates them (Proposition 8.3 of docs/mathematics.md).

use thiserror::Error;

use super::event::Change;
use numbers::partition::Partition;

/// The faces: for each slab, the face of each gap but the lowest.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Faces {
    /// `of_gap[slab][i]` is the face above the i-th curve of the slab.
    pub of_gap: Vec<Vec<usize>>,
    /// Number of faces.
    pub count: usize,
}

/// The orders on both sides of an event do not fit the event.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("the vertical orders on the two sides of event {event} do not fit it")]
pub struct InconsistentOrder {
    /// Number of the event.
    pub event: usize,
}

/// How the gaps of one slab continue into the next.
struct Gluing {
    /// Pairs (gap before, gap after) that are one face.
    continued: Vec<(usize, usize)>,
}

impl Faces {
    /// Glues the cells. `orders[j]` is the vertical order in slab j, `changes[j]` the event between slabs j and j + 1.
    ///
    /// # Errors
    /// [`InconsistentOrder`] when an order does not follow from the one before by the event between them.
    pub fn glue(orders: &[Vec<usize>], changes: &[Change]) -> Result<Self, InconsistentOrder> {
        let offsets: Vec<usize> = orders
            .iter()
            .scan(0, |sum, order| {
                let first = *sum;
                *sum += order.len() + 1;
                Some(first)
            })
            .collect();
        let cells = offsets.last().map_or(0, |first| first + orders[orders.len() - 1].len() + 1);
        let mut joined = Partition::new(cells);
        for (event, change) in changes.iter().enumerate() {
            let gluing = glue_event(&orders[event], &orders[event + 1], change).ok_or(InconsistentOrder { event })?;
            for (before, after) in gluing.continued {
                joined.unite(offsets[event] + before, offsets[event + 1] + after);
            }
        }
        let mut number: Vec<Option<usize>> = vec![None; cells];
        let mut count = 0;
        let mut of_gap = Vec::with_capacity(orders.len());
        for (slab, order) in orders.iter().enumerate() {
            let mut faces = Vec::with_capacity(order.len());
            for gap in 1..=order.len() {
                let root = joined.find(offsets[slab] + gap);
                let face = *number[root].get_or_insert_with(|| {
                    count += 1;
                    count - 1
                });
                faces.push(face);
            }
            of_gap.push(faces);
        }
        Ok(Self { of_gap, count })
    }
}

/// The gluing of the gaps across one event, or `None` when the orders do not fit the event.
fn glue_event(before: &[usize], after: &[usize], change: &Change) -> Option<Gluing> {
    let at = |order: &[usize], curve: usize| order.iter().position(|&c| c == curve);
    match *change {
        Change::Swap([a, b]) => {
            let (p, q) = (at(before, a)?, at(before, b)?);
            let low = p.min(q);
            let mut swapped = before.to_vec();
            swapped.swap(p, q);
            if p.abs_diff(q) != 1 || swapped != after {
                return None;
            }
            Some(Gluing { continued: (0..=before.len()).filter(|&gap| gap != low + 1).map(|gap| (gap, gap)).collect() })
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
        Self { continued: self.continued.into_iter().map(|(before, after)| (after, before)).collect() }
    }

    /// One gap of the smaller order is split by two new curves at positions low, low + 1 of the larger: both outer
    /// parts continue it, the part between is new.
    fn around(small: usize, low: usize) -> Self {
        let below = (0..=low).map(|gap| (gap, gap));
        let above = (low..=small).map(|gap| (gap, gap + 2));
        Self { continued: below.chain(above).collect() }
    }
}

/// Two neighbouring curves are new in the larger order.
fn inserted(small: &[usize], large: &[usize], positions: [usize; 2]) -> Option<Gluing> {
    let low = positions[0].min(positions[1]);
    if positions[0].abs_diff(positions[1]) != 1 {
        return None;
    }
    let rest: Vec<usize> = large.iter().enumerate().filter(|(k, _)| !positions.contains(k)).map(|(_, &c)| c).collect();
    (rest == small).then(|| Gluing::around(small.len(), low))
}

/// A curve continues as another with a pair next to it.
fn opened(before: &[usize], after: &[usize], through: [usize; 2], pair: usize) -> Option<Gluing> {
    let old = before.iter().position(|&c| c == through[0])?;
    let (new, beside) = (after.iter().position(|&c| c == through[1])?, after.iter().position(|&c| c == pair)?);
    let low = new.min(beside);
    let mut expected = before.to_vec();
    expected.splice(old..=old, if new < beside { [through[1], pair] } else { [pair, through[1]] });
    if new.abs_diff(beside) != 1 || expected != after {
        return None;
    }
    // The gaps below and above the curve continue; the one between curve and pair is new.
    let below = (0..=low).map(|gap| (gap, gap));
    let above = (low + 1..=before.len()).map(|gap| (gap, gap + 1));
    Some(Gluing { continued: below.chain(above).collect() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_crossing_closes_one_face_and_opens_another() {
        let faces = Faces::glue(&[vec![0, 1], vec![1, 0]], &[Change::Swap([0, 1])]).unwrap();
        assert_eq!(faces.count, 3);
        assert_eq!(faces.of_gap, vec![vec![0, 1], vec![2, 1]]);
    }

    #[test]
    fn a_cusp_opens_one_face_inside_another() {
        let orders = [vec![0, 1], vec![0, 2, 3, 1]];
        let faces = Faces::glue(&orders, &[Change::Birth([3, 2])]).unwrap();
        assert_eq!(faces.of_gap, vec![vec![0, 1], vec![0, 2, 0, 1]]);
    }

    #[test]
    fn a_cusp_that_closes_is_the_mirror_image() {
        let orders = [vec![0, 2, 3, 1], vec![0, 1]];
        let faces = Faces::glue(&orders, &[Change::Death([2, 3])]).unwrap();
        assert_eq!(faces.of_gap, vec![vec![0, 1, 0, 2], vec![0, 2]]);
    }

    #[test]
    fn a_pitchfork_opens_one_face_against_the_curve() {
        let orders = [vec![0, 1], vec![0, 3, 2]];
        let faces = Faces::glue(&orders, &[Change::Open { through: [1, 2], pair: 3 }]).unwrap();
        assert_eq!(faces.of_gap, vec![vec![0, 1], vec![0, 2, 1]]);
    }

    #[test]
    fn orders_that_do_not_fit_are_refused() {
        let wrong = Faces::glue(&[vec![0, 1, 2], vec![2, 1, 0]], &[Change::Swap([0, 2])]);
        assert_eq!(wrong, Err(InconsistentOrder { event: 0 }));
        let wrong = Faces::glue(&[vec![0], vec![0, 1]], &[Change::Birth([0, 1])]);
        assert_eq!(wrong, Err(InconsistentOrder { event: 0 }));
    }
}
