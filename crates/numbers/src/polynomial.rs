//! Polynomials with integer coefficients and exact isolation of their real roots.
//!
//! Descartes' rule on (0, 1) (Vincent, Collins and Akritas): the sign variations of (1+x)^n p(1/(1+x)) bound the number of
//! roots, with equality for 0 and 1. Intervals with more are halved; what halving does not separate within
//! `SPLITS` levels is a multiple root (or nearly one), and the squarefree part by gcd is isolated instead. No crate
//! of pure Rust isolates roots of integer polynomials with certainty; the tests compare with python-flint.

use std::sync::Arc;

use dashu_base::{Gcd, Signed};
use dashu_int::{IBig, UBig};
use dashu_ratio::RBig;

use crate::modular::surely_coprime;

/// Halvings after which multiple roots are looked for by gcd.
const SPLITS: usize = 48;
/// Halvings of a squarefree polynomial; beyond, roots are closer than anything that the rest could use.
const MAX_SPLITS: usize = 4000;

/// c\[0\] + c\[1\] t + …; no trailing zeros.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Polynomial {
    c: Vec<IBig>,
}

/// A real root in a range that holds no other.
#[derive(Clone, Debug)]
pub struct Root {
    /// Squarefree at this root: it changes sign there.
    polynomial: Arc<Polynomial>,
    /// lo ≤ root ≤ hi; equal when the root is this rational, else neither end is a root.
    pub lo: RBig,
    /// The upper end.
    pub hi: RBig,
    /// Whether the polynomial that was asked about changes sign.
    pub odd: bool,
}

impl Polynomial {
    /// From coefficients by rising power.
    #[must_use]
    pub fn new(mut c: Vec<IBig>) -> Self {
        while c.last().is_some_and(|last| *last == IBig::ZERO) {
            c.pop();
        }
        Self { c }
    }

    /// The polynomial times the common denominator of these coefficients, which is positive.
    #[must_use]
    pub fn from_rationals(c: &[RBig]) -> Self {
        let common = c.iter().fold(UBig::ONE, |common, x| {
            let d = x.denominator();
            let shared = (&common).gcd(d);
            common / shared * d
        });
        let scaled = c.iter().map(|x| x.numerator() * IBig::from(&common / x.denominator()));
        Self::new(scaled.collect()).primitive()
    }

    /// Its coefficients by rising power; the last one is not 0.
    #[must_use]
    pub fn coefficients(&self) -> &[IBig] {
        &self.c
    }

