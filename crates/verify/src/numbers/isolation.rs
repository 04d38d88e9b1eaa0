//! Real roots of a polynomial in an interval, isolated by Descartes' rule of signs: a polynomial has as many positive roots
//! as its coefficients change sign, up to an even number; so 0 and 1 are numbers of roots.

use std::rc::Rc;

use dashu_base::BitTest;
use dashu_int::IBig;
use dashu_ratio::RBig;

use super::polynomial::{Polynomial, Signs, sign};

/// Splits after which a multiple root is suspected, and at most.
const SIMPLE: usize = 100;
const MOST: usize = 10_000;

/// 2ᵏ parts of a range at most: doubles tell them apart.
const FINEST: usize = 32;

/// A number; n/0 is infinite.
type Fraction = [IBig; 2];

/// A polynomial on an interval from a/c to b/d, as one in u > 0 with (a + bu)/(c + du) in its place.
struct Part {
    polynomial: Vec<IBig>,
    from: Fraction,
    to: Fraction,
}

/// The only root of a polynomial in a range, simple, or both ends if it is known exactly.
#[derive(Clone, Debug)]
pub(crate) struct Root {
    pub lo: RBig,
    pub hi: RBig,
    polynomial: Rc<Signs>,
    /// Sign of the polynomial at the upper end.
    above: i8,
}

/// Parts of an open interval, one for each different root there, in no order, with the polynomial that was split, which
/// has the same roots; both ends of a part are a root that is known exactly. `None` where roots are too close.
fn separated(p: &Polynomial, [lo, hi]: [Option<&RBig>; 2]) -> Option<(Polynomial, Vec<Part>)> {
    let end = |x: Option<&RBig>, infinite: IBig| match x {
        Some(x) => [x.numerator().clone(), IBig::from(x.denominator().clone())],
        None => [infinite, IBig::ZERO],
    };
    let (from, to) = (end(lo, IBig::NEG_ONE), end(hi, IBig::ONE));
    let within = |p: Polynomial, splits| {
        let moved = moved(&p.0, [&from[0], &to[0]], [&from[1], &to[1]]);
        let parts = Part { polynomial: moved, from: from.clone(), to: to.clone() }.separated(splits)?;
        Some((p, parts))
    };
    within(p.clone(), SIMPLE).or_else(|| within(p.squarefree(), MOST))
}

/// All different roots of a polynomial in an open interval, in order and in ranges that do not touch; `None` where two are
/// too close.
pub(crate) fn roots(p: &Polynomial, [lo, hi]: [&RBig; 2]) -> Option<Vec<Root>> {
    let (p, parts) = separated(p, [Some(lo), Some(hi)])?;
    let p = Rc::new(Signs::new(p));
    let mut found: Vec<Root> = parts.into_iter().map(|part| part.root(&p)).collect();
    found.sort_by(|p, q| (&p.lo, &p.hi).cmp(&(&q.lo, &q.hi)));
    // An end of one range may be one of the next.
    for number in 1..found.len() {
        while found[number - 1].hi >= found[number].lo {
            found[number - 1].halve();
            found[number].halve();
        }
    }
    Some(found)
}

impl Polynomial {
    /// Number of different real roots in the open interval, where `None` is −∞ or ∞; `None` if some are too close.
    pub fn inside(&self, ends: [Option<&RBig>; 2]) -> Option<usize> {
        if let [None, None] = ends {
            let zero = RBig::ZERO;
            let at_zero = usize::from(self.sign_at(&zero) == 0);
            return Some(self.inside([None, Some(&zero)])? + at_zero + self.inside([Some(&zero), None])?);
        }
        Some(separated(self, ends)?.1.len())
    }

    /// Both polynomials have a root in [lo, hi].
    pub fn share_root(&self, other: &Self, range: [&RBig; 2]) -> bool {
        let shared = self.shared(other);
        shared.0.len() > 1 && shared.closed(range).is_some_and(|roots| roots > 0)
    }

    /// Number of different real roots in [lo, hi].
    pub fn closed(&self, [lo, hi]: [&RBig; 2]) -> Option<usize> {
        let at = |x: &RBig| usize::from(self.sign_at(x) == 0);
        if lo == hi { Some(at(lo)) } else { Some(self.inside([Some(lo), Some(hi)])? + at(lo) + at(hi)) }
    }
}

