//! Birkhoff's normal form to degree six, for where Arnold's determinant vanishes.
//!
//! In the coordinates of [`normal_form`](super::normal_form), let {G₃, H₂} = H₃. Then exp{·, G₃} leaves
//!
//! H₄′ = H₄ + ½{H₃, G₃}, H₆′ = H₆ + {H₅, G₃} + ½{{H₄, G₃}, G₃} + ⅛{{{H₃, G₃}, G₃}, G₃}
//!
//! and a generating function G₄ that takes away from H₄′ all but its terms in the actions leaves those of H₆′ + ½{H₄′, G₄}. What
//! takes H₅′ away changes only higher degrees.

use bifdiag_numbers::enclosure::Enclosure;

use super::complex::Complex;
use super::modes::{CONJUGATE, ModePair, in_modes, linear_forms};
use super::normal_form::bracket;
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
/// opposite signs. `None` where the enclosures do not tell that no resonance k₁ω₁ = k₂ω₂ of order k₁ + k₂ ≤ 6 holds.
#[must_use]
pub fn sixth<E: Enclosure>(hamiltonian: &Series<E, HIGHEST>, b: &E, c: &E, precision: E::Precision) -> Option<E> {
    let pair = ModePair::new(hamiltonian, b, c, precision)?;
    let work = Work { pair: &pair, precision };
    if !work.is_without_resonance() {
        return None;
    }
    let forms = linear_forms(&pair.modes, precision);
    let [h3, h4, h5, h6] = [3, 4, 5, 6].map(|degree| {
        let real = Homogeneous::composed(hamiltonian, degree, &forms, |_| true);
        InModes { degree, values: in_modes(real.as_ref(), degree, precision) }
    });
    let over = |n| E::small(1, precision) / E::small(n, precision);
    let g3 = work.generator(&h3);
    let [by_h3, by_h4] = [work.bracket(&h3, &g3), work.bracket(&h4, &g3)];
    let h4 = h4.plus(&by_h3, &over(2));
    let twice = work.bracket(&by_h3, &g3);
    let rest = h6
        .plus(&work.bracket(&h5, &g3), &over(1))
        .plus(&work.bracket(&by_h4, &g3), &over(2))
        .plus(&work.bracket(&twice, &g3), &over(8))
        .plus(&work.bracket(&h4, &work.generator(&h4)), &over(2));
    // z_jz̄_j = I_j over 2ω_j|n_j|.
    let actions = pair.actions(precision);
    let ratios = [0, 1].map(|j| pair.omega[1 - j].clone() / actions[j].clone());
    let power = |j: usize, n: u8| (0..n).fold(E::small(1, precision), |product, _| product * ratios[j].clone());
    let terms = CUBES.map(|powers| rest.at(powers).re.clone() * power(0, powers[0]) * power(1, powers[1]));
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

    /// The Poisson bracket, with {z_j, z̄_j} = i/(2ω_jn_j).
    fn bracket(&self, left: &InModes<E>, right: &InModes<E>) -> InModes<E> {
        let degree = left.degree + right.degree - 2;
        let zero = || E::small(0, self.precision);
        let mut values: Vec<_> = of_degree(degree).map(|_| Complex { re: zero(), im: zero() }).collect();
        let inverse = [0, 1].map(|j| E::small(1, self.precision) / self.pair.bracket(j, self.precision));
        let known = |of: &InModes<E>| -> Vec<(Exponents, Complex<E>)> {
            let terms = of_degree(of.degree).zip(of.values.iter().cloned());
            terms.filter(|(_, value)| !value.is_zero()).collect()
        };
        let right = known(right);
        for (p, x) in known(left) {
            for (q, y) in &right {
                let product = x.clone() * y.clone();
                for j in 0..CONJUGATE {
                    let times = bracket(p, *q, j);
                    if times == 0 {
                        continue;
                    }
                    let mut powers: Exponents = std::array::from_fn(|k| p[k] + q[k]);
                    powers[j] -= 1;
                    powers[j + CONJUGATE] -= 1;
                    let Some(place) = place_in_degree(&powers) else { continue };
                    let scale = E::small(times, self.precision) * inverse[j].clone();
                    let sum = &mut values[place];
                    sum.re = sum.re.clone() - product.im.clone() * scale.clone();
                    sum.im = sum.im.clone() + product.re.clone() * scale;
                }
            }
        }
        InModes { degree, values }
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
