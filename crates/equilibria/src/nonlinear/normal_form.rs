//! Birkhoff's normal form to degree four at an equilibrium with two imaginary pairs.
//!
//! Let M = J H″ be the linearised flow in canonical coordinates x = (q₁, q₂, p₁, p₂), with eigenvalues ±iω₁, ±iω₂. For
//! any vector e, y = (M² + ω₂²)e spans with My the plane of the first pair: M²y = −ω₁²y, and v = My + iω₁y is an
//! eigenvector of iω₁. In coordinates x = Σ (z_j v_j + z̄_j v̄_j) the brackets are {z_j, z̄_j} = i/(2ω_j n_j) with
//! n_j = ⟨y_j, H″y_j⟩, ż_j = iω_j z_j, and the actions I_j = 2ω_j |n_j| |z_j|², so that H = Σ ±ω_j I_j + … with the sign of
//! n_j. A generating function of degree three, with coefficients H₃/(i⟨ω, a − b⟩) at z^a z̄^b, takes away H₃, and of
//! degree four ½{H₃, G₃} + H₄ stays where a = b.

use bifdiag_numbers::Sign;
use bifdiag_numbers::enclosure::Enclosure;

use super::complex::Complex;
use super::determinant::hessian;
use super::series::{Exponents, Series, VARIABLES, degree, of_degree};

/// H = ±ω₁I₁ ± ω₂I₂ + K₁₁I₁² + K₁₂I₁I₂ + K₂₂I₂² + …, with ω₁ > ω₂ > 0.
#[derive(Clone, Debug)]
pub struct NormalForm<E> {
    /// ω₁ and ω₂.
    pub omega: [E; 2],
    /// The signs of the energies of the two modes (Krein signs).
    pub signs: [Sign; 2],
    /// K₁₁, K₁₂, K₂₂.
    pub twist: [E; 3],
    /// Arnold's determinant K₁₁ω₂² ∓ K₁₂ω₁ω₂ + K₂₂ω₁², the upper sign where the energies have one sign.
    pub arnold: E,
    /// C² of the term C √I₁ I₂ cos(φ₁ − 2φ₂ + …) of degree three, which stays at ω₁ = 2ω₂.
    pub cubic: E,
    /// B² of the term B √I₁ I₂^(3/2) cos(φ₁ − 3φ₂ + …) of degree four, which stays at ω₁ = 3ω₂.
    pub quartic: E,
}

/// z₁, z₂, z̄₁, z̄₂ of a mode and its conjugate.
const CONJUGATE: usize = 2;

/// A mode: the real and the imaginary part of its eigenvector, and n.
struct Mode<E> {
    vector: [Complex<E>; VARIABLES],
    energy: E,
}

