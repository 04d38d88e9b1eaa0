//! The contract of interval arithmetic: what every type of intervals guarantees, in every precision.
//!
//! An interval is a closed, non-empty set of reals given by two ends. An infinite end says that there is no bound; it
//! is not a member. The result of an operation holds the exact result for every choice of members, always:
//!
//! | case | result |
//! | --- | --- |
//! | rounding | ends move outward |
//! | the point 0 | exact: 0 + X = X, 0 · X = 0 even when X is unbounded, 0 / X = 0 |
//! | 0 · ∞ or ∞ − ∞ among the ends | the whole line |
//! | overflow | no bound on that side, or the whole line |
//! | a divisor that holds 0 | the whole line |
//! | square root | of the members that are not negative; the whole line if there are none |
//! | common part of disjoint intervals | `None` |
//!
//! So a sign may be unknown, but is never wrong. `tests/intervals.rs` holds every type against exact rationals.

use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

use dashu_ratio::RBig;

use crate::Sign;

/// The operations in which formulas are written.
pub trait Arithmetic:
    Clone + Debug + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// How many bits the ends carry.
    type Precision: Copy + Debug;

    /// All reals: nothing is known.
    fn line(precision: Self::Precision) -> Self;

    /// An exact number, as narrow as the precision allows.
    fn rational(value: &RBig, precision: Self::Precision) -> Self;

    /// A double, as a point; the whole line when it is not finite.
    fn double(value: f64, precision: Self::Precision) -> Self;

    /// √x.
    #[must_use]
    fn sqrt(&self) -> Self;

    /// x²; a finite lower end is not negative.
    #[must_use]
    fn square(&self) -> Self;

    /// Common part of two results for one value; `None` when they contradict each other.
    #[must_use]
    fn meet(&self, other: &Self) -> Option<Self>;

    /// A small whole number, as a point.
    fn small(value: i32, precision: Self::Precision) -> Self {
        Self::double(f64::from(value), precision)
    }
}

/// Intervals: operations that use the ends.
pub trait Enclosure: Arithmetic {
    /// The sign that all members share; zero only for the point 0.
    fn sign(&self) -> Option<Sign>;

    /// The sign that all members share, if it is not zero.
    fn strict_sign(&self) -> Option<Sign> {
        self.sign()?.strict()
    }

    /// The smallest interval that holds both.
    #[must_use]
    fn hull(&self, other: &Self) -> Self;

    /// The lower end, as a point; the whole line when it is infinite.
    #[must_use]
    fn lower(&self) -> Self;

    /// The upper end, as a point; the whole line when it is infinite.
    #[must_use]
    fn upper(&self) -> Self;

    /// A point between the ends (or an end); the whole line when an end is infinite.
    #[must_use]
    fn middle(&self) -> Self;

    /// Ends rounded outward to `f64`.
    fn bounds(&self) -> [f64; 2];

    /// The ends, exactly; `None` when one is infinite.
    fn exact_bounds(&self) -> Option<[RBig; 2]>;

    /// Relative spacing of the ends' numbers, with a few bits to spare.
    fn resolution(precision: Self::Precision) -> f64;

    /// Every member is less than every member of `other`.
    fn is_below(&self, other: &Self) -> bool {
        (other.clone() - self.clone()).sign() == Some(Sign::Positive)
    }
}

/// The values of a polynomial, given by its coefficients by rising power, by Horner's rule.
#[must_use]
pub fn horner<E: Arithmetic>(c: &[E], at: &E, precision: E::Precision) -> E {
    c.iter().rev().fold(E::small(0, precision), |sum, c| sum * at.clone() + c.clone())
}