impl Part {
    fn separated(self, mut splits: usize) -> Option<Vec<Self>> {
        let mut found = Vec::new();
        let mut open = vec![self];
        while let Some(mut part) = open.pop() {
            // A root at an end.
            while part.polynomial.last().is_some_and(|c| *c == IBig::ZERO) {
                part.polynomial.pop();
            }
            match variations(&part.polynomial) {
                0 => {}
                1 => found.push(part),
                _ => {
                    splits = splits.checked_sub(1)?;
                    let [below, above] = part.split();
                    if above.polynomial[0] == IBig::ZERO {
                        let middle = above.from.clone();
                        found.push(Self { polynomial: Vec::new(), from: middle.clone(), to: middle });
                    }
                    open.extend([below, above]);
                }
            }
        }
        Some(found)
    }

    /// What lies on both sides of u = 2ˢ, for an s that makes the geometric mean of the roots' absolute values about 1: so
    /// roots of different sizes are told apart at once.
    fn split(mut self) -> [Self; 2] {
        let degree = self.polynomial.len() - 1;
        let first = self.polynomial.iter().take_while(|c| **c == IBig::ZERO).count();
        let bits = |k: usize| self.polynomial[k].clone().into_parts().1.bit_len();
        let (low, high) = (bits(first), bits(degree));
        let shift = low.abs_diff(high) / (degree - first);
        for (k, c) in self.polynomial.iter_mut().enumerate() {
            *c <<= shift * if low > high { k } else { degree - k };
        }
        let smaller = if low > high { &mut self.to } else { &mut self.from };
        for part in smaller {
            *part <<= shift;
        }
        let middle = [&self.from[0] + &self.to[0], &self.from[1] + &self.to[1]];
        let mut below: Vec<IBig> = self.polynomial.iter().rev().cloned().collect();
        let mut above = self.polynomial;
        shift_by_one(&mut below);
        shift_by_one(&mut above);
        [
            Self { polynomial: below, from: middle.clone(), to: self.from },
            Self { polynomial: above, from: middle, to: self.to },
        ]
    }

    /// Its root, where it is bounded.
    fn root(self, polynomial: &Rc<Signs>) -> Root {
        let [from, to] = [self.from, self.to].map(|[n, d]| RBig::from(n) / RBig::from(d));
        // It changes its sign once, and the last coefficient has that for large u.
        let at_to = self.polynomial.last().map_or(0, sign);
        let (lo, hi, above) = if from <= to { (from, to, at_to) } else { (to, from, -at_to) };
        Root { lo, hi, polynomial: Rc::clone(polynomial), above }
    }
}

impl Root {
    /// Narrows the range at least 2ᵇ-fold: to one of its 2ᵏ parts, beside the zero of the chord, where k is doubled as
    /// long as that holds the root (J. Abbott, Quadratic interval refinement for real roots, 2014).
    pub fn narrow(&mut self, mut bits: usize) {
        let mut step = 1;
        while bits > 0 && self.lo != self.hi {
            if step == 1 {
                self.halve();
            } else if !self.narrow_by_chord(step) {
                step /= 2;
                continue;
            }
            bits = bits.saturating_sub(step);
            step = (2 * step).min(FINEST);
        }
    }

    /// Takes the part of 2ᵏ beside the zero of the chord for the range, or, where it does not hold the root, what is left on the
    /// root's side of it; true in the first case.
    fn narrow_by_chord(&mut self, step: usize) -> bool {
        let parts = IBig::ONE << step;
        let [below, above] = [&self.lo, &self.hi].map(|x| self.polynomial.enclosed(x));
        let Some(share) = below.over(&(&below - &above)) else { return false };
        let nearest = IBig::try_from((share.times_two_to(step.cast_signed()).to_f64()).round()).unwrap_or(IBig::ZERO);
        let width = (&self.hi - &self.lo) / RBig::from(parts.clone());
        let place = |n: &IBig| &self.lo + &width * RBig::from(n.clone());
        let middle = nearest.clamp(IBig::ONE, parts - IBig::ONE);
        let sign = self.polynomial.at(&place(&middle));
        let next = if sign == self.above { &middle - IBig::ONE } else { &middle + IBig::ONE };
        let [middle, next] = [middle, next].map(|n| place(&n));
        if sign == 0 {
            (self.lo, self.hi) = (middle.clone(), middle);
            return true;
        }
        let beyond = self.polynomial.at(&next);
        if beyond == 0 && self.lo < next && next < self.hi {
            (self.lo, self.hi) = (next.clone(), next);
            return true;
        }
        let holds = beyond * sign <= 0;
        match (sign == self.above, holds) {
            (true, true) => (self.lo, self.hi) = (next, middle),
            (true, false) => self.hi = next,
            (false, true) => (self.lo, self.hi) = (middle, next),
            (false, false) => self.lo = next,
        }
        holds
    }

