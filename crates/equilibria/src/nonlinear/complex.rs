//! Complex numbers over any arithmetic.

use std::ops::{Add, Mul};

use bifdiag_numbers::Sign;
use bifdiag_numbers::enclosure::{Arithmetic, Enclosure};

/// re + i·im.
#[derive(Clone, Debug)]
pub(super) struct Complex<E> {
    pub(super) re: E,
    pub(super) im: E,
}

impl<E: Arithmetic> Complex<E> {
    pub(super) fn scaled(&self, factor: &E) -> Self {
        Self { re: self.re.clone() * factor.clone(), im: self.im.clone() * factor.clone() }
    }

    pub(super) fn conjugate(&self) -> Self {
        Self { re: self.re.clone(), im: -self.im.clone() }
    }

    /// The real part of the product.
    pub(super) fn real_product(&self, other: &Self) -> E {
        self.re.clone() * other.re.clone() - self.im.clone() * other.im.clone()
    }
}

impl<E: Enclosure> Complex<E> {
    /// Known to be 0.
    pub(super) fn is_zero(&self) -> bool {
        [&self.re, &self.im].into_iter().all(|part| part.sign() == Some(Sign::Zero))
    }
}

impl<E: Arithmetic> Add for Complex<E> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { re: self.re + other.re, im: self.im + other.im }
    }
}

impl<E: Arithmetic> Mul for Complex<E> {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self {
            re: self.re.clone() * other.re.clone() - self.im.clone() * other.im.clone(),
            im: self.re * other.im + self.im * other.re,
        }
    }
}
