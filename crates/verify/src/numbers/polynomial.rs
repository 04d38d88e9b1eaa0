//! Polynomials, exact: built from rational coefficients, and with integer ones where only their zeros and signs count.

use dashu_base::{BitTest, Gcd};
use dashu_int::{IBig, UBig};
use dashu_ratio::RBig;

use super::ball::Ball;

/// Words in which signs are sought first.
const WORDS: usize = 6;

/// Coefficients by rising degree.
pub(crate) type Coefficients = Vec<RBig>;

/// The coefficients times a positive integer that makes them whole, and that integer.
pub(crate) fn whole(p: &[RBig]) -> (Vec<IBig>, UBig) {
    let common = p.iter().fold(UBig::ONE, |common, x| {
        let shared = (&common).gcd(x.denominator());
        common / shared * x.denominator()
    });
    (p.iter().map(|x| x.numerator() * IBig::from(&common / x.denominator())).collect(), common)
}

/// p q, multiplied in integers, so that each coefficient is reduced only once.
pub(crate) fn times(p: &[RBig], q: &[RBig]) -> Coefficients {
    let ((p, p_below), (q, q_below)) = (whole(p), whole(q));
    let below = p_below * q_below;
    product(&p, &q).into_iter().map(|c| RBig::from_parts(c, below.clone())).collect()
}

/// p q in integers.
pub(crate) fn product(p: &[IBig], q: &[IBig]) -> Vec<IBig> {
    let mut product = vec![IBig::ZERO; (p.len() + q.len()).saturating_sub(1)];
    for (i, a) in p.iter().enumerate() {
        for (j, b) in q.iter().enumerate() {
            product[i + j] += a * b;
        }
    }
    product
}

/// p + factor q.
pub(crate) fn plus(p: &[RBig], q: &[RBig], factor: &RBig) -> Coefficients {
    (0..p.len().max(q.len()))
        .map(|k| p.get(k).cloned().unwrap_or(RBig::ZERO) + q.get(k).map_or(RBig::ZERO, |c| c * factor))
        .collect()
}

/// A polynomial up to a positive factor: integers without common divisor, by rising degree, the last not 0.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Polynomial(pub Vec<IBig>);

impl Polynomial {
    pub fn new(p: &[RBig]) -> Self {
        Self::primitive(whole(p).0)
    }

    /// Without the common divisor.
    pub fn primitive(mut p: Vec<IBig>) -> Self {
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
        Self(p)
    }

    pub fn sign_at(&self, x: &RBig) -> i8 {
        let (n, d) = (x.numerator(), IBig::from(x.denominator().clone()));
        let mut power = IBig::ONE;
        let mut value = IBig::ZERO;
        for c in self.0.iter().rev() {
            value = value * n + c * &power;
            power *= &d;
        }
        sign(&value)
    }

    /// How often a number is a root.
    pub fn order_at(&self, x: &RBig) -> usize {
        let mut rest: Coefficients = self.0.iter().map(|c| RBig::from(c.clone())).collect();
        let mut order = 0;
        while rest.len() > 1 {
            // Horner's scheme leaves the quotient above the remainder.
            let mut carry = RBig::ZERO;
            for c in rest.iter_mut().rev() {
                carry = carry * x + &*c;
                c.clone_from(&carry);
            }
            if !rest.remove(0).is_zero() {
                break;
            }
            order += 1;
        }
        order
    }

    /// The greatest common divisor of two polynomials.
    pub fn shared(&self, other: &Self) -> Self {
        let (mut a, mut b) = (self.clone(), other.clone());
        while !b.0.is_empty() {
            let rest = a.remainder(&b);
            a = std::mem::replace(&mut b, rest);
        }
        a
    }

    /// A polynomial with the same roots, all of them simple.
    pub fn squarefree(&self) -> Self {
        let derivative = self.0.iter().enumerate().skip(1).map(|(k, c)| c * IBig::from(k)).collect();
        self.over(&self.shared(&Self::primitive(derivative)))
    }

    /// self mod d, up to a factor.
    fn remainder(&self, d: &Self) -> Self {
        let (mut rest, lead) = (self.0.clone(), &d.0[d.0.len() - 1]);
        while rest.len() >= d.0.len() {
            let top = rest[rest.len() - 1].clone();
            let offset = rest.len() - d.0.len();
            for c in &mut rest {
                *c *= lead;
            }
            for (k, c) in d.0.iter().enumerate() {
                rest[offset + k] -= c * &top;
            }
            rest.pop();
        }
        Self::primitive(rest)
    }

