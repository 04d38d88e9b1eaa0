//! A floating-point number in N words of 64 bits: nothing is allocated, and an operation costs tens of nanoseconds.

use std::cmp::Ordering;

use dashu_base::{BitTest, DivRem, FloatEncoding as _, SquareRootRem};
use dashu_int::{IBig, UBig};
use dashu_ratio::RBig;

use super::Sign;
use super::directed::{Directed, Toward};

/// Results with a larger exponent count as overflow.
const LARGEST: i64 = 1 << 40;

/// ± m 2^exponent with N words in m, the leading bit of which is 1; or 0. At least two words.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FixedFloat<const N: usize> {
    sign: Sign,
    /// By rising weight.
    m: [u64; N],
    exponent: i64,
}

/// The low word and the carry of x y + p + q, which is less than 2^128.
#[inline]
fn product(x: u64, y: u64, p: u64, q: u64) -> (u64, u64) {
    halves(u128::from(x) * u128::from(y) + u128::from(p) + u128::from(q))
}

/// The low and the high word.
#[allow(clippy::cast_possible_truncation)]
#[inline]
fn halves(wide: u128) -> (u64, u64) {
    (wide as u64, (wide >> 64) as u64)
}

/// a += b; the carry.
#[inline]
fn add(a: &mut [u64], b: &[u64]) -> bool {
    a.iter_mut().zip(b).fold(false, |carry, (a, b)| {
        let (sum, first) = a.overflowing_add(*b);
        let (sum, second) = sum.overflowing_add(u64::from(carry));
        *a = sum;
        first | second
    })
}

/// a −= b; the borrow.
#[inline]
fn subtract(a: &mut [u64], b: &[u64]) -> bool {
    a.iter_mut().zip(b).fold(false, |borrow, (a, b)| {
        let (rest, first) = a.overflowing_sub(*b);
        let (rest, second) = rest.overflowing_sub(u64::from(borrow));
        *a = rest;
        first | second
    })
}

/// Bits of N words, as an exponent.
#[allow(clippy::cast_possible_wrap)]
#[inline]
const fn width(words: usize) -> i64 {
    64 * words as i64
}

fn words_of(x: &UBig) -> Vec<u64> {
    let word = |bytes: &[u8]| bytes.iter().rev().fold(0, |word, &byte| word << 8 | u64::from(byte));
    x.to_le_bytes().chunks(8).map(word).collect()
}

impl<const N: usize> FixedFloat<N> {
    const ZERO: Self = Self { sign: Sign::Zero, m: [0; N], exponent: 0 };

    /// ± (words + something in (0, 1) if there is a `rest`) 2^exponent, with the leading bit in the words.
    fn rounded(sign: Sign, words: &[u64], rest: bool, exponent: i64, toward: Toward) -> Option<Self> {
        match words.iter().rposition(|word| *word != 0) {
            Some(top) => Self::led_by(top, sign, words, rest, exponent, toward),
            None => (!rest).then_some(Self::ZERO),
        }
    }

    /// The same for words whose last one that is not 0 is number `top`. (Inlined with a constant `top` it costs a third.)
    #[inline]
    fn led_by(top: usize, sign: Sign, words: &[u64], rest: bool, exponent: i64, toward: Toward) -> Option<Self> {
        let mut m = [0; N];
        let Some(from) = (top + 1).checked_sub(N) else {
            m[N - 1 - top..].copy_from_slice(&words[..=top]);
            return Self::normalized(sign, m, [0, u64::from(rest)], exponent - width(N - 1 - top), toward);
        };
        m.copy_from_slice(&words[from..=top]);
        let (next, lower) = words[..from].split_last().map_or((0, [].as_slice()), |(next, lower)| (*next, lower));
        let rest = lower.iter().fold(u64::from(rest), |rest, word| rest | word);
        Self::normalized(sign, m, [next, rest], exponent + width(from), toward)
    }

    /// ± m 2^exponent for words whose leading one is not 0. `below` is the word below them, and a word that is 0 if nothing lies
    /// below that.
    #[inline]
    fn normalized(sign: Sign, mut m: [u64; N], below: [u64; 2], mut exponent: i64, toward: Toward) -> Option<Self> {
        let [next, rest] = below;
        let lead = m[N - 1].leading_zeros();
        let mut lower = next;
        for m in &mut m {
            let word = *m;
            *m = word << lead | lower >> 1 >> (63 - lead);
            lower = word;
        }
        exponent -= i64::from(lead);
        if (next << lead | rest) != 0 && (toward == Toward::Up) == (sign == Sign::Positive) {
            let carry = m.iter_mut().all(|m| {
                *m = m.wrapping_add(1);
                *m == 0
            });
            if carry {
                m[N - 1] = 1 << 63;
                exponent += 1;
            }
        }
        (exponent.abs() < LARGEST).then_some(Self { sign, m, exponent })
    }

