//! Binary floating-point numbers whose operations round in a given direction: the ends of intervals.

use std::fmt::Debug;

use dashu_base::{Approximation, FloatEncoding as _};
use dashu_float::round::Rounding;
use dashu_float::round::mode::{Down, Up};
use dashu_float::{Context, FBig, Repr};
use dashu_int::IBig;
use dashu_ratio::RBig;

use super::Sign;

/// The direction in which a result is rounded that the precision cannot represent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Toward {
    /// Not above the exact result.
    Down,
    /// Not below it.
    Up,
}

/// An end of an interval. Every operation gives the nearest number of the precision on the side that is asked for; `None`
/// where its exponent is too large, for a quotient by 0 and for the root of a negative number.
pub trait Directed: Clone + Debug + Ord {
    /// How many bits a number carries.
    type Precision: Copy + Debug;

    /// 0.
    fn zero() -> Self;
    /// Its sign.
    fn sign(&self) -> Sign;
    /// −x.
    #[must_use]
    fn negated(&self) -> Self;
    /// x + y.
    fn plus(&self, other: &Self, precision: Self::Precision, toward: Toward) -> Option<Self>;
    /// x y.
    fn times(&self, other: &Self, precision: Self::Precision, toward: Toward) -> Option<Self>;
    /// x / y.
    fn over(&self, other: &Self, precision: Self::Precision, toward: Toward) -> Option<Self>;
    /// √x.
    fn root(&self, precision: Self::Precision, toward: Toward) -> Option<Self>;
    /// A rational number, rounded once.
    fn rational(value: &RBig, precision: Self::Precision, toward: Toward) -> Option<Self>;
    /// A double, exactly; `None` when it is not finite.
    fn double(value: f64, precision: Self::Precision) -> Option<Self>;
    /// The number as a rational, without rounding.
    fn to_rational(&self) -> RBig;
    /// The nearest double that is not above it.
    fn to_double(&self) -> f64;
    /// The bits of a precision.
    fn bits(precision: Self::Precision) -> usize;
}

/// A number of any precision.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Big(Repr<2>);

type Rounded<R> = Approximation<FBig<R, 2>, Rounding>;

/// The result of one operation in either direction.
macro_rules! rounded {
    ($bits:expr, $toward:expr, |$context:ident| $operation:expr) => {
        match $toward {
            Toward::Down => {
                let $context = Context::<Down>::new($bits);
                Big::of(lower($operation.ok()))
            }
            Toward::Up => {
                let $context = Context::<Up>::new($bits);
                Big::of(upper($operation.ok()))
            }
        }
    };
}

fn lower(result: Option<Rounded<Down>>) -> Option<Repr<2>> {
    result.map(|rounded| rounded.value().into_repr())
}

fn upper(result: Option<Rounded<Up>>) -> Option<Repr<2>> {
    result.map(|rounded| rounded.value().into_repr())
}

impl Big {
    fn of(end: Option<Repr<2>>) -> Option<Self> {
        end.filter(Repr::is_finite).map(Self)
    }
}

impl Directed for Big {
    type Precision = usize;

    fn zero() -> Self {
        Self(Repr::zero())
    }

    fn sign(&self) -> Sign {
        Sign::from(self.0.significand())
    }

    fn negated(&self) -> Self {
        Self(-self.0.clone())
    }

    fn plus(&self, other: &Self, bits: usize, toward: Toward) -> Option<Self> {
        rounded!(bits, toward, |context| context.add(&self.0, &other.0))
    }

    fn times(&self, other: &Self, bits: usize, toward: Toward) -> Option<Self> {
        rounded!(bits, toward, |context| context.mul(&self.0, &other.0))
    }

    fn over(&self, other: &Self, bits: usize, toward: Toward) -> Option<Self> {
        rounded!(bits, toward, |context| context.div(&self.0, &other.0))
    }

    fn root(&self, bits: usize, toward: Toward) -> Option<Self> {
        rounded!(bits, toward, |context| context.sqrt(&self.0))
    }

    fn rational(value: &RBig, bits: usize, toward: Toward) -> Option<Self> {
        let numerator = Repr::new(value.numerator().clone(), 0);
        let denominator = Repr::new(IBig::from(value.denominator().clone()), 0);
        rounded!(bits, toward, |context| context.div(&numerator, &denominator))
    }

    fn double(value: f64, _: usize) -> Option<Self> {
        let (significand, exponent) = value.decode().ok()?;
        Some(Self(Repr::new(IBig::from(significand), exponent.into())))
    }

    fn to_rational(&self) -> RBig {
        let (significand, exponent) = (self.0.significand().clone(), self.0.exponent());
        let power = IBig::from(1) << exponent.unsigned_abs();
        if exponent >= 0 { RBig::from(significand * power) } else { RBig::from(significand) / RBig::from(power) }
    }

    fn to_double(&self) -> f64 {
        FBig::<Down, 2>::from_repr(self.0.clone(), Context::new(0)).to_f64().value()
    }

    fn bits(bits: usize) -> usize {
        bits
    }
}