    /// self/d for a d that divides it, up to a factor.
    fn over(&self, d: &Self) -> Self {
        let mut rest: Coefficients = self.0.iter().map(|c| RBig::from(c.clone())).collect();
        let lead = RBig::from(d.0[d.0.len() - 1].clone());
        let mut result = vec![RBig::ZERO; (rest.len() + 1).saturating_sub(d.0.len())];
        while rest.len() >= d.0.len() {
            let factor = &rest[rest.len() - 1] / &lead;
            let offset = rest.len() - d.0.len();
            for (k, c) in d.0.iter().enumerate() {
                rest[offset + k] -= RBig::from(c.clone()) * &factor;
            }
            result[offset] = factor;
            rest.pop();
        }
        Self::new(&result)
    }

    /// Every root has a smaller absolute value (Fujiwara): twice the largest k-th root of |c_{n−k}/c_n|, rounded up to a
    /// power of two that is at least 2.
    pub fn bound(&self) -> RBig {
        let bits = |c: &IBig| isize::try_from(c.clone().into_parts().1.bit_len()).unwrap_or(isize::MAX);
        let lead = self.0.last().map_or(0, bits);
        let lower = self.0.iter().rev().enumerate().skip(1).filter(|(_, c)| **c != IBig::ZERO);
        let power = lower.map(|(k, c)| (bits(c) - lead + 1).max(0).cast_unsigned().div_ceil(k)).max();
        RBig::from(IBig::ONE << (power.unwrap_or(0) + 1))
    }
}

/// A polynomial whose signs are asked at many places: most are those of an enclosure.
#[derive(Debug)]
pub(super) struct Signs {
    exact: Polynomial,
    enclosed: Vec<Ball<WORDS>>,
}

impl Signs {
    pub fn new(exact: Polynomial) -> Self {
        let enclosed = exact.0.iter().map(Ball::integer).collect();
        Self { exact, enclosed }
    }

    pub fn at(&self, x: &RBig) -> i8 {
        self.enclosed(x).strict_sign().unwrap_or_else(|| self.exact.sign_at(x))
    }

    /// The value, up to a positive factor that does not depend on x.
    pub fn enclosed(&self, x: &RBig) -> Ball<WORDS> {
        horner(self.enclosed.iter().rev(), &Ball::of(x))
    }
}

/// From the highest coefficient to the lowest.
pub(crate) fn horner<'a, const N: usize>(form: impl Iterator<Item = &'a Ball<N>>, x: &Ball<N>) -> Ball<N> {
    form.fold(Ball::zero(), |sum, c| &(&sum * x) + c)
}

pub(crate) fn sign(x: &IBig) -> i8 {
    i8::from(*x > IBig::ZERO) - i8::from(*x < IBig::ZERO)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn with_roots(roots: &[i32]) -> Coefficients {
        roots.iter().fold(vec![RBig::ONE], |p, &r| times(&p, &[RBig::from(-r), RBig::ONE]))
    }

    #[test]
    fn what_two_polynomials_share_is_found() {
        let polynomial = |roots: &[i32]| Polynomial::new(&with_roots(roots));
        let shared = polynomial(&[1, 4, 6]).shared(&polynomial(&[4, 7]));
        assert!(shared.sign_at(&RBig::from(4)) == 0 && shared.0.len() == 2);
        let simple = polynomial(&[2, 2, 2, -3, -3, 5]).squarefree();
        assert!([2, -3, 5].iter().all(|&root| simple.sign_at(&RBig::from(root)) == 0) && simple.0.len() == 4);
    }

    #[test]
    fn roots_have_their_order() {
        let p = Polynomial::new(&with_roots(&[2, 2, 2, -3, 0, 0]));
        assert_eq!([2, -3, 0, 1].map(|x| p.order_at(&RBig::from(x))), [3, 1, 2, 0]);
    }

    #[test]
    fn zero_has_no_sign() {
        let signs = [-3, 0, 5].map(|n| Polynomial(vec![IBig::ZERO, n.into()]).sign_at(&RBig::ONE));
        assert_eq!(signs, [-1, 0, 1]);
        assert_eq!(Polynomial(vec![IBig::ONE]).sign_at(&RBig::ZERO), 1);
    }

    #[test]
    fn all_roots_lie_within_the_bound() {
        for roots in [&[1, -7, 1000][..], &[0, 0, 3], &[-1_000_000], &[]] {
            let bound = Polynomial::new(&with_roots(roots)).bound();
            assert!(roots.iter().all(|&root| RBig::from(root.abs()) < bound), "{roots:?} {bound}");
        }
    }
}