impl<E: Enclosure> NormalForm<E> {
    /// From the Taylor series of a Hamiltonian in (q₁, q₂, p₁, p₂) and the coefficients of its λ⁴ + bλ² + c. `None` where
    /// the enclosures do not tell that the pairs are imaginary, distinct, and of certain energies. At ω₁ = 2ω₂ the twist is
    /// unbounded.
    #[must_use]
    pub fn new(hamiltonian: &Series<E>, b: &E, c: &E, precision: E::Precision) -> Option<Self> {
        let small = |value| E::small(value, precision);
        let discriminant = b.square() - small(4) * c.clone();
        if [b, c, &discriminant].into_iter().any(|value| value.sign() != Some(Sign::Positive)) {
            return None;
        }
        let larger = (b.clone() + discriminant.sqrt()) / small(2);
        let squares = [larger.clone(), c.clone() / larger];
        let omega = squares.each_ref().map(E::sqrt);
        let hessian = hessian(hamiltonian, precision);
        let mode = |j: usize| Mode::new(&hessian, &omega[j], &squares[1 - j], precision);
        let modes = [mode(0)?, mode(1)?];
        let signs = [modes[0].energy.strict_sign()?, modes[1].energy.strict_sign()?];

        let cubic = cubic_in_modes(&substituted(hamiltonian, 3, &modes, precision), precision);
        let quartic = substituted(hamiltonian, 4, &modes, precision);
        // i G₃; a term that is known to vanish has no share in it, resonant or not.
        let terms = cubic.iter().filter(|(_, value)| !value.is_zero());
        let generator: Vec<(Exponents, Complex<E>)> = terms
            .map(|(powers, value)| {
                let frequency = (0..2).fold(small(0), |sum, j| {
                    let winding = i32::from(powers[j]) - i32::from(powers[j + CONJUGATE]);
                    sum + small(winding) * omega[j].clone()
                });
                (*powers, value.scaled(&(small(1) / frequency)))
            })
            .collect();
        // ½ · 1/(2ω_j n_j)
        let factors: [E; 2] =
            std::array::from_fn(|j| small(1) / (small(4) * omega[j].clone() * modes[j].energy.clone()));
        let rest = |wanted: Exponents| {
            let mut sum = coefficient_in_modes(&quartic, wanted, precision);
            for (powers, value) in &cubic {
                for (others, other) in &generator {
                    for (j, factor) in factors.iter().enumerate() {
                        if let Some(n) = bracket(*powers, *others, j, wanted) {
                            let scale = factor.clone() * small(n);
                            sum = sum + (value.clone() * other.clone()).scaled(&scale);
                        }
                    }
                }
            }
            sum
        };
        let coefficients = [[2, 0, 2, 0], [1, 1, 1, 1], [0, 2, 0, 2]].map(|powers| rest(powers).re);
        let action = |j: usize| {
            let size = small(2) * omega[j].clone() * modes[j].energy.clone();
            if signs[j] == Sign::Negative { -size } else { size }
        };
        let (first, second) = (action(0), action(1));
        let [k11, k12, k22] = coefficients;
        let twist = [k11 / first.square(), k12 / (first.clone() * second.clone()), k22 / second.square()];
        // 2|c| |z₁| |z₂|ⁿ with |z_j|² = I_j/(2ω_j|n_j|).
        let square = |value: Complex<E>| small(4) * (value.re.square() + value.im.square());
        let resonant = cubic.iter().find(|(powers, _)| *powers == [1, 0, 0, 2]);
        let cubic = resonant.map_or_else(|| small(0), |(_, value)| square(value.clone()));
        let cubic = cubic / (first.clone() * second.square());
        let quartic = square(rest([1, 0, 0, 3])) / (first * second.square() * second);
        let mixed = twist[1].clone() * omega[0].clone() * omega[1].clone();
        let mixed = if signs[0] == signs[1] { -mixed } else { mixed };
        let arnold = twist[0].clone() * squares[1].clone() + mixed + twist[2].clone() * squares[0].clone();
        Some(Self { omega, signs, twist, arnold, cubic, quartic })
    }
}

