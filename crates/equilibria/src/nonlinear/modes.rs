//! The coordinates z_j = X_j + iY_j of the two modes of the linearised flow, x = Σ (z_j v_j + z̄_j v̄_j), and coefficients in them.

use bifdiag_numbers::Sign;
use bifdiag_numbers::enclosure::Enclosure;

use super::complex::Complex;
use super::determinant::hessian;
use super::series::{Exponents, HIGHEST, Homogeneous, Series, VARIABLES, of_degree, place_in_degree};

/// z₁, z₂, z̄₁, z̄₂ of a mode and its conjugate.
pub(super) const CONJUGATE: usize = 2;

/// A mode: the real and the imaginary part of its eigenvector, and n.
pub(super) struct Mode<E> {
    pub(super) vector: [Complex<E>; VARIABLES],
    pub(super) energy: E,
}

impl<E: Enclosure> Mode<E> {
    /// re v ⊗ re v + im v ⊗ im v by monomials of degree two, as a quadratic form.
    pub(super) fn squared(&self) -> Vec<E> {
        let entry = |powers: Exponents| {
            let mut of = (0..VARIABLES).flat_map(|k| std::iter::repeat_n(k, usize::from(powers[k])));
            let (i, j) = (of.next().unwrap_or_default(), of.next().unwrap_or_default());
            let [p, q] = [&self.vector[i], &self.vector[j]];
            let value = p.re.clone() * q.re.clone() + p.im.clone() * q.im.clone();
            if i == j { value } else { value.clone() + value }
        };
        of_degree(2).map(entry).collect()
    }

    /// The mode of frequency ω beside one whose squared frequency is `other`.
    pub(super) fn new(
        hessian: &[[E; VARIABLES]; VARIABLES],
        omega: &E,
        other: &E,
        precision: E::Precision,
    ) -> Option<Self> {
        let zero = || E::small(0, precision);
        let gradient = |x: &[E; VARIABLES]| -> [E; VARIABLES] {
            std::array::from_fn(|a| (0..VARIABLES).fold(zero(), |sum, b| sum + hessian[a][b].clone() * x[b].clone()))
        };
        let turned = |[a, b, c, d]: [E; VARIABLES]| [c, d, -a, -b];
        let flow = |x: &[E; VARIABLES]| turned(gradient(x));
        // The unit vector whose part in the plane is the largest.
        let candidates = (0..VARIABLES).map(|unit| {
            let one = E::small(1, precision);
            let mut y = flow(&turned(hessian.each_ref().map(|row| row[unit].clone() * one.clone())));
            y[unit] = y[unit].clone() + other.clone() * one;
            let slope = gradient(&y);
            let energy = (0..VARIABLES).fold(zero(), |sum, a| sum + y[a].clone() * slope[a].clone());
            (y, energy)
        });
        let size = |energy: &E| energy.bounds().into_iter().map(f64::abs).fold(f64::INFINITY, f64::min);
        let certain = candidates.filter(|(_, energy)| energy.strict_sign().is_some());
        let (y, energy) = certain.max_by(|p, q| size(&p.1).total_cmp(&size(&q.1)))?;
        let image = flow(&y);
        let vector = std::array::from_fn(|a| Complex { re: image[a].clone(), im: omega.clone() * y[a].clone() });
        Some(Self { vector, energy })
    }
}

/// Both modes, that of the larger frequency first.
pub(super) struct ModePair<E> {
    /// ω₁, ω₂ and their squares.
    pub(super) omega: [E; 2],
    pub(super) squares: [E; 2],
    pub(super) modes: [Mode<E>; 2],
    /// Of their energies.
    pub(super) signs: [Sign; 2],
}

impl<E: Enclosure> ModePair<E> {
    /// From a Hamiltonian and the coefficients of its λ⁴ + bλ² + c; `None` where the enclosures do not show that the
    /// pairs are imaginary, distinct, and of known energies.
    pub(super) fn new<const D: usize>(
        hamiltonian: &Series<E, D>,
        b: &E,
        c: &E,
        precision: E::Precision,
    ) -> Option<Self> {
        let discriminant = b.square() - E::small(4, precision) * c.clone();
        if [b, c, &discriminant].into_iter().any(|value| value.sign() != Some(Sign::Positive)) {
            return None;
        }
        let larger = (b.clone() + discriminant.sqrt()) / E::small(2, precision);
        let squares = [larger.clone(), c.clone() / larger];
        let omega = squares.each_ref().map(E::sqrt);
        let hessian = hessian(hamiltonian, precision);
        let mode = |j: usize| Mode::new(&hessian, &omega[j], &squares[1 - j], precision);
        let modes = [mode(0)?, mode(1)?];
        let signs = [modes[0].energy.strict_sign()?, modes[1].energy.strict_sign()?];
        Some(Self { omega, squares, modes, signs })
    }

