//! Real roots of a polynomial between 0 and 1, isolated by halvings with Descartes' rule of signs.

use dashu_int::IBig;
use dashu_ratio::RBig;

use super::descartes::{self, shift, sign};
use super::sturm::{negative_remainder, quotient, sign_at};

/// Halvings after which a multiple root is suspected, and at most.
const SIMPLE: usize = 64;
const MOST: usize = 4000;

/// The only root of a polynomial in a range, simple, or both ends if it is known exactly.
#[derive(Clone, Debug)]
pub(crate) struct Root {
    pub lo: RBig,
    pub hi: RBig,
    polynomial: Vec<IBig>,
    /// Sign of the polynomial at the upper end.
    above: i8,
}

/// A polynomial on a part of the range, moved to 0 … 1: from n/2ᵏ to (n+1)/2ᵏ.
struct Node {
    polynomial: Vec<IBig>,
    n: IBig,
    k: usize,
}

/// All different roots in the open range, in order and in ranges that do not touch; `None` where two are closer than 2⁻⁴⁰⁰⁰.
pub(crate) fn roots(polynomial: &[IBig]) -> Option<Vec<Root>> {
    simple_roots(polynomial, SIMPLE).or_else(|| simple_roots(&squarefree(polynomial), MOST))
}

/// p divided by what it shares with its derivative.
fn squarefree(p: &[IBig]) -> Vec<IBig> {
    let mut a = p.to_vec();
    let mut b: Vec<IBig> = p.iter().enumerate().skip(1).map(|(k, c)| c * IBig::from(k)).collect();
    while !b.is_empty() {
        let rest = negative_remainder(&a, &b);
        a = std::mem::replace(&mut b, rest);
    }
    quotient(p, &a)
}

fn simple_roots(polynomial: &[IBig], depth: usize) -> Option<Vec<Root>> {
    let mut found = Vec::new();
    let mut open = vec![Node { polynomial: polynomial.to_vec(), n: IBig::ZERO, k: 0 }];
    while let Some(mut node) = open.pop() {
        let zeros = node.polynomial.iter().take_while(|c| **c == IBig::ZERO).count();
        if zeros == node.polynomial.len() {
            continue;
        }
        let at = |n: &IBig| RBig::from(n.clone()) / RBig::from(IBig::ONE << node.k);
        if zeros > 0 {
            node.polynomial.drain(..zeros);
            if node.n > IBig::ZERO {
                let at = at(&node.n);
                found.push(Root { lo: at.clone(), hi: at, polynomial: polynomial.to_vec(), above: 0 });
            }
        }
        match variations(&node.polynomial) {
            0 => {}
            1 => {
                // Its sign just inside of the upper end.
                let sum = node.polynomial.iter().fold(IBig::ZERO, |sum, c| sum + c);
                let above = if sum == IBig::ZERO { -sign(&node.polynomial[0]) } else { sign(&sum) };
                let (lo, hi) = (at(&node.n), at(&(&node.n + IBig::ONE)));
                found.push(Root { lo, hi, polynomial: polynomial.to_vec(), above });
            }
            _ if node.k == depth => return None,
            _ => open.extend(node.halves()),
        }
    }
    found.sort_by(|p, q| (&p.lo, &p.hi).cmp(&(&q.lo, &q.hi)));
    // A root that is known exactly may be an end of the ranges beside it.
    for number in 1..found.len() {
        while found[number - 1].hi >= found[number].lo {
            found[number - 1].halve();
            found[number].halve();
        }
    }
    Some(found)
}

impl Node {
    fn halves(self) -> [Self; 2] {
        let degree = self.polynomial.len() - 1;
        let lower: Vec<IBig> = self.polynomial.into_iter().enumerate().map(|(k, c)| c << (degree - k)).collect();
        let mut upper = lower.clone();
        shift(&mut upper);
        let (n, k) = (self.n << 1usize, self.k + 1);
        [Self { polynomial: upper, n: &n + IBig::ONE, k }, Self { polynomial: lower, n, k }]
    }
}

/// Changes of sign of (1+w)ⁿ p(1/(1+w)), as many as roots between 0 and 1 up to an even number.
fn variations(p: &[IBig]) -> usize {
    let mut turned: Vec<IBig> = p.iter().rev().cloned().collect();
    shift(&mut turned);
    descartes::variations(&turned)
}

impl Root {
    /// Halves the range.
    pub fn halve(&mut self) {
        if self.lo == self.hi {
            return;
        }
        let middle = (&self.lo + &self.hi) / RBig::from(2);
        match sign_at(&self.polynomial, &middle) {
            0 => (self.lo, self.hi) = (middle.clone(), middle),
            s if s == self.above => self.hi = middle,
            _ => self.lo = middle,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn polynomial(roots: &[(i32, i32)]) -> Vec<IBig> {
        roots.iter().fold(vec![IBig::ONE], |p, &(n, d)| {
            let mut product = vec![IBig::ZERO; p.len() + 1];
            for (k, c) in p.iter().enumerate() {
                product[k] -= c * IBig::from(n);
                product[k + 1] += c * IBig::from(d);
            }
            product
        })
    }

    fn found(list: &[(i32, i32)]) -> Vec<f64> {
        let mut roots = roots(&polynomial(list)).unwrap();
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
}
