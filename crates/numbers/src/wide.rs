//! Interval arithmetic with ends of any kind: floats of any precision, or of a few words of 64 bits, which are ten times as
//! fast and give the same ends.

use std::ops::{Add, Div, Mul, Neg, Sub};

use dashu_ratio::RBig;

use super::Sign;
use super::directed::{Big, Directed, Toward};
use super::enclosure::{Arithmetic, Enclosure};
pub use super::fixed_float::FixedFloat;

/// Finite ends of a given precision, or the whole line, under the contract of [`Enclosure`].
#[derive(Clone, Debug)]
pub struct Bounded<F: Directed> {
    ends: Option<(F, F)>,
    precision: F::Precision,
}

/// Intervals whose ends have any number of bits.
pub type Wide = Bounded<Big>;

/// Intervals whose ends have 128 bits.
pub type Interval128 = Bounded<FixedFloat<2>>;

/// Intervals whose ends have 384 bits.
pub type Interval384 = Bounded<FixedFloat<6>>;

/// Intervals whose ends have 1024 bits.
pub type Interval1024 = Bounded<FixedFloat<16>>;

impl<F: Directed> Bounded<F> {
    /// Both ends, or the whole line when an operation had no finite result.
    fn of(lo: Option<F>, hi: Option<F>, precision: F::Precision) -> Self {
        Self { ends: lo.zip(hi), precision }
    }

    fn point(end: F, precision: F::Precision) -> Self {
        Self { ends: Some((end.clone(), end)), precision }
    }

    fn is_zero(&self) -> bool {
        self.ends.as_ref().is_some_and(|(a, b)| a.sign() == Sign::Zero && b.sign() == Sign::Zero)
    }
}

fn is_negative<F: Directed>(end: &F) -> bool {
    end.sign() == Sign::Negative
}

impl<F: Directed> Add for Bounded<F> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let precision = self.precision;
        match (&self.ends, &other.ends) {
            (Some((a, b)), Some((c, d))) => {
                Self::of(a.plus(c, precision, Toward::Down), b.plus(d, precision, Toward::Up), precision)
            }
            _ => Self::line(precision),
        }
    }
}

impl<F: Directed> Sub for Bounded<F> {
    type Output = Self;
    // a − b is a + (−b), with either bound of b on the other side.
    #[allow(clippy::suspicious_arithmetic_impl)]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<F: Directed> Neg for Bounded<F> {
    type Output = Self;
    fn neg(self) -> Self {
        Self { ends: self.ends.map(|(a, b)| (b.negated(), a.negated())), precision: self.precision }
    }
}

impl<F: Directed> Mul for Bounded<F> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let precision = self.precision;
        if self.is_zero() || other.is_zero() {
            return Self::point(F::zero(), precision);
        }
        let (Some((a, b)), Some((c, d))) = (&self.ends, &other.ends) else { return Self::line(precision) };
        let (low, high) = match (is_negative(a), is_negative(b), is_negative(c), is_negative(d)) {
            (false, _, false, _) => ((a, c), (b, d)),
            (false, _, _, true) => ((b, c), (a, d)),
            (false, _, true, false) => ((b, c), (b, d)),
            (_, true, false, _) => ((a, d), (b, c)),
            (_, true, _, true) => ((b, d), (a, c)),
            (_, true, true, false) => ((a, d), (a, c)),
            (true, false, false, _) => ((a, d), (b, d)),
            (true, false, _, true) => ((b, c), (a, c)),
            (true, false, true, false) => {
                let lows = [a.times(d, precision, Toward::Down), b.times(c, precision, Toward::Down)];
                let highs = [a.times(c, precision, Toward::Up), b.times(d, precision, Toward::Up)];
                let [Some(p), Some(q)] = lows else { return Self::line(precision) };
                let [Some(r), Some(s)] = highs else { return Self::line(precision) };
                return Self::of(Some(p.min(q)), Some(r.max(s)), precision);
            }
        };
        Self::of(low.0.times(low.1, precision, Toward::Down), high.0.times(high.1, precision, Toward::Up), precision)
    }
}

