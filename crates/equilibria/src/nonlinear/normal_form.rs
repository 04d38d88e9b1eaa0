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
use super::series::{DEGREE, Exponents, Homogeneous, Series, VARIABLES, of_degree, place_in_degree};

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
    /// B² of the term B √I₁ I₂^(3/2) cos(φ₁ − 3φ₂ + …) of degree four, which stays at ω₁ = 3ω₂; where it was asked for.
    pub quartic: Option<E>,
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
    /// unbounded. Without the term that stays at ω₁ = 3ω₂.
    #[must_use]
    pub fn new(hamiltonian: &Series<E>, b: &E, c: &E, precision: E::Precision) -> Option<Self> {
        Some(Form::new(hamiltonian, b, c, precision, false)?.normal())
    }

    /// The same with the term that stays at ω₁ = 3ω₂.
    #[must_use]
    pub fn with_quartic(hamiltonian: &Series<E>, b: &E, c: &E, precision: E::Precision) -> Option<Self> {
        let form = Form::new(hamiltonian, b, c, precision, true)?;
        // 2|c| |z₁| |z₂|ⁿ with |z_j|² = I_j/(2ω_j|n_j|).
        let size = form.squared_size(form.rest([1, 0, 0, 3], true));
        let [first, second] = form.actions();
        let quartic = size / (first * second.square() * second);
        Some(Self { quartic: Some(quartic), ..form.normal() })
    }
}

/// A Hamiltonian in the coordinates of its modes.
struct Form<E: Enclosure> {
    /// ω₁, ω₂ and their squares.
    omega: [E; 2],
    squares: [E; 2],
    modes: [Mode<E>; 2],
    signs: [Sign; 2],
    /// H₃ by monomials of z₁, z₂, z̄₁, z̄₂.
    cubic: Vec<Complex<E>>,
    /// iG₃ likewise. A term that is known to vanish has no share in it, resonant or not.
    generator: Vec<Option<Complex<E>>>,
    /// H₄ in the real coordinates.
    quartic: Option<Homogeneous<E>>,
    precision: E::Precision,
}

impl<E: Enclosure> Form<E> {
    fn new(hamiltonian: &Series<E>, b: &E, c: &E, precision: E::Precision, with_quartic: bool) -> Option<Self> {
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

        let forms = linear_forms(&modes, precision);
        let cubic = cubic_in_modes(Homogeneous::composed(hamiltonian, 3, &forms, |_| true).as_ref(), precision);
        // The twist needs what is even in each mode.
        let is_even = |powers: &Exponents| (powers[0] + powers[CONJUGATE]).is_multiple_of(2);
        let quartic = Homogeneous::composed(hamiltonian, 4, &forms, |powers| with_quartic || is_even(powers));
        let over_frequency = |(powers, value): (Exponents, &Complex<E>)| {
            let frequency = (0..2).fold(small(0), |sum, j| {
                let winding = i32::from(powers[j]) - i32::from(powers[j + CONJUGATE]);
                sum + small(winding) * omega[j].clone()
            });
            (!value.is_zero()).then(|| value.scaled(&(small(1) / frequency)))
        };
        let generator = of_degree(3).zip(&cubic).map(over_frequency).collect();
        Some(Self { omega, squares, modes, signs, cubic, generator, quartic, precision })
    }

    fn small(&self, value: i32) -> E {
        E::small(value, self.precision)
    }

    /// The coefficient of a monomial of degree four in H₄ + ½{H₃, G₃}; its imaginary part only if that `is_complex`.
    fn rest(&self, wanted: Exponents, is_complex: bool) -> Complex<E> {
        // ½ · 1/(2ω_j n_j)
        let factor = |j: usize| self.small(1) / (self.small(4) * self.omega[j].clone() * self.modes[j].energy.clone());
        let factors = [factor(0), factor(1)];
        let mut sum = coefficient_in_modes(self.quartic.as_ref(), wanted, self.precision);
        for (powers, value) in of_degree(3).zip(&self.cubic) {
            // The partner in the bracket of each mode.
            let partner = |j: usize| {
                let mut product = wanted;
                product[j] += 1;
                product[j + CONJUGATE] += 1;
                let others = divided(product, powers)?;
                Some((place_in_degree(&others)?, bracket(powers, others, j), j))
            };
            let mut partners = [partner(0), partner(1)];
            partners.sort_by_key(|partner| partner.map(|(place, ..)| place));
            for (place, n, j) in partners.into_iter().flatten().filter(|(_, n, _)| *n != 0) {
                let Some(other) = &self.generator[place] else { continue };
                let scale = factors[j].clone() * self.small(n);
                if is_complex {
                    sum = sum + (value.clone() * other.clone()).scaled(&scale);
                } else {
                    sum.re = sum.re + value.real_product(other) * scale;
                }
            }
        }
        sum
    }

