//! Arnold's determinant along a stretch, all of it: N = (D₄/s) χ² (β² − 4χ)(4β² − 25χ) p⁹, on an axis (D₄/s) χ (β² −
//! 4χ), is a polynomial of known degree (Theorem 13.13), so its values at one place more determine where it vanishes.
//! In μ it is one polynomial on all branches.

use dashu_int::IBig;
use dashu_ratio::RBig;

use super::amplitudes::NormalForm;
use super::flow::Flow;
use super::modes::Rotation;
use crate::equilibria::pieces::Branch;
use crate::equilibria::spaces::{Space, Spaces};
use crate::numbers::ball::Ball;
use crate::numbers::polynomial::{Polynomial, horner, product};

/// Splits at most.
const SPLITS: usize = 400;

/// The polynomial over the zeros that are known, as Σ c_k xᵏ(1 − x)ⁿ⁻ᵏ with t = from + width x.
pub(super) struct Determinant<const N: usize> {
    from: RBig,
    width: RBig,
    known: Vec<RBig>,
    form: Vec<Ball<N>>,
}

/// r on an axis, and rotation about it.
pub(super) fn is_axis(spaces: &Spaces, branch: Branch) -> bool {
    spaces.active.len() == 1 && !matches!(branch, Branch::Over(_))
}

impl<const N: usize> Determinant<N> {
    /// From the normal forms inside a range of the parameter, in which there are two imaginary pairs at index 2 but at
    /// moments.
    pub fn new(spaces: &Spaces, branch: Branch, flow: &Flow, [from, to]: [&RBig; 2]) -> Option<Self> {
        let (is_axis, width) = (is_axis(spaces, branch), to - from);
        let known = known_zeros(spaces, branch, &flow.resonances()[0]);
        let degree = match branch {
            Branch::Over(_) => 9,
            _ if is_axis => 5,
            _ => 9 * (2 * spaces.active.len() - 1),
        } - known.len();

        let rotations = Rotations::new(spaces, branch);
        let value_at = |place: i64| {
            let t = from + &width * RBig::from_parts(place.into(), UNIT.unsigned_abs().into());
            let at = rotations.at(&Ball::of(&t))?;
            let NormalForm { b, c, arnold, .. } = NormalForm::new(&at)?;
            let defect = |m: i32, n: i32| &(&Ball::whole(m) * &b.square()) - &(&Ball::whole(n) * &c);
            let mut value = &(&arnold * &c) * &defect(1, 4);
            if !is_axis {
                let cube = &at.weight.square() * &at.weight;
                value = &(&value * &c) * &(&defect(4, 25) * &(&cube.square() * &cube));
            }
            let away = known.iter().fold(RBig::ONE, |product, zero| product * (&t - zero) / &width);
            value.over(&Ball::of(&away))
        };
        // A resonance may lie exactly at a place.
        let beside = |place: i64| [place, place + 1].into_iter().find_map(|place| Some((place, value_at(place)?)));
        let found: Option<Vec<_>> = places(degree).into_iter().map(beside).collect();
        let (places, values): (Vec<i64>, Vec<Ball<N>>) = found?.into_iter().unzip();
        let form = interpolated(&places, &values)?;
        Some(Self { from: from.clone(), width, known, form })
    }

    /// The polynomial over (1 − x)ⁿ or, in the upper half, over xⁿ, for all x from one to another.
    fn at(&self, [lo, hi]: [&RBig; 2]) -> Option<Ball<N>> {
        let [below, above] = [lo, hi].map(|x| RBig::ONE - x);
        if *hi < above {
            let ratio = Ball::between(&(lo / below), &(hi / above));
            return Some(horner(self.form.iter().rev(), &ratio));
        }
        let ratio = (*lo > RBig::ZERO).then(|| Ball::between(&(above / hi), &(below / lo)))?;
        Some(horner(self.form.iter(), &ratio))
    }

    /// The sign of N over a range of the parameter, where it is one.
    pub fn sign(&self, range: &[RBig; 2]) -> Option<i8> {
        let [lo, hi] = range.each_ref().map(|t| (t - &self.from) / &self.width);
        self.known.iter().try_fold(self.at([&lo, &hi])?.strict_sign()?, |sign, zero| match range {
            [lo, _] if zero < lo => Some(sign),
            [_, hi] if zero > hi => Some(-sign),
            _ => None,
        })
    }