impl<E: Enclosure> Mode<E> {
    /// The mode of frequency ω beside one whose squared frequency is `other`.
    fn new(hessian: &[[E; VARIABLES]; VARIABLES], omega: &E, other: &E, precision: E::Precision) -> Option<Self> {
        let zero = || E::small(0, precision);
        let gradient = |x: &[E; VARIABLES]| -> [E; VARIABLES] {
            std::array::from_fn(|a| (0..VARIABLES).fold(zero(), |sum, b| sum + hessian[a][b].clone() * x[b].clone()))
        };
        let flow = |x: &[E; VARIABLES]| {
            let [a, b, c, d] = gradient(x);
            [c, d, -a, -b]
        };
        // The unit vector whose part in the plane is the largest.
        let candidates = (0..VARIABLES).map(|unit| {
            let e: [E; VARIABLES] = std::array::from_fn(|a| E::small(i32::from(a == unit), precision));
            let twice = flow(&flow(&e));
            let y: [E; VARIABLES] = std::array::from_fn(|a| twice[a].clone() + other.clone() * e[a].clone());
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

/// The terms of one degree in the real coordinates X₁, X₂, Y₁, Y₂ of z_j = X_j + iY_j.
fn substituted<E: Enclosure>(
    hamiltonian: &Series<E>,
    wanted: usize,
    modes: &[Mode<E>; 2],
    precision: E::Precision,
) -> Series<E> {
    // x_a as a linear form: z v + z̄ v̄ = 2X re v − 2Y im v.
    let form: [Series<E>; VARIABLES] = std::array::from_fn(|a| {
        Series::of((0..VARIABLES).map(|k| {
            let mut powers = [0; VARIABLES];
            powers[k] = 1;
            let part = &modes[k % CONJUGATE].vector[a];
            let value = if k < CONJUGATE { part.re.clone() } else { -part.im.clone() };
            (powers, E::small(2, precision) * value)
        }))
    });
    let terms: Vec<(Exponents, E)> = hamiltonian.terms(wanted).map(|(powers, value)| (powers, value.clone())).collect();
    composed(&terms, &form)
}

/// A homogeneous polynomial of linear forms: its terms are divided by their last variable, and so on.
fn composed<E: Enclosure>(terms: &[(Exponents, E)], forms: &[Series<E>; VARIABLES]) -> Series<E> {
    let last = |powers: &Exponents| (0..VARIABLES).rev().find(|&a| powers[a] > 0);
    let mut sum = Series::of(terms.iter().filter(|(powers, _)| degree(powers) == 0).cloned());
    for (a, form) in forms.iter().enumerate() {
        let divided = terms.iter().filter(|(powers, _)| last(powers) == Some(a)).map(|(powers, value)| {
            let mut lower = *powers;
            lower[a] -= 1;
            (lower, value.clone())
        });
        let divided: Vec<(Exponents, E)> = divided.collect();
        if !divided.is_empty() {
            sum = sum.plus(&composed(&divided, forms).times(form));
        }
    }
    sum
}

/// All terms of degree three in z₁, z₂, z̄₁, z̄₂.
fn cubic_in_modes<E: Enclosure>(real: &Series<E>, precision: E::Precision) -> Vec<(Exponents, Complex<E>)> {
    of_degree(3).map(|powers| (powers, coefficient_in_modes(real, powers, precision))).collect()
}

/// The coefficient of a monomial in z₁, z₂, z̄₁, z̄₂, from X = (z + z̄)/2 and Y = (z − z̄)/(2i).
fn coefficient_in_modes<E: Enclosure>(real: &Series<E>, wanted: Exponents, precision: E::Precision) -> Complex<E> {
    let zero = || E::small(0, precision);
    let mut sum = Complex { re: zero(), im: zero() };
    let whole = [0, 1].map(|j| wanted[j] + wanted[j + CONJUGATE]);
    for first in 0..=whole[0] {
        for second in 0..=whole[1] {
            // Powers of Y₁ and Y₂.
            let powers = [whole[0] - first, whole[1] - second, first, second];
            let Some(value) = real.coefficient(powers) else { continue };
            let share = |j: usize, y: u8| krawtchouk(whole[j], y, wanted[j + CONJUGATE]);
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

/// The coefficient of z̄^k in (z + z̄)^(n−y) (z − z̄)^y.
fn krawtchouk(n: u8, y: u8, k: u8) -> i32 {
    let binomial = |n: u8, k: u8| (0..k).fold(1, |product, i| product * i32::from(n - i) / i32::from(i + 1));
    (0..=k.min(y))
        .filter(|&j| k - j <= n - y)
        .map(|j| {
            if j % 2 == 0 { binomial(y, j) * binomial(n - y, k - j) } else { -binomial(y, j) * binomial(n - y, k - j) }
        })
        .sum()
}

/// The factor of the product of two monomials in the bracket of mode j, if its powers are those wanted.
fn bracket(left: Exponents, right: Exponents, j: usize, wanted: Exponents) -> Option<i32> {
    let product: [u8; VARIABLES] = std::array::from_fn(|k| left[k] + right[k]);
    let fits = (0..VARIABLES).all(|k| product[k] == wanted[k] + u8::from(k == j || k == j + CONJUGATE));
    let power = |powers: Exponents, k: usize| i32::from(powers[k]);
    let factor = power(left, j) * power(right, j + CONJUGATE) - power(left, j + CONJUGATE) * power(right, j);
    (fits && factor != 0).then_some(factor)
}
