//! Small linear systems in the six coordinates of phase space.

/// Dimension of phase space.
pub(super) const N: usize = 6;

/// A point or a direction of phase space.
pub(super) type PhaseVector = [f64; N];

pub(super) fn inner(u: &PhaseVector, v: &PhaseVector) -> f64 {
    u.iter().zip(v).map(|(a, b)| a * b).sum()
}

/// u + c v.
pub(super) fn along(u: &PhaseVector, c: f64, v: &PhaseVector) -> PhaseVector {
    std::array::from_fn(|i| u[i] + c * v[i])
}

pub(super) fn length(u: &PhaseVector) -> f64 {
    inner(u, u).sqrt()
}

/// The solution of six equations `rows`·x = `rhs` by elimination with partial pivoting of equilibrated rows; `None`
/// where they are singular to rounding.
pub(super) fn solve(mut rows: [PhaseVector; N], mut rhs: [f64; N]) -> Option<PhaseVector> {
    for (row, value) in rows.iter_mut().zip(&mut rhs) {
        let size = length(row);
        if size == 0.0 || !size.is_finite() {
            return None;
        }
        *row = row.map(|entry| entry / size);
        *value /= size;
    }
    for column in 0..N {
        let pivot = (column..N).max_by(|&i, &j| rows[i][column].abs().total_cmp(&rows[j][column].abs()))?;
        rows.swap(column, pivot);
        rhs.swap(column, pivot);
        if rows[column][column].abs() < 1e-13 {
            return None;
        }
        for row in column + 1..N {
            let factor = rows[row][column] / rows[column][column];
            rows[row] = along(&rows[row], -factor, &rows[column]);
            rhs[row] -= factor * rhs[column];
        }
    }
    let mut x = [0.0; N];
    for row in (0..N).rev() {
        let known: f64 = (row + 1..N).map(|column| rows[row][column] * x[column]).sum();
        x[row] = (rhs[row] - known) / rows[row][row];
    }
    Some(x)
}

/// The unit vector, up to its sign, on which five equations vanish; `None` where there is more than one.
pub(super) fn null_vector(rows: &[PhaseVector; N - 1]) -> Option<PhaseVector> {
    let mut rows = *rows;
    let mut columns: [usize; N] = std::array::from_fn(|i| i);
    for row in &mut rows {
        let size = length(row);
        if size == 0.0 || !size.is_finite() {
            return None;
        }
        *row = row.map(|entry| entry / size);
    }
    for step in 0..N - 1 {
        let places = (step..N - 1).flat_map(|row| (step..N).map(move |column| (row, column)));
        let (row, column) =
            places.max_by(|&(i, j), &(k, m)| rows[i][columns[j]].abs().total_cmp(&rows[k][columns[m]].abs()))?;
        rows.swap(step, row);
        columns.swap(step, column);
        let pivot = rows[step][columns[step]];
        if pivot.abs() < 1e-13 {
            return None;
        }
        for below in step + 1..N - 1 {
            let factor = rows[below][columns[step]] / pivot;
            rows[below] = along(&rows[below], -factor, &rows[step]);
        }
    }
    let mut x = [0.0; N];
    x[columns[N - 1]] = 1.0;
    for step in (0..N - 1).rev() {
        let known: f64 = (step + 1..N).map(|place| rows[step][columns[place]] * x[columns[place]]).sum();
        x[columns[step]] = -known / rows[step][columns[step]];
    }
    let size = length(&x);
    Some(x.map(|entry| entry / size))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Entries in (−1, 1) without a pattern.
    fn entries(seed: u32) -> impl FnMut() -> f64 {
        let mut state = seed;
        move || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            f64::from(state >> 8) / f64::from(1_u32 << 23) - 1.0
        }
    }

    #[test]
    fn planted_solutions_are_found() {
        for seed in 0..50 {
            let mut next = entries(seed);
            let rows: [PhaseVector; N] = std::array::from_fn(|_| std::array::from_fn(|_| next()));
            let planted: PhaseVector = std::array::from_fn(|_| next());
            let found = solve(rows, rows.each_ref().map(|row| inner(row, &planted))).unwrap();
            assert!(length(&along(&found, -1.0, &planted)) < 1e-10);
        }
    }

    #[test]
    fn null_vectors_vanish_on_every_row() {
        for seed in 0..50 {
            let mut next = entries(seed);
            let rows: [PhaseVector; N - 1] = std::array::from_fn(|_| std::array::from_fn(|_| next()));
            let null = null_vector(&rows).unwrap();
            assert!((length(&null) - 1.0).abs() < 1e-14);
            assert!(rows.iter().all(|row| inner(row, &null).abs() < 1e-12));
        }
    }

    #[test]
    fn dependent_equations_have_no_single_answer() {
        let mut next = entries(7);
        let mut rows: [PhaseVector; N - 1] = std::array::from_fn(|_| std::array::from_fn(|_| next()));
        rows[4] = along(&rows[0], -0.5, &rows[2]);
        assert_eq!(null_vector(&rows), None);
    }
}
