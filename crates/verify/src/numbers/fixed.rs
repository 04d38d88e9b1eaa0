//! Interval arithmetic on integers: both ends are multiples of 2⁻ᵇ, where every set knows its b.
//!
//! Whole numbers have b = 0 and are exact; a result has the larger b of its operands. Ends are of any size, so nothing
//! overflows and no end is infinite. What has no value (a quotient whose divisor may be 0, the root of a negative set,
//! the common part of disjoint sets) is `None`, and the check that needed it fails.

use std::borrow::Cow;
use std::ops::{Add, Mul, Neg, Sub};

use dashu_base::{DivEuclid, Signed, SquareRoot};
use dashu_int::IBig;
use dashu_ratio::RBig;

/// All reals between two multiples of 2⁻ᵇ.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Fixed {
    lo: IBig,
    hi: IBig,
    bits: usize,
}

/// ⌊n/d⌋ for d > 0.
fn floor_div(n: IBig, d: &IBig) -> IBig {
    n.div_euclid(d)
}

fn ceil_div(n: IBig, d: &IBig) -> IBig {
    -(-n).div_euclid(d)
}

/// ⌊n/2ᵇ⌋: a shift of a negative number rounds down.
fn floor_shift(n: IBig, bits: usize) -> IBig {
    n >> bits
}

/// ⌈n/2ᵇ⌉
fn ceil_shift(n: IBig, bits: usize) -> IBig {
    -((-n) >> bits)
}

impl Fixed {
    /// A number within 2⁻ᵇ.
    pub fn of(x: &RBig, bits: usize) -> Self {
        let (n, d) = (x.numerator() << bits, IBig::from(x.denominator().clone()));
        Self { lo: floor_div(n.clone(), &d), hi: ceil_div(n, &d), bits }
    }

    pub fn whole(n: i32) -> Self {
        let n = IBig::from(n);
        Self { lo: n.clone(), hi: n, bits: 0 }
    }