    /// Makes the range this number alone, if it is the root; true in that case.
    pub fn settle_at(&mut self, x: &RBig) -> bool {
        // An end of the range may be another root.
        if self.lo < *x && *x < self.hi && self.polynomial.at(x) == 0 {
            (self.lo, self.hi) = (x.clone(), x.clone());
        }
        self.lo == *x && self.hi == *x
    }

    /// Halves the range.
    pub fn halve(&mut self) {
        if self.lo == self.hi {
            return;
        }
        let middle = (&self.lo + &self.hi) / RBig::from(2);
        match self.polynomial.at(&middle) {
            0 => (self.lo, self.hi) = (middle.clone(), middle),
            s if s == self.above => self.hi = middle,
            _ => self.lo = middle,
        }
    }
}

/// p(u + 1).
fn shift_by_one(p: &mut [IBig]) {
    for from in 0..p.len() {
        for k in (from..p.len() - 1).rev() {
            let (low, high) = p.split_at_mut(k + 1);
            low[k] += &high[0];
        }
    }
}

/// Changes of sign along the coefficients.
fn variations(p: &[IBig]) -> usize {
    let mut signs = p.iter().map(sign).filter(|s| *s != 0);
    let Some(mut last) = signs.next() else {
        return 0;
    };
    signs.filter(|&s| std::mem::replace(&mut last, s) != s).count()
}

/// Σ c_k αᵏ βⁿ⁻ᵏ for linear polynomials α and β: p at α/β, times βⁿ.
fn moved(p: &[IBig], above: [&IBig; 2], below: [&IBig; 2]) -> Vec<IBig> {
    let mut power = vec![IBig::ONE];
    let mut sum: Vec<IBig> = Vec::new();
    for coefficient in p.iter().rev() {
        sum = product(&sum, above);
        sum.resize(power.len(), IBig::ZERO);
        for (sum, c) in sum.iter_mut().zip(&power) {
            *sum += c * coefficient;
        }
        power = product(&power, below);
    }
    sum
}

fn product(p: &[IBig], [low, high]: [&IBig; 2]) -> Vec<IBig> {
    let mut product = vec![IBig::ZERO; p.len() + 1];
    for (k, c) in p.iter().enumerate() {
        product[k] += c * low;
        product[k + 1] += c * high;
    }
    product
}

#[cfg(test)]
mod tests {
    use super::*;

    fn with_roots(roots: &[(i32, i32)]) -> Polynomial {
        let p = roots.iter().fold(vec![IBig::ONE], |p, &(n, d)| product(&p, [&IBig::from(-n), &IBig::from(d)]));
        Polynomial(p)
    }

    fn found(list: &[(i32, i32)]) -> Vec<f64> {
        let mut roots = roots(&with_roots(list), [&RBig::ZERO, &RBig::ONE]).unwrap();
        assert!(roots.windows(2).all(|pair| pair[0].hi < pair[1].lo), "{list:?}: {roots:?}");
        for root in &mut roots {
            (0..60).for_each(|_| root.halve());
            assert!(root.lo <= root.hi);
        }
        roots.iter().map(|root| root.lo.to_f64().value()).collect()
    }

    #[test]
    fn roots_inside_are_found_once() {
        let near = |list: &[(i32, i32)], expected: &[f64]| {
            let found = found(list);
            assert_eq!(found.len(), expected.len(), "{list:?}: {found:?}");
            assert!(found.iter().zip(expected).all(|(p, q)| (p - q).abs() < 1e-12), "{list:?}: {found:?}");
        };
        near(&[(1, 3), (-1, 2), (5, 2), (1, 2), (2, 3)], &[1.0 / 3.0, 0.5, 2.0 / 3.0]);
        // At the ends, multiple ones, close ones.
        near(&[(0, 1), (0, 1), (1, 1), (1, 7)], &[1.0 / 7.0]);
        near(&[(1, 3), (1, 3), (3, 4), (1, 4)], &[0.25, 1.0 / 3.0, 0.75]);
        near(&[(100_000, 300_001), (100_000, 300_000)], &[100_000.0 / 300_001.0, 1.0 / 3.0]);
        near(&[], &[]);
    }

