//! Isolation of real roots by Descartes' rule on (0, 1) (Vincent, Collins and Akritas): the sign variations of
//! (1+x)^n p(1/(1+x)) bound the number of roots, with equality for 0 and 1. Intervals with more are halved; what halving
//! does not separate within `SPLITS` levels is a multiple root (or nearly one), and the squarefree part by gcd is
//! isolated instead.

use std::sync::Arc;

use dashu_base::BitTest;
use dashu_int::IBig;
use dashu_ratio::RBig;

use super::integer::Polynomial;
use super::root::Root;
use crate::Sign;

/// Halvings after which multiple roots are looked for by gcd.
const SPLITS: usize = 48;
/// Halvings of a squarefree polynomial; beyond, roots are closer than anything that the rest could use.
const MAX_SPLITS: usize = 4000;

impl Polynomial {
    /// p(t + 1), by repeated sums.
    fn shifted(mut self) -> Self {
        for first in 0..self.c.len() {
            self.sum_from(first);
        }
        self
    }

    /// The sums of one round, after which the coefficient of t^first is that of p(t + 1).
    fn sum_from(&mut self, first: usize) {
        for k in (first..self.c.len() - 1).rev() {
            let (sums, last) = self.c.split_at_mut(k + 1);
            sums[k] += &last[0];
        }
    }

    /// 2ⁿ p(t/2).
    fn halved(&self) -> Self {
        let n = self.degree();
        Self { c: self.c.iter().enumerate().map(|(k, c)| c << (n - k)).collect() }
    }

    /// Sign variations that bound the number of roots in the open interval (0, 1); 2 for two and more.
    fn variations(&self) -> usize {
        let mut shifted = self.clone();
        shifted.c.reverse();
        let mut last = Sign::Zero;
        let mut count = 0;
        for first in 0..shifted.c.len() {
            shifted.sum_from(first);
            let Some(sign) = Sign::from(&shifted.c[first]).strict() else { continue };
            count += usize::from(last == -sign);
            last = sign;
            if count == 2 {
                break;
            }
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
        // Halving begins at 1: roots in another unit would take a halving for each bit of it.
        let unit = self.mean_root();
        let found = self.composed(&RBig::ZERO, &unit).positive_roots_about_one()?;
        Some(found.into_iter().map(|root| root.times(&unit)).collect())
    }

    fn positive_roots_about_one(&self) -> Option<Vec<Root>> {
        let mut found = self.roots_in_unit()?;
        if self.sign_at(&RBig::ONE) == Sign::Zero && !self.is_zero() {
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

    /// A power of two near the geometric mean of the sizes of all complex roots but 0.
    fn mean_root(&self) -> RBig {
        let size = |c: &IBig| i64::try_from(c.bit_len()).unwrap_or(i64::MAX);
        let ends = self.c.iter().position(|c| !c.is_zero()).zip(self.c.last());
        let exponent = ends.map_or(0, |(first, last)| {
            let count = i64::try_from(self.degree() - first).unwrap_or(i64::MAX);
            (size(&self.c[first]) - size(last)) / count.max(1)
        });
        let power = RBig::from(IBig::ONE << usize::try_from(exponent.unsigned_abs()).unwrap_or(usize::MAX));
        if exponent < 0 { RBig::ONE / power } else { power }
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
    /// The root of p(t/unit).
    fn times(self, unit: &RBig) -> Self {
        if *unit == RBig::ONE {
            return self;
        }
        let polynomial = Arc::new(self.polynomial.composed(&RBig::ZERO, &(RBig::ONE / unit)));
        Self { polynomial, lo: self.lo * unit, hi: self.hi * unit, odd: self.odd }
    }

    /// An end of the isolating interval may be a root of its own (a neighbour's, or at 0): moves the ends inward until
    /// they are not.
    fn with_clean_ends(mut self) -> Self {
        let polynomial = Arc::clone(&self.polynomial);
        for lower in [true, false] {
            let end = if lower { self.lo.clone() } else { self.hi.clone() };
            if polynomial.sign_at(&end) != Sign::Zero {
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
                if polynomial.sign_at(&at) == Sign::Zero {
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
}

#[cfg(test)]
mod tests {
    use super::super::rational;
    use super::*;
    use crate::enclosure::Enclosure;
    use crate::interval::Interval;
    use crate::wide::{Interval128, Interval384};
    use proptest::prelude::*;

    fn holds<E: Enclosure>(set: &E, at: &RBig) -> bool {
        let exact = |[lo, hi]: [RBig; 2]| lo <= *at && *at <= hi;
        set.exact_bounds().is_none_or(exact)
    }

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

    /// Ascending.
    fn of_rationals(roots: &[(i64, u32)]) -> Vec<RBig> {
        let mut list: Vec<RBig> = roots.iter().map(|&(p, q)| RBig::from_parts(p.into(), q.into())).collect();
        list.sort();
        list
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
                prop_assert!(holds(&root.enclosed::<Interval>(()), &at));
                let close = root.enclosed::<Interval128>(());
                prop_assert!(holds(&close, &at));
                prop_assert!(multiplicity > 1 || close.bounds()[1] - close.bounds()[0] < 1e-12 * (1.0 + close.bounds()[1]));
                root.refine(60);
                prop_assert!(root.lo <= at && at <= root.hi);
                prop_assert!((&root.hi - &root.lo) * RBig::from(IBig::ONE << 60) <= root.hi);
                prop_assert_eq!(root.odd, multiplicity % 2 == 1);
                prop_assert!(root.is_root_of(&polynomial));
                prop_assert!(holds(&root.enclosed::<Interval>(()), &at));
                prop_assert!(holds(&root.enclosed::<Interval384>(()), &at));
            }
        }
    }

    /// The roots of a body whose numbers have 17 digits are about 10^17 in whole numbers.
    #[test]
    fn roots_in_another_unit_are_isolated_about_one() {
        let near = [(3, 7), (2, 1), (5, 2), (1, 90)];
        let there: Vec<RBig> = of_rationals(&near);
        for unit in [RBig::ONE, RBig::from(IBig::ONE << 57), RBig::ONE / RBig::from(IBig::ONE << 200)] {
            let polynomial = with_roots(&near).composed(&RBig::ZERO, &(RBig::ONE / &unit));
            let ratio = polynomial.mean_root() / &unit;
            assert!(RBig::ONE < &ratio * RBig::from(8) && ratio < RBig::from(2), "{ratio} {unit}");
            let found = polynomial.positive_roots().unwrap();
            assert_eq!(found.len(), there.len());
            for (root, at) in found.iter().zip(&there) {
                let at = at * &unit;
                assert!(root.lo <= at && at <= root.hi && root.is_root_of(&polynomial) && root.odd);
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
