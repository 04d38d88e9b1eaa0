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

/// The cells of which all so many cells away and nearer show the same: patches that meet in a narrow place only fall apart.
pub(super) fn thinned(columns: usize, entries: &[Option<usize>], away: usize) -> Vec<Option<usize>> {
    let rows = entries.len().checked_div(columns).unwrap_or(0);
    // First along rows, then along columns.
    let along = |entries: &[Option<usize>], lines: usize, length: usize, cell: &dyn Fn(usize, usize) -> usize| {
        let mut left = entries.to_vec();
        for (line, at) in (0..lines).flat_map(|line| (0..length).map(move |at| (line, at))) {
            let near = at.saturating_sub(away)..(at + away + 1).min(length);
            let own = entries[cell(line, at)];
            if near.into_iter().any(|other| entries[cell(line, other)] != own) {
                left[cell(line, at)] = None;
            }
        }
        left
    };
    let across = along(entries, rows, columns, &|row, column| row * columns + column);
    along(&across, columns, rows, &|column, row| row * columns + column)
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

/// The most points told for an entry by [`inside`].
const POINTS: usize = 32;
/// A point lies well inside where its patch is so wide, compared to the entry's widest place.
const WELL: f64 = 0.55;

/// For each entry points well inside of what shows it, spread over it: (column, row).
pub(super) fn inside(columns: usize, entries: &[Option<usize>], count: usize) -> Vec<Vec<(f64, f64)>> {
    let rows = entries.len().checked_div(columns).unwrap_or(0);
    let across = runs(entries, rows, columns, |row, column| row * columns + column);
    let along = runs(entries, columns, rows, |column, row| row * columns + column);
    let width = |cell: usize| across[cell].1.min(along[cell].1);
    let mut widest = vec![0; count];
    for (cell, entry) in entries.iter().enumerate() {
        if let Some(most) = entry.and_then(|entry| widest.get_mut(entry)) {
            *most = width(cell).max(*most);
        }
    }
    let mut points: Vec<Vec<(f64, f64)>> = vec![Vec::new(); count];
    for (cell, entry) in entries.iter().enumerate() {
        let Some(entry) = entry.filter(|entry| *entry < count) else { continue };
        let is_middle = across[cell].0 || along[cell].0;
        if is_middle && width(cell) as f64 >= WELL * widest[entry] as f64 {
            points[entry].push(((cell % columns) as f64 + 0.5, (cell / columns) as f64 + 0.5));
        }
    }
    for own in &mut points {
        let every = own.len().div_ceil(POINTS).max(1);
        *own = own.iter().copied().step_by(every).collect();
    }
    points
}

/// For each cell whether it is the middle of its run of equal cells in a line, and the length of the run.
fn runs(
    entries: &[Option<usize>],
    lines: usize,
    length: usize,
    cell: impl Fn(usize, usize) -> usize,
) -> Vec<(bool, usize)> {
    let mut runs = vec![(false, 0); entries.len()];
    for line in 0..lines {
        let mut from = 0;
        while from < length {
            let same = |at: &usize| entries[cell(line, *at)] == entries[cell(line, from)];
            let to = from + (from..length).take_while(same).count();
            for at in from..to {
                runs[cell(line, at)] = (at == usize::midpoint(from, to), to - from);
            }
            from = to;
        }
    }
    runs
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
    fn patches_that_meet_in_a_narrow_place_fall_apart() {
        let (a, b) = (Some(0), Some(1));
        #[rustfmt::skip]
        let entries = [
            a, a, a, b, b, b,
            a, a, a, b, b, b,
            a, a, a, a, a, a,
            b, b, b, a, a, a,
            b, b, b, a, a, a,
        ];
        assert_eq!(patches(6, &entries).1, [0, 1, 1]);
        let (patch, shown) = patches(6, &thinned(6, &entries, 1));
        assert_eq!(shown, [0, 1, 0, 1]);
        assert_eq!([patch[0], patch[5], patch[29], patch[24]], [Some(0), Some(1), Some(2), Some(3)]);
    }

    #[test]
    fn points_inside_keep_to_the_wide_part() {
        let (a, b) = (Some(0), Some(1));
        #[rustfmt::skip]
        let entries = [
            a, a, a, b, b,
            a, a, a, b, b,
            a, a, a, b, b,
            b, a, b, b, b,
        ];
        let points = inside(5, &entries, 2);
        assert!(points[0].contains(&(1.5, 1.5)) && !points[0].contains(&(1.5, 3.5)), "{points:?}");
        assert!(points[1].iter().all(|(column, _)| *column > 3.0), "{points:?}");
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
