//! Descartes' rule of signs: a polynomial has as many positive roots as its coefficients change sign, up to an even number;
//! so 0 and 1 are numbers of roots.

use dashu_base::Gcd;
use dashu_int::IBig;
use dashu_ratio::RBig;

/// Splits after which a multiple root, or a pair closer than is worth it, is suspected.
const SPLITS: usize = 100;

/// p(w + 1).
pub(crate) fn shift(p: &mut [IBig]) {
    for from in 0..p.len() {
        for k in (from..p.len() - 1).rev() {
            let (low, high) = p.split_at_mut(k + 1);
            low[k] += &high[0];
        }
    }
}

/// Changes of sign along the coefficients.
pub(crate) fn variations(p: &[IBig]) -> usize {
    let mut signs = p.iter().map(sign).filter(|s| *s != 0);
    let Some(mut last) = signs.next() else {
        return 0;
    };
    signs.filter(|&s| std::mem::replace(&mut last, s) != s).count()
}

pub(crate) fn sign(x: &IBig) -> i8 {
    i8::from(*x > IBig::ZERO) - i8::from(*x < IBig::ZERO)
}

/// Σ c_k αᵏ βⁿ⁻ᵏ for linear polynomials α and β: p at α/β, times βⁿ.
pub(crate) fn moved(polynomial: &[IBig], above: &[IBig; 2], below: &[IBig; 2]) -> Vec<IBig> {
    let mut power = vec![IBig::ONE];
    let mut sum: Vec<IBig> = Vec::new();
    for coefficient in polynomial.iter().rev() {
        sum = product(&sum, above);
        for (k, c) in power.iter().enumerate() {
            if k == sum.len() {
                sum.push(IBig::ZERO);
            }
            sum[k] += c * coefficient;
        }
        power = product(&power, below);
    }
    sum
}

fn product(p: &[IBig], [low, high]: &[IBig; 2]) -> Vec<IBig> {
    if p.is_empty() {
        return Vec::new();
    }
    let mut product = vec![IBig::ZERO; p.len() + 1];
    for (k, c) in p.iter().enumerate() {
        product[k] += c * low;
        product[k + 1] += c * high;
    }
    product
}

/// Number of different roots in an open interval, where `None` is −∞ or ∞; `None` if the signs do not decide.
pub(crate) fn inside(p: &[IBig], ends: [Option<&RBig>; 2]) -> Option<i64> {
    let whole = |x: &RBig| (x.numerator().clone(), IBig::from(x.denominator().clone()));
    let (above, below) = match ends {
        [Some(lo), Some(hi)] if lo > hi => return None,
        // (lo + t hi)/(1 + t)
        [Some(lo), Some(hi)] => {
            let shared = lo.denominator().gcd(hi.denominator());
            let [p, q] = [hi, lo].map(|x| IBig::from(x.denominator() / &shared));
            let common = &p * IBig::from(lo.denominator().clone());
            ([lo.numerator() * p, hi.numerator() * q], [common.clone(), common])
        }
        [Some(lo), None] => {
            let (n, d) = whole(lo);
            ([n, d.clone()], [d, IBig::ZERO])
        }
        [None, Some(hi)] => {
            let (n, d) = whole(hi);
            ([n, -&d], [d, IBig::ZERO])
        }
        [None, None] => {
            let zero = RBig::ZERO;
            let at_zero = i64::from(p.first().is_some_and(|c| *c == IBig::ZERO));
            return Some(inside(p, [None, Some(&zero)])? + at_zero + inside(p, [Some(&zero), None])?);
        }
    };
    positive(moved(p, &above, &below), &mut SPLITS.clone())
}

/// Number of different positive roots: those beyond 1, those below it, and 1.
fn positive(p: Vec<IBig>, splits: &mut usize) -> Option<i64> {
    match variations(&p) {
        0 => return Some(0),
        1 => return Some(1),
        _ => *splits = splits.checked_sub(1)?,
    }
    let mut below: Vec<IBig> = p.iter().rev().cloned().collect();
    let mut above = p;
    shift(&mut above);
    shift(&mut below);
    let at_one = i64::from(above[0] == IBig::ZERO);
    Some(at_one + positive(above, splits)? + positive(below, splits)?)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn with_roots(roots: &[i32]) -> Vec<IBig> {
        roots.iter().fold(vec![IBig::ONE], |p, &r| product(&p, &[IBig::from(-r), IBig::ONE]))
    }

    #[test]
    fn roots_are_counted_where_the_signs_tell() {
        let p = with_roots(&[-5, 0, 1, 3, 8]);
        let n = |n: i32, d: u32| RBig::from_parts(n.into(), d.into());
        let count = |lo: Option<RBig>, hi: Option<RBig>| inside(&p, [lo.as_ref(), hi.as_ref()]);
        assert_eq!(count(None, None), Some(5));
        assert_eq!(count(Some(n(-5, 1)), Some(n(8, 1))), Some(3));
        assert_eq!(count(Some(n(1, 2)), Some(n(10, 3))), Some(2));
        assert_eq!(count(Some(n(10, 3)), None), Some(1));
        assert_eq!(count(None, Some(n(-5, 1))), Some(0));
        assert_eq!(count(Some(n(4, 1)), Some(n(15, 2))), Some(0));
        // Without real roots, and with double ones: some splits meet them, √2 none does.
        assert_eq!(inside(&[1, 0, 1].map(IBig::from), [None, None]), Some(0));
        assert_eq!(inside(&with_roots(&[3, 3]), [Some(&n(1, 3)), None]), Some(1));
        assert_eq!(inside(&with_roots(&[3, 3]), [Some(&n(4, 1)), None]), Some(0));
        assert_eq!(inside(&[4, 0, -4, 0, 1].map(IBig::from), [Some(&RBig::ZERO), None]), None);
    }
}
