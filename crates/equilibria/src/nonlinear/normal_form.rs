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
use super::series::{Exponents, Series, VARIABLES, degree};

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

        let cubic = in_modes(hamiltonian, 3, &modes, precision);
        let quartic = in_modes(hamiltonian, 4, &modes, precision);
        let zero = Complex { re: small(0), im: small(0) };
        // i G₃; a term that is known to vanish has no share in it, resonant or not.
        let terms = cubic.terms(3).filter(|(_, value)| !value.is_zero());
        let generator = Series::of(terms.map(|(powers, value)| {
            let frequency = (0..2).fold(small(0), |sum, j| {
                let winding = i32::from(powers[j]) - i32::from(powers[j + CONJUGATE]);
                sum + small(winding) * omega[j].clone()
            });
            let inverse = Complex { re: small(1) / frequency, im: small(0) };
            (powers, value.clone() * inverse)
        }));
        let whole = |power: u8| Complex { re: small(i32::from(power)), im: small(0) };
        let mut rest = quartic;
        for j in 0..2 {
            let by = |series: &Series<Complex<E>>, variable: usize| series.derivative(variable, whole);
            let bracket = by(&cubic, j).times(&by(&generator, j + CONJUGATE)).plus(
                &by(&cubic, j + CONJUGATE).times(&by(&generator, j)).scaled(&Complex { re: small(-1), im: small(0) }),
            );
            // ½ · 1/(2ω_j n_j)
            let factor = small(1) / (small(4) * omega[j].clone() * modes[j].energy.clone());
            rest = rest.plus(&bracket.scaled(&Complex { re: factor, im: small(0) }));
        }
        let at = |powers: Exponents| rest.coefficient(powers).unwrap_or(&zero).re.clone();
        let coefficients = [at([2, 0, 2, 0]), at([1, 1, 1, 1]), at([0, 2, 0, 2])];
        let action = |j: usize| {
            let size = small(2) * omega[j].clone() * modes[j].energy.clone();
            if signs[j] == Sign::Negative { -size } else { size }
        };
        let (first, second) = (action(0), action(1));
        let [k11, k12, k22] = coefficients;
        let twist = [k11 / first.square(), k12 / (first.clone() * second.clone()), k22 / second.square()];
        // 2|c| |z₁| |z₂|ⁿ with |z_j|² = I_j/(2ω_j|n_j|).
        let resonant = |series: &Series<Complex<E>>, powers: Exponents, scale: E| {
            let value = series.coefficient(powers).unwrap_or(&zero);
            small(4) * (value.re.square() + value.im.square()) / scale
        };
        let cubic = resonant(&cubic, [1, 0, 0, 2], first.clone() * second.square());
        let quartic = resonant(&rest, [1, 0, 0, 3], first * second.square() * second);
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

/// H″ at the origin.
fn hessian<E: Enclosure>(hamiltonian: &Series<E>, precision: E::Precision) -> [[E; VARIABLES]; VARIABLES] {
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

/// The terms of one degree in the coordinates z₁, z₂, z̄₁, z̄₂.
fn in_modes<E: Enclosure>(
    hamiltonian: &Series<E>,
    wanted: usize,
    modes: &[Mode<E>; 2],
    precision: E::Precision,
) -> Series<Complex<E>> {
    let zero = || E::small(0, precision);
    // x_a as a linear form.
    let form: [Series<Complex<E>>; VARIABLES] = std::array::from_fn(|a| {
        Series::of((0..VARIABLES).map(|k| {
            let mut powers = [0; VARIABLES];
            powers[k] = 1;
            let part = &modes[k % CONJUGATE].vector[a];
            (powers, if k < CONJUGATE { part.clone() } else { part.conjugate() })
        }))
    });
    let mut products: Vec<(Exponents, Series<Complex<E>>)> = Vec::new();
    let mut sum = Series::of([]);
    for (powers, value) in hamiltonian.terms(wanted) {
        let product = product_of(powers, &form, &mut products);
        sum = sum.plus(&product.scaled(&Complex { re: value.clone(), im: zero() }));
    }
    sum
}

/// The product of linear forms with these powers; those of lower degree are kept.
fn product_of<E: Enclosure>(
    powers: Exponents,
    form: &[Series<Complex<E>>; VARIABLES],
    known: &mut Vec<(Exponents, Series<Complex<E>>)>,
) -> Series<Complex<E>> {
    if let Some((_, product)) = known.iter().find(|(other, _)| *other == powers) {
        return product.clone();
    }
    let Some(last) = (0..VARIABLES).rev().find(|&a| powers[a] > 0) else { return Series::of([]) };
    if degree(&powers) == 1 {
        return form[last].clone();
    }
    let mut lower = powers;
    lower[last] -= 1;
    let product = product_of(lower, form, known).times(&form[last]);
    known.push((powers, product.clone()));
    product
}
