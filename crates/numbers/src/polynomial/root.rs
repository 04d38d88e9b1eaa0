//! A real root of a polynomial: isolated, and refined to any precision.

use std::cmp::Ordering;
use std::sync::Arc;

use dashu_int::IBig;
use dashu_ratio::RBig;

use super::integer::Polynomial;
use crate::Sign;
use crate::enclosure::{Enclosure, horner};
use crate::interval::Interval;
use crate::power::exponent;
use crate::root::narrowed;

/// Bits of a root that intervals of doubles give, less a safety margin.
const DOUBLES: usize = 40;

/// A real root in a range that holds no other.
#[derive(Clone, Debug)]
pub struct Root {
    /// Squarefree at this root: it changes sign there.
    pub(super) polynomial: Arc<Polynomial>,
    /// lo ≤ root ≤ hi; equal when the root is this rational, else neither end is a root.
    pub lo: RBig,
    /// The upper end of the range.
    pub hi: RBig,
    /// Whether the polynomial whose roots were isolated changes sign here.
    pub odd: bool,
}

impl Root {
    /// Halves the range until its lower end is positive.
    pub(super) fn away_from_zero(mut self) -> Self {
        while self.lo.is_zero() {
            self.halve();
        }
        self
    }

    fn halve(&mut self) {
        self.halve_below(self.polynomial.sign_at(&self.hi));
    }

    /// Halves the range, given the sign at the upper end.
    fn halve_below(&mut self, above: Sign) {
        let middle = (&self.lo + &self.hi) / RBig::from(2);
        self.cut(middle, above);
    }