    fn magnitude(&self) -> UBig {
        let bytes: Vec<u8> = self.m.iter().flat_map(|word| word.to_le_bytes()).collect();
        UBig::from_le_bytes(&bytes)
    }
}

impl<const N: usize> Ord for FixedFloat<N> {
    fn cmp(&self, other: &Self) -> Ordering {
        let size = || self.exponent.cmp(&other.exponent).then_with(|| self.m.iter().rev().cmp(other.m.iter().rev()));
        self.sign.cmp(&other.sign).then_with(|| match self.sign {
            Sign::Positive => size(),
            Sign::Zero => Ordering::Equal,
            Sign::Negative => size().reverse(),
        })
    }
}

impl<const N: usize> PartialOrd for FixedFloat<N> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl<const N: usize> Directed for FixedFloat<N> {
    type Precision = ();

    fn zero() -> Self {
        Self::ZERO
    }

    fn sign(&self) -> Sign {
        self.sign
    }

    fn negated(&self) -> Self {
        Self { sign: -self.sign, ..*self }
    }

    fn plus(&self, other: &Self, (): (), toward: Toward) -> Option<Self> {
        if self.sign == Sign::Zero {
            return Some(*other);
        }
        if other.sign == Sign::Zero {
            return Some(*self);
        }
        let (a, b) = if self.exponent >= other.exponent { (self, other) } else { (other, self) };
        // Both in units of 2^-64N of the last place of a. Of a smaller b only its presence matters, since it is less
        // than half of that place.
        let (mut x, mut y) = ([[0; N]; 3], [[0; N]; 3]);
        let (x, y) = (x.as_flattened_mut(), y.as_flattened_mut());
        x[N..2 * N].copy_from_slice(&a.m);
        match usize::try_from(width(N) - (a.exponent - b.exponent)) {
            Ok(up) => {
                let (place, bits) = (up / 64, up % 64);
                for (k, m) in b.m.iter().enumerate() {
                    let (low, high) = halves(u128::from(*m) << bits);
                    y[place + k] |= low;
                    y[place + k + 1] |= high;
                }
            }
            Err(_below) => y[0] = 1,
        }
        let (x, y) = (&mut x[..=2 * N], &y[..=2 * N]);
        let mut sign = a.sign;
        if a.sign == b.sign {
            add(x, y);
        } else if subtract(x, y) {
            // Of equal exponents, and b is the larger: two's complement.
            sign = b.sign;
            for x in x.iter_mut() {
                *x = !*x;
            }
            let _ = x.iter_mut().all(|x| {
                *x = x.wrapping_add(1);
                *x == 0
            });
        }
        let exponent = a.exponent - width(N);
        if x[2 * N] != 0 {
            Self::led_by(2 * N, sign, x, false, exponent, toward)
        } else if x[2 * N - 1] != 0 {
            Self::led_by(2 * N - 1, sign, x, false, exponent, toward)
        } else {
            Self::rounded(sign, x, false, exponent, toward)
        }
    }

    fn times(&self, other: &Self, (): (), toward: Toward) -> Option<Self> {
        let mut wide = [[0; N]; 2];
        let wide = wide.as_flattened_mut();
        for (i, a) in self.m.iter().enumerate() {
            let mut carry = 0;
            for (k, b) in other.m.iter().enumerate() {
                (wide[i + k], carry) = product(*a, *b, wide[i + k], carry);
            }
            wide[i + N] = carry;
        }
        let (sign, exponent) = (self.sign * other.sign, self.exponent + other.exponent);
        if sign == Sign::Zero {
            return Some(Self::ZERO);
        }
        // Both leading bits are 1, so that the leading word of the product is not 0.
        Self::led_by(2 * N - 1, sign, wide, false, exponent, toward)
    }

