//! Power series in four variables up to degree four or six.

use std::ops::{Add, Mul};
use std::sync::OnceLock;

/// Variables.
pub(super) const VARIABLES: usize = 4;
/// The degree above which terms are dropped, unless a type says otherwise.
pub(super) const DEGREE: usize = 4;
/// The highest degree of any series.
pub const HIGHEST: usize = 6;

/// The powers of the variables in a monomial.
pub(super) type Exponents = [u8; VARIABLES];

/// How many monomials have a lower degree: C(d + 3, 4).
const BELOW: [usize; HIGHEST + 2] = [0, 1, 5, 15, 35, 70, 126, 210];

/// The monomials by rising degree.
struct Monomials {
    exponents: Vec<Exponents>,
    /// For each the places of its products with those, the first ones, with which it makes at most degree six.
    products: Vec<Vec<usize>>,
    /// The place of each, by its powers as digits.
    places: Vec<usize>,
}

/// Powers as one number with digits from 0 to 6.
fn code(powers: &Exponents) -> usize {
    powers.iter().fold(0, |code, &power| (HIGHEST + 1) * code + usize::from(power))
}

impl Monomials {
    fn get() -> &'static Self {
        static MONOMIALS: OnceLock<Monomials> = OnceLock::new();
        MONOMIALS.get_or_init(|| {
            let powers = 0..=6_u8;
            let mut exponents: Vec<Exponents> = powers
                .clone()
                .flat_map(|i| powers.clone().map(move |j| (i, j)))
                .flat_map(|(i, j)| powers.clone().map(move |k| (i, j, k)))
                .flat_map(|(i, j, k)| powers.clone().map(move |m| [i, j, k, m]))
                .filter(|powers| degree(powers) <= HIGHEST)
                .collect();
            exponents.sort_by_key(degree);
            let mut places = vec![usize::MAX; (HIGHEST + 1).pow(4)];
            for (place, powers) in exponents.iter().enumerate() {
                places[code(powers)] = place;
            }
            let times = |first: &Exponents| {
                let partners = &exponents[..BELOW[HIGHEST - degree(first) + 1]];
                let product = |second: &Exponents| std::array::from_fn(|k| first[k] + second[k]);
                partners.iter().map(|second| places[code(&product(second))]).collect()
            };
            let products = exponents.iter().map(times).collect();
            Self { exponents, products, places }
        })
    }

    /// The place of a monomial of degree at most six.
    fn place(&self, powers: &Exponents) -> Option<usize> {
        self.places.get(code(powers)).copied().filter(|&place| place != usize::MAX)
    }
}

/// The degree of a monomial.
pub(super) fn degree(powers: &Exponents) -> usize {
    powers.iter().map(|&power| usize::from(power)).sum()
}

/// The monomials of one degree.
pub(super) fn of_degree(wanted: usize) -> impl ExactSizeIterator<Item = Exponents> {
    Monomials::get().exponents[BELOW[wanted]..BELOW[wanted + 1]].iter().copied()
}

/// Adds to a sum; one that is known to vanish is `None`.
pub(super) fn add<T: Add<Output = T>>(sum: &mut Option<T>, value: T) {
    *sum = Some(match sum.take() {
        Some(known) => known + value,
        None => value,
    });
}

/// A power series without its terms above degree D. A coefficient that is known to vanish is `None`.
#[derive(Clone, Debug)]
pub struct Series<T, const D: usize = DEGREE> {
    coefficients: Vec<Option<T>>,
}