    /// All zeros inside a range of the parameter, by rising parameter, in ranges of 2⁻ᵇ of their distance from its ends,
    /// or as narrow as the numbers allow, but of 2⁻ᶜ of it; b and c are `narrow`. `None` where they are not told apart, or
    /// one is at an end.
    pub fn zeros(&self, within: [&RBig; 2], narrow: [usize; 2]) -> Option<Vec<[RBig; 2]>> {
        let within = within.map(|t| (t - &self.from) / &self.width);
        let mut open = vec![(bernstein(&self.form)?, [RBig::ZERO, RBig::ONE])];
        open[0].0.first()?.strict_sign()?;
        open[0].0.last()?.strict_sign()?;
        let (mut found, mut splits) = (Vec::new(), 0);
        while let Some((form, [lo, hi])) = open.pop() {
            if hi <= within[0] || within[1] <= lo {
                continue;
            }
            match changes(&form) {
                [_, 0] => {}
                [1, 1] => found.extend(self.narrowed([lo, hi], &within, narrow)?),
                _ if splits == SPLITS => return None,
                _ => {
                    splits += 1;
                    let [below, above] = halves(form);
                    above[0].strict_sign()?;
                    let middle = (&lo + &hi) / RBig::from(2);
                    open.push((above, [middle.clone(), hi]));
                    open.push((below, [lo, middle]));
                }
            }
        }
        Some(found)
    }

    /// The zero between two numbers; none where it is not within the range.
    fn narrowed(&self, [mut lo, mut hi]: [RBig; 2], within: &[RBig; 2], narrow: [usize; 2]) -> Option<Vec<[RBig; 2]>> {
        let sign = |x: &RBig| self.at([x, x])?.strict_sign();
        let above = sign(&hi)?;
        let [finer, fine] = narrow.map(|bits| RBig::from(IBig::ONE << bits));
        loop {
            if hi <= within[0] || within[1] <= lo {
                return Some(Vec::new());
            }
            let (width, room) = (&hi - &lo, (&lo - &within[0]).min(&within[1] - &hi));
            if &width * &finer <= room {
                break;
            }
            // The zero may be in the middle.
            let cut = [4, 3].into_iter().find_map(|part: i32| {
                let place = &lo + &width * RBig::from_parts(part.into(), 8u8.into());
                sign(&place).map(|found| (place, found))
            });
            match cut {
                Some((place, found)) if found == above => hi = place,
                Some((place, _)) => lo = place,
                None if &width * &fine <= room => break,
                None => return None,
            }
        }
        Some(vec![[lo, hi].map(|x| &self.from + &self.width * x)])
    }
}

/// Of the places.
const UNIT: i64 = 1 << 13;

/// Places in (0, 1), times the unit, one more than a degree: as dense as zeros of Chebyshev's polynomials, so that
/// interpolation takes few bits. Those are at sin² of equal angles; 3u² − 2u³ is near sin²(πu/2).
fn places(degree: usize) -> Vec<i64> {
    let all = 2 * i64::try_from(degree).unwrap_or(i64::MAX) + 2;
    (0..all / 2).map(|k| 2 * k + 1).map(|odd| odd * odd * (3 * all - 2 * odd) * UNIT / (all * all * all)).collect()
}

/// The coefficients c_k of Σ c_k xᵏ(1 − x)ⁿ⁻ᵏ with these values, by Lagrange's formula, the factors of
/// which are exact.
fn interpolated<const N: usize>(places: &[i64], values: &[Ball<N>]) -> Option<Vec<Ball<N>>> {
    // Π ((1 − p) x − p (1 − x)).
    let all = places.iter().fold(vec![IBig::ONE], |all, &p| product(&all, &[IBig::from(-p), IBig::from(UNIT - p)]));
    let mut form = vec![Ball::zero(); places.len()];
    for (&p, value) in places.iter().zip(values) {
        let others = places.iter().filter(|&&other| other != p);
        let below = others.fold(IBig::ONE, |product, other| product * IBig::from(p - other));
        let factor = value.over(&Ball::integer(&below))?;
        // The product over all other places, from above.
        let mut carry = IBig::ZERO;
        for (c, all) in form.iter_mut().zip(&all[1..]).rev() {
            carry = (all + carry * IBig::from(p)) / IBig::from(UNIT - p);
            *c = &*c + &(&factor * &Ball::integer(&carry));
        }
    }
    Some(form)
}