    /// The zero polynomial.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.c.is_empty()
    }

    /// Its degree; 0 for constants.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.c.len().saturating_sub(1)
    }

    /// Divided by the greatest common divisor of the coefficients.
    fn primitive(self) -> Self {
        let content = self.c.iter().fold(UBig::ZERO, |content, c| {
            if content == UBig::ONE || *c == IBig::ZERO {
                content
            } else if content == UBig::ZERO {
                c.unsigned_abs_value()
            } else {
                content.gcd(c.unsigned_abs_value())
            }
        });
        if content <= UBig::ONE {
            return self;
        }
        let content = IBig::from(content);
        Self { c: self.c.into_iter().map(|c| c / &content).collect() }
    }

    /// −1, 0 or 1 at p/q.
    #[must_use]
    pub fn sign_at(&self, at: &RBig) -> i8 {
        sign(&self.homogeneous(at.numerator(), &IBig::from(at.denominator().clone())))
    }

    /// qⁿ p(p/q).
    fn homogeneous(&self, p: &IBig, q: &IBig) -> IBig {
        let mut power = IBig::ONE;
        let mut value = IBig::ZERO;
        for c in self.c.iter().rev() {
            value = value * p + c * &power;
            power *= q;
        }
        value
    }

    /// p′.
    #[must_use]
    pub fn derivative(&self) -> Self {
        Self::new(self.c.iter().enumerate().skip(1).map(|(k, c)| c * IBig::from(k)).collect())
    }

    /// p(shift + scale t).
    #[must_use]
    pub fn composed(&self, shift: &RBig, scale: &RBig) -> Self {
        let mut result: Vec<RBig> = Vec::with_capacity(self.c.len());
        for c in self.c.iter().rev() {
            // result ← result · (shift + scale t) + c
            let mut next = vec![RBig::ZERO; result.len() + 1];
            for (k, r) in result.iter().enumerate() {
                next[k] += r * shift;
                next[k + 1] += r * scale;
            }
            next[0] += RBig::from(c.clone());
            result = next;
        }
        Self::from_rationals(&result)
    }

    /// tⁿ p(1/t).
    #[must_use]
    pub fn reversed(&self) -> Self {
        Self::new(self.c.iter().rev().cloned().collect())
    }

    /// Greatest common divisor, primitive; by pseudo-remainders.
    #[must_use]
    pub fn gcd(&self, other: &Self) -> Self {
        let (mut a, mut b) = (self.clone().primitive(), other.clone().primitive());
        if a.c.len() < b.c.len() {
            std::mem::swap(&mut a, &mut b);
        }
        while !b.is_zero() {
            let remainder = a.pseudo_remainder(&b).primitive();
            a = b;
            b = remainder;
        }
        a.primitive()
    }

    /// True only if no common factor exists; false may mean either.
    #[must_use]
    pub fn is_surely_coprime_to(&self, other: &Self) -> bool {
        surely_coprime(&self.c, &other.c)
    }

    /// True only if every root is simple; false may mean either.
    fn is_surely_squarefree(&self) -> bool {
        self.is_surely_coprime_to(&self.derivative())
    }

    fn pseudo_remainder(&self, divisor: &Self) -> Self {
        let mut rest = self.c.clone();
        let n = divisor.c.len();
        let lead = &divisor.c[n - 1];
        while rest.len() >= n {
            let top = rest[rest.len() - 1].clone();
            let offset = rest.len() - n;
            for c in &mut rest {
                *c *= lead;
            }
            for (k, d) in divisor.c.iter().enumerate() {
                rest[offset + k] -= d * &top;
            }
            rest.pop();
        }
        Self::new(rest)
    }

    /// self / divisor, which must divide.
    fn quotient(&self, divisor: &Self) -> Self {
        let mut rest: Vec<RBig> = self.c.iter().map(|c| RBig::from(c.clone())).collect();
        let n = divisor.c.len();
        let lead = RBig::from(divisor.c[n - 1].clone());
        let mut quotient = vec![RBig::ZERO; (rest.len() + 1).saturating_sub(n)];
        while rest.len() >= n {
            let factor = &rest[rest.len() - 1] / &lead;
            let offset = rest.len() - n;
            for (k, d) in divisor.c.iter().enumerate() {
                rest[offset + k] -= RBig::from(d.clone()) * &factor;
            }
            quotient[offset] = factor;
            rest.pop();
        }
        Self::from_rationals(&quotient)
    }

    /// p / gcd(p, p′): the same roots, each simple.
    #[must_use]
    pub fn squarefree(&self) -> Self {
        if self.is_surely_squarefree() {
            return self.clone();
        }
        let shared = self.gcd(&self.derivative());
        if shared.degree() == 0 { self.clone() } else { self.quotient(&shared) }
    }

    /// p(t + 1), by repeated sums.
    fn shifted(mut self) -> Self {
        for first in 0..self.c.len() {
            for k in (first..self.c.len() - 1).rev() {
                let next = self.c[k + 1].clone();
                self.c[k] += next;
            }
        }
        self
    }

    /// 2ⁿ p(t/2).
    fn halved(&self) -> Self {
        let n = self.degree();
        Self { c: self.c.iter().enumerate().map(|(k, c)| c << (n - k)).collect() }
    }

    /// Sign variations that bound the number of roots in the open interval (0, 1).
    fn variations(&self) -> usize {
        let mut reversed = self.c.clone();
        reversed.reverse();
        let signs = Self { c: reversed }.shifted().c.into_iter().map(|c| sign(&c)).filter(|s| *s != 0);
        let mut last = 0;
        let mut count = 0;
        for s in signs {
            count += usize::from(last == -s);
            last = s;
        }
        count
    }

    /// All real roots in the open interval (0, 1), ascending. `None` when they lie closer than 2^-4000.
    #[must_use]
    pub fn roots_in_unit(&self) -> Option<Vec<Root>> {
        if self.is_zero() || self.degree() == 0 {
            return Some(Vec::new());
        }
        // Without multiple roots halving ends, however close the roots.
        let splits = if self.is_surely_squarefree() { MAX_SPLITS } else { SPLITS };
        if let Some(found) = isolate(&Arc::new(self.clone()), splits) {
            return Some(found);
        }
        let squarefree = Arc::new(self.squarefree());
        let mut found = isolate(&squarefree, MAX_SPLITS)?;
        for root in &mut found {
            root.odd = self.changes_sign_at(root);
        }
        Some(found)
    }

    /// All real roots in (0, ∞).
    #[must_use]
    pub fn positive_roots(&self) -> Option<Vec<Root>> {
        let mut found = self.roots_in_unit()?;
        if self.sign_at(&RBig::ONE) == 0 && !self.is_zero() {
            let mut root = Root { polynomial: Arc::new(self.squarefree()), lo: RBig::ONE, hi: RBig::ONE, odd: true };
            root.odd = self.changes_sign_at(&root);
            found.push(root);
        }
        let far = self.reversed().roots_in_unit()?;
        for root in far.into_iter().rev() {
            // 1/t of a root at 0 does not occur: the interval is open, but its lower end may be 0.
            let root = root.away_from_zero();
            let polynomial = Arc::new(root.polynomial.reversed());
            found.push(Root { polynomial, lo: RBig::ONE / root.hi, hi: RBig::ONE / root.lo, odd: root.odd });
        }
        Some(found)
    }

    /// Whether p has opposite signs on both sides of a root of its squarefree part.
    fn changes_sign_at(&self, root: &Root) -> bool {
        if root.lo != root.hi {
            return self.sign_at(&root.lo) * self.sign_at(&root.hi) < 0;
        }
        let mut derivative = self.clone();
        let mut multiplicity = 0;
        while !derivative.is_zero() && derivative.sign_at(&root.lo) == 0 {
            derivative = derivative.derivative();
            multiplicity += 1;
        }
        multiplicity % 2 == 1
    }
}

