//! Sums and products of polynomials with integer coefficients.

use dashu_int::IBig;

use super::polynomial::Polynomial;

impl Polynomial {
    /// A constant.
    #[must_use]
    pub fn constant(value: IBig) -> Self {
        Self::new(vec![value])
    }

    /// t − root.
    #[must_use]
    pub fn linear(root: &IBig) -> Self {
        Self::new(vec![-root.clone(), IBig::ONE])
    }

    /// p + q.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        let (long, short) = if self.coefficients().len() >= other.coefficients().len() {
            (self.coefficients(), other.coefficients())
        } else {
            (other.coefficients(), self.coefficients())
        };
        let mut sum = long.to_vec();
        for (at, c) in sum.iter_mut().zip(short) {
            *at += c;
        }
        Self::new(sum)
    }

    /// p q.
    #[must_use]
    pub fn times(&self, other: &Self) -> Self {
        let (p, q) = (self.coefficients(), other.coefficients());
        if p.is_empty() || q.is_empty() {
            return Self::new(Vec::new());
        }
        let mut product = vec![IBig::ZERO; p.len() + q.len() - 1];
        for (i, a) in p.iter().enumerate() {
            for (j, b) in q.iter().enumerate() {
                product[i + j] += a * b;
            }
        }
        Self::new(product)
    }

    /// c p.
    #[must_use]
    pub fn scaled(&self, factor: &IBig) -> Self {
        Self::new(self.coefficients().iter().map(|c| c * factor).collect())
    }

    /// p − q.
    #[must_use]
    pub fn minus(&self, other: &Self) -> Self {
        self.plus(&other.scaled(&IBig::NEG_ONE))
    }

    /// p².
    #[must_use]
    pub fn squared(&self) -> Self {
        self.times(self)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use dashu_ratio::RBig;
    use proptest::prelude::*;

    fn polynomial(c: &[i32]) -> Polynomial {
        Polynomial::new(c.iter().map(|&c| IBig::from(c)).collect())
    }

    proptest! {
        #[test]
        fn the_ring_of_polynomials_maps_to_values(
            p in proptest::collection::vec(-9i32..9, 0..6),
            q in proptest::collection::vec(-9i32..9, 0..6),
            at in -5i32..5,
        ) {
            let value = |c: &Polynomial| {
                c.coefficients().iter().rev().fold(IBig::ZERO, |sum, c| sum * IBig::from(at) + c)
            };
            let (p, q) = (polynomial(&p), polynomial(&q));
            prop_assert_eq!(value(&p.plus(&q)), value(&p) + value(&q));
            prop_assert_eq!(value(&p.minus(&q)), value(&p) - value(&q));
            prop_assert_eq!(value(&p.times(&q)), value(&p) * value(&q));
            prop_assert_eq!(value(&p.squared()), value(&p) * value(&p));
            prop_assert_eq!(p.minus(&p).sign_at(&RBig::from(at)), crate::Sign::Zero);
        }
    }
}
