//! Interval arithmetic on doubles, for paths on the sphere.
//!
//! Each end moves outward by one unit in the last place after each operation, which encloses the exact result in every
//! rounding mode. The lower end is never +∞ and the upper end never −∞, so that sums cannot be ∞ − ∞; an infinite end
//! is not a member, so that a product of 0 with it is 0.

use std::ops::{Add, Mul, Neg, Sub};

use super::fixed::Fixed;

/// The reals between `lo` and `hi`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Interval {
    lo: f64,
    hi: f64,
}

const WHOLE_LINE: Interval = Interval { lo: f64::NEG_INFINITY, hi: f64::INFINITY };

impl Interval {
    /// The reals between two doubles; the whole line unless both are finite and in order.
    pub fn between(lo: f64, hi: f64) -> Self {
        if lo.is_finite() && hi.is_finite() && lo <= hi { Self { lo, hi } } else { WHOLE_LINE }
    }

    pub fn point(x: f64) -> Self {
        Self::between(x, x)
    }

    /// A small enclosure of a set, whose ends lie between the neighbours of their nearest doubles.
    pub fn of(set: &Fixed) -> Self {
        let [lo, hi] = set.ends().map(|end| end.to_f64().value());
        Self { lo: lo.next_down(), hi: hi.next_up() }
    }

    pub fn middle(self) -> f64 {
        0.5 * (self.lo + self.hi)
    }

    /// 1/x; the whole line when x may be 0.
    pub fn recip(self) -> Self {
        if self.lo <= 0.0 && self.hi >= 0.0 {
            return WHOLE_LINE;
        }
        Self { lo: (1.0 / self.hi).next_down(), hi: (1.0 / self.lo).next_up() }
    }

    /// x², never negative.
    pub fn square(self) -> Self {
        let (p, q) = (self.lo * self.lo, self.hi * self.hi);
        let lo = if self.lo <= 0.0 && self.hi >= 0.0 { 0.0 } else { p.min(q).next_down().max(0.0) };
        Self { lo, hi: p.max(q).next_up() }
    }

    /// The square root of a number that is known not to be negative.
    pub fn sqrt(self) -> Self {
        Self { lo: self.lo.max(0.0).sqrt().next_down().max(0.0), hi: self.hi.max(0.0).sqrt().next_up() }
    }

    /// 1 or −1 when every member has that sign.
    pub fn sign(self) -> Option<i8> {
        if self.lo > 0.0 {
            Some(1)
        } else if self.hi < 0.0 {
            Some(-1)
        } else {
            None
        }
    }
}

/// A product of ends: 0 times an infinite end is 0.
fn product(p: f64, q: f64) -> f64 {
    if p == 0.0 || q == 0.0 { 0.0 } else { p * q }
}

impl Add for Interval {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { lo: (self.lo + other.lo).next_down(), hi: (self.hi + other.hi).next_up() }
    }
}

