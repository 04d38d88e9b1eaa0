//! Birkhoff's normal form to degree six, for where Arnold's determinant vanishes.
//!
//! In the coordinates of [`normal_form`](super::normal_form), let {G₃, H₂} = H₃. Then exp{·, G₃} leaves
//!
//! H₄′ = H₄ + ½{H₃, G₃}, H₆′ = H₆ + {H₅ + ½{H₄, G₃} + ⅛{{H₃, G₃}, G₃}, G₃}
//!
//! and a generating function G₄ that removes from H₄′ all but its terms in the actions leaves those of H₆′ + ½{H₄′,
//! G₄}. Removing H₅′ changes only higher degrees.

use bifdiag_numbers::enclosure::Enclosure;

use super::complex::Complex;
use super::modes::{CONJUGATE, ModePair, coefficient_in_modes, in_modes, linear_forms};
use super::normal_form::{bracket, divided};
use super::series::{Exponents, HIGHEST, Homogeneous, Series, of_degree, place_in_degree};

/// The coefficients of a homogeneous polynomial in z₁, z₂, z̄₁, z̄₂.
#[derive(Clone)]
struct InModes<E> {
    degree: usize,
    values: Vec<Complex<E>>,
}

/// Those of I₁³, I₁²I₂, I₁I₂² and I₂³, by the power of I₁.
const CUBES: [Exponents; 4] = [[0, 3, 0, 3], [1, 2, 1, 2], [2, 1, 2, 1], [3, 0, 3, 0]];

/// D₆: the terms of degree six of the normal form at I₁ = ω₂, I₂ = ω₁, where H₂ vanishes if the energies of the modes have
/// opposite signs. `None` where the enclosures do not exclude all resonances k₁ω₁ = k₂ω₂ of order k₁ + k₂ ≤ 6.
#[must_use]
pub fn sixth<E: Enclosure>(hamiltonian: &Series<E, HIGHEST>, b: &E, c: &E, precision: E::Precision) -> Option<E> {
    let pair = ModePair::new(hamiltonian, b, c, precision)?;
    let work = Work { pair: &pair, precision };
    if !work.is_without_resonance() {
        return None;
    }
    let forms = linear_forms(&pair.modes, precision);
    let [h3, h4, h5] = [3, 4, 5].map(|degree| {
        let real = Homogeneous::composed(hamiltonian, degree, &forms, |_| true);
        InModes { degree, values: in_modes(real.as_ref(), degree, precision) }
    });
    let h6 = Homogeneous::composed(hamiltonian, 6, &forms, |powers| (powers[0] + powers[CONJUGATE]).is_multiple_of(2));
    let over = |n| E::small(1, precision) / E::small(n, precision);
    let g3 = work.generator(&h3);
    let [by_h3, by_h4] = [work.bracket(&h3, &g3), work.bracket(&h4, &g3)];
    let fifth = h5.plus(&by_h4, &over(2)).plus(&work.bracket(&by_h3, &g3), &over(8));
    let fourth = h4.plus(&by_h3, &over(2));
    let g4 = work.generator(&fourth);
    let rest = |powers: Exponents| {
        coefficient_in_modes(h6.as_ref(), powers, precision).re
            + work.coefficient(&fifth, &g3, powers).re
            + work.coefficient(&fourth, &g4, powers).re * over(2)
    };
    // z_jz̄_j = I_j over 2ω_j|n_j|.
    let actions = pair.actions(precision);
    let ratios = [0, 1].map(|j| pair.omega[1 - j].clone() / actions[j].clone());
    let power = |j: usize, n: u8| (0..n).fold(E::small(1, precision), |product, _| product * ratios[j].clone());
    let terms = CUBES.map(|powers| rest(powers) * power(0, powers[0]) * power(1, powers[1]));
    terms.into_iter().reduce(|sum, term| sum + term)
}

struct Work<'a, E: Enclosure> {
    pair: &'a ModePair<E>,
    precision: E::Precision,
}

impl<E: Enclosure> Work<'_, E> {
    fn is_without_resonance(&self) -> bool {
        let mut higher = (3..=HIGHEST).flat_map(of_degree).filter(|powers| !is_in_actions(powers));
        higher.all(|powers| self.pair.frequency(&powers, self.precision).strict_sign().is_some())
    }

    /// G with {G, H₂} equal to all terms but those in the actions: coefficients over i⟨ω, a − b⟩.
    fn generator(&self, of: &InModes<E>) -> InModes<E> {
        let zero = || E::small(0, self.precision);
        let divided = |(powers, value): (Exponents, &Complex<E>)| {
            if is_in_actions(&powers) {
                return Complex { re: zero(), im: zero() };
            }
            let inverse = E::small(1, self.precision) / self.pair.frequency(&powers, self.precision);
            let Complex { re, im } = value.scaled(&inverse);
            Complex { re: im, im: -re }
        };
        InModes { degree: of.degree, values: of_degree(of.degree).zip(&of.values).map(divided).collect() }
    }

    /// The Poisson bracket. Its coefficient at a conjugate is the conjugate.
    fn bracket(&self, left: &InModes<E>, right: &InModes<E>) -> InModes<E> {
        let degree = left.degree + right.degree - 2;
        let mut values: Vec<Complex<E>> = Vec::with_capacity(of_degree(degree).len());
        for [a, b, c, d] in of_degree(degree) {
            let known = place_in_degree(&[c, d, a, b]).and_then(|place| values.get(place)).map(Complex::conjugate);
            values.push(known.unwrap_or_else(|| self.coefficient(left, right, [a, b, c, d])));
        }
        InModes { degree, values }
    }

    /// The coefficient of a monomial in a Poisson bracket, with {z_j, z̄_j} = i/(2ω_jn_j).
    fn coefficient(&self, left: &InModes<E>, right: &InModes<E>, wanted: Exponents) -> Complex<E> {
        let small = |value| E::small(value, self.precision);
        let mut sum = Complex { re: small(0), im: small(0) };
        for j in 0..CONJUGATE {
            let mut product = wanted;
            product[j] += 1;
            product[j + CONJUGATE] += 1;
            let mut part = Complex { re: small(0), im: small(0) };
            for (p, x) in of_degree(left.degree).zip(&left.values).filter(|(_, x)| !x.is_zero()) {
                let Some(q) = divided(product, p) else { continue };
                let (times, y) = (bracket(p, q, j), right.at(q));
                if times != 0 && !y.is_zero() {
                    part = part + (x.clone() * y.clone()).scaled(&small(times));
                }
            }
            let Complex { re, im } = part.scaled(&(small(1) / self.pair.bracket(j, self.precision)));
            sum = sum + Complex { re: -im, im: re };
        }
        sum
    }
}

impl<E: Enclosure> InModes<E> {
    fn plus(mut self, other: &Self, factor: &E) -> Self {
        for (sum, value) in self.values.iter_mut().zip(&other.values) {
            *sum = sum.clone() + value.scaled(factor);
        }
        self
    }

    fn at(&self, powers: Exponents) -> &Complex<E> {
        &self.values[place_in_degree(&powers).unwrap_or_default()]
    }
}

/// A monomial in z₁z̄₁ and z₂z̄₂.
fn is_in_actions(powers: &Exponents) -> bool {
    (0..CONJUGATE).all(|j| powers[j] == powers[j + CONJUGATE])
}
