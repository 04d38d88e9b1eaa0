//! Counting real roots, exactly: by Descartes' rule where its signs decide, by Sturm's theorem elsewhere.

use std::cell::OnceCell;

use dashu_base::{Gcd, Signed};
use dashu_int::{IBig, UBig};
use dashu_ratio::RBig;

use super::descartes::{self, sign};

/// Coefficients by rising degree.
pub(crate) type Coefficients = Vec<RBig>;

pub(crate) fn times(p: &[RBig], q: &[RBig]) -> Coefficients {
    let mut product = vec![RBig::ZERO; (p.len() + q.len()).saturating_sub(1)];
    for (i, a) in p.iter().enumerate() {
        for (j, b) in q.iter().enumerate() {
            product[i + j] += a * b;
        }
    }
    product
}

pub(crate) fn plus(p: &[RBig], q: &[RBig], factor: &RBig) -> Coefficients {
    (0..p.len().max(q.len()))
        .map(|k| p.get(k).cloned().unwrap_or(RBig::ZERO) + q.get(k).map_or(RBig::ZERO, |c| c * factor))
        .collect()
}

/// A polynomial whose real roots are counted.
#[derive(Clone, Debug)]
pub(crate) struct Sturm {
    polynomial: Vec<IBig>,
    /// Sturm's sequence, made when it is asked for.
    sequence: OnceCell<Vec<Vec<IBig>>>,
}

/// p/d for a d that divides p, up to a positive factor.
pub(crate) fn quotient(p: &[IBig], d: &[IBig]) -> Vec<IBig> {
    let mut rest: Vec<RBig> = p.iter().map(|c| RBig::from(c.clone())).collect();
    let lead = RBig::from(d[d.len() - 1].clone());
    let mut result = vec![RBig::ZERO; (p.len() + 1).saturating_sub(d.len())];
    while rest.len() >= d.len() {
        let factor = &rest[rest.len() - 1] / &lead;
        let offset = rest.len() - d.len();
        for (k, c) in d.iter().enumerate() {
            rest[offset + k] -= RBig::from(c.clone()) * &factor;
        }
        result[offset] = factor;
        rest.pop();
    }
    integers(&result)
}

/// Integer multiples by a positive factor, without common divisor.
pub(crate) fn integers(p: &[RBig]) -> Vec<IBig> {
    let common = p.iter().fold(UBig::ONE, |common, x| {
        let shared = (&common).gcd(x.denominator());
        common / shared * x.denominator()
    });
    primitive(p.iter().map(|x| x.numerator() * IBig::from(&common / x.denominator())).collect())
}

fn primitive(mut p: Vec<IBig>) -> Vec<IBig> {
    while p.last().is_some_and(|c| *c == IBig::ZERO) {
        p.pop();
    }
    let content = p.iter().fold(UBig::ZERO, |content, c| match c.clone().into_parts().1 {
        c if c == UBig::ZERO => content,
        c if content == UBig::ZERO => c,
        c => content.gcd(c),
    });
    if content > UBig::ONE {
        let content = IBig::from(content);
        for c in &mut p {
            *c /= &content;
        }
    }
    p
}

/// −(p mod q), up to a positive factor.
pub(crate) fn negative_remainder(p: &[IBig], q: &[IBig]) -> Vec<IBig> {
    let mut rest = p.to_vec();
    let lead = &q[q.len() - 1];
    let factor = if lead.is_negative() { -lead } else { lead.clone() };
    while rest.len() >= q.len() {
        let top = rest[rest.len() - 1].clone();
        let top = if lead.is_negative() { -top } else { top };
        let offset = rest.len() - q.len();
        for c in &mut rest {
            *c *= &factor;
        }
        for (k, d) in q.iter().enumerate() {
            rest[offset + k] -= d * &top;
        }
        rest.pop();
    }
    primitive(rest.into_iter().map(|c| -c).collect())
}

impl Sturm {
    pub fn new(p: &[RBig]) -> Self {
        Self { polynomial: integers(p), sequence: OnceCell::new() }
    }

    /// Of the squarefree part, so that multiple roots at the ends of an interval do no harm.
    fn sequence(&self) -> &[Vec<IBig>] {
        self.sequence.get_or_init(|| {
            let first = self.polynomial.clone();
            let mut next = primitive(first.iter().enumerate().skip(1).map(|(k, c)| c * IBig::from(k)).collect());
            let mut sequence = vec![first];
            while !next.is_empty() {
                let after = negative_remainder(&sequence[sequence.len() - 1], &next);
                sequence.push(next);
                next = after;
            }
            match sequence.last().filter(|last| last.len() > 1).cloned() {
                Some(shared) => sequence.iter().map(|p| quotient(p, &shared)).collect(),
                None => sequence,
            }
        })
    }