trait UnsignedAbs {
    fn unsigned_abs_value(&self) -> UBig;
}

impl UnsignedAbs for IBig {
    fn unsigned_abs_value(&self) -> UBig {
        self.clone().into_parts().1
    }
}

fn sign(x: &IBig) -> i8 {
    if *x == IBig::ZERO {
        0
    } else if x.is_negative() {
        -1
    } else {
        1
    }
}

/// Isolates the roots in (0, 1) as long as at most `splits` halvings do.
fn isolate(polynomial: &Arc<Polynomial>, splits: usize) -> Option<Vec<Root>> {
    let mut found = Vec::new();
    // (p on the interval mapped to (0, 1), number of the interval, level)
    let mut open = vec![(polynomial.as_ref().clone(), IBig::ZERO, 0usize)];
    while let Some((p, number, level)) = open.pop() {
        let end = |number: &IBig| RBig::from(number.clone()) / RBig::from(IBig::ONE << level);
        match p.variations() {
            0 => {}
            1 => {
                let (lo, hi) = (end(&number), end(&(&number + IBig::ONE)));
                found.push(Root { polynomial: Arc::clone(polynomial), lo, hi, odd: true }.with_clean_ends());
            }
            _ if level == splits => return None,
            _ => {
                let left = p.halved();
                let right = left.clone().shifted();
                let first = &number * IBig::from(2);
                let middle = &first + IBig::ONE;
                open.push((right.clone(), middle.clone(), level + 1));
                if right.c[0] == IBig::ZERO {
                    let at = RBig::from(middle) / RBig::from(IBig::ONE << (level + 1));
                    let simple = right.c.get(1).is_some_and(|c| *c != IBig::ZERO);
                    if !simple {
                        return None;
                    }
                    let polynomial = Arc::clone(polynomial);
                    found.push(Root { polynomial, lo: at.clone(), hi: at, odd: true });
                }
                open.push((left, first, level + 1));
            }
        }
    }
    found.sort_by(|p, q| p.lo.cmp(&q.lo));
    Some(found)
}

impl Root {
    /// An end of the isolating interval may be a root of its own (a neighbour's, or at 0): moves the ends inward until
    /// they are not.
    fn with_clean_ends(mut self) -> Self {
        let polynomial = Arc::clone(&self.polynomial);
        for lower in [true, false] {
            let end = if lower { self.lo.clone() } else { self.hi.clone() };
            if polynomial.sign_at(&end) != 0 {
                continue;
            }
            // One simple root strictly inside: the sign beside the end is that of the end's own simple zero, so halve
            // towards it until the sign is opposite to the one at the other end.
            let other = if lower { self.hi.clone() } else { self.lo.clone() };
            let mut at = (&end + &other) / RBig::from(2);
            loop {
                let here =
                    Self { lo: at.clone().min(other.clone()), hi: at.clone().max(other.clone()), ..self.clone() };
                let inner = polynomial.on(&here.lo, &here.hi);
                if polynomial.sign_at(&at) == 0 {
                    return Self { lo: at.clone(), hi: at, ..self };
                }
                if inner.variations() == 1 {
                    break;
                }
                at = (&end + &at) / RBig::from(2);
            }
            if lower { self.lo = at } else { self.hi = at }
        }
        self
    }