    /// The same set with at least `bits` bits.
    fn at(&self, bits: usize) -> Cow<'_, Self> {
        if self.bits >= bits {
            return Cow::Borrowed(self);
        }
        let shift = bits - self.bits;
        Cow::Owned(Self { lo: &self.lo << shift, hi: &self.hi << shift, bits })
    }

    /// Two sets with the same bits.
    fn aligned<'a>(&'a self, other: &'a Self) -> [Cow<'a, Self>; 2] {
        [self.at(other.bits), other.at(self.bits)]
    }

    /// Both ends as exact numbers.
    pub fn ends(&self) -> [RBig; 2] {
        let step = IBig::ONE << self.bits;
        [&self.lo, &self.hi].map(|end| RBig::from(end.clone()) / RBig::from(step.clone()))
    }

    /// 1, −1, or 0 for zero alone; `None` when the signs differ.
    pub fn sign(&self) -> Option<i8> {
        let zero = IBig::ZERO;
        if self.lo > zero {
            Some(1)
        } else if self.hi < zero {
            Some(-1)
        } else if self.lo == zero && self.hi == zero {
            Some(0)
        } else {
            None
        }
    }

    /// 1 without negative numbers, −1 without positive ones, 0 with both.
    fn side(&self) -> i8 {
        i8::from(!self.lo.is_negative()) - i8::from(self.lo.is_negative() && self.hi <= IBig::ZERO)
    }

    /// 1 or −1 when every number here has that sign.
    pub fn strict_sign(&self) -> Option<i8> {
        self.sign().filter(|sign| *sign != 0)
    }

    pub fn is_positive(&self) -> bool {
        self.sign() == Some(1)
    }

    /// self / other; `None` when the divisor may be 0.
    pub fn over(&self, other: &Self) -> Option<Self> {
        match other.strict_sign()? {
            1 => {
                let bits = self.bits.max(other.bits);
                let shift = bits + other.bits - self.bits;
                let least = if self.lo.is_negative() { &other.lo } else { &other.hi };
                let greatest = if self.hi.is_negative() { &other.hi } else { &other.lo };
                let (lo, hi) = (floor_div(&self.lo << shift, least), ceil_div(&self.hi << shift, greatest));
                Some(Self { lo, hi, bits })
            }
            _ => (-self).over(&-other),
        }
    }

    /// The square root of a number that is known not to be negative; `None` when every number here is.
    pub fn root(&self) -> Option<Self> {
        let root = |n: &IBig| {
            let (_, magnitude) = (n << self.bits).max(IBig::ZERO).into_parts();
            IBig::from(magnitude.sqrt())
        };
        let set = || Self { lo: root(&self.lo), hi: root(&self.hi) + IBig::ONE, bits: self.bits };
        (!self.hi.is_negative()).then(set)
    }

    pub fn square(&self) -> Self {
        let product = self * self;
        Self { lo: product.lo.max(IBig::ZERO), ..product }
    }

    /// Exact for whole numbers.
    pub fn half(&self) -> Self {
        let set = self.at(1);
        Self { lo: &set.lo >> 1usize, hi: ceil_shift(set.hi.clone(), 1), bits: set.bits }
    }

    pub fn hull(&self, other: &Self) -> Self {
        let [p, q] = self.aligned(other);
        Self { lo: (&p.lo).min(&q.lo).clone(), hi: (&p.hi).max(&q.hi).clone(), bits: p.bits }
    }

    /// Common part of two enclosures of one number; `None` when they contradict each other.
    pub fn meet(&self, other: &Self) -> Option<Self> {
        let [p, q] = self.aligned(other);
        let (lo, hi) = ((&p.lo).max(&q.lo), (&p.hi).min(&q.hi));
        (lo <= hi).then(|| Self { lo: lo.clone(), hi: hi.clone(), bits: p.bits })
    }

    pub fn lower(&self) -> Self {
        Self { hi: self.lo.clone(), ..self.clone() }
    }

    pub fn upper(&self) -> Self {
        Self { lo: self.hi.clone(), ..self.clone() }
    }

    pub fn middle(&self) -> Self {
        let middle: IBig = (&self.lo + &self.hi) >> 1usize;
        Self { lo: middle.clone(), hi: middle, bits: self.bits }
    }

    /// Its width is at most 2⁻ᵇ of each of its numbers.
    pub fn is_sharp(&self, bits: usize) -> bool {
        let width = (&self.hi - &self.lo) << bits;
        width <= self.lo || width <= -&self.hi
    }

    /// Every number here is below every number there.
    pub fn below(&self, other: &Self) -> bool {
        let [p, q] = self.aligned(other);
        p.hi < q.lo
    }

    /// Every number here is at most every number there.
    pub fn at_most(&self, other: &Self) -> bool {
        let [p, q] = self.aligned(other);
        p.hi <= q.lo
    }

    /// All of this lies in `other`.
    pub fn inside(&self, other: &Self) -> bool {
        let [p, q] = self.aligned(other);
        q.lo <= p.lo && p.hi <= q.hi
    }

    /// All of this lies between two numbers.
    pub fn lies_in(&self, lo: &RBig, hi: &RBig) -> bool {
        let compare =
            |end: &IBig, x: &RBig| (end * IBig::from(x.denominator().clone())).cmp(&(x.numerator() << self.bits));
        compare(&self.lo, lo).is_ge() && compare(&self.hi, hi).is_le()
    }

    /// The double next to the middle: for messages, not for bounds.
    pub fn to_f64(&self) -> f64 {
        let [lo, hi] = self.ends();
        ((lo + hi) / RBig::from(2)).to_f64().value()
    }
}

impl Add for &Fixed {
    type Output = Fixed;
    fn add(self, other: Self) -> Fixed {
        let [p, q] = self.aligned(other);
        Fixed { lo: &p.lo + &q.lo, hi: &p.hi + &q.hi, bits: p.bits }
    }
}

impl Sub for &Fixed {
    type Output = Fixed;
    fn sub(self, other: Self) -> Fixed {
        let [p, q] = self.aligned(other);
        Fixed { lo: &p.lo - &q.hi, hi: &p.hi - &q.lo, bits: p.bits }
    }
}

impl Neg for &Fixed {
    type Output = Fixed;
    fn neg(self) -> Fixed {
        Fixed { lo: -&self.hi, hi: -&self.lo, bits: self.bits }
    }
}

