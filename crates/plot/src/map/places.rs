//! Where an entry of a grid has room for its mark.

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
