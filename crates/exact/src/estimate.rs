//! Plain `f64` in the place of intervals: for guesses, which are proved afterwards.

use std::ops::{Add, Div, Mul, Neg, Sub};

use dashu_ratio::RBig;

use bifdiag_numbers::enclosure::Arithmetic;

/// A rounded number that encloses nothing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Estimate(pub f64);

impl Add for Estimate {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }
}

impl Sub for Estimate {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self(self.0 - other.0)
    }
}

impl Neg for Estimate {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Mul for Estimate {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self(self.0 * other.0)
    }
}

impl Div for Estimate {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        Self(self.0 / other.0)
    }
}

impl Arithmetic for Estimate {
    type Precision = ();

    fn line((): ()) -> Self {
        Self(f64::NAN)
    }

    fn rational(value: &RBig, (): ()) -> Self {
        Self(value.to_f64().value())
    }

    fn double(value: f64, (): ()) -> Self {
        Self(value)
    }

    fn sqrt(&self) -> Self {
        Self(self.0.sqrt())
    }

    fn square(&self) -> Self {
        Self(self.0 * self.0)
    }

    fn meet(&self, _: &Self) -> Option<Self> {
        Some(*self)
    }
}
