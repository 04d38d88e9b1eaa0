//! Numbers of a document with the errors that it states: the truth lies within them, and they are no larger than what
//! they are made of.

use dashu_int::IBig;
use dashu_ratio::RBig;

use super::fixed::Fixed;

/// A number of a document, exactly; none that is not finite, and no 0 with a sign.
pub(crate) fn exact(x: f64) -> Option<RBig> {
    RBig::try_from(x).ok().filter(|exact| !(exact.is_zero() && x.is_sign_negative()))
}

/// All numbers within an error.
pub(crate) fn around(x: f64, error: f64) -> Option<[RBig; 2]> {
    let (x, error) = (exact(x)?, exact(error)?);
    Some([&x - &error, x + error])
}

/// The range holds the other.
pub(crate) fn holds([low, high]: &[RBig; 2], [from, to]: &[RBig; 2]) -> bool {
    low <= from && to <= high
}

/// The range holds the positive roots of the numbers.
pub(crate) fn holds_root([low, high]: &[RBig; 2], [from, to]: &[RBig; 2]) -> bool {
    (*low <= RBig::ZERO || &(low * low) <= from) && *high >= RBig::ZERO && *to <= high * high
}

/// A number is a unit times every one of a set, within an error.
pub(crate) fn is_within(x: f64, error: f64, unit: &RBig, set: &Fixed) -> bool {
    around(x, error).is_some_and(|range| holds(&range, &set.ends().map(|end| end * unit)))
}

/// The square of a number is a unit times every one of a set, within an error of the number.
pub(crate) fn is_root_within(x: f64, error: f64, unit: &RBig, set: &Fixed) -> bool {
    around(x, error).is_some_and(|range| holds_root(&range, &set.ends().map(|end| end * unit)))
}

/// An error is no larger than this, apart from its own rounding.
pub(crate) fn is_at_most(error: f64, most: &RBig) -> bool {
    let thousand = |n: i32| RBig::from(1000 + n);
    exact(error).is_some_and(|error| error >= RBig::ZERO && error * thousand(0) <= most * thousand(1))
}

/// So many roundings of doubles of this size.
pub(crate) fn roundings(number: u32, size: &RBig) -> RBig {
    size * RBig::from(number) / RBig::from(IBig::ONE << 52usize)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_hold_roots_by_their_squares() {
        let n = |n: i32| RBig::from(n);
        assert!(holds_root(&[n(2), n(3)], &[n(4), n(9)]));
        assert!(holds_root(&[n(-5), n(3)], &[n(4), n(9)]));
        assert!(!holds_root(&[n(3), n(4)], &[n(4), n(9)]));
        assert!(!holds_root(&[n(-4), n(-3)], &[n(9), n(9)]));
    }

    #[test]
    fn numbers_are_finite_and_zero_has_no_sign() {
        assert_eq!(exact(0.0), Some(RBig::ZERO));
        assert!([-0.0, f64::NAN, f64::INFINITY].into_iter().all(|x| exact(x).is_none()));
    }

    #[test]
    fn errors_are_no_larger_than_they_may_be() {
        let most = roundings(4, &RBig::from(8));
        assert!(is_at_most(0.0, &most) && is_at_most(32.0 * f64::EPSILON, &most));
        assert!(!is_at_most(33.0 * f64::EPSILON, &most) && !is_at_most(-1e-20, &most) && !is_at_most(f64::NAN, &most));
    }
}