    /// With a positive lower end.
    fn away_from_zero(mut self) -> Self {
        while self.lo.is_zero() {
            self.halve();
        }
        self
    }

    fn halve(&mut self) {
        let middle = (&self.lo + &self.hi) / RBig::from(2);
        self.cut(middle);
    }

    /// Keeps the side of `at` on which the root lies.
    fn cut(&mut self, at: RBig) {
        match self.polynomial.sign_at(&at) {
            0 => {
                self.lo.clone_from(&at);
                self.hi = at;
            }
            s if s == self.polynomial.sign_at(&self.hi) => self.hi = at,
            _ => self.lo = at,
        }
    }

    /// A rational root.
    #[must_use]
    pub fn exact(polynomial: &Polynomial, at: RBig) -> Self {
        let mut root = Self { polynomial: Arc::new(polynomial.squarefree()), lo: at.clone(), hi: at, odd: true };
        root.odd = polynomial.changes_sign_at(&root);
        root
    }

    /// The root is the rational `lo`.
    #[must_use]
    pub fn is_exact(&self) -> bool {
        self.lo == self.hi
    }

    /// Narrows until (hi − lo) ≤ 2^−bits · hi. The root must be positive.
    pub fn refine(&mut self, bits: usize) {
        let factor = RBig::from(IBig::ONE << bits);
        while !self.is_exact() && (&self.hi - &self.lo) * &factor > self.hi {
            let width = &self.hi - &self.lo;
            // Guess by the secant, fence it by a power of the width; fall back on halving.
            if let Some((low, high)) = self.fence() {
                self.cut(low);
                if !self.is_exact() && self.lo < high && high < self.hi {
                    self.cut(high);
                }
            }
            if !self.is_exact() && (&self.hi - &self.lo) * RBig::from(2) > width {
                self.halve();
            }
        }
    }

    /// Two points close around the Newton guess.
    fn fence(&self) -> Option<(RBig, RBig)> {
        let width = &self.hi - &self.lo;
        let middle = (&self.hi + &self.lo) / RBig::from(2);
        // f/f' at p/q without fractions: f = N/qⁿ, f' = M/qⁿ⁻¹, so that the guess is (p M − N)/(q M).
        let (p, q) = (middle.numerator(), IBig::from(middle.denominator().clone()));
        let (n, m) = (self.polynomial.homogeneous(p, &q), self.polynomial.derivative().homogeneous(p, &q));
        if m == IBig::ZERO {
            return None;
        }
        let relative = (&width / &self.hi).to_f64().value();
        // Newton squares the relative width; half of the gain is taken, so that the fence holds the root.
        let bits = i64::from(exponent(relative)).abs();
        let gain = usize::try_from(bits + bits / 2 + 2).ok()?;
        let bits = (2 * gain + 8).min(8000);
        let grid = RBig::from(IBig::ONE << bits);
        let guess = ((p * &m - n) << bits) / (&q * &m);
        let reach = (&self.hi * &grid / RBig::from(IBig::ONE << gain.min(4000))).ceil();
        let (low, high) = (RBig::from(&guess - &reach) / &grid, RBig::from(guess + reach) / grid);
        (self.lo < low && high < self.hi).then_some((low, high))
    }

    /// The root of this polynomial and `other` are the same number: decided by gcd.
    #[must_use]
    pub fn is_root_of(&self, other: &Polynomial) -> bool {
        if self.is_exact() {
            return other.sign_at(&self.lo) == 0;
        }
        if self.polynomial.is_surely_coprime_to(other) {
            return false;
        }
        let shared = self.polynomial.squarefree().gcd(other).squarefree();
        shared.degree() > 0 && shared.sign_at(&self.lo) * shared.sign_at(&self.hi) < 0
    }

    /// A polynomial of which this is a simple root.
    #[must_use]
    pub fn polynomial(&self) -> &Polynomial {
        &self.polynomial
    }
}

/// The exponent of the leading bit.
fn exponent(x: f64) -> i32 {
    ((x.abs().to_bits() >> 52) & 0x7ff) as i32 - 1023
}

impl Polynomial {
    /// p on [lo, hi] mapped to [0, 1].
    fn on(&self, lo: &RBig, hi: &RBig) -> Self {
        self.composed(lo, &(hi - lo))
    }
}

/// Sum, product and difference of polynomials with rational coefficients, to build the integer ones from.
pub mod rational {
    use dashu_ratio::RBig;

    /// p + q.
    #[must_use]
    pub fn add(p: &[RBig], q: &[RBig]) -> Vec<RBig> {
        let n = p.len().max(q.len());
        let at = |s: &[RBig], k: usize| s.get(k).cloned().unwrap_or(RBig::ZERO);
        (0..n).map(|k| at(p, k) + at(q, k)).collect()
    }