/// Σ c_k xᵏ(1 − x)ⁿ⁻ᵏ in the basis of Bernstein.
fn bernstein<const N: usize>(form: &[Ball<N>]) -> Option<Vec<Ball<N>>> {
    let (mut binomial, mut left) = (IBig::ONE, form.len());
    let over = |(k, c): (usize, &Ball<N>)| {
        let found = c.over(&Ball::integer(&binomial));
        left -= 1;
        binomial = &binomial * IBig::from(left) / IBig::from(k + 1);
        found
    };
    form.iter().enumerate().map(over).collect()
}

/// Both halves of a polynomial in the basis of Bernstein, by de Casteljau's scheme.
fn halves<const N: usize>(mut form: Vec<Ball<N>>) -> [Vec<Ball<N>>; 2] {
    let mut below = Vec::with_capacity(form.len());
    for last in (0..form.len()).rev() {
        below.push(form[0].clone());
        for k in 0..last {
            form[k] = (&form[k] + &form[k + 1]).half();
        }
    }
    [below, form]
}

/// Zeros of the polynomial that are not zeros of the determinant: pitchforks, double moments, and the resonance 1:2 at
/// a moment.
fn known_zeros(spaces: &Spaces, branch: Branch, resonance: &Polynomial) -> Vec<RBig> {
    // The pair has its cusp at the pitchfork.
    let is_cusp = |base: usize| {
        let (r, p) = spaces.sums(base);
        &spaces.list[base].a * p + RBig::from(3) * r == RBig::ZERO
    };
    if let Branch::Over(base) = branch {
        let limit = vec![RBig::ZERO; resonance.order_at(&RBig::ZERO)];
        let times = if is_cusp(base) { 3 } else { 1 };
        return [vec![RBig::ONE / spaces.sums(base).1; times], limit].concat();
    }
    let is_axis = is_axis(spaces, branch);
    let mut known = Vec::new();
    for (k, space) in spaces.list.iter().enumerate() {
        let times = match (spaces.active.contains(&k), is_axis) {
            (true, true) => space.axes.len() - 1,
            (true, false) => 2 * (space.axes.len() - 1) + resonance.order_at(&space.a),
            (false, is_axis) => usize::from(!is_axis) + usize::from(is_cusp(k)),
        };
        known.extend(std::iter::repeat_n(space.a.clone(), times));
    }
    known
}

/// The relative equilibria of a branch with Ω = 1, r along the first axis of each space.
pub(super) struct Rotations<'a, const N: usize> {
    spaces: &'a Spaces,
    branch: Branch,
    /// a and q of each space.
    moments: Vec<Ball<N>>,
    squares: Vec<Ball<N>>,
    /// Of the space that the branch lies over: a − a_k for all k, and P̂.
    over: Option<(Vec<Ball<N>>, Ball<N>)>,
}

impl<'a, const N: usize> Rotations<'a, N> {
    pub fn new(spaces: &'a Spaces, branch: Branch) -> Self {
        let all = |of: &dyn Fn(&Space) -> Ball<N>| spaces.list.iter().map(of).collect::<Vec<_>>();
        let over = match branch {
            Branch::Over(base) => {
                let differences = all(&|space| Ball::of(&(&spaces.list[base].a - &space.a)));
                Some((differences, Ball::of(&spaces.sums(base).1)))
            }
            _ => None,
        };
        let (moments, squares) = (all(&|space| Ball::of(&space.a)), all(&|space| Ball::of(&space.q)));
        Self { spaces, branch, moments, squares, over }
    }

    /// That at a range of the parameter.
    pub fn at(&self, t: &Ball<N>) -> Option<Rotation<N>> {
        let tau: Vec<Ball<N>> = match &self.over {
            Some((differences, _)) => differences.clone(),
            None => self.moments.iter().map(|a| t - a).collect(),
        };
        let weight = |k: usize| match (self.branch, &self.over) {
            (Branch::Over(base), Some((_, p_sum))) if k == base => Some(&Ball::whole(1) - &(t * p_sum)),
            (_, Some(_)) => (t * &self.squares[k]).over(&tau[k].square()),
            _ if !self.spaces.active.contains(&k) => Some(Ball::zero()),
            _ => {
                let others = self.spaces.active.iter().filter(|&&j| j != k);
                Some(others.fold(self.squares[k].clone(), |product, &j| &product * &tau[j].square()))
            }
        };
        // By axes: the space, and the weight.
        let mut axes = Vec::new();
        for (k, space) in self.spaces.list.iter().enumerate() {
            for n in 0..space.axes.len() {
                axes.push((k, if n == 0 { weight(k)? } else { Ball::zero() }));
            }
        }
        let total = axes.iter().fold(Ball::zero(), |sum, (_, weight)| &sum + weight);
        let share = total.recip()?;
        let gamma = |n: usize| (&axes[n].1 * &share).root();
        let gamma = [gamma(0)?, gamma(1)?, gamma(2)?];
        let by_axes = |of: &[Ball<N>]| [0, 1, 2].map(|n| of[axes[n].0].clone());
        Some(Rotation { a: by_axes(&self.moments), gamma, tau: by_axes(&tau), weight: total })
    }
}

