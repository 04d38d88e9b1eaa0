//! Arnold's determinant without eigenvectors: a rational function of the Taylor coefficients of the Hamiltonian (Theorem
//! 13.10 of docs/algorithms.md).
//!
//! Let H₂ = ½⟨x, Sx⟩, M = J S, F = ½⟨Mx, SMx⟩, LG = ⟨∇G, Mx⟩ and LG₃ = H₃. With B(p, q) = p(J∂)q
//!
//! 4c(b² − 4c) D₄ = B((b² + 2c)F² − 2b(b² − c)FH₂ + (b⁴ − 4b²c + 6c²)H₂², H₄ + ½{H₃, G₃}),
//!
//! which stays finite at ω₁ = ω₂.

use bifdiag_numbers::Sign;
use bifdiag_numbers::enclosure::Enclosure;

use super::series::{Exponents, Series, VARIABLES, add, of_degree};

type Matrix<E> = [[E; VARIABLES]; VARIABLES];

/// c(b² − 4c) D₄; `None` where the enclosures do not show that LG₃ = H₃ has a solution: at ω₁ = 2ω₂ and at c = 0.
#[must_use]
pub fn arnold_numerator<E: Enclosure>(hamiltonian: &Series<E>, b: &E, c: &E, precision: E::Precision) -> Option<E> {
    let small = |value| E::small(value, precision);
    let s = hessian(hamiltonian, precision);
    // ẋ = Mx: q̇ = H_p, ṗ = −H_q.
    let [p, q, r, t] = s.clone();
    let m = [r, t, p.map(|x| -x), q.map(|x| -x)];
    let generator = generator(hamiltonian, &m, precision)?;
    let whole = |power: u8| small(i32::from(power));
    let cubic = Series::of(hamiltonian.terms(3).map(|(powers, value)| (powers, value.clone())));
    let mut rest = Series::of(hamiltonian.terms(4).map(|(powers, value)| (powers, value.clone())));
    let half = small(1) / small(2);
    for k in 0..2 {
        let by = |series: &Series<E>, variable: usize| series.derivative(variable, whole);
        let forward = by(&cubic, k).times(&by(&generator, k + 2));
        let backward = by(&cubic, k + 2).times(&by(&generator, k)).scaled(&small(-1));
        rest = rest.plus(forward.plus(backward).scaled(&half));
    }
    let sm = product(&s, &m, precision);
    let transposed: Matrix<E> = std::array::from_fn(|i| std::array::from_fn(|j| m[j][i].clone()));
    let f = turned(&product(&transposed, &sm, precision));
    let h = turned(&s);
    let (by_f, by_h) = (contracted(&rest, &f, precision), contracted(&rest, &h, precision));
    let scalar = |series: &Series<E>, form: &Matrix<E>| {
        let value = contracted(series, form, precision);
        value.coefficient([0; VARIABLES]).cloned().unwrap_or_else(|| small(0))
    };
    let (ff, fh, hh) = (scalar(&by_f, &f), scalar(&by_f, &h), scalar(&by_h, &h));
    let (b2, c2) = (b.square(), c.square());
    let sum = (b2.clone() + small(2) * c.clone()) * ff - small(2) * b.clone() * (b2.clone() - c.clone()) * fh
        + (b2.square() - small(4) * b2 * c.clone() + small(6) * c2) * hh;
    Some(sum / small(4))
}

/// H″ at the origin.
pub(super) fn hessian<E: Enclosure, const D: usize>(hamiltonian: &Series<E, D>, precision: E::Precision) -> Matrix<E> {
    std::array::from_fn(|a| {
        std::array::from_fn(|b| {
            let mut powers = [0; VARIABLES];
            powers[a] += 1;
            powers[b] += 1;
            let value = hamiltonian.coefficient(powers).cloned().unwrap_or_else(|| E::small(0, precision));
            if a == b { value * E::small(2, precision) } else { value }
        })
    })
}

fn product<E: Enclosure>(left: &Matrix<E>, right: &Matrix<E>, precision: E::Precision) -> Matrix<E> {
    std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            (0..VARIABLES).fold(E::small(0, precision), |sum, k| sum + left[i][k].clone() * right[k][j].clone())
        })
    })
}

/// The form of x ↦ ½⟨Jx, SJx⟩, J(q, p) = (p, −q).
fn turned<E: Enclosure>(form: &Matrix<E>) -> Matrix<E> {
    let turn = |k: usize| (k + 2) % VARIABLES;
    std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let value = form[turn(i)][turn(j)].clone();
            if (i < 2) == (j < 2) { value } else { -value }
        })
    })
}

/// ½ Σ form_ij ∂_i ∂_j of a series.
fn contracted<E: Enclosure>(series: &Series<E>, form: &Matrix<E>, precision: E::Precision) -> Series<E> {
    let half = E::small(1, precision) / E::small(2, precision);
    let mut terms: Vec<(Exponents, E)> = Vec::new();
    for (powers, value) in (2..=4).flat_map(|degree| series.terms(degree)) {
        for i in 0..VARIABLES {
            for j in i..VARIABLES {
                let mut lower = powers;
                let first = i32::from(lower[i]);
                lower[i] = lower[i].wrapping_sub(1);
                let second = i32::from(lower[j]);
                lower[j] = lower[j].wrapping_sub(1);
                if first <= 0 || second <= 0 || (i == j && first < 2) {
                    continue;
                }
                let factor = E::small(first * second, precision) * form[i][j].clone() * value.clone();
                terms.push((lower, if i == j { factor * half.clone() } else { factor }));
            }
        }
    }
    Series::of(terms)
}

