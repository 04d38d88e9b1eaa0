//! Interval arithmetic with as many bits as it takes: ends by `dashu-float` with directed rounding.

use std::ops::{Add, Div, Mul, Neg, Sub};

use dashu_base::Approximation;
use dashu_float::round::mode::{Down, Up};
use dashu_float::{Context, FBig, Repr};
use dashu_int::IBig;
use dashu_ratio::RBig;

use super::Sign;
use super::enclosure::{Arithmetic, Enclosure};

type End = Repr<2>;

/// Finite ends of a given number of bits, or the whole line, under the contract of [`Enclosure`].
#[derive(Clone, Debug)]
pub struct Wide {
    ends: Option<(End, End)>,
    bits: usize,
}

fn down(bits: usize) -> Context<Down> {
    Context::new(bits)
}

fn up(bits: usize) -> Context<Up> {
    Context::new(bits)
}

impl Wide {
    /// Both ends, or the whole line when an operation had no finite result.
    fn of(lo: Option<End>, hi: Option<End>, bits: usize) -> Self {
        let finite = |end: &End| end.is_finite();
        Self { ends: lo.filter(finite).zip(hi.filter(finite)), bits }
    }

    fn point(end: End, bits: usize) -> Self {
        Self { ends: Some((end.clone(), end)), bits }
    }

    fn is_zero(&self) -> bool {
        self.sign() == Some(Sign::Zero)
    }
}

fn lower<E>(result: Result<Approximation<FBig<Down, 2>, dashu_float::round::Rounding>, E>) -> Option<End> {
    result.ok().map(|rounded| rounded.value().into_repr())
}

fn upper<E>(result: Result<Approximation<FBig<Up, 2>, dashu_float::round::Rounding>, E>) -> Option<End> {
    result.ok().map(|rounded| rounded.value().into_repr())
}

fn is_negative(end: &End) -> bool {
    end.sign() == dashu_base::Sign::Negative && !is_nought(end)
}

fn is_nought(end: &End) -> bool {
    end.significand().is_zero() && end.is_finite()
}

fn to_rational(end: &End) -> RBig {
    let (significand, exponent) = (end.significand().clone(), end.exponent());
    let power = IBig::from(1) << exponent.unsigned_abs();
    if exponent >= 0 { RBig::from(significand * power) } else { RBig::from(significand) / RBig::from(power) }
}

impl Add for Wide {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let bits = self.bits;
        match (self.ends, other.ends) {
            (Some((a, b)), Some((c, d))) => Self::of(lower(down(bits).add(&a, &c)), upper(up(bits).add(&b, &d)), bits),
            _ => Self::line(bits),
        }
    }
}

impl Sub for Wide {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        let bits = self.bits;
        match (self.ends, other.ends) {
            (Some((a, b)), Some((c, d))) => Self::of(lower(down(bits).sub(&a, &d)), upper(up(bits).sub(&b, &c)), bits),
            _ => Self::line(bits),
        }
    }
}

impl Neg for Wide {
    type Output = Self;
    fn neg(self) -> Self {
        Self { ends: self.ends.map(|(a, b)| (-b, -a)), bits: self.bits }
    }
}

impl Mul for Wide {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let bits = self.bits;
        if self.is_zero() || other.is_zero() {
            return Self::point(End::zero(), bits);
        }
        let (Some((a, b)), Some((c, d))) = (self.ends, other.ends) else { return Self::line(bits) };
        let (low, high) = match (is_negative(&a), is_negative(&b), is_negative(&c), is_negative(&d)) {
            (false, _, false, _) => ((&a, &c), (&b, &d)),
            (false, _, _, true) => ((&b, &c), (&a, &d)),
            (false, _, true, false) => ((&b, &c), (&b, &d)),
            (_, true, false, _) => ((&a, &d), (&b, &c)),
            (_, true, _, true) => ((&b, &d), (&a, &c)),
            (_, true, true, false) => ((&a, &d), (&a, &c)),
            (true, false, false, _) => ((&a, &d), (&b, &d)),
            (true, false, _, true) => ((&b, &c), (&a, &c)),
            (true, false, true, false) => {
                let lows = [lower(down(bits).mul(&a, &d)), lower(down(bits).mul(&b, &c))];
                let highs = [upper(up(bits).mul(&a, &c)), upper(up(bits).mul(&b, &d))];
                let [Some(p), Some(q)] = lows else { return Self::line(bits) };
                let [Some(r), Some(s)] = highs else { return Self::line(bits) };
                return Self::of(Some(p.min(q)), Some(r.max(s)), bits);
            }
        };
        Self::of(lower(down(bits).mul(low.0, low.1)), upper(up(bits).mul(high.0, high.1)), bits)
    }
}