    /// ⟨ω, a − b⟩ of the monomial z^a z̄^b.
    pub(super) fn frequency(&self, powers: &Exponents, precision: E::Precision) -> E {
        (0..CONJUGATE).fold(E::small(0, precision), |sum, j| {
            let winding = i32::from(powers[j]) - i32::from(powers[j + CONJUGATE]);
            sum + E::small(winding, precision) * self.omega[j].clone()
        })
    }

    /// 2ω_j n_j; {z_j, z̄_j} is i times its inverse.
    pub(super) fn bracket(&self, j: usize, precision: E::Precision) -> E {
        E::small(2, precision) * self.omega[j].clone() * self.modes[j].energy.clone()
    }

    /// 2ω_j |n_j|: the actions over |z_j|².
    pub(super) fn actions(&self, precision: E::Precision) -> [E; 2] {
        [0, 1].map(|j| match self.signs[j] {
            Sign::Negative => -self.bracket(j, precision),
            _ => self.bracket(j, precision),
        })
    }
}

/// x in the real coordinates X₁, X₂, Y₁, Y₂ of z_j = X_j + iY_j: z v + z̄ v̄ = 2X re v − 2Y im v.
pub(super) fn linear_forms<E: Enclosure>(modes: &[Mode<E>; 2], precision: E::Precision) -> [[E; VARIABLES]; VARIABLES] {
    std::array::from_fn(|a| {
        std::array::from_fn(|k| {
            let part = &modes[k % CONJUGATE].vector[a];
            let value = if k < CONJUGATE { part.re.clone() } else { -part.im.clone() };
            E::small(2, precision) * value
        })
    })
}

/// The coefficients of all monomials of one degree in z₁, z₂, z̄₁, z̄₂. That of a conjugate is the conjugate: the same
/// operations with other signs.
pub(super) fn in_modes<E: Enclosure>(
    real: Option<&Homogeneous<E>>,
    degree: usize,
    precision: E::Precision,
) -> Vec<Complex<E>> {
    let mut found: Vec<Complex<E>> = Vec::with_capacity(of_degree(degree).len());
    for [a, b, c, d] in of_degree(degree) {
        let known = place_in_degree(&[c, d, a, b]).and_then(|place| found.get(place)).map(Complex::conjugate);
        found.push(known.unwrap_or_else(|| coefficient_in_modes(real, [a, b, c, d], precision)));
    }
    found
}

/// The coefficient of a monomial in z₁, z₂, z̄₁, z̄₂, from X = (z + z̄)/2 and Y = (z − z̄)/(2i).
pub(super) fn coefficient_in_modes<E: Enclosure>(
    real: Option<&Homogeneous<E>>,
    wanted: Exponents,
    precision: E::Precision,
) -> Complex<E> {
    let zero = || E::small(0, precision);
    let mut sum = Complex { re: zero(), im: zero() };
    let whole = [0, 1].map(|j| wanted[j] + wanted[j + CONJUGATE]);
    for first in 0..=whole[0] {
        for second in 0..=whole[1] {
            // Powers of Y₁ and Y₂.
            let powers = [whole[0] - first, whole[1] - second, first, second];
            let Some(value) = real.and_then(|real| real.coefficient(powers)) else { continue };
            let share =
                |j: usize, y: u8| KRAWTCHOUK[usize::from(whole[j])][usize::from(y)][usize::from(wanted[j + CONJUGATE])];
            let count = share(0, first) * share(1, second);
            if count == 0 {
                continue;
            }
            let part = value.clone() * E::small(count, precision);
            // (1/i)ⁿ
            match (first + second) % 4 {
                0 => sum.re = sum.re + part,
                1 => sum.im = sum.im - part,
                2 => sum.re = sum.re - part,
                _ => sum.im = sum.im + part,
            }
        }
    }
    let scale = E::small(1, precision) / E::small(1 << (whole[0] + whole[1]), precision);
    sum.scaled(&scale)
}

/// The coefficient of z̄^k in (z + z̄)^(n−y) (z − z̄)^y, by n, y and k.
const KRAWTCHOUK: [[[i32; HIGHEST + 1]; HIGHEST + 1]; HIGHEST + 1] = {
    let mut table = [[[0; HIGHEST + 1]; HIGHEST + 1]; HIGHEST + 1];
    let mut n = 0;
    while n <= HIGHEST {
        let mut y = 0;
        while y <= n {
            table[n][y][0] = 1;
            let mut factor = 0;
            while factor < n {
                let mut k = factor + 1;
                while k > 0 {
                    let lower = table[n][y][k - 1];
                    table[n][y][k] += if factor < y { -lower } else { lower };
                    k -= 1;
                }
                factor += 1;
            }
            y += 1;
        }
        n += 1;
    }
    table
};
