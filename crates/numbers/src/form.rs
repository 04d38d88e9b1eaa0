//! Homogeneous forms with enclosed coefficients, and their simple roots: Descartes' rule in Bernstein form as in
//! [`bernstein`](super::bernstein), with intervals for the bounds, so that also what under- or overflows is covered.

use super::Sign;
use super::enclosure::Enclosure;
use super::polynomial::Polynomial;
use super::root::narrowed;

/// Σ c_k v^(n−k) u^k with v = 1 − u. (The forms of [`bernstein`](super::bernstein) bound their rounding by magnitudes, which under-
/// and overflow spoil.)
#[derive(Clone, Debug)]
pub struct EnclosedForm<E> {
    c: Vec<E>,
}

impl<E: Enclosure<Precision = ()>> EnclosedForm<E> {
    /// The form of degree 1 with these values at u = 0 and u = 1.
    #[must_use]
    pub fn linear(at_zero: E, at_one: E) -> Self {
        Self { c: vec![at_zero, at_one] }
    }

    /// vⁿ p(u/v), where n is at least the degree of p.
    #[must_use]
    pub fn of(p: &Polynomial, n: usize) -> Self {
        let mut c = p.enclosed(());
        c.resize(n + 1, E::small(0, ()));
        Self { c }
    }

    /// The form of a degree less than the number of these different places in (0, 1) with these values there (v + u is 1): by
    /// Newton's divided differences. Places that are spread well at each stage keep it narrow.
    #[must_use]
    pub fn through(places: &[E], values: &[E]) -> Self {
        let one = E::small(1, ());
        // v_j/Π(x_j − x_i) over the places so far: a recursion would widen the differences by more than their sums.
        let mut shares: Vec<E> = Vec::with_capacity(places.len());
        let mut differences = Vec::with_capacity(places.len());
        for (k, (place, value)) in places.iter().zip(values).enumerate() {
            let mut product = one.clone();
            for (share, other) in shares.iter_mut().zip(places) {
                let run = place.clone() - other.clone();
                *share = -(share.clone() / run.clone());
                product = product * run;
            }
            shares.push(value.clone() / product);
            let sum = shares[..k].iter().fold(shares[k].clone(), |sum, share| sum + share.clone());
            differences.push(sum);
        }
        let sum = Self::linear(one.clone(), one.clone());
        let mut power = Self { c: vec![one.clone()] };
        let mut form = Self { c: differences.pop().into_iter().collect() };
        for (place, difference) in places.iter().zip(differences).rev() {
            power = power.times(&sum);
            let factor = Self::linear(-place.clone(), one.clone() - place.clone());
            form = form.times(&factor).plus(&power.scaled(&difference));
        }
        form
    }

    /// The product; the degrees add up.
    #[must_use]
    pub fn times(&self, other: &Self) -> Self {
        let mut c = vec![E::small(0, ()); self.c.len() + other.c.len() - 1];
        for (i, a) in self.c.iter().enumerate() {
            for (j, b) in other.c.iter().enumerate() {
                c[i + j] = c[i + j].clone() + a.clone() * b.clone();
            }
        }
        Self { c }
    }

    /// The form times a number.
    #[must_use]
    pub fn scaled(&self, factor: &E) -> Self {
        Self { c: self.c.iter().map(|c| c.clone() * factor.clone()).collect() }
    }

