//! The sign of a real number.

use std::cmp::Ordering;
use std::ops::{Mul, Neg};

use dashu_int::IBig;

/// The sign of a real number; ordered as −1 < 0 < 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Sign {
    /// −1.
    Negative,
    /// 0.
    Zero,
    /// 1.
    Positive,
}

impl Sign {
    /// Both signs of numbers that are not zero.
    pub const BOTH: [Self; 2] = [Self::Positive, Self::Negative];

    /// This sign, unless it is that of zero.
    #[must_use]
    #[inline]
    pub fn strict(self) -> Option<Self> {
        (self != Self::Zero).then_some(self)
    }

    /// −x for −1, otherwise x.
    #[must_use]
    #[inline]
    pub fn orient<T: Neg<Output = T>>(self, x: T) -> T {
        if self == Self::Negative { -x } else { x }
    }
}

impl From<Ordering> for Sign {
    /// The sign of a − b from the order of a and b.
    #[inline]
    fn from(order: Ordering) -> Self {
        match order {
            Ordering::Less => Self::Negative,
            Ordering::Equal => Self::Zero,
            Ordering::Greater => Self::Positive,
        }
    }
}

impl From<&IBig> for Sign {
    #[inline]
    fn from(x: &IBig) -> Self {
        x.cmp(&IBig::ZERO).into()
    }
}

impl From<Sign> for i8 {
    #[inline]
    fn from(sign: Sign) -> Self {
        match sign {
            Sign::Negative => -1,
            Sign::Zero => 0,
            Sign::Positive => 1,
        }
    }
}

impl From<Sign> for f64 {
    #[inline]
    fn from(sign: Sign) -> Self {
        i8::from(sign).into()
    }
}

impl Neg for Sign {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        match self {
            Self::Negative => Self::Positive,
            Self::Zero => Self::Zero,
            Self::Positive => Self::Negative,
        }
    }
}

impl Mul for Sign {
    type Output = Self;

    #[inline]
    fn mul(self, other: Self) -> Self {
        match self {
            Self::Negative => -other,
            Self::Zero => Self::Zero,
            Self::Positive => other,
        }
    }
}
