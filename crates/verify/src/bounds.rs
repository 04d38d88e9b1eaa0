//! Numbers of a document with the errors that it states: the truth lies within them, and they are not so large that they
//! say nothing.

use dashu_int::IBig;
use dashu_ratio::RBig;

use super::fixed::Fixed;

/// An error is at most 2⁻ᵇ of the size of what it belongs to.
const USEFUL: usize = 20;

/// All numbers within an error.
pub(super) fn around(x: f64, error: f64) -> Option<[RBig; 2]> {
    let (x, error) = (RBig::try_from(x).ok()?, RBig::try_from(error).ok()?);
    Some([&x - &error, x + error])
}

/// The range holds the other.
pub(super) fn holds([low, high]: &[RBig; 2], [from, to]: &[RBig; 2]) -> bool {
    low <= from && to <= high
}

/// The range holds the positive roots of the numbers.
pub(super) fn holds_root([low, high]: &[RBig; 2], [from, to]: &[RBig; 2]) -> bool {
    (*low <= RBig::ZERO || &(low * low) <= from) && *high >= RBig::ZERO && *to <= high * high
}

/// A number is a unit times every one of a set, within an error.
pub(super) fn is_within(x: f64, error: f64, unit: &RBig, set: &Fixed) -> bool {
    around(x, error).is_some_and(|range| holds(&range, &set.ends().map(|end| end * unit)))
}

/// The square of a number is a unit times every one of a set, within an error of the number.
pub(super) fn is_root_within(x: f64, error: f64, unit: &RBig, set: &Fixed) -> bool {
    around(x, error).is_some_and(|range| holds_root(&range, &set.ends().map(|end| end * unit)))
}

/// An error that says something about a number of this size.
pub(super) fn is_useful(error: f64, size: &RBig) -> bool {
    RBig::try_from(error).is_ok_and(|error| error >= RBig::ZERO && error * RBig::from(IBig::ONE << USEFUL) <= *size)
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
    fn errors_are_useful_or_refused() {
        let size = RBig::from(4);
        assert!(is_useful(0.0, &size) && is_useful(1e-6, &size));
        assert!(!is_useful(1e-5, &size) && !is_useful(-1e-9, &size) && !is_useful(f64::NAN, &size));
    }
}