    fn variations(&self, value: impl Fn(&[IBig]) -> i8) -> i64 {
        let mut last = 0;
        let mut count = 0;
        for sign in self.sequence().iter().map(|p| value(p)).filter(|s| *s != 0) {
            count += i64::from(last == -sign);
            last = sign;
        }
        count
    }

    /// Number of different real roots in (lo, hi] by Sturm's theorem; `None` is −∞ or ∞.
    fn roots(&self, lo: Option<&RBig>, hi: Option<&RBig>) -> i64 {
        let far = |negative: bool| {
            move |p: &[IBig]| {
                let sign = p.last().map_or(0, sign);
                if negative && p.len().is_multiple_of(2) { -sign } else { sign }
            }
        };
        let at = |x: Option<&RBig>, negative: bool| match x {
            Some(x) => self.variations(|p| sign_at(p, x)),
            None => self.variations(far(negative)),
        };
        at(lo, true) - at(hi, false)
    }

    /// Number of different real roots in the open interval; `None` is −∞ or ∞.
    pub fn inside(&self, lo: Option<&RBig>, hi: Option<&RBig>) -> i64 {
        descartes::inside(&self.polynomial, [lo, hi])
            .unwrap_or_else(|| self.roots(lo, hi) - i64::from(hi.is_some_and(|x| self.sign_at(x) == 0)))
    }

    /// Number of different real roots in [lo, hi].
    pub fn closed(&self, lo: &RBig, hi: &RBig) -> i64 {
        let at = |x: &RBig| i64::from(self.sign_at(x) == 0);
        if lo == hi { at(lo) } else { self.inside(Some(lo), Some(hi)) + at(lo) + at(hi) }
    }

    pub fn sign_at(&self, x: &RBig) -> i8 {
        sign_at(&self.polynomial, x)
    }

    /// The greatest common divisor of two polynomials has a root in [lo, hi].
    pub fn common_root(p: &[RBig], q: &[RBig], lo: &RBig, hi: &RBig) -> bool {
        let (mut a, mut b) = (integers(p), integers(q));
        while !b.is_empty() {
            let rest = negative_remainder(&a, &b);
            a = b;
            b = rest;
        }
        let shared: Coefficients = a.into_iter().map(RBig::from).collect();
        shared.len() > 1 && Self::new(&shared).closed(lo, hi) > 0
    }
}

/// Sign of a polynomial at a number.
pub(crate) fn sign_at(p: &[IBig], x: &RBig) -> i8 {
    let (n, d) = (x.numerator(), IBig::from(x.denominator().clone()));
    let mut power = IBig::ONE;
    let mut value = IBig::ZERO;
    for c in p.iter().rev() {
        value = value * n + c * &power;
        power *= &d;
    }
    sign(&value)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn with_roots(roots: &[i32]) -> Coefficients {
        roots.iter().fold(vec![RBig::ONE], |p, &r| times(&p, &[RBig::from(-r), RBig::ONE]))
    }

    #[test]
    fn roots_are_counted_once_each() {
        let sturm = Sturm::new(&with_roots(&[1, 2, 2, 3, -5]));
        assert_eq!(sturm.roots(None, None), 4);
        assert_eq!(sturm.inside(Some(&RBig::from(1)), Some(&RBig::from(3))), 1);
        assert_eq!(sturm.closed(&RBig::from(1), &RBig::from(3)), 3);
        assert_eq!(sturm.closed(&RBig::from(2), &RBig::from(2)), 1);
        assert_eq!(sturm.inside(None, Some(&RBig::ZERO)), 1);
        // Double roots at both ends.
        let sturm = Sturm::new(&with_roots(&[0, 0, 1, 2, 2]));
        assert_eq!(sturm.inside(Some(&RBig::ZERO), Some(&RBig::from(2))), 1);
        let none = Sturm::new(&plus(&with_roots(&[0, 0]), &[RBig::ONE], &RBig::ONE));
        assert_eq!(none.roots(None, None), 0);
    }

    #[test]
    fn common_roots_are_found() {
        let (p, q) = (with_roots(&[1, 4, 6]), with_roots(&[4, 7]));
        assert!(Sturm::common_root(&p, &q, &RBig::from(3), &RBig::from(5)));
        assert!(!Sturm::common_root(&p, &q, &RBig::from(5), &RBig::from(9)));
    }
}
