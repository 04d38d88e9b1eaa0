//! Birkhoff's normal form to degree four at an equilibrium with two imaginary pairs.
//!
//! Let M = J H″ be the linearised flow in canonical coordinates x = (q₁, q₂, p₁, p₂), with eigenvalues ±iω₁, ±iω₂. For
//! any vector e, y = (M² + ω₂²)e spans with My the plane of the first pair: M²y = −ω₁²y, and v = My + iω₁y is an
//! eigenvector of iω₁. In coordinates x = Σ (z_j v_j + z̄_j v̄_j) the brackets are {z_j, z̄_j} = i/(2ω_j n_j) with
//! n_j = ⟨y_j, H″y_j⟩, ż_j = iω_j z_j, and the actions I_j = 2ω_j |n_j| |z_j|², so that H = Σ ±ω_j I_j + … with the sign of
//! n_j. A generating function of degree three, with coefficients H₃/(i⟨ω, a − b⟩) at z^a z̄^b, removes H₃, and in
//! degree four ½{H₃, G₃} + H₄ remains where a = b.

use bifdiag_numbers::Sign;
use bifdiag_numbers::enclosure::Enclosure;

use super::complex::Complex;
use super::modes::{CONJUGATE, Mode, ModePair, coefficient_in_modes, in_modes, linear_forms};
use super::series::{Exponents, Homogeneous, Series, VARIABLES, of_degree, place_in_degree};

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

impl<E: Enclosure> NormalForm<E> {
    /// From the Taylor series of a Hamiltonian in (q₁, q₂, p₁, p₂) and the coefficients of its λ⁴ + bλ² + c. `None`
    /// where the enclosures do not show that the pairs are imaginary, distinct, and of known energies. At ω₁ = 2ω₂ the
    /// twist is unbounded. Without the term that stays at ω₁ = 3ω₂.
    #[must_use]
    pub fn new(hamiltonian: &Series<E>, b: &E, c: &E, precision: E::Precision) -> Option<Self> {
        Some(ModeHamiltonian::new(hamiltonian, b, c, precision, Quartic::even)?.normal())
    }

    /// Arnold's determinant alone, by fewer operations.
    #[must_use]
    pub fn arnold(hamiltonian: &Series<E>, b: &E, c: &E, precision: E::Precision) -> Option<E> {
        Some(ModeHamiltonian::new(hamiltonian, b, c, precision, Quartic::contracted)?.normal().arnold)
    }

    /// The same with the term that stays at ω₁ = 3ω₂.
    #[must_use]
    pub fn with_quartic(hamiltonian: &Series<E>, b: &E, c: &E, precision: E::Precision) -> Option<Self> {
        let form = ModeHamiltonian::new(hamiltonian, b, c, precision, Quartic::whole)?;
        // 2|c| |z₁| |z₂|ⁿ with |z_j|² = I_j/(2ω_j|n_j|).
        let size = form.squared_size(&form.rest([1, 0, 0, 3], true));
        let [first, second] = form.pair.actions(precision);
        let quartic = size / (first * second.square() * second);
        Some(Self { quartic: Some(quartic), ..form.normal() })
    }
}

/// A Hamiltonian in the coordinates of its modes.
struct ModeHamiltonian<E: Enclosure> {
    pair: ModePair<E>,
    /// H₃ by monomials of z₁, z₂, z̄₁, z̄₂.
    cubic: Vec<Complex<E>>,
    /// iG₃ likewise. A term that is known to vanish contributes nothing, resonant or not.
    generator: Vec<Option<Complex<E>>>,
    quartic: Quartic<E>,
    precision: E::Precision,
}

impl<E: Enclosure> ModeHamiltonian<E> {
    fn new(
        hamiltonian: &Series<E>,
        b: &E,
        c: &E,
        precision: E::Precision,
        quartic: impl FnOnce(&Series<E>, &[Mode<E>; 2], E::Precision) -> Quartic<E>,
    ) -> Option<Self> {
        let pair = ModePair::new(hamiltonian, b, c, precision)?;
        let forms = linear_forms(&pair.modes, precision);
        let cubic = in_modes(Homogeneous::composed(hamiltonian, 3, &forms, |_| true).as_ref(), 3, precision);
        let quartic = quartic(hamiltonian, &pair.modes, precision);
        let over_frequency = |(powers, value): (Exponents, &Complex<E>)| {
            (!value.is_zero()).then(|| value.scaled(&(E::small(1, precision) / pair.frequency(&powers, precision))))
        };
        let generator = of_degree(3).zip(&cubic).map(over_frequency).collect();
        Some(Self { pair, cubic, generator, quartic, precision })
    }

    fn small(&self, value: i32) -> E {
        E::small(value, self.precision)
    }

