//! Where an entry of a grid has room for its mark.

/// The patches of neighbouring cells that show one entry: the patch of each cell, and the entry of each patch.
pub(super) fn patches(columns: usize, entries: &[Option<usize>]) -> (Vec<Option<usize>>, Vec<usize>) {
    let mut patch: Vec<Option<usize>> = vec![None; entries.len()];
    let mut shown = Vec::new();
    for start in 0..entries.len() {
        let Some(entry) = entries[start].filter(|_| patch[start].is_none()) else { continue };
        let mut open = vec![start];
        patch[start] = Some(shown.len());
        while let Some(cell) = open.pop() {
            let column = cell % columns;
            let beside = [
                (column > 0).then(|| cell - 1),
                (column + 1 < columns).then_some(cell + 1),
                cell.checked_sub(columns),
                Some(cell + columns).filter(|next| *next < entries.len()),
            ];
            for next in beside.into_iter().flatten() {
                if entries[next] == Some(entry) && patch[next].is_none() {
                    patch[next] = Some(shown.len());
                    open.push(next);
                }
            }
        }
        shown.push(entry);
    }
    (patch, shown)
}

/// For each entry the middle of the largest square of cells that show it, and half its side: (column, row, half).
pub(super) fn widest(columns: usize, entries: &[Option<usize>], count: usize) -> Vec<Option<(f64, f64, f64)>> {
    let rows = entries.len().checked_div(columns).unwrap_or(0);
    // side[cell]: the largest square with its upper right corner in the cell.
    let mut side = vec![0_usize; entries.len()];
    let mut best: Vec<Option<(usize, usize, usize)>> = vec![None; count];
    for row in 0..rows {
        for column in 0..columns {
            let cell = row * columns + column;
            let Some(entry) = entries[cell] else { continue };
            let same = |cell: usize| if entries[cell] == Some(entry) { side[cell] } else { 0 };
            side[cell] = if row == 0 || column == 0 {
                1
            } else {
                1 + same(cell - 1).min(same(cell - columns)).min(same(cell - columns - 1))
            };
            if let Some(place) = best.get_mut(entry)
                && place.is_none_or(|(least, _, _)| side[cell] > least)
            {
                *place = Some((side[cell], column, row));
            }
        }
    }
    let middle = |(side, column, row): (usize, usize, usize)| {
        let half = 0.5 * side as f64;
        (column as f64 + 1.0 - half, row as f64 + 1.0 - half, half)
    };
    best.into_iter().map(|place| place.map(middle)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn patches_of_one_entry_are_apart() {
        let (a, b) = (Some(7), Some(3));
        let (patch, shown) = patches(3, &[a, b, a, a, b, a]);
        assert_eq!(shown, [7, 3, 7]);
        assert_eq!(patch, [Some(0), Some(1), Some(2), Some(0), Some(1), Some(2)]);
    }

    #[test]
    fn the_mark_stands_in_the_middle_of_the_largest_square() {
        let (a, b) = (Some(0), Some(1));
        #[rustfmt::skip]
        let entries = [
            a, b, b, b,
            a, b, b, b,
            a, b, b, b,
        ];
        let places = widest(4, &entries, 3);
        assert_eq!(places, [Some((0.5, 0.5, 0.5)), Some((2.5, 1.5, 1.5)), None]);
    }
}