    /// The sum with a form of the same degree.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        debug_assert_eq!(self.c.len(), other.c.len());
        Self { c: self.c.iter().zip(&other.c).map(|(a, b)| a.clone() + b.clone()).collect() }
    }

    /// The derivative by u.
    fn derivative(&self) -> Self {
        let degree = self.c.len() - 1;
        let times = |c: &E, k: usize| c.clone() * E::double(k as f64, ());
        Self { c: (0..degree).map(|k| times(&self.c[k + 1], k + 1) - times(&self.c[k], degree - k)).collect() }
    }

    /// The value at u.
    #[must_use]
    pub fn at(&self, u: &E) -> E {
        let v = E::small(1, ()) - u.clone();
        let mut power = E::small(1, ());
        let mut value = E::small(0, ());
        for c in self.c.iter().rev() {
            value = value * u.clone() + c.clone() * power.clone();
            power = power * v.clone();
        }
        value
    }

    /// The roots in 0 < u < 1, ascending, in ranges that share ends at most. `None` when the coefficients leave their number
    /// open, a root is not simple, or one is at 0 or 1.
    #[must_use]
    pub fn simple_roots(&self) -> Option<Vec<E>> {
        const SPLITS: usize = 400;
        for end in [self.c.first()?, self.c.last()?] {
            end.strict_sign()?;
        }
        let slope = self.derivative();
        let mut open = vec![Piece::whole(self)];
        let mut found = Vec::new();
        let mut splits = 0;
        while let Some(part) = open.pop() {
            match part.changes() {
                [_, 0] => {}
                [1, 1] => {
                    let above = part.b[part.b.len() - 1].strict_sign()?;
                    let range = part.range[0].hull(&part.range[1]);
                    found.push(narrowed(range, above, |u| self.at(u), |u| slope.at(u), ()));
                }
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
}

/// A part of (0, 1), with the Bernstein coefficients there.
struct Piece<E> {
    b: Vec<E>,
    /// Its ends, as points.
    range: [E; 2],
    /// Where it is split, as a share of it.
    share: f64,
}

impl<E: Enclosure<Precision = ()>> Piece<E> {
    fn whole(form: &EnclosedForm<E>) -> Self {
        let degree = form.c.len() - 1;
        let mut binomial = 1.0;
        let mut b = Vec::with_capacity(form.c.len());
        for (k, c) in form.c.iter().enumerate() {
            b.push(c.clone() / E::double(binomial, ()));
            binomial = binomial * (degree - k) as f64 / (k + 1) as f64;
        }
        Self { b, range: [0, 1].map(|end| E::small(end, ())), share: 0.5 }
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

    /// Both sides of a place at which the form is not 0, by de Casteljau's rule.
    fn halves(&self) -> Option<[Self; 2]> {
        [1.0, 0.75].into_iter().find_map(|t| {
            let halves = self.split(t * self.share)?;
            halves[1].b[0].strict_sign().map(|_| halves)
        })
    }

    fn split(&self, t: f64) -> Option<[Self; 2]> {
        let [lo, hi] = self.range.clone();
        let width = hi.clone() - lo.clone();
        let at = (lo.clone() + width.clone() * E::double(t, ())).middle();
        if !(lo.is_below(&at) && at.is_below(&hi)) {
            return None;
        }
        let (u, v) = ((at.clone() - lo.clone()) / width.clone(), (hi.clone() - at.clone()) / width);
        let mut row = self.b.clone();
        let (mut left, mut right) = (Vec::with_capacity(row.len()), Vec::with_capacity(row.len()));
        while let (Some(first), Some(last)) = (row.first().cloned(), row.last().cloned()) {
            left.push(first);
            right.push(last);
            row = row.windows(2).map(|pair| pair[0].clone() * v.clone() + pair[1].clone() * u.clone()).collect();
        }
        right.reverse();
        let [below, above] = self.next_shares();
        Some([
            Self { b: left, range: [lo, at.clone()], share: below },
            Self { b: right, range: [at, hi], share: above },
        ])
    }

    /// Where the parts below and above are split: after a step towards an end the next one goes as much further in the
    /// exponent, so that roots very near to an end take few steps.
    fn next_shares(&self) -> [f64; 2] {
        const NEAREST: f64 = 1.0 / (1u64 << 48) as f64;
        let nearer = |distance: f64| if distance <= 0.5 { (distance * distance).max(NEAREST) } else { 0.5 };
        [nearer(self.share), 1.0 - nearer(1.0 - self.share)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::enclosure::Arithmetic;
    use crate::interval::Interval;
    use crate::wide::{Interval128, Interval384};
    use dashu_ratio::RBig;
    use proptest::prelude::*;

    /// Π (u − root).
    fn with_roots<E: Enclosure<Precision = ()>>(roots: &[RBig]) -> EnclosedForm<E> {
        let number = |x: &RBig| E::rational(x, ());
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
            let form = with_roots::<Interval>(&roots);
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
    fn forms_through_their_values_have_their_roots() {
        let planted: Vec<RBig> = (1..=30).map(|k| rational(k * k, 877)).collect();
        let form = with_roots::<Interval384>(&planted);
        let places: Vec<Interval384> = (0..=30).map(|k| Interval384::rational(&rational(2 * k + 1, 62), ())).collect();
        let values: Vec<Interval384> = places.iter().map(|place| form.at(place)).collect();
        let found = EnclosedForm::through(&places, &values).simple_roots().unwrap();
        let inside = planted.iter().filter(|root| **root < RBig::ONE);
        assert_eq!(found.len(), inside.clone().count());
        for (range, root) in found.iter().zip(inside) {
            let [lo, hi] = range.exact_bounds().unwrap();
            assert!(lo <= *root && *root <= hi && hi - lo < rational(1, 1_000_000_007), "{range:?}");
        }
    }

    #[test]
    fn multiple_roots_and_roots_at_the_ends_are_left_open() {
        let half = rational(1, 2);
        assert!(with_roots::<Interval>(&[half.clone(), half.clone()]).simple_roots().is_none());
        assert!(with_roots::<Interval>(&[half.clone(), RBig::ZERO]).simple_roots().is_none());
        assert!(with_roots::<Interval>(&[RBig::ONE, rational(1, 3)]).simple_roots().is_none());
        assert_eq!(with_roots::<Interval>(&[half, rational(7, 3)]).simple_roots().unwrap().len(), 1);
    }

    #[test]
    fn roots_of_very_different_size_are_enclosed() {
        let planted =
            [rational(1, 1_000_000_007) * rational(1, 1_000_000_009), rational(1, 1_000_000_007), rational(2, 5)];
        let found = with_roots::<Interval>(&planted).simple_roots().unwrap();
        for (range, root) in found.iter().zip(&planted) {
            let [lo, hi] = range.exact_bounds().unwrap();
            assert!(lo <= *root && *root <= hi && range.hi - range.lo < 1e-6 * range.hi, "{range:?}");
        }
    }

    #[test]
    fn roots_that_f64_leaves_open_are_enclosed_with_more_bits() {
        let third = rational(1, 3);
        let planted = [third.clone(), third + rational(1, 1_000_000_007) * rational(1, 1_000_000_009)];
        assert!(with_roots::<Interval>(&planted).simple_roots().is_none());
        let found = with_roots::<Interval128>(&planted).simple_roots().unwrap();
        assert!(found[0].is_below(&found[1]));
        for (range, root) in found.iter().zip(&planted) {
            let [lo, hi] = range.exact_bounds().unwrap();
            assert!(lo <= *root && *root <= hi, "{range:?}");
        }
    }

    #[test]
    fn what_overflows_is_left_open() {
        let huge = EnclosedForm::linear(Interval::point(-1e200), Interval::point(1e200));
        assert!(huge.times(&huge).times(&huge).simple_roots().is_none());
    }
}