impl Div for Wide {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let bits = self.bits;
        if other.strict_sign().is_none() {
            return Self::line(bits);
        }
        if self.is_zero() {
            return self;
        }
        let (Some((a, b)), Some((c, d))) = (self.ends, other.ends) else { return Self::line(bits) };
        let (low, high) = match (is_negative(&a), is_negative(&b), is_negative(&c)) {
            (false, _, false) => ((&a, &d), (&b, &c)),
            (false, _, true) => ((&b, &d), (&a, &c)),
            (true, true, false) => ((&a, &c), (&b, &d)),
            (true, true, true) => ((&b, &c), (&a, &d)),
            (true, false, false) => ((&a, &c), (&b, &c)),
            (true, false, true) => ((&b, &d), (&a, &d)),
        };
        Self::of(lower(down(bits).div(low.0, low.1)), upper(up(bits).div(high.0, high.1)), bits)
    }
}

impl Arithmetic for Wide {
    type Precision = usize;

    fn line(bits: usize) -> Self {
        Self { ends: None, bits }
    }

    fn rational(value: &RBig, bits: usize) -> Self {
        let numerator = End::new(value.numerator().clone(), 0);
        let denominator = End::new(IBig::from(value.denominator().clone()), 0);
        let lo = lower(down(bits).div(&numerator, &denominator));
        let hi = upper(up(bits).div(&numerator, &denominator));
        Self::of(lo, hi, bits)
    }

    fn double(value: f64, bits: usize) -> Self {
        match RBig::try_from(value) {
            Ok(value) => Self { bits, ..Self::rational(&value, bits.max(64)) },
            Err(_not_finite) => Self::line(bits),
        }
    }

    fn sqrt(&self) -> Self {
        let Some((a, b)) = &self.ends else { return self.clone() };
        if is_nought(b) {
            return Self::point(End::zero(), self.bits);
        }
        if is_negative(b) {
            return Self::line(self.bits);
        }
        let lo = if is_negative(a) || is_nought(a) { Some(End::zero()) } else { lower(down(self.bits).sqrt(a)) };
        Self::of(lo, upper(up(self.bits).sqrt(b)), self.bits)
    }

    fn square(&self) -> Self {
        let product = self.clone() * self.clone();
        match product.ends {
            Some((lo, hi)) if is_negative(&lo) => Self { ends: Some((End::zero(), hi)), bits: self.bits },
            ends => Self { ends, bits: self.bits },
        }
    }

    fn meet(&self, other: &Self) -> Option<Self> {
        match (&self.ends, &other.ends) {
            (Some((a, b)), Some((c, d))) => {
                let (lo, hi) = (a.max(c).clone(), b.min(d).clone());
                (lo <= hi).then(|| Self { ends: Some((lo, hi)), bits: self.bits })
            }
            (Some(_), None) => Some(self.clone()),
            (None, _) => Some(other.clone()),
        }
    }
}

impl Enclosure for Wide {
    fn sign(&self) -> Option<Sign> {
        let (a, b) = self.ends.as_ref()?;
        if !is_negative(a) && !is_nought(a) {
            Some(Sign::Positive)
        } else if is_negative(b) {
            Some(Sign::Negative)
        } else if is_nought(a) && is_nought(b) {
            Some(Sign::Zero)
        } else {
            None
        }
    }

    fn hull(&self, other: &Self) -> Self {
        match (&self.ends, &other.ends) {
            (Some((a, b)), Some((c, d))) => Self { ends: Some((a.min(c).clone(), b.max(d).clone())), bits: self.bits },
            _ => Self::line(self.bits),
        }
    }

    fn lower(&self) -> Self {
        Self { ends: self.ends.clone().map(|(a, _)| (a.clone(), a)), bits: self.bits }
    }

    fn upper(&self) -> Self {
        Self { ends: self.ends.clone().map(|(_, b)| (b.clone(), b)), bits: self.bits }
    }

    fn middle(&self) -> Self {
        let half = Self::double(0.5, self.bits);
        let sum = (self.lower() + self.upper()) * half;
        Self { ends: sum.ends.map(|(a, _)| (a.clone(), a)), bits: self.bits }
    }

    fn bounds(&self) -> [f64; 2] {
        let Some((a, b)) = &self.ends else { return [f64::NEG_INFINITY, f64::INFINITY] };
        let ends = [a, b].map(|end| FBig::<Down, 2>::from_repr(end.clone(), Context::new(self.bits)).to_f64().value());
        [ends[0].next_down(), ends[1].next_up()]
    }

    fn exact_bounds(&self) -> Option<[RBig; 2]> {
        self.ends.as_ref().map(|(a, b)| [to_rational(a), to_rational(b)])
    }

    fn resolution(bits: usize) -> f64 {
        let mut resolution = 8.0;
        for _ in 1..bits.min(1000) {
            resolution *= 0.5;
        }
        resolution
    }
}