/// The smallest and the largest number of changes of sign: Descartes' rule counts zeros in (0, 1) by them.
fn changes<const N: usize>(form: &[Ball<N>]) -> [usize; 2] {
    let (mut fewest, mut last) = (0, None);
    // Most changes so far that end with this sign.
    let mut most = [Some(0), Some(0)];
    for (k, c) in form.iter().enumerate() {
        let sign = c.strict_sign();
        fewest += usize::from(last.is_some() && sign.is_some() && sign != last);
        last = sign.or(last);
        let before = most;
        most = [0, 1].map(|end| {
            let turned = before[1 - end].filter(|_| k > 0).map(|count: usize| count + 1);
            before[end].max(turned).filter(|_| sign.is_none_or(|sign| sign == [-1, 1][end]))
        });
    }
    [fewest, most[0].max(most[1]).unwrap_or(0)]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The zeros at 2/20, 6/20, 11/20 and 18/20 of a polynomial of degree 45 without others in (0, 1), from its values.
    #[test]
    fn values_give_the_zeros_inside_a_range() {
        let number = |p: i32, q: u32| RBig::from_parts(p.into(), q.into());
        let zeros = [2, 6, 11, 18].map(|p| number(p, 20));
        let value = |x: &RBig| {
            let far = (5..46).fold(RBig::ONE, |product, k| product * (x + number(k, 3)));
            zeros.iter().fold(far, |product, zero| product * (x - zero))
        };
        let places = places(45);
        let values: Vec<Ball<3>> =
            places.iter().map(|&p| Ball::of(&value(&RBig::from_parts(p.into(), UNIT.unsigned_abs().into())))).collect();
        let form = interpolated(&places, &values).unwrap();
        let determinant = Determinant { from: RBig::ZERO, width: RBig::ONE, known: Vec::new(), form };
        let [lo, hi] = [number(1, 5), number(7, 10)];
        let found = determinant.zeros([&lo, &hi], [60, 60]).unwrap();
        assert_eq!(found.len(), 2);
        for ([low, high], zero) in found.iter().zip(&zeros[1..]) {
            assert!(low <= zero && zero <= high && (high - low) * RBig::from(IBig::ONE << 59) < RBig::ONE);
        }
        let ends = [&RBig::ZERO, &RBig::ONE];
        assert_eq!(determinant.zeros(ends, [60, 60]).unwrap().len(), 4);
        // Not with these numbers.
        assert_eq!(determinant.zeros(ends, [400, 400]), None);
        let sign = |p: i32, q: u32| determinant.sign(&[number(p, q), number(p + 1, q)]);
        assert_eq!(
            [sign(0, 1000), sign(200, 1000), sign(549, 1000), sign(950, 1000)],
            [Some(1), Some(-1), None, Some(1)]
        );
    }

    /// The only zero is in the middle of the range, where no sign is known.
    #[test]
    fn a_zero_in_the_middle_is_found() {
        let places = places(2);
        let values: Vec<Ball<3>> = places
            .iter()
            .map(|&p| Ball::of(&RBig::from_parts((2 * p - UNIT).into(), UNIT.unsigned_abs().into())))
            .collect();
        let form = interpolated(&places, &values).unwrap();
        let determinant = Determinant { from: RBig::ZERO, width: RBig::ONE, known: Vec::new(), form };
        let found = determinant.zeros([&RBig::ZERO, &RBig::ONE], [60, 60]).unwrap();
        let half = RBig::from_parts(1.into(), 2u8.into());
        assert!(matches!(&found[..], [[low, high]] if *low < half && half < *high), "{found:?}");
    }
}