impl<T: Clone + Add<Output = T> + Mul<Output = T>, const D: usize> Series<T, D> {
    fn zero() -> Self {
        Self { coefficients: std::iter::repeat_with(|| None).take(BELOW[D + 1]).collect() }
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

    /// From terms; those of the same monomial are added.
    pub(super) fn of(terms: impl IntoIterator<Item = (Exponents, T)>) -> Self {
        let mut series = Self::zero();
        for (powers, value) in terms {
            if let Some(place) = Monomials::get().place(&powers).filter(|place| *place < BELOW[D + 1]) {
                series.add_at(place, value);
            }
        }
        series
    }

    /// A function of one variable, from its Taylor coefficients.
    pub(super) fn univariate(number: usize, taylor: impl IntoIterator<Item = T>) -> Self {
        Self::of(taylor.into_iter().zip(0..).map(|(value, power)| {
            let mut powers = [0; VARIABLES];
            powers[number] = power;
            (powers, value)
        }))
    }

    fn add_at(&mut self, place: usize, value: T) {
        add(&mut self.coefficients[place], value);
    }

    /// The coefficient of a monomial; `None` if it is known to vanish.
    #[must_use]
    pub fn coefficient(&self, powers: Exponents) -> Option<&T> {
        self.coefficients.get(Monomials::get().place(&powers)?)?.as_ref()
    }

    /// The terms of one degree.
    pub(super) fn terms(&self, wanted: usize) -> impl Iterator<Item = (Exponents, &T)> {
        let values = &self.coefficients[BELOW[wanted]..BELOW[wanted + 1]];
        of_degree(wanted).zip(values).filter_map(|(powers, value)| Some((powers, value.as_ref()?)))
    }

    /// The sum.
    #[must_use]
    pub fn plus(mut self, other: Self) -> Self {
        for (sum, value) in self.coefficients.iter_mut().zip(other.coefficients) {
            if let Some(value) = value {
                add(sum, value);
            }
        }
        self
    }

    /// The product.
    #[must_use]
    pub fn times(&self, other: &Self) -> Self {
        let mut product = Self::zero();
        let known = || other.coefficients.iter().enumerate().filter_map(|(j, value)| Some((j, value.as_ref()?)));
        let others: Vec<(usize, &T)> = known().collect();
        let monomials = Monomials::get();
        for (place, left) in self.coefficients.iter().enumerate() {
            let Some(left) = left else { continue };
            let partners = BELOW[D - degree(&monomials.exponents[place]) + 1];
            let products = &monomials.products[place];
            for &(j, right) in others.iter().take_while(|(j, _)| *j < partners) {
                product.add_at(products[j], left.clone() * right.clone());
            }
        }
        product
    }

    /// A multiple.
    #[must_use]
    pub fn scaled(mut self, factor: &T) -> Self {
        for value in &mut self.coefficients {
            *value = value.take().map(|value| value * factor.clone());
        }
        self
    }

    /// The derivative by a variable; `whole` makes numbers of powers.
    pub(super) fn derivative(&self, number: usize, whole: impl Fn(u8) -> T) -> Self {
        let terms = (1..=D).flat_map(|degree| self.terms(degree));
        Self::of(terms.filter(|(powers, _)| powers[number] > 0).map(|(mut powers, value)| {
            let factor = whole(powers[number]);
            powers[number] -= 1;
            (powers, value.clone() * factor)
        }))
    }

    /// Σ cᵢ (f − f(0))ⁱ: a function of f, from its Taylor coefficients at f(0).
    #[must_use]
    pub fn composed(&self, taylor: impl IntoIterator<Item = T>) -> Self {
        let mut change = self.clone();
        change.coefficients[0] = None;
        let mut taylor = taylor.into_iter();
        let mut sum = taylor.next().map_or_else(Self::zero, Self::constant);
        let mut power: Option<Self> = None;
        for value in taylor.take(D) {
            let next = power.map_or_else(|| change.clone(), |power| power.times(&change));
            sum = sum.plus(next.clone().scaled(&value));
            power = Some(next);
        }
        sum
    }
}

/// A homogeneous polynomial in four variables, of degree at most six.
#[derive(Clone, Debug)]
pub(super) struct Homogeneous<T> {
    degree: usize,
    /// Those that are known to vanish are `None`.
    coefficients: Vec<Option<T>>,
}

impl<T: Clone + Add<Output = T> + Mul<Output = T>> Homogeneous<T> {
    fn zero(degree: usize) -> Self {
        Self { degree, coefficients: of_degree(degree).map(|_| None).collect() }
    }

    /// The terms of one degree of a series, with linear forms for its variables (by rising number of their own ones). Only the
    /// coefficients of monomials that are `wanted` are made.
    pub(super) fn composed<const D: usize>(
        series: &Series<T, D>,
        degree: usize,
        forms: &[[T; VARIABLES]; VARIABLES],
        wanted: impl Fn(&Exponents) -> bool,
    ) -> Option<Self> {
        let wanted: Vec<bool> = of_degree(degree).map(|powers| wanted(&powers)).collect();
        Self::divided(series, degree, ([0; VARIABLES], VARIABLES), forms, Some(&wanted))
    }

    /// Of the terms that a monomial divides, the quotients in variables up to one, composed: these are again divided by their
    /// last variable, and so on.
    fn divided<const D: usize>(
        series: &Series<T, D>,
        degree: usize,
        (divisor, variables): (Exponents, usize),
        forms: &[[T; VARIABLES]; VARIABLES],
        wanted: Option<&[bool]>,
    ) -> Option<Self> {
        if degree == 0 {
            return Some(Self { degree, coefficients: vec![Some(series.coefficient(divisor)?.clone())] });
        }
        let mut sum: Option<Self> = None;
        for (last, form) in forms.iter().enumerate().take(variables) {
            let mut next = divisor;
            next[last] += 1;
            if let Some(quotient) = Self::divided(series, degree - 1, (next, last + 1), forms, None) {
                let product = quotient.times(form, wanted);
                sum = Some(match sum {
                    Some(sum) => sum.plus(product),
                    None => product,
                });
            }
        }
        sum
    }

    /// The product with a linear form.
    fn times(&self, form: &[T; VARIABLES], wanted: Option<&[bool]>) -> Self {
        let mut product = Self::zero(self.degree + 1);
        let first = BELOW[self.degree + 1];
        for (left, places) in self.coefficients.iter().zip(&Monomials::get().products[BELOW[self.degree]..]) {
            let Some(left) = left else { continue };
            // Among the monomials of degree one the last variable is the first.
            for (right, place) in form.iter().rev().zip(&places[1..]) {
                if wanted.is_none_or(|wanted| wanted[place - first]) {
                    add(&mut product.coefficients[place - first], left.clone() * right.clone());
                }
            }
        }
        product
    }

    fn plus(mut self, other: Self) -> Self {
        for (sum, value) in self.coefficients.iter_mut().zip(other.coefficients) {
            if let Some(value) = value {
                add(sum, value);
            }
        }
        self
    }

    /// The coefficient of a monomial of its degree; `None` if it is known to vanish.
    pub(super) fn coefficient(&self, powers: Exponents) -> Option<&T> {
        self.coefficients[place_in_degree(&powers)?].as_ref()
    }
}

/// The number of a monomial among those of its degree.
pub(super) fn place_in_degree(powers: &Exponents) -> Option<usize> {
    Some(Monomials::get().place(powers)? - BELOW[degree(powers)])
}
