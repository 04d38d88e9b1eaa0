//! Homogeneous forms with enclosed coefficients, and their simple roots: Descartes' rule in Bernstein form as in
//! [`bernstein`](super::bernstein), with intervals for the bounds, so that also what under- or overflows is covered.

use super::Sign;
use super::enclosure::Enclosure;
use super::interval::Interval;
use super::root::itp;

/// Σ c_k v^(n−k) u^k with v = 1 − u. (The forms of [`bernstein`](super::bernstein) bound their rounding by magnitudes, which under-
/// and overflow spoil.)
#[derive(Clone, Debug)]
pub struct EnclosedForm {
    c: Vec<Interval>,
}

impl EnclosedForm {
    /// The form of degree 1 with these values at u = 0 and u = 1.
    #[must_use]
    pub fn linear(at_zero: Interval, at_one: Interval) -> Self {
        Self { c: vec![at_zero, at_one] }
    }

    /// The product.
    #[must_use]
    pub fn times(&self, other: &Self) -> Self {
        let mut c = vec![Interval::ZERO; self.c.len() + other.c.len() - 1];
        for (i, a) in self.c.iter().enumerate() {
            for (j, b) in other.c.iter().enumerate() {
                c[i + j] = c[i + j] + *a * *b;
            }
        }
        Self { c }
    }

    /// The form times a number.
    #[must_use]
    pub fn scaled(&self, factor: Interval) -> Self {
        Self { c: self.c.iter().map(|c| *c * factor).collect() }
    }

    /// The sum with a form of the same degree.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        debug_assert_eq!(self.c.len(), other.c.len());
        Self { c: self.c.iter().zip(&other.c).map(|(a, b)| *a + *b).collect() }
    }

    /// The value at u.
    #[must_use]
    pub fn at(&self, u: Interval) -> Interval {
        let v = Interval::ONE - u;
        let mut power = Interval::ONE;
        let mut value = Interval::ZERO;
        for c in self.c.iter().rev() {
            value = value * u + *c * power;
            power = power * v;
        }
        value
    }

    /// The roots in 0 < u < 1, ascending, in intervals that share ends at most. `None` when the coefficients do not tell how
    /// many there are, one is not simple, or one is at 0 or 1.
    #[must_use]
    pub fn simple_roots(&self) -> Option<Vec<Interval>> {
        const SPLITS: usize = 400;
        for end in [self.c.first()?, self.c.last()?] {
            end.strict_sign()?;
        }
        let mut open = vec![Part::whole(self)];
        let mut found = Vec::new();
        let mut splits = 0;
        while let Some(part) = open.pop() {
            match part.changes() {
                [_, 0] => {}
                [1, 1] => found.push(self.narrowed(&part)),
                _ if splits == SPLITS => return None,
                _ => {
                    splits += 1;
                    let [left, right] = part.halves()?;
                    open.extend([right, left]);
                }
            }
        }
        Some(found)
    }

    /// The one root in a part, in a narrow interval around what `f64` finds where the signs at its ends prove it.
    fn narrowed(&self, part: &Part) -> Interval {
        /// Relative to u: 2^−46, 2^−40, 2^−32, 2^−22.
        const REACHES: [f64; 4] = [64.0, 4096.0, 1_048_576.0, 1_073_741_824.0];
        let [lo, hi] = part.range;
        let [first, last] = [part.b[0], part.b[part.b.len() - 1]];
        let value = |u: f64| centre(self.at(Interval::point(u)));
        let guess = itp(lo, hi, centre(first), centre(last), 4.0 * f64::EPSILON * hi, value).at;
        let sign_at =
            |u: f64, end: Interval| if u == lo || u == hi { end.sign() } else { self.at(Interval::point(u)).sign() };
        let around = |units: f64| {
            let reach = guess * (units * f64::EPSILON);
            let [low, high] = [(guess - reach).max(lo), (guess + reach).min(hi)];
            let holds = low < high && sign_at(low, first) == first.sign() && sign_at(high, last) == last.sign();
            holds.then_some(Interval { lo: low, hi: high })
        };
        REACHES.into_iter().find_map(around).unwrap_or(Interval { lo, hi })
    }
}

fn centre(range: Interval) -> f64 {
    0.5 * range.lo + 0.5 * range.hi
}

/// A part of (0, 1), with the Bernstein coefficients there.
struct Part {
    b: Vec<Interval>,
    range: [f64; 2],
}

impl Part {
    fn whole(form: &EnclosedForm) -> Self {
        let degree = form.c.len() - 1;
        let mut binomial = 1.0;
        let mut b = Vec::with_capacity(form.c.len());
        for (k, c) in form.c.iter().enumerate() {
            b.push(*c / Interval::point(binomial));
            binomial = binomial * (degree - k) as f64 / (k + 1) as f64;
        }
        Self { b, range: [0.0, 1.0] }
    }