/// G₃ with LG₃ = H₃.
fn generator<E: Enclosure>(hamiltonian: &Series<E>, m: &Matrix<E>, precision: E::Precision) -> Option<Series<E>> {
    let monomials: Vec<Exponents> = of_degree(3).collect();
    let size = monomials.len();
    let place = |wanted: Exponents| monomials.iter().position(|powers| *powers == wanted);
    // The right side is the last column.
    let mut rows: Vec<Row<E>> = vec![vec![None; size + 1]; size];
    for (column, powers) in monomials.iter().enumerate() {
        for i in (0..VARIABLES).filter(|&i| powers[i] > 0) {
            for j in 0..VARIABLES {
                let mut image = *powers;
                image[i] -= 1;
                image[j] += 1;
                let value = E::small(i32::from(powers[i]), precision) * m[i][j].clone();
                if value.sign() != Some(Sign::Zero) {
                    add(&mut rows[place(image)?][column], value);
                }
            }
        }
    }
    for (row, powers) in rows.iter_mut().zip(&monomials) {
        row[size] = hamiltonian.coefficient(*powers).cloned();
    }
    let solution = solved(preconditioned(&rows, precision)?, precision)?;
    Some(Series::of(monomials.into_iter().zip(solution).filter_map(|(powers, value)| Some((powers, value?)))))
}

/// A row of linear equations; what is known to vanish is `None`.
type Row<E> = Vec<Option<E>>;

/// The equations times an approximate inverse: elimination of what is nearly the identity widens nothing.
fn preconditioned<E: Enclosure>(rows: &[Row<E>], precision: E::Precision) -> Option<Vec<Row<E>>> {
    let size = rows.len();
    let middle = |entry: &Option<E>| {
        entry.as_ref().map_or(0.0, |value| {
            let [lo, hi] = value.bounds();
            lo + 0.5 * (hi - lo)
        })
    };
    let inverse = inverted(rows.iter().map(|row| row[..size].iter().map(middle).collect()).collect())?;
    let mut product: Vec<Row<E>> = vec![vec![None; size + 1]; size];
    for (sums, factors) in product.iter_mut().zip(&inverse) {
        for (row, &factor) in rows.iter().zip(factors) {
            let factor = E::double(factor, precision);
            for (sum, entry) in sums.iter_mut().zip(row) {
                if let Some(entry) = entry {
                    add(sum, factor.clone() * entry.clone());
                }
            }
        }
    }
    Some(product)
}

/// The inverse of a matrix, in floats.
fn inverted(mut rows: Vec<Vec<f64>>) -> Option<Vec<Vec<f64>>> {
    let size = rows.len();
    for (k, row) in rows.iter_mut().enumerate() {
        row.extend((0..size).map(|j| if j == k { 1.0 } else { 0.0 }));
    }
    for column in 0..size {
        let pivot = (column..size).max_by(|&i, &j| rows[i][column].abs().total_cmp(&rows[j][column].abs()))?;
        rows.swap(column, pivot);
        let known: Vec<f64> = rows[column].iter().map(|value| value / rows[column][column]).collect();
        for (k, row) in rows.iter_mut().enumerate() {
            let factor = row[column];
            if k == column {
                row.clone_from(&known);
            } else if factor != 0.0 {
                row.iter_mut().zip(&known).for_each(|(value, other)| *value -= factor * other);
            }
        }
    }
    Some(rows.into_iter().map(|row| row[size..].to_vec()).collect())
}

/// The solution of equations with a matrix near the identity.
fn solved<E: Enclosure>(mut rows: Vec<Row<E>>, precision: E::Precision) -> Option<Row<E>> {
    let size = rows.len();
    for column in 0..size {
        let (above, below) = rows.split_at_mut(column + 1);
        let known = &above[column];
        let pivot = known[column].clone().filter(|value| value.sign() == Some(Sign::Positive))?;
        let inverse = E::small(1, precision) / pivot;
        for row in below {
            let Some(value) = row[column].take() else { continue };
            let factor = value * inverse.clone();
            for (entry, other) in row.iter_mut().zip(known).skip(column + 1) {
                if let Some(other) = other {
                    add(entry, -(factor.clone() * other.clone()));
                }
            }
        }
    }
    let mut solution: Row<E> = vec![None; size];
    for row in (0..size).rev() {
        let mut value = rows[row][size].take();
        for column in row + 1..size {
            if let (Some(entry), Some(known)) = (&rows[row][column], &solution[column]) {
                add(&mut value, -(entry.clone() * known.clone()));
            }
        }
        solution[row] = match value {
            Some(value) => Some(value / rows[row][row].clone()?),
            None => None,
        };
    }
    Some(solution)
}