    /// By Knuth's algorithm D (The Art of Computer Programming 2, 4.3.1).
    fn over(&self, other: &Self, (): (), toward: Toward) -> Option<Self> {
        if other.sign == Sign::Zero {
            return None;
        }
        let (mut rest, mut quotient) = ([[0; N]; 3], [[0; N]; 2]);
        let (rest, quotient) = (rest.as_flattened_mut(), quotient.as_flattened_mut());
        rest[N..2 * N].copy_from_slice(&self.m);
        let divisor = &other.m;
        let [first, second] = [divisor[N - 1], divisor[N - 2]].map(u128::from);
        for place in (0..=N).rev() {
            let rest = &mut rest[place..=place + N];
            let top = u128::from(rest[N]) << 64 | u128::from(rest[N - 1]);
            let (mut digit, mut left) = (top / first, top % first);
            while digit >> 64 != 0 || digit * second > (left << 64 | u128::from(rest[N - 2])) {
                digit -= 1;
                left += first;
                if left >> 64 != 0 {
                    break;
                }
            }
            let (mut digit, _) = halves(digit);
            let mut taken = [[0; N]; 2];
            let taken = &mut taken.as_flattened_mut()[..=N];
            let mut carry = 0;
            for (taken, d) in taken.iter_mut().zip(divisor) {
                (*taken, carry) = product(digit, *d, 0, carry);
            }
            taken[N] = carry;
            if subtract(rest, taken) {
                digit -= 1;
                let carry = add(&mut rest[..N], divisor);
                rest[N] = rest[N].wrapping_add(u64::from(carry));
            }
            quotient[place] = digit;
        }
        let is_inexact = rest.iter().any(|word| *word != 0);
        let exponent = self.exponent - other.exponent - width(N);
        let sign = self.sign * other.sign;
        match (sign, quotient[N]) {
            (Sign::Zero, _) => Some(Self::ZERO),
            (_, 0) => Self::led_by(N - 1, sign, quotient, is_inexact, exponent, toward),
            _ => Self::led_by(N, sign, quotient, is_inexact, exponent, toward),
        }
    }

    fn root(&self, (): (), toward: Toward) -> Option<Self> {
        if self.sign != Sign::Positive {
            return (self.sign == Sign::Zero).then_some(Self::ZERO);
        }
        // An even exponent, and 64N bits in the root.
        let is_odd = self.exponent % 2 != 0;
        let up = 64 * N - usize::from(is_odd);
        let (root, rest) = (self.magnitude() << up).sqrt_rem();
        let exponent = (self.exponent - width(N) + i64::from(is_odd)) >> 1;
        Self::rounded(Sign::Positive, &words_of(&root), !rest.is_zero(), exponent, toward)
    }

    fn rational(value: &RBig, (): (), toward: Toward) -> Option<Self> {
        let (numerator, denominator) = (value.numerator().clone().into_parts().1, value.denominator());
        let up = (64 * N + 1 + denominator.bit_len()).saturating_sub(numerator.bit_len());
        let (quotient, rest) = (numerator << up).div_rem(denominator);
        let exponent = -i64::try_from(up).ok()?;
        Self::rounded(value.numerator().into(), &words_of(&quotient), !rest.is_zero(), exponent, toward)
    }

    fn double(value: f64, (): ()) -> Option<Self> {
        let (significand, exponent) = value.decode().ok()?;
        let sign = significand.cmp(&0).into();
        Self::rounded(sign, &[significand.unsigned_abs()], false, exponent.into(), Toward::Down)
    }

    fn to_rational(&self) -> RBig {
        let power = IBig::ONE << usize::try_from(self.exponent.unsigned_abs()).unwrap_or(usize::MAX);
        let m = self.sign.orient(IBig::from(self.magnitude()));
        if self.exponent >= 0 { RBig::from(m * power) } else { RBig::from(m) / RBig::from(power) }
    }

    fn to_double(&self) -> f64 {
        let is_negative = self.sign == Sign::Negative;
        // The weight of the leading bit, and how many bits a double keeps from there on.
        let weight = self.exponent + width(N) - 1;
        if self.sign == Sign::Zero {
            return 0.0;
        }
        if weight > 1023 {
            return if is_negative { f64::NEG_INFINITY } else { f64::MAX };
        }
        let kept = (weight + 1075).clamp(0, 53);
        let Ok(kept @ 1..) = u32::try_from(kept) else { return if is_negative { -5e-324 } else { 0.0 } };
        let rest = self.m[N - 1] << kept != 0 || self.m[..N - 1].iter().any(|word| *word != 0);
        let whole = (self.m[N - 1] >> (64 - kept)) + u64::from(rest && is_negative);
        let last = weight - i64::from(kept) + 1;
        let power = match u64::try_from(last + 1023) {
            Ok(biased @ 1..) => f64::from_bits(biased << 52),
            _ => f64::from_bits(1 << (last + 1074)),
        };
        // At most 2^53, so that both are exact.
        let size = whole as f64 * power;
        if is_negative { -size } else { size }
    }