    /// The smallest and the largest number of changes of sign among the coefficients.
    fn changes(&self) -> [usize; 2] {
        let mut fewest = 0;
        let mut last: Option<Sign> = None;
        // Most changes so far that end with this sign.
        let mut most = [Some(0), Some(0)];
        for (k, b) in self.b.iter().enumerate() {
            let sign = b.strict_sign();
            fewest += usize::from(last.is_some_and(|last| sign == Some(-last)));
            last = sign.or(last);
            let [stays, turns] = [most, [most[1], most[0]]];
            most = [0, 1].map(|end| {
                let possible = sign.is_none_or(|sign| sign == Sign::BOTH[end]);
                let turned = turns[end].filter(|_| k > 0).map(|count: usize| count + 1);
                stays[end].max(turned).filter(|_| possible)
            });
        }
        [fewest, most[0].max(most[1]).unwrap_or(0)]
    }

    /// Both sides of a place near the middle at which the form is not 0, by de Casteljau's rule.
    fn halves(&self) -> Option<[Self; 2]> {
        [0.5, 0.375].into_iter().find_map(|t| {
            let halves = self.split(t)?;
            halves[1].b[0].strict_sign().map(|_| halves)
        })
    }

    fn split(&self, t: f64) -> Option<[Self; 2]> {
        let [lo, hi] = self.range;
        let at = lo + t * (hi - lo);
        if !(lo < at && at < hi) {
            return None;
        }
        let [from, to, here] = [lo, hi, at].map(Interval::point);
        let width = to - from;
        let (u, v) = ((here - from) / width, (to - here) / width);
        let mut row = self.b.clone();
        let (mut left, mut right) = (Vec::with_capacity(row.len()), Vec::with_capacity(row.len()));
        while let (Some(first), Some(last)) = (row.first().copied(), row.last().copied()) {
            left.push(first);
            right.push(last);
            row = row.windows(2).map(|pair| pair[0] * v + pair[1] * u).collect();
        }
        right.reverse();
        Some([Self { b: left, range: [lo, at] }, Self { b: right, range: [at, hi] }])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::enclosure::Arithmetic;
    use dashu_ratio::RBig;
    use proptest::prelude::*;

    /// Π (u − root).
    fn with_roots(roots: &[RBig]) -> EnclosedForm {
        let number = |x: &RBig| Interval::rational(x, ());
        let factor = |root: &RBig| EnclosedForm::linear(number(&-root.clone()), number(&(RBig::ONE - root)));
        roots[1..].iter().fold(factor(&roots[0]), |product, root| product.times(&factor(root)))
    }

    fn rational(p: i32, q: u32) -> RBig {
        RBig::from_parts(p.into(), q.into())
    }

    proptest! {
        #[test]
        fn planted_roots_are_enclosed(roots in proptest::collection::vec((-300i32..1300, 900u32..1100), 1..=12)) {
            let mut roots: Vec<RBig> = roots.into_iter().map(|(p, q)| rational(p, q)).collect();
            roots.sort();
            roots.dedup();
            let form = with_roots(&roots);
            let inside: Vec<&RBig> = roots.iter().filter(|root| **root > RBig::ZERO && **root < RBig::ONE).collect();
            // Whatever is found is right; what is well apart is found.
            let apart = roots.windows(2).all(|pair| &pair[1] - &pair[0] > rational(1, 25));
            let found = form.simple_roots();
            let at_end = roots.iter().any(|root| *root == RBig::ZERO || *root == RBig::ONE);
            prop_assert!(found.is_some() || !apart || at_end || roots.len() > 8);
            let Some(found) = found else { return Ok(()) };
            prop_assert_eq!(found.len(), inside.len());
            for (range, root) in found.iter().zip(inside) {
                let [lo, hi] = range.exact_bounds().unwrap();
                prop_assert!(lo <= *root && *root <= hi);
                prop_assert!(!apart || roots.len() > 8 || range.hi - range.lo < 1e-6);
            }
        }
    }

    #[test]
    fn multiple_roots_and_roots_at_the_ends_are_left_open() {
        let half = rational(1, 2);
        assert!(with_roots(&[half.clone(), half.clone()]).simple_roots().is_none());
        assert!(with_roots(&[half.clone(), RBig::ZERO]).simple_roots().is_none());
        assert!(with_roots(&[RBig::ONE, rational(1, 3)]).simple_roots().is_none());
        assert_eq!(with_roots(&[half, rational(7, 3)]).simple_roots().unwrap().len(), 1);
    }

    #[test]
    fn roots_of_very_different_size_are_enclosed() {
        let planted =
            [rational(1, 1_000_000_007) * rational(1, 1_000_000_009), rational(1, 1_000_000_007), rational(2, 5)];
        let found = with_roots(&planted).simple_roots().unwrap();
        for (range, root) in found.iter().zip(&planted) {
            let [lo, hi] = range.exact_bounds().unwrap();
            assert!(lo <= *root && *root <= hi && range.hi - range.lo < 1e-6 * range.hi, "{range:?}");
        }
    }

    #[test]
    fn what_overflows_is_left_open() {
        let huge = EnclosedForm::linear(Interval::point(-1e200), Interval::point(1e200));
        assert!(huge.times(&huge).times(&huge).simple_roots().is_none());
    }
}