    /// The coefficient of a monomial of degree four in H₄ + ½{H₃, G₃}; its imaginary part only if that `is_complex`.
    fn rest(&self, wanted: Exponents, is_complex: bool) -> Complex<E> {
        // ½ · 1/(2ω_j n_j)
        let factors = [0, 1].map(|j| self.small(1) / (self.small(2) * self.pair.bracket(j, self.precision)));
        let mut sum = self.quartic.coefficient(wanted, self.precision);
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

    /// 4|c|².
    fn squared_size(&self, value: &Complex<E>) -> E {
        self.small(4) * (value.re.square() + value.im.square())
    }

    /// All but the resonant term of degree four.
    fn normal(self) -> NormalForm<E> {
        let [k11, k12, k22] = TWIST.map(|powers| self.rest(powers, false).re);
        let [first, second] = self.pair.actions(self.precision);
        let twist = [k11 / first.square(), k12 / (first.clone() * second.clone()), k22 / second.square()];
        // 2|c| |z₁| |z₂|ⁿ with |z_j|² = I_j/(2ω_j|n_j|).
        let resonant = of_degree(3).zip(&self.cubic).find(|(powers, _)| *powers == [1, 0, 0, 2]);
        let cubic = resonant.map_or_else(|| self.small(0), |(_, value)| self.squared_size(value));
        let cubic = cubic / (first * second.square());
        let ModePair { omega, squares, signs, .. } = self.pair;
        let mixed = twist[1].clone() * omega[0].clone() * omega[1].clone();
        let mixed = if signs[0] == signs[1] { -mixed } else { mixed };
        let arnold = twist[0].clone() * squares[1].clone() + mixed + twist[2].clone() * squares[0].clone();
        NormalForm { omega, signs, twist, arnold, cubic, quartic: None }
    }
}

/// H₄ by monomials of z₁, z₂, z̄₁, z̄₂.
enum Quartic<E> {
    /// In the real coordinates.
    Real(Option<Homogeneous<E>>),
    /// At z₁²z̄₁², z₁z̄₁z₂z̄₂ and z₂²z̄₂².
    Twist([E; 3]),
}

/// The monomials of the twist.
const TWIST: [Exponents; 3] = [[2, 0, 2, 0], [1, 1, 1, 1], [0, 2, 0, 2]];

impl<E: Enclosure> Quartic<E> {
    fn whole(hamiltonian: &Series<E>, modes: &[Mode<E>; 2], precision: E::Precision) -> Self {
        Self::Real(Homogeneous::composed(hamiltonian, 4, &linear_forms(modes, precision), |_| true))
    }

    /// What is even in each mode, which the twist needs.
    fn even(hamiltonian: &Series<E>, modes: &[Mode<E>; 2], precision: E::Precision) -> Self {
        let is_even = |powers: &Exponents| (powers[0] + powers[CONJUGATE]).is_multiple_of(2);
        Self::Real(Homogeneous::composed(hamiltonian, 4, &linear_forms(modes, precision), is_even))
    }

    /// With Q = re v ⊗ re v + im v ⊗ im v of each mode: ¼(Q₁∂∂)²H₄, (Q₁∂∂)(Q₂∂∂)H₄ and ¼(Q₂∂∂)²H₄.
    fn contracted(hamiltonian: &Series<E>, modes: &[Mode<E>; 2], precision: E::Precision) -> Self {
        let factorial = |powers: Exponents| powers.iter().flat_map(|&power| 1..=i32::from(power)).product();
        let derivative = |powers: Exponents| {
            hamiltonian.coefficient(powers).map(|value| value.clone() * E::small(factorial(powers), precision))
        };
        let fourth: Vec<Option<E>> = of_degree(4).map(derivative).collect();
        let sum = |terms: &mut dyn Iterator<Item = E>| terms.reduce(|sum, term| sum + term);
        let once = |form: &[E]| -> Vec<Option<E>> {
            let at = |powers: Exponents| {
                let terms = of_degree(2).zip(form).filter_map(|(pair, q)| {
                    let place = place_in_degree(&std::array::from_fn(|k| powers[k] + pair[k]))?;
                    Some(fourth[place].clone()? * q.clone())
                });
                sum(&mut { terms })
            };
            of_degree(2).map(at).collect()
        };
        let twice = |once: &[Option<E>], form: &[E]| {
            let terms = once.iter().zip(form).filter_map(|(value, q)| Some(value.clone()? * q.clone()));
            sum(&mut { terms }).unwrap_or_else(|| E::small(0, precision))
        };
        let [first, second] = modes.each_ref().map(Mode::squared);
        let [of_first, of_second] = [once(&first), once(&second)];
        let quarter = E::small(1, precision) / E::small(4, precision);
        let [own, other] = [twice(&of_first, &first), twice(&of_second, &second)].map(|value| value * quarter.clone());
        Self::Twist([own, twice(&of_first, &second), other])
    }

    fn coefficient(&self, wanted: Exponents, precision: E::Precision) -> Complex<E> {
        match self {
            Self::Real(real) => coefficient_in_modes(real.as_ref(), wanted, precision),
            Self::Twist(values) => {
                let known = TWIST.iter().zip(values).find(|(powers, _)| **powers == wanted);
                let re = known.map_or_else(|| E::line(precision), |(_, value)| value.clone());
                Complex { re, im: E::small(0, precision) }
            }
        }
    }
}

/// The quotient of two monomials, if it is one.
pub(super) fn divided(product: Exponents, powers: Exponents) -> Option<Exponents> {
    let fits = (0..VARIABLES).all(|k| powers[k] <= product[k]);
    fits.then(|| std::array::from_fn(|k| product[k] - powers[k]))
}

/// The factor of the product of two monomials in the bracket of mode j.
pub(super) fn bracket(left: Exponents, right: Exponents, j: usize) -> i32 {
    let power = |powers: Exponents, k: usize| i32::from(powers[k]);
    power(left, j) * power(right, j + CONJUGATE) - power(left, j + CONJUGATE) * power(right, j)
}