    fn bits((): ()) -> usize {
        64 * N
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::directed::Big;
    use proptest::prelude::*;

    const SIDES: [Toward; 2] = [Toward::Down, Toward::Up];

    /// Rationals with many bits or few, near each other or far apart.
    fn numbers() -> impl Strategy<Value = RBig> {
        let word = prop_oneof![3 => any::<i64>(), 1 => -3..4i64, 1 => Just(i64::MAX), 1 => Just(i64::MIN)];
        let shift = prop_oneof![2 => -70..70i32, 1 => -700..700i32];
        (prop::collection::vec(word, 1..8), shift).prop_map(|(words, shift)| {
            let whole = words.iter().fold(IBig::ZERO, |sum, word| (sum << 64) + IBig::from(*word));
            let power = IBig::ONE << shift.unsigned_abs() as usize;
            if shift < 0 { RBig::from(whole) / RBig::from(power) } else { RBig::from(whole * power) }
        })
    }

    /// The next number in a direction.
    fn beside<const N: usize>(x: &FixedFloat<N>, toward: Toward) -> RBig {
        let grows = (toward == Toward::Up) == (x.sign == Sign::Positive);
        // Towards 0 the numbers lie twice as close below a power of two.
        let is_power = x.m[N - 1] == 1 << 63 && x.m[..N - 1].iter().all(|word| *word == 0);
        let last = FixedFloat::<N> {
            sign: Sign::Positive,
            exponent: x.exponent - i64::from(is_power && !grows),
            ..FixedFloat::<N>::ZERO
        };
        let unit = FixedFloat::<N> { m: std::array::from_fn(|k| u64::from(k == 0)), ..last }.to_rational();
        if toward == Toward::Up { x.to_rational() + unit } else { x.to_rational() - unit }
    }

    /// It lies on the side that was asked for, and no other number lies between; `order` compares a rational with the exact
    /// result.
    fn nearest<const N: usize>(
        x: Option<FixedFloat<N>>,
        toward: Toward,
        order: impl Fn(&RBig) -> Ordering,
    ) -> Result<(), TestCaseError> {
        let x = x.unwrap();
        let at = order(&x.to_rational());
        let (outward, inward) = match toward {
            Toward::Down => (Ordering::Less, Toward::Up),
            Toward::Up => (Ordering::Greater, Toward::Down),
        };
        if x.sign == Sign::Zero {
            prop_assert_eq!(at, Ordering::Equal);
        } else if at != Ordering::Equal {
            prop_assert_eq!(at, outward);
            prop_assert_eq!(order(&beside(&x, inward)), outward.reverse(), "{:?}", x);
        }
        Ok(())
    }

    fn rounds<const N: usize>(p: &RBig, q: &RBig) -> Result<(), TestCaseError> {
        for toward in SIDES {
            let [a, b] = [p, q].map(|x| FixedFloat::<N>::rational(x, (), toward).unwrap());
            nearest(Some(a), toward, |x| x.cmp(p))?;
            let [p, q] = [a, b].map(|x| x.to_rational());
            for side in SIDES {
                nearest(a.plus(&b, (), side), side, |x| x.cmp(&(&p + &q)))?;
                nearest(a.plus(&b.negated(), (), side), side, |x| x.cmp(&(&p - &q)))?;
                nearest(a.times(&b, (), side), side, |x| x.cmp(&(&p * &q)))?;
                if b.sign == Sign::Zero {
                    prop_assert!(a.over(&b, (), side).is_none());
                } else {
                    nearest(a.over(&b, (), side), side, |x| x.cmp(&(&p / &q)))?;
                }
                match a.root((), side) {
                    None => prop_assert!(p < RBig::ZERO),
                    root => nearest(root, side, |x| if *x < RBig::ZERO { Ordering::Less } else { (x * x).cmp(&p) })?,
                }
            }
            prop_assert_eq!(a.cmp(&b), p.cmp(&q));
            let big = Big::rational(&p, 64 * N, toward).unwrap();
            prop_assert_eq!((big.to_rational(), big.to_double()), (p, a.to_double()));
        }
        Ok(())
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2000))]

        #[test]
        fn every_operation_gives_the_nearest_number_on_its_side(p in numbers(), q in numbers(), near in any::<bool>()) {
            let q = if near { &p + q / RBig::from(IBig::ONE << 900) } else { q };
            rounds::<2>(&p, &q)?;
            rounds::<3>(&p, &q)?;
            rounds::<6>(&p, &q)?;
        }

        #[test]
        fn doubles_are_exact(value in any::<f64>()) {
            let found = FixedFloat::<2>::double(value, ());
            prop_assert_eq!(found.is_some(), value.is_finite());
            if let Some(found) = found {
                prop_assert_eq!(found.to_rational(), RBig::try_from(value).unwrap());
                prop_assert_eq!(found.to_double(), value);
            }
        }
    }

    #[test]
    fn exponents_without_end_are_no_numbers() {
        let mut x = FixedFloat::<2>::double(2.0, ()).unwrap();
        while let Some(square) = x.times(&x, (), Toward::Up) {
            x = square;
        }
        assert!(x.exponent > 1 << 30);
        assert_eq!([x, x.negated()].map(|x| x.to_double()), [f64::MAX, f64::NEG_INFINITY]);
        let tiny =
            FixedFloat::<2>::double(1.0, ()).unwrap().over(&x.root((), Toward::Down).unwrap(), (), Toward::Up).unwrap();
        assert_eq!([tiny, tiny.negated()].map(|x| x.to_double()), [0.0, -5e-324]);
    }
}