impl<F: Directed> Div for Bounded<F> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let precision = self.precision;
        if other.strict_sign().is_none() {
            return Self::line(precision);
        }
        if self.is_zero() {
            return self;
        }
        let (Some((a, b)), Some((c, d))) = (self.ends, other.ends) else { return Self::line(precision) };
        let (low, high) = match (is_negative(&a), is_negative(&b), is_negative(&c)) {
            (false, _, false) => ((&a, &d), (&b, &c)),
            (false, _, true) => ((&b, &d), (&a, &c)),
            (true, true, false) => ((&a, &c), (&b, &d)),
            (true, true, true) => ((&b, &c), (&a, &d)),
            (true, false, false) => ((&a, &c), (&b, &c)),
            (true, false, true) => ((&b, &d), (&a, &d)),
        };
        Self::of(low.0.over(low.1, precision, Toward::Down), high.0.over(high.1, precision, Toward::Up), precision)
    }
}

impl<F: Directed> Arithmetic for Bounded<F> {
    type Precision = F::Precision;

    fn line(precision: F::Precision) -> Self {
        Self { ends: None, precision }
    }

    fn rational(value: &RBig, precision: F::Precision) -> Self {
        let end = |toward| F::rational(value, precision, toward);
        Self::of(end(Toward::Down), end(Toward::Up), precision)
    }

    fn double(value: f64, precision: F::Precision) -> Self {
        F::double(value, precision).map_or_else(|| Self::line(precision), |end| Self::point(end, precision))
    }

    fn sqrt(&self) -> Self {
        let Some((a, b)) = &self.ends else { return self.clone() };
        let precision = self.precision;
        match b.sign() {
            Sign::Zero => Self::point(F::zero(), precision),
            Sign::Negative => Self::line(precision),
            Sign::Positive => {
                let lo = if a.sign() == Sign::Positive { a.root(precision, Toward::Down) } else { Some(F::zero()) };
                Self::of(lo, b.root(precision, Toward::Up), precision)
            }
        }
    }

    fn square(&self) -> Self {
        let product = self.clone() * self.clone();
        match product.ends {
            Some((lo, hi)) if is_negative(&lo) => Self { ends: Some((F::zero(), hi)), precision: self.precision },
            ends => Self { ends, precision: self.precision },
        }
    }

    fn meet(&self, other: &Self) -> Option<Self> {
        match (&self.ends, &other.ends) {
            (Some((a, b)), Some((c, d))) => {
                let (lo, hi) = (a.max(c).clone(), b.min(d).clone());
                (lo <= hi).then(|| Self { ends: Some((lo, hi)), precision: self.precision })
            }
            (Some(_), None) => Some(self.clone()),
            (None, _) => Some(other.clone()),
        }
    }
}

impl<F: Directed> Enclosure for Bounded<F> {
    fn sign(&self) -> Option<Sign> {
        let (a, b) = self.ends.as_ref()?;
        match (a.sign(), b.sign()) {
            (Sign::Positive, _) => Some(Sign::Positive),
            (_, Sign::Negative) => Some(Sign::Negative),
            (Sign::Zero, Sign::Zero) => Some(Sign::Zero),
            _ => None,
        }
    }

    fn hull(&self, other: &Self) -> Self {
        match (&self.ends, &other.ends) {
            (Some((a, b)), Some((c, d))) => {
                Self { ends: Some((a.min(c).clone(), b.max(d).clone())), precision: self.precision }
            }
            _ => Self::line(self.precision),
        }
    }

    fn lower(&self) -> Self {
        Self { ends: self.ends.clone().map(|(a, _)| (a.clone(), a)), precision: self.precision }
    }

    fn upper(&self) -> Self {
        Self { ends: self.ends.clone().map(|(_, b)| (b.clone(), b)), precision: self.precision }
    }

    fn middle(&self) -> Self {
        let half = Self::double(0.5, self.precision);
        let sum = (self.lower() + self.upper()) * half;
        Self { ends: sum.ends.map(|(a, _)| (a.clone(), a)), precision: self.precision }
    }

    fn bounds(&self) -> [f64; 2] {
        let Some((a, b)) = &self.ends else { return [f64::NEG_INFINITY, f64::INFINITY] };
        [a.to_double().next_down(), b.to_double().next_up()]
    }

    fn exact_bounds(&self) -> Option<[RBig; 2]> {
        self.ends.as_ref().map(|(a, b)| [a.to_rational(), b.to_rational()])
    }

    fn resolution(precision: F::Precision) -> f64 {
        let mut resolution = 8.0;
        for _ in 1..F::bits(precision).min(1000) {
            resolution *= 0.5;
        }
        resolution
    }
}