    /// Keeps the side of `at` on which the root lies, with the sign at the upper end, which stays the same.
    fn cut(&mut self, at: RBig, above: Sign) {
        match self.polynomial.sign_at(&at) {
            Sign::Zero => {
                self.lo.clone_from(&at);
                self.hi = at;
            }
            s if s == above => self.hi = at,
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

    /// The order of a rational number and the root.
    #[must_use]
    pub fn place_of(&self, at: &RBig) -> Ordering {
        if *at < self.lo {
            Ordering::Less
        } else if *at > self.hi {
            Ordering::Greater
        } else {
            match self.polynomial.sign_at(at) {
                Sign::Zero => Ordering::Equal,
                sign if sign == self.polynomial.sign_at(&self.hi) => Ordering::Greater,
                _ => Ordering::Less,
            }
        }
    }

    /// Narrows until (hi − lo) ≤ 2^−bits · hi. The root must be positive.
    pub fn refine(&mut self, bits: usize) {
        if self.is_known_to(bits) {
            return;
        }
        let above = self.polynomial.sign_at(&self.hi);
        if !self.is_known_to(bits.min(DOUBLES)) {
            self.narrow_in_doubles(above);
        }
        let slope = self.polynomial.derivative();
        let mut lost = 6;
        while !self.is_known_to(bits) {
            let width = &self.hi - &self.lo;
            // Newton doubles the bits except for what curvature loses; where the root is beyond the fence, more is
            // lost.
            for at in self.fence(&slope, lost, bits).into_iter().flatten() {
                if self.lo < at && at < self.hi {
                    self.cut(at, above);
                }
            }
            if (&self.hi - &self.lo) * RBig::from(2) > width {
                lost = lost.saturating_mul(2);
                self.halve_below(above);
            }
        }
    }

    fn is_known_to(&self, bits: usize) -> bool {
        self.is_exact() || (&self.hi - &self.lo) * RBig::from(IBig::ONE << bits) <= self.hi
    }

    /// Narrows as much as intervals of doubles allow, at a hundredth of the cost of exact numbers; exact signs have
    /// the last word. The sign at the upper end is `above`.
    fn narrow_in_doubles(&mut self, above: Sign) {
        let range: Interval = self.enclosed_below(above, ());
        // The ends of the range may be the root.
        let beyond = [range.lo.next_down(), range.hi.next_up()].map(|end| RBig::try_from(end).ok());
        let [Some(lo), Some(hi)] = beyond else { return };
        if self.lo < lo && lo < self.hi && self.polynomial.sign_at(&lo) == -above {
            self.lo = lo;
        }
        if self.lo < hi && hi < self.hi && self.polynomial.sign_at(&hi) == above {
            self.hi = hi;
        }
    }

    /// The root in one arithmetic, as narrow as this makes it.
    #[must_use]
    pub fn enclosed<E: Enclosure>(&self, precision: E::Precision) -> E {
        if self.is_exact() {
            return E::rational(&self.lo, precision);
        }
        self.enclosed_below(self.polynomial.sign_at(&self.hi), precision)
    }

    /// The same for a root that is not exact, given the sign at the upper end.
    fn enclosed_below<E: Enclosure>(&self, above: Sign, precision: E::Precision) -> E {
        let number = |x: &RBig| E::rational(x, precision);
        let range = number(&self.lo).hull(&number(&self.hi));
        let (f, slope) = (self.polynomial.enclosed(precision), self.polynomial.derivative().enclosed(precision));
        let at = |c: &[E], at: &E| horner(c, at, precision);
        narrowed(range, above, |x| at(&f, x), |x| at(&slope, x), precision)
    }

    /// Two points close around Newton's guess, which is taken to have twice the bits less those `lost`.
    fn fence(&self, slope: &Polynomial, lost: i64, wanted: usize) -> Option<[RBig; 2]> {
        let width = &self.hi - &self.lo;
        let middle = (&self.hi + &self.lo) / RBig::from(2);
        // f/f' at p/q without fractions: f = N/qⁿ, f' = M/qⁿ⁻¹, so that the guess is (p M − N)/(q M).
        let (p, q) = (middle.numerator(), IBig::from(middle.denominator().clone()));
        let (n, m) = (self.polynomial.homogeneous(p, &q), slope.homogeneous(p, &q));
        if m == IBig::ZERO {
            return None;
        }
        let known = -exponent(&(&width / &self.hi));
        let gain = usize::try_from((2 * known).saturating_sub(lost).max(known + known / 2 + 2)).ok()?.min(wanted + 2);
        let size = usize::try_from(-exponent(&self.hi)).unwrap_or(0);
        let bits = gain + size + 4;
        let grid = RBig::from(IBig::ONE << bits);
        let guess = ((p * &m - n) << bits) / (&q * &m);
        let reach = (&self.hi * &grid / RBig::from(IBig::ONE << (gain + 1))).ceil();
        Some([RBig::from(&guess - &reach) / &grid, RBig::from(guess + reach) / grid])
    }

    /// The root of this polynomial and `other` are the same number: decided by gcd.
    #[must_use]
    pub fn is_root_of(&self, other: &Polynomial) -> bool {
        if self.is_exact() {
            return other.sign_at(&self.lo) == Sign::Zero;
        }
        if self.polynomial.is_surely_coprime_to(other) {
            return false;
        }
        let shared = self.polynomial.squarefree().gcd(other).squarefree();
        shared.degree() > 0 && shared.sign_at(&self.lo) * shared.sign_at(&self.hi) == Sign::Negative
    }

    /// A polynomial with this as a simple root.
    #[must_use]
    pub fn polynomial(&self) -> &Polynomial {
        &self.polynomial
    }
}

impl Polynomial {
    /// Whether p has opposite signs on both sides of a root of its squarefree part.
    pub(super) fn changes_sign_at(&self, root: &Root) -> bool {
        if root.lo != root.hi {
            return self.sign_at(&root.lo) * self.sign_at(&root.hi) == Sign::Negative;
        }
        self.multiplicity_at(&root.lo) % 2 == 1
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rationals_lie_on_their_side_of_a_root() {
        let between = |c: [i64; 4]| {
            let polynomial = Arc::new(Polynomial::new(c.map(IBig::from).to_vec()));
            Root { polynomial, lo: RBig::ONE, hi: RBig::from(2), odd: true }
        };
        let places = |root: &Root| [2, 5, 6, 9].map(|n: i64| root.place_of(&RBig::from_parts(n.into(), 4u8.into())));
        // ∛2 and 3/2.
        assert_eq!(
            places(&between([-2, 0, 0, 1])),
            [Ordering::Less, Ordering::Less, Ordering::Greater, Ordering::Greater]
        );
        assert_eq!(
            places(&between([-3, 2, 0, 0])),
            [Ordering::Less, Ordering::Less, Ordering::Equal, Ordering::Greater]
        );
    }

    /// √(1 + 2⁻³⁰⁰) between 1 and 2: one of the two points beside Newton's guess lies beyond the range.
    #[test]
    fn a_root_next_to_an_end_of_its_range_is_fenced_from_the_other_side() {
        let unit = IBig::ONE << 300usize;
        let polynomial = Polynomial::new(vec![-(&unit + IBig::ONE), IBig::ZERO, unit]);
        let (lo, hi) = (RBig::ONE, RBig::from(2));
        let mut root = Root { polynomial: Arc::new(polynomial), lo, hi, odd: true };
        let [low, high] = root.fence(&root.polynomial.derivative(), 6, 1200).unwrap();
        assert!(low < root.lo && root.lo < high && high < root.hi);
        root.refine(1200);
        assert!(root.is_known_to(1200));
        let signs = [&root.lo, &root.hi].map(|end| root.polynomial.sign_at(end));
        assert_eq!(signs, [Sign::Negative, Sign::Positive]);
    }
}