impl Mul for &Fixed {
    type Output = Fixed;
    fn mul(self, other: Self) -> Fixed {
        let (bits, surplus) = (self.bits.max(other.bits), self.bits.min(other.bits));
        let [p, q] = [self, other];
        let product = |a: &IBig, b: &IBig| a * b;
        let (least, greatest) = match [p, q].map(Fixed::side) {
            [1, 1] => (product(&p.lo, &q.lo), product(&p.hi, &q.hi)),
            [1, -1] => (product(&p.hi, &q.lo), product(&p.lo, &q.hi)),
            [-1, 1] => (product(&p.lo, &q.hi), product(&p.hi, &q.lo)),
            [-1, -1] => (product(&p.hi, &q.hi), product(&p.lo, &q.lo)),
            [1, _] => (product(&p.hi, &q.lo), product(&p.hi, &q.hi)),
            [_, 1] => (product(&p.lo, &q.hi), product(&p.hi, &q.hi)),
            [-1, _] => (product(&p.lo, &q.hi), product(&p.lo, &q.lo)),
            [_, -1] => (product(&p.hi, &q.lo), product(&p.lo, &q.lo)),
            _ => (product(&p.lo, &q.hi).min(product(&p.hi, &q.lo)), product(&p.lo, &q.lo).max(product(&p.hi, &q.hi))),
        };
        Fixed { lo: floor_shift(least, surplus), hi: ceil_shift(greatest, surplus), bits }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Ordinary rationals, zero and whole numbers, and numbers far larger and far smaller than the grid's step.
    fn rationals() -> impl Strategy<Value = RBig> {
        let ratio = |p: i64, q: u32| RBig::from_parts(p.into(), q.into());
        let scale = |x: RBig, power: i32| {
            let factor = RBig::from(IBig::ONE << power.unsigned_abs() as usize);
            if power < 0 { x / factor } else { x * factor }
        };
        prop_oneof![
            (-9999i64..9999, 1u32..999).prop_map(move |(p, q)| ratio(p, q)),
            (-3i64..=3).prop_map(RBig::from),
            (any::<i64>(), 1u32..u32::MAX, -400i32..400).prop_map(move |(p, q, power)| scale(ratio(p, q), power)),
        ]
    }

    /// A set, some of one number, and a member of it.
    fn sets() -> impl Strategy<Value = (Fixed, RBig)> {
        let bits = prop::sample::select(vec![0usize, 1, 64, 256, 1024]);
        (rationals(), rationals(), rationals(), bits).prop_map(|(p, q, x, bits)| {
            let (lo, hi) = if p <= q { (p, q) } else { (q, p) };
            let x = x.clamp(lo.clone(), hi.clone());
            (Fixed::of(&lo, bits).hull(&Fixed::of(&hi, bits)), x)
        })
    }

    fn holds(set: &Fixed, x: &RBig) -> bool {
        let scaled = x * RBig::from(IBig::ONE << set.bits);
        set.lo <= set.hi && RBig::from(set.lo.clone()) <= scaled && scaled <= RBig::from(set.hi.clone())
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(1000))]

        #[test]
        fn operations_hold_every_result((a, x) in sets(), (b, y) in sets()) {
            prop_assert!(holds(&a, &x) && holds(&Fixed::of(&x, a.bits), &x));
            prop_assert!(holds(&(&a + &b), &(&x + &y)));
            prop_assert!(holds(&(&a - &b), &(&x - &y)));
            prop_assert!(holds(&(&a * &b), &(&x * &y)));
            prop_assert!(holds(&-&a, &-&x));
            prop_assert!(holds(&a.square(), &(&x * &x)));
            prop_assert!(holds(&a.half(), &(&x / RBig::from(2))));
            prop_assert!(holds(&a.hull(&b), &x) && holds(&a.hull(&b), &y));
            match a.over(&b) {
                Some(quotient) => prop_assert!(holds(&quotient, &(&x / &y))),
                None => prop_assert!(holds(&b, &RBig::ZERO)),
            }
        }

        #[test]
        fn roots_hold_every_root((a, x) in sets()) {
            // √t of t = x² is |x|; for sets that reach below 0 only the other part counts.
            let size = x.clone().max(-x);
            let square = a.square();
            prop_assert!(holds(&square.root().unwrap(), &size));
            let reaching = square.hull(&Fixed::whole(-1));
            prop_assert!(holds(&reaching.root().unwrap(), &size));
        }

        #[test]
        fn common_parts_hold_common_members((a, x) in sets(), (b, _) in sets()) {
            match a.meet(&b) {
                Some(met) => prop_assert!(met.inside(&a) && met.inside(&b) && (!holds(&b, &x) || holds(&met, &x))),
                None => prop_assert!(a.below(&b) || b.below(&a)),
            }
        }

        #[test]
        fn order_and_signs_are_claimed_only_when_certain((a, x) in sets(), (b, y) in sets()) {
            prop_assert!(!a.below(&b) || x < y);
            prop_assert!(!a.at_most(&b) || x <= y);
            prop_assert!(!a.inside(&b) || holds(&b, &x));
            let zero = RBig::ZERO;
            let right = match a.sign() {
                Some(1) => x > zero,
                Some(0) => x == zero,
                Some(_) => x < zero,
                None => holds(&a, &zero),
            };
            prop_assert!(right);
        }
    }

    #[test]
    fn what_has_no_value_has_no_set() {
        let (one, two) = (Fixed::whole(1), Fixed::whole(2));
        assert_eq!(one.over(&(&one - &one)), None);
        assert_eq!((-&one).root(), None);
        assert_eq!(one.meet(&two), None);
        assert_eq!(Fixed::whole(0).root().unwrap().lo, IBig::ZERO);
    }
}