    #[test]
    fn roots_are_narrowed() {
        let list = [(1, 3), (1, 2), (100_000, 150_001), (7, 8), (-5, 1)];
        for bits in [1, 2, 53, 200, 1000] {
            let mut found = roots(&with_roots(&list), [&RBig::ZERO, &RBig::ONE]).unwrap();
            assert_eq!(found.len(), 4);
            for (root, &(n, d)) in found.iter_mut().zip(&list) {
                let (exact, before) = (RBig::from(n) / RBig::from(d), &root.hi - &root.lo);
                root.narrow(bits);
                assert!(root.lo <= exact && exact <= root.hi, "{n}/{d} {bits}");
                assert!((&root.hi - &root.lo) * RBig::from(IBig::ONE << bits) <= before, "{n}/{d} {bits}");
            }
        }
    }

    #[test]
    fn roots_are_counted_once_each() {
        let count = |roots: &[i32], lo: Option<i32>, hi: Option<i32>| {
            let ends = [lo, hi].map(|x| x.map(RBig::from));
            with_roots(&roots.iter().map(|&root| (root, 1)).collect::<Vec<_>>())
                .inside(ends.each_ref().map(Option::as_ref))
        };
        let roots = [1, 2, 2, 3, -5];
        assert_eq!(count(&roots, None, None), Some(4));
        assert_eq!(count(&roots, Some(1), Some(3)), Some(1));
        assert_eq!(count(&roots, None, Some(0)), Some(1));
        assert_eq!(count(&roots, Some(1), None), Some(2));
        // Double roots at both ends, and at all places.
        assert_eq!(count(&[0, 0, 1, 2, 2], Some(0), Some(2)), Some(1));
        assert_eq!(count(&[4, 4, 7, 7, -9, -9], None, None), Some(3));
        let closed = |lo: i32, hi: i32| with_roots(&roots.map(|root| (root, 1))).closed([&lo.into(), &hi.into()]);
        assert_eq!((closed(1, 3), closed(2, 2), closed(-4, 0)), (Some(3), Some(1), Some(0)));
    }

    #[test]
    fn roots_are_counted_in_every_kind_of_interval() {
        let p = with_roots(&[(-5, 1), (0, 1), (1, 1), (3, 1), (8, 1)]);
        let n = |n: i32, d: u32| RBig::from_parts(n.into(), d.into());
        let count = |lo: Option<RBig>, hi: Option<RBig>| p.inside([lo.as_ref(), hi.as_ref()]);
        assert_eq!(count(None, None), Some(5));
        assert_eq!(count(Some(n(-5, 1)), Some(n(8, 1))), Some(3));
        assert_eq!(count(Some(n(1, 2)), Some(n(10, 3))), Some(2));
        assert_eq!(count(Some(n(10, 3)), None), Some(1));
        assert_eq!(count(None, Some(n(-5, 1))), Some(0));
        assert_eq!(count(Some(n(4, 1)), Some(n(15, 2))), Some(0));
        // x² + 1 and (x² − 2)²: none real; both double, so that only the squarefree part decides.
        assert_eq!(Polynomial([1, 0, 1].map(IBig::from).to_vec()).inside([None, None]), Some(0));
        assert_eq!(Polynomial([4, 0, -4, 0, 1].map(IBig::from).to_vec()).inside([None, None]), Some(2));
    }

    /// Roots near one another beside others that are far larger or smaller need a handful of splits.
    #[test]
    fn roots_of_different_sizes_are_told_apart_at_once() {
        let list = [(1, 1_000_000_007), (1_000_000_007, 1), (3, 7), (1, 1_000_003), (900_001, 900_000)];
        let [one, zero] = [IBig::ONE, IBig::ZERO];
        let part = Part { polynomial: with_roots(&list).0, from: [zero.clone(), one.clone()], to: [one, zero] };
        assert_eq!(part.separated(12).map(|parts| parts.len()), Some(5));
    }
}
