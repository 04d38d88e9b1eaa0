//! The borders of the cells of a region, and the edges of outlines that run along them.

use schema::CellDocument;

use super::gluing::Joins;
use super::regions::Cell;

/// An edge of an outline, with the cells whose border it is, by their numbers in the list of their region.
pub(super) struct Edge<'a> {
    pub corners: &'a [[f64; 2]],
    pub cells: Vec<usize>,
}

/// The cells of a region, in the document and in the slabs.
pub(super) struct Borders<'a> {
    pub described: &'a [CellDocument],
    pub cells: &'a [Cell],
    pub joins: &'a Joins,
    /// How far corners may lie from an l.
    pub aside: f64,
}

impl Edge<'_> {
    /// It runs over one l.
    pub fn is_wall(&self) -> bool {
        self.corners[0][1] == self.corners[1][1]
    }

    /// It runs to the right.
    pub fn rises(&self) -> bool {
        self.corners[0][1] < self.corners[1][1]
    }

    pub fn spans(&self, l: f64) -> bool {
        (self.corners[0][1] > l) != (self.corners[1][1] > l)
    }
}

impl Borders<'_> {
    /// From each edge, walls left out, an outline goes on along the same cell, or along one with which that continues over the l
    /// of their corner: where the region does not go on it turns.
    pub fn are_followed(&self, outline: &[Edge]) -> bool {
        let edges: Vec<&Edge> = outline.iter().filter(|edge| !edge.is_wall()).collect();
        let next = edges.iter().cycle().skip(1);
        edges
            .iter()
            .zip(next)
            .all(|(edge, next)| edge.cells.iter().any(|cell| next.cells.contains(cell)) || self.are_joined(edge, next))
    }

    /// Cells of both edges are one around the l of their corner.
    fn are_joined(&self, edge: &Edge, next: &Edge) -> bool {
        let l = next.corners[0][1];
        let is_there = |cell: &usize| {
            let [from, to] = range(&self.described[*cell]);
            from - 2.0 * self.aside <= l && l <= to + 2.0 * self.aside
        };
        let there: Vec<usize> = (0..self.cells.len()).filter(is_there).collect();
        let mut reached: Vec<usize> = edge.cells.iter().copied().filter(is_there).collect();
        let mut passed = 0;
        while let Some(&cell) = reached.get(passed) {
            passed += 1;
            let beside = |other: &usize| self.continues(cell, *other) && !reached.contains(other);
            let found: Vec<usize> = there.iter().copied().filter(beside).collect();
            reached.extend(found);
        }
        next.cells.iter().any(|cell| reached.contains(cell))
    }

    fn continues(&self, cell: usize, other: usize) -> bool {
        let pair = [self.cells[cell], self.cells[other]];
        let [left, right] = if pair[0] < pair[1] { pair } else { [pair[1], pair[0]] };
        self.joins.contains(&[left, right])
    }
}

/// From where to where a cell runs.
pub(super) fn range(cell: &CellDocument) -> [f64; 2] {
    [cell.l_range[0].unwrap_or(0.0), cell.l_range[1].unwrap_or(f64::INFINITY)]
}

/// Each of these may have a partner of its own out of its list.
pub(super) fn have_partners(lists: &[Vec<usize>]) -> bool {
    let mut partners: Vec<(usize, usize)> = Vec::new();
    (0..lists.len()).all(|one| finds_partner(lists, one, &mut partners, &mut Vec::new()))
}

/// One more gets a partner, though others have to look for another one.
fn finds_partner(lists: &[Vec<usize>], one: usize, partners: &mut Vec<(usize, usize)>, asked: &mut Vec<usize>) -> bool {
    for &partner in &lists[one] {
        if asked.contains(&partner) {
            continue;
        }
        asked.push(partner);
        let Some(taken) = partners.iter().position(|(_, other)| *other == partner) else {
            partners.push((one, partner));
            return true;
        };
        if finds_partner(lists, partners[taken].0, partners, asked) {
            // The one before has another partner now.
            partners[taken].0 = one;
            return true;
        }
    }
    false
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn partners_are_found_though_others_change_theirs() {
        assert!(have_partners(&[]));
        assert!(have_partners(&[vec![1, 2], vec![1], vec![3, 2]]));
        assert!(have_partners(&[vec![1, 2], vec![1, 3], vec![1]]));
        assert!(!have_partners(&[vec![1, 2], vec![1, 2], vec![2, 1]]));
        assert!(!have_partners(&[vec![1], vec![]]));
        assert!(!have_partners(&[vec![1, 2, 3], vec![1], vec![1]]));
    }

    /// A crossing at l = 1: the region lies left and right of it, and above it.
    #[test]
    fn an_outline_turns_at_a_crossing_and_goes_on_above_it() {
        let cell = |from: f64, to: f64| CellDocument {
            l_range: [Some(from), Some(to)],
            lower: "a".to_owned(),
            upper: Some("b".to_owned()),
        };
        let described = [cell(0.0, 1.0), cell(0.0, 1.0), cell(1.0, 2.0), cell(1.0, 2.0)];
        let joins = Joins::from([[(0, 1), (1, 1)]]);
        let borders =
            Borders { described: &described, cells: &[(0, 0), (0, 1), (1, 0), (1, 1)], joins: &joins, aside: 1e-9 };
        let corners = [[0.0, 0.5], [1.0, 1.0], [2.0, 1.5]];
        let follows = |first: usize, last: usize| {
            let edge = |corners, cell| Edge { corners, cells: vec![cell] };
            borders.are_joined(&edge(&corners[..2], first), &edge(&corners[1..], last))
        };
        assert!(follows(1, 3) && follows(3, 1));
        assert!(!follows(0, 2) && !follows(0, 3) && !follows(1, 2));
    }
}
