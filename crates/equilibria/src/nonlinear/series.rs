//! Power series in four variables up to degree four.

use std::ops::{Add, Mul};
use std::sync::OnceLock;

/// Variables.
pub(super) const VARIABLES: usize = 4;
/// The degree above which terms are dropped.
pub(super) const DEGREE: usize = 4;
/// Monomials of degree at most four in four variables: C(8, 4).
const MONOMIALS: usize = 70;

/// The powers of the variables in a monomial.
pub(super) type Exponents = [u8; VARIABLES];

/// The monomials by rising degree.
struct Monomials {
    exponents: Vec<Exponents>,
    /// For each the places of those that it multiplies to one of degree at most four, and of the product.
    products: Vec<Vec<[usize; 2]>>,
    /// The place of each, by its powers as digits.
    places: Vec<usize>,
}

/// Powers as one number with digits from 0 to 4.
fn code(powers: &Exponents) -> usize {
    powers.iter().fold(0, |code, &power| 5 * code + usize::from(power))
}

impl Monomials {
    fn get() -> &'static Self {
        static MONOMIALS: OnceLock<Monomials> = OnceLock::new();
        MONOMIALS.get_or_init(|| {
            let powers = 0..=4_u8;
            let mut exponents: Vec<Exponents> = powers
                .clone()
                .flat_map(|i| powers.clone().map(move |j| (i, j)))
                .flat_map(|(i, j)| powers.clone().map(move |k| (i, j, k)))
                .flat_map(|(i, j, k)| powers.clone().map(move |m| [i, j, k, m]))
                .filter(|powers| degree(powers) <= DEGREE)
                .collect();
            exponents.sort_by_key(degree);
            let place = |wanted: Exponents| exponents.iter().position(|powers| *powers == wanted);
            let times = |first: &Exponents| {
                let product = |second: &Exponents| place(std::array::from_fn(|k| first[k] + second[k]));
                exponents.iter().enumerate().filter_map(|(j, second)| Some([j, product(second)?])).collect()
            };
            let products = exponents.iter().map(times).collect();
            let mut places = vec![usize::MAX; 5_usize.pow(4)];
            for (place, powers) in exponents.iter().enumerate() {
                places[code(powers)] = place;
            }
            Self { exponents, products, places }
        })
    }

    /// The place of a monomial of degree at most four.
    fn place(&self, powers: &Exponents) -> Option<usize> {
        self.places.get(code(powers)).copied().filter(|&place| place != usize::MAX)
    }
}

/// The degree of a monomial.
pub(super) fn degree(powers: &Exponents) -> usize {
    powers.iter().map(|&power| usize::from(power)).sum()
}

/// The monomials of one degree.
pub(super) fn of_degree(wanted: usize) -> impl Iterator<Item = Exponents> {
    Monomials::get().exponents.iter().copied().filter(move |powers| degree(powers) == wanted)
}

/// A power series without its terms above degree four. A coefficient that is known to vanish is `None`.
#[derive(Clone, Debug)]
pub struct Series<T> {
    coefficients: Vec<Option<T>>,
}

impl<T: Clone + Add<Output = T> + Mul<Output = T>> Series<T> {
    fn zero() -> Self {
        Self { coefficients: vec![None; MONOMIALS] }
    }

    /// A constant.
    #[must_use]
    pub fn constant(value: T) -> Self {
        Self::of([([0; VARIABLES], value)])
    }

    /// The variable of this number plus a constant.
    #[must_use]
    pub fn variable(number: usize, constant: T, one: T) -> Self {
        let mut power = [0; VARIABLES];
        power[number] = 1;
        Self::of([([0; VARIABLES], constant), (power, one)])
    }

    /// From terms, of which those of one monomial are added up.
    pub(super) fn of(terms: impl IntoIterator<Item = (Exponents, T)>) -> Self {
        let mut series = Self::zero();
        for (powers, value) in terms {
            if let Some(place) = Monomials::get().place(&powers) {
                series.add_at(place, value);
            }
        }
        series
    }

    /// A function of one variable, from its Taylor coefficients.
    pub(super) fn univariate(number: usize, taylor: [T; DEGREE + 1]) -> Self {
        Self::of(taylor.into_iter().zip(0..).map(|(value, power)| {
            let mut powers = [0; VARIABLES];
            powers[number] = power;
            (powers, value)
        }))
    }

    fn add_at(&mut self, place: usize, value: T) {
        let sum = match self.coefficients[place].take() {
            Some(known) => known + value,
            None => value,
        };
        self.coefficients[place] = Some(sum);
    }

    /// The coefficient of a monomial; `None` if it is known to vanish.
    #[must_use]
    pub fn coefficient(&self, powers: Exponents) -> Option<&T> {
        let place = Monomials::get().place(&powers)?;
        self.coefficients[place].as_ref()
    }

    /// The terms of one degree.
    pub(super) fn terms(&self, wanted: usize) -> impl Iterator<Item = (Exponents, &T)> {
        let known = Monomials::get().exponents.iter().zip(&self.coefficients);
        known.filter_map(move |(powers, value)| Some((*powers, value.as_ref().filter(|_| degree(powers) == wanted)?)))
    }

    /// The sum.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        let mut sum = self.clone();
        for (place, value) in other.coefficients.iter().enumerate() {
            if let Some(value) = value {
                sum.add_at(place, value.clone());
            }
        }
        sum
    }

    /// The product.
    #[must_use]
    pub fn times(&self, other: &Self) -> Self {
        let mut product = Self::zero();
        for (left, partners) in self.coefficients.iter().zip(&Monomials::get().products) {
            let Some(left) = left else { continue };
            for &[j, k] in partners {
                if let Some(right) = &other.coefficients[j] {
                    product.add_at(k, left.clone() * right.clone());
                }
            }
        }
        product
    }

    /// A multiple.
    #[must_use]
    pub fn scaled(&self, factor: &T) -> Self {
        let coefficients =
            self.coefficients.iter().map(|value| value.clone().map(|value| value * factor.clone())).collect();
        Self { coefficients }
    }

    /// The derivative by a variable; `whole` makes numbers of powers.
    pub(super) fn derivative(&self, number: usize, whole: impl Fn(u8) -> T) -> Self {
        let terms = (1..=DEGREE).flat_map(|degree| self.terms(degree));
        Self::of(terms.filter(|(powers, _)| powers[number] > 0).map(|(mut powers, value)| {
            let factor = whole(powers[number]);
            powers[number] -= 1;
            (powers, value.clone() * factor)
        }))
    }

    /// Σ cᵢ (f − f(0))ⁱ: a function of f, from its Taylor coefficients at f(0).
    #[must_use]
    pub fn composed(&self, taylor: [T; DEGREE + 1]) -> Self {
        let mut change = self.clone();
        change.coefficients[0] = None;
        let [first, rest @ ..] = taylor;
        let mut sum = Self::constant(first);
        let mut power: Option<Self> = None;
        for value in rest {
            let next = power.map_or_else(|| change.clone(), |power| power.times(&change));
            sum = sum.plus(&next.scaled(&value));
            power = Some(next);
        }
        sum
    }
}