    /// 2ω_j |n_j|.
    fn actions(&self) -> [E; 2] {
        [0, 1].map(|j| {
            let size = self.small(2) * self.omega[j].clone() * self.modes[j].energy.clone();
            if self.signs[j] == Sign::Negative { -size } else { size }
        })
    }

    /// 4|c|².
    fn squared_size(&self, value: Complex<E>) -> E {
        self.small(4) * (value.re.square() + value.im.square())
    }

    /// All but the resonant term of degree four.
    fn normal(self) -> NormalForm<E> {
        let [k11, k12, k22] = [[2, 0, 2, 0], [1, 1, 1, 1], [0, 2, 0, 2]].map(|powers| self.rest(powers, false).re);
        let [first, second] = self.actions();
        let twist = [k11 / first.square(), k12 / (first.clone() * second.clone()), k22 / second.square()];
        // 2|c| |z₁| |z₂|ⁿ with |z_j|² = I_j/(2ω_j|n_j|).
        let resonant = of_degree(3).zip(&self.cubic).find(|(powers, _)| *powers == [1, 0, 0, 2]);
        let cubic = resonant.map_or_else(|| self.small(0), |(_, value)| self.squared_size(value.clone()));
        let cubic = cubic / (first * second.square());
        let Self { omega, squares, signs, .. } = self;
        let mixed = twist[1].clone() * omega[0].clone() * omega[1].clone();
        let mixed = if signs[0] == signs[1] { -mixed } else { mixed };
        let arnold = twist[0].clone() * squares[1].clone() + mixed + twist[2].clone() * squares[0].clone();
        NormalForm { omega, signs, twist, arnold, cubic, quartic: None }
    }
}

impl<E: Enclosure> Mode<E> {
    /// The mode of frequency ω beside one whose squared frequency is `other`.
    fn new(hessian: &[[E; VARIABLES]; VARIABLES], omega: &E, other: &E, precision: E::Precision) -> Option<Self> {
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

/// x in the real coordinates X₁, X₂, Y₁, Y₂ of z_j = X_j + iY_j: z v + z̄ v̄ = 2X re v − 2Y im v.
fn linear_forms<E: Enclosure>(modes: &[Mode<E>; 2], precision: E::Precision) -> [[E; VARIABLES]; VARIABLES] {
    std::array::from_fn(|a| {
        std::array::from_fn(|k| {
            let part = &modes[k % CONJUGATE].vector[a];
            let value = if k < CONJUGATE { part.re.clone() } else { -part.im.clone() };
            E::small(2, precision) * value
        })
    })
}

/// The coefficients of all monomials of degree three in z₁, z₂, z̄₁, z̄₂. That of a conjugate is the conjugate: the same
/// operations with other signs.
fn cubic_in_modes<E: Enclosure>(real: Option<&Homogeneous<E>>, precision: E::Precision) -> Vec<Complex<E>> {
    let mut cubic: Vec<Complex<E>> = Vec::with_capacity(of_degree(3).len());
    for [a, b, c, d] in of_degree(3) {
        let known = place_in_degree(&[c, d, a, b]).and_then(|place| cubic.get(place)).map(Complex::conjugate);
        cubic.push(known.unwrap_or_else(|| coefficient_in_modes(real, [a, b, c, d], precision)));
    }
    cubic
}

/// The coefficient of a monomial in z₁, z₂, z̄₁, z̄₂, from X = (z + z̄)/2 and Y = (z − z̄)/(2i).
fn coefficient_in_modes<E: Enclosure>(
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
            let share = |j: usize, y: u8| KRAWTCHOUK[whole[j] as usize][y as usize][wanted[j + CONJUGATE] as usize];
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
const KRAWTCHOUK: [[[i32; DEGREE + 1]; DEGREE + 1]; DEGREE + 1] = {
    let mut table = [[[0; DEGREE + 1]; DEGREE + 1]; DEGREE + 1];
    let mut n = 0;
    while n <= DEGREE {
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

/// The quotient of two monomials, if it is one.
fn divided(product: Exponents, powers: Exponents) -> Option<Exponents> {
    let fits = (0..VARIABLES).all(|k| powers[k] <= product[k]);
    fits.then(|| std::array::from_fn(|k| product[k] - powers[k]))
}

/// The factor of the product of two monomials in the bracket of mode j.
fn bracket(left: Exponents, right: Exponents, j: usize) -> i32 {
    let power = |powers: Exponents, k: usize| i32::from(powers[k]);
    power(left, j) * power(right, j + CONJUGATE) - power(left, j + CONJUGATE) * power(right, j)
}