impl Sub for Interval {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Neg for Interval {
    type Output = Self;
    fn neg(self) -> Self {
        Self { lo: -self.hi, hi: -self.lo }
    }
}

impl Mul for Interval {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let (a, b) = (product(self.lo, other.lo), product(self.lo, other.hi));
        let (c, d) = (product(self.hi, other.lo), product(self.hi, other.hi));
        Self { lo: a.min(b).min(c.min(d)).next_down(), hi: a.max(b).max(c.max(d)).next_up() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use dashu_ratio::RBig;
    use proptest::prelude::*;

    /// Doubles at which arithmetic overflows, underflows, changes sign or is exact, and ordinary ones.
    fn doubles() -> impl Strategy<Value = f64> {
        let special = [
            0.0,
            -0.0,
            f64::from_bits(1),
            f64::MIN_POSITIVE,
            1e-200,
            f64::EPSILON,
            1.0 - f64::EPSILON,
            1.0,
            1.0 + f64::EPSILON,
            1e200,
            f64::MAX,
        ];
        let signed =
            (prop::sample::select(special.to_vec()), any::<bool>()).prop_map(|(x, flip)| if flip { -x } else { x });
        let any_size = any::<f64>().prop_filter("finite", |x| x.is_finite());
        prop_oneof![signed, any_size, -10.0..10.0f64]
    }

    /// An interval, some with infinite ends, and a member of it.
    fn intervals() -> impl Strategy<Value = (Interval, f64)> {
        (doubles(), doubles(), doubles(), 0..8u8).prop_map(|(p, q, x, ends)| {
            let (mut lo, mut hi) = (p.min(q), p.max(q));
            if ends == 1 || ends == 3 {
                lo = f64::NEG_INFINITY;
            }
            if ends == 2 || ends == 3 {
                hi = f64::INFINITY;
            }
            (Interval { lo, hi }, x.clamp(lo, hi))
        })
    }

    fn exact(x: f64) -> RBig {
        RBig::try_from(x).expect("finite")
    }

    /// The set is one, and holds the exact number.
    fn holds(set: Interval, x: &RBig) -> bool {
        let proper = set.lo < f64::INFINITY && set.hi > f64::NEG_INFINITY && set.lo <= set.hi;
        let above = set.lo == f64::NEG_INFINITY || exact(set.lo) <= *x;
        proper && above && (set.hi == f64::INFINITY || *x <= exact(set.hi))
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2000))]

        #[test]
        fn operations_hold_every_result((a, x) in intervals(), (b, y) in intervals()) {
            let (p, q) = (exact(x), exact(y));
            prop_assert!(holds(a + b, &(&p + &q)), "{a:?} + {b:?} = {:?}", a + b);
            prop_assert!(holds(a - b, &(&p - &q)), "{a:?} - {b:?} = {:?}", a - b);
            prop_assert!(holds(a * b, &(&p * &q)), "{a:?} * {b:?} = {:?}", a * b);
            prop_assert!(holds(-a, &-&p));
            prop_assert!(holds(a.square(), &(&p * &p)), "{a:?}² = {:?}", a.square());
            if y != 0.0 {
                prop_assert!(holds(b.recip(), &(RBig::ONE / &q)), "1/{b:?} = {:?}", b.recip());
            }
            if let Some(sign) = a.sign() {
                prop_assert_eq!(f64::from(sign), x.signum());
                prop_assert!(x != 0.0);
            }
        }

        #[test]
        fn roots_hold_every_root((a, x) in intervals()) {
            // √t of t = x² is |x|; for sets that reach below 0 only the other part counts.
            let square = a.square();
            prop_assert!(holds(square.sqrt(), &exact(x.abs())), "√{square:?} = {:?}", square.sqrt());
            let reaching = Interval { lo: -1.0, hi: square.hi };
            prop_assert!(holds(reaching.sqrt(), &exact(x.abs())));
        }

        #[test]
        fn exact_numbers_are_enclosed(x in doubles(), y in doubles(), z in doubles()) {
            let number = if z == 0.0 { exact(x) * exact(y) } else { exact(x) * exact(y) / exact(z) };
            let set = Interval::of(&Fixed::of(&number, 64));
            prop_assert!(holds(set, &number), "{number} in {set:?}");
        }
    }

    #[test]
    fn only_finite_ends_in_order_make_an_interval() {
        for (lo, hi) in [(f64::NAN, 1.0), (0.0, f64::NAN), (1.0, 0.0), (f64::INFINITY, f64::INFINITY)] {
            assert_eq!(Interval::between(lo, hi), WHOLE_LINE);
        }
        assert_eq!(Interval::between(0.0, 1.0), Interval { lo: 0.0, hi: 1.0 });
    }

    #[test]
    fn signs_are_claimed_only_when_certain() {
        assert_eq!(Interval::between(1.0, 2.0).sign(), Some(1));
        assert_eq!(Interval::between(-1.0, 2.0).sign(), None);
        assert_eq!(Interval::point(0.0).sign(), None);
        assert_eq!((Interval::point(0.1) + Interval::point(0.2) - Interval::point(0.3)).sign(), None);
        assert_eq!((Interval::point(0.0) * WHOLE_LINE).sign(), None);
    }
}
