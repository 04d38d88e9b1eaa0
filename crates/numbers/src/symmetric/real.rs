//! A real number between two rationals.

use dashu_base::SquareRoot;
use dashu_int::{IBig, UBig};
use dashu_ratio::RBig;

/// A real number, exact or enclosed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Real {
    /// Not above the number.
    pub lo: RBig,
    /// Not below the number; equal to `lo` when the number is this rational.
    pub hi: RBig,
}

impl Real {
    /// A rational.
    #[must_use]
    pub fn exact(value: RBig) -> Self {
        Self { lo: value.clone(), hi: value }
    }

    /// The number is the rational `lo`.
    #[must_use]
    pub fn is_exact(&self) -> bool {
        self.lo == self.hi
    }

    /// −x.
    #[must_use]
    pub fn negated(&self) -> Self {
        Self { lo: -self.hi.clone(), hi: -self.lo.clone() }
    }

    /// hi − lo ≤ 10^−digits · |x|.
    #[must_use]
    pub fn is_known_to(&self, digits: usize) -> bool {
        let size = if self.lo > RBig::ZERO { &self.lo } else { &-self.hi.clone() };
        self.is_exact() || (&self.hi - &self.lo) * power_of_ten(digits) <= *size
    }

    /// √x of a rational x ≥ 0: exact where x is a square, else known to so many digits.
    #[must_use]
    pub fn root_of(x: &RBig, digits: usize) -> Self {
        let (numerator, denominator) = (x.numerator().clone().into_parts().1, x.denominator().clone());
        let [p, q] = [&numerator, &denominator].map(SquareRoot::sqrt);
        if &p * &p == numerator && &q * &q == denominator {
            return Self::exact(RBig::from_parts(p.into(), q));
        }
        // √(p/q) = √(p q 4^s) / (q 2^s), with so large an s that one unit is below 10^-digits of it.
        let product = &numerator * &denominator;
        let wanted = 4 * digits + 4;
        let shift = wanted.saturating_sub(bits(&product) / 2);
        let root = (product << (2 * shift)).sqrt();
        let unit = denominator << shift;
        let over = |root: UBig| RBig::from_parts(IBig::from(root), unit.clone());
        Self { lo: over(root.clone()), hi: over(root + UBig::ONE) }
    }

    /// A decimal of so many significant digits, off by at most one unit of the last one and the width of the enclosure;
    /// an exact number with fewer digits stays what it is.
    #[must_use]
    pub fn decimal(&self, digits: usize) -> String {
        let middle = (&self.lo + &self.hi) / RBig::from(2);
        crate::decimal::of_length(&middle, digits)
    }

    /// The nearest double of the middle.
    #[must_use]
    pub fn to_f64(&self) -> f64 {
        ((&self.lo + &self.hi) / RBig::from(2)).to_f64().value()
    }
}

fn bits(x: &UBig) -> usize {
    dashu_base::BitTest::bit_len(x)
}

/// 10^power.
pub(super) fn power_of_ten(power: usize) -> RBig {
    RBig::from(IBig::from(10).pow(power))
}