    /// c p.
    #[must_use]
    pub fn scale(p: &[RBig], factor: &RBig) -> Vec<RBig> {
        p.iter().map(|c| c * factor).collect()
    }

    /// p − q.
    #[must_use]
    pub fn sub(p: &[RBig], q: &[RBig]) -> Vec<RBig> {
        add(p, &scale(q, &RBig::from(-1)))
    }

    /// p q.
    #[must_use]
    pub fn mul(p: &[RBig], q: &[RBig]) -> Vec<RBig> {
        if p.is_empty() || q.is_empty() {
            return Vec::new();
        }
        let mut product = vec![RBig::ZERO; p.len() + q.len() - 1];
        for (i, a) in p.iter().enumerate() {
            for (j, b) in q.iter().enumerate() {
                product[i + j] += a * b;
            }
        }
        product
    }

    /// p′.
    #[must_use]
    pub fn derivative(p: &[RBig]) -> Vec<RBig> {
        p.iter().enumerate().skip(1).map(|(k, c)| c * RBig::from(k)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn of(c: &[i64]) -> Polynomial {
        Polynomial::new(c.iter().map(|&c| IBig::from(c)).collect())
    }

    fn with_roots(roots: &[(i64, u32)]) -> Polynomial {
        let one = vec![RBig::ONE];
        let product = roots.iter().fold(one, |product, &(p, q)| {
            rational::mul(&product, &[RBig::from_parts((-p).into(), q.into()), RBig::ONE])
        });
        Polynomial::from_rationals(&product)
    }

    proptest! {
        #[test]
        fn planted_roots_are_isolated(mut roots in proptest::collection::vec((1i64..400, 1u32..40), 1..7)) {
            let polynomial = with_roots(&roots);
            let mut found = polynomial.positive_roots().unwrap();
            roots.sort_by(|a, b| (a.0 * i64::from(b.1)).cmp(&(b.0 * i64::from(a.1))));
            let mut expected: Vec<(RBig, usize)> = Vec::new();
            for (p, q) in roots {
                let root = RBig::from_parts(p.into(), q.into());
                match expected.last_mut() {
                    Some((last, count)) if *last == root => *count += 1,
                    _ => expected.push((root, 1)),
                }
            }
            prop_assert_eq!(found.len(), expected.len());
            for (root, (at, multiplicity)) in found.iter_mut().zip(expected) {
                root.refine(60);
                prop_assert!(root.lo <= at && at <= root.hi);
                prop_assert!((&root.hi - &root.lo) * RBig::from(IBig::ONE << 60) <= root.hi);
                prop_assert_eq!(root.odd, multiplicity % 2 == 1);
                prop_assert!(root.is_root_of(&polynomial));
            }
        }
    }

    #[test]
    fn wilkinson_and_a_close_pair() {
        let wilkinson: Vec<(i64, u32)> = (1..=18).map(|k| (k, 1)).collect();
        assert_eq!(with_roots(&wilkinson).positive_roots().unwrap().len(), 18);
        // (t² − 2)² − 10⁻³⁰: two pairs 10⁻¹⁵ apart.
        let tenth = RBig::from(IBig::from(10).pow(30));
        let close = Polynomial::from_rationals(&[
            RBig::from(4) - RBig::ONE / tenth,
            RBig::ZERO,
            RBig::from(-4),
            RBig::ZERO,
            RBig::ONE,
        ]);
        let found = close.positive_roots().unwrap();
        assert_eq!(found.len(), 2);
        assert!(found[0].hi <= found[1].lo && found.iter().all(|root| root.odd));
    }

    #[test]
    fn double_roots_are_one_root_without_a_change_of_sign() {
        // (t² − 2)² (t − 3)
        let c = of(&[-12, 4, 12, -4, -3, 1]);
        let found = c.positive_roots().unwrap();
        assert_eq!(found.iter().map(|root| root.odd).collect::<Vec<_>>(), [false, true]);
        assert!(found[0].is_root_of(&of(&[-2, 0, 1])) && !found[0].is_root_of(&of(&[-3, 0, 1])));
    }

    #[test]
    fn roots_at_the_ends_do_not_count() {
        // t (t − 1) (2t − 1)
        assert_eq!(of(&[0, 1, -3, 2]).roots_in_unit().unwrap().len(), 1);
        assert!(of(&[0, 0, 1]).positive_roots().unwrap().is_empty());
    }
}
