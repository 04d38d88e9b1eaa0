//! Arnold's determinant along a stretch, all of it: N = (D₄/s) χ² (β² − 4χ)(4β² − 25χ) p⁹, on an axis (D₄/s) χ (β² −
//! 4χ), is a polynomial of known degree (Theorem 13.13), so its values at equal distances determine where it vanishes.

use dashu_int::IBig;
use dashu_ratio::RBig;

use super::amplitudes::NormalForm;
use super::flow::Flow;
use super::modes::Rotation;
use crate::equilibria::pieces::Branch;
use crate::equilibria::spaces::Spaces;
use crate::numbers::ball::Ball;
use crate::numbers::polynomial::Polynomial;

/// Splits at most.
const SPLITS: usize = 400;

/// The polynomial in x, t = from + width x, over the zeros that are known, by rising powers.
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
    /// From the normal forms inside a range of the parameter, in which there are two imaginary pairs at index 2.
    pub fn new(spaces: &Spaces, branch: Branch, flow: &Flow, [from, to]: [&RBig; 2]) -> Option<Self> {
        let (is_axis, width) = (is_axis(spaces, branch), to - from);
        let known = known_zeros(spaces, branch, &flow.resonances()[0]);
        let degree = match branch {
            Branch::Over(_) => 9,
            _ if is_axis => 5,
            _ => 9 * (2 * spaces.active.len() - 1),
        } - known.len();
        let number = |n: usize| RBig::from(IBig::from(n));
        let places: Vec<RBig> =
            (0..=degree).map(|k| from + &width * number(2 * k + 1) / number(2 * degree + 2)).collect();
        let values = places.iter().map(|t| {
            let at = rotation(spaces, branch, &Ball::of(t))?;
            let NormalForm { b, c, arnold, .. } = NormalForm::new(&at)?;
            let defect = |m: i32, n: i32| &(&Ball::whole(m) * &b.square()) - &(&Ball::whole(n) * &c);
            let mut value = &(&arnold * &c) * &defect(1, 4);
            if !is_axis {
                let cube = &at.weight.square() * &at.weight;
                value = &(&value * &c) * &(&defect(4, 25) * &(&cube.square() * &cube));
            }
            let away = known.iter().fold(RBig::ONE, |product, zero| product * (t - zero) / &width);
            value.over(&Ball::of(&away))
        });
        let mut differences: Vec<Ball<N>> = values.collect::<Option<_>>()?;
        for step in 0..degree {
            for k in (step + 1..=degree).rev() {
                differences[k] = &differences[k] - &differences[k - 1];
            }
        }
        // Newton's form in (degree + 1)x − ½, the number of the place.
        let mut form: Vec<Ball<N>> = Vec::new();
        let slope = Ball::of(&number(degree + 1));
        for (k, difference) in differences.iter().enumerate().rev() {
            let [shift, over] = [number(2 * k + 1) / number(2), RBig::ONE / number(k + 1)].map(|x| Ball::of(&x));
            let mut next = vec![difference.clone()];
            next.resize(form.len() + 1, Ball::zero());
            for (power, coefficient) in form.iter().enumerate() {
                let coefficient = coefficient * &over;
                next[power] = &next[power] - &(&coefficient * &shift);
                next[power + 1] = &next[power + 1] + &(&coefficient * &slope);
            }
            form = next;
        }
        Some(Self { from: from.clone(), width, known, form })
    }

    fn at(&self, x: &Ball<N>) -> Ball<N> {
        self.form.iter().rev().fold(Ball::zero(), |sum, c| &(&sum * x) + c)
    }

    /// The sign of N over a range of the parameter, where it is one.
    pub fn sign(&self, range: &[RBig; 2]) -> Option<i8> {
        let [lo, hi] = range.each_ref().map(|t| (t - &self.from) / &self.width);
        self.known.iter().try_fold(self.at(&Ball::between(&lo, &hi)).strict_sign()?, |sign, zero| match range {
            [lo, _] if zero < lo => Some(sign),
            [_, hi] if zero > hi => Some(-sign),
            _ => None,
        })
    }

    /// All zeros inside, by rising parameter, in ranges of 2⁻ᵇ of their distance from the ends, or as narrow as the numbers
    /// allow; `None` where they are not told apart, or one is at an end.
    pub fn zeros(&self, narrow: usize) -> Option<Vec<[RBig; 2]>> {
        self.form.first()?.strict_sign()?;
        self.at(&Ball::whole(1)).strict_sign()?;
        let mut open = vec![(self.form.clone(), [RBig::ZERO, RBig::ONE])];
        let (mut found, mut splits) = (Vec::new(), 0);
        while let Some((form, [lo, hi])) = open.pop() {
            match changes(&form) {
                [_, 0] => {}
                [1, 1] => found.push(self.narrowed([lo, hi], narrow)?),
                _ if splits == SPLITS => return None,
                _ => {
                    splits += 1;
                    let below: Vec<Ball<N>> = form.iter().zip(0..).map(|(c, k)| c.times_two_to(-k)).collect();
                    let above = shifted(below.clone());
                    above[0].strict_sign()?;
                    let middle = (&lo + &hi) / RBig::from(2);
                    open.push((above, [middle.clone(), hi]));
                    open.push((below, [lo, middle]));
                }
            }
        }
        Some(found)
    }

    fn narrowed(&self, [mut lo, mut hi]: [RBig; 2], bits: usize) -> Option<[RBig; 2]> {
        let sign = |x: &RBig| self.at(&Ball::of(x)).strict_sign();
        let (above, finer) = (sign(&hi)?, RBig::from(IBig::ONE << bits));
        while (&hi - &lo) * &finer > (&lo).min(&(RBig::ONE - &hi)).clone() {
            let middle = (&lo + &hi) / RBig::from(2);
            match sign(&middle) {
                Some(found) if found == above => hi = middle,
                Some(_) => lo = middle,
                None => break,
            }
        }
        Some([lo, hi].map(|x| &self.from + &self.width * x))
    }
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

/// The relative equilibrium over a range of the parameter, with Ω = 1, r along the first axis of each space.
pub(super) fn rotation<const N: usize>(spaces: &Spaces, branch: Branch, t: &Ball<N>) -> Option<Rotation<N>> {
    let set = |x: &RBig| Ball::of(x);
    let mut axes = Vec::new();
    let tau = |k: usize| match branch {
        Branch::Over(base) => set(&(&spaces.list[base].a - &spaces.list[k].a)),
        _ => t - &set(&spaces.list[k].a),
    };
    let weight = |k: usize| {
        let space = &spaces.list[k];
        match branch {
            Branch::Over(base) if k == base => Some(&Ball::whole(1) - &(t * &set(&spaces.sums(base).1))),
            Branch::Over(_) => (t * &set(&space.q)).over(&tau(k).square()),
            _ if !spaces.active.contains(&k) => Some(Ball::zero()),
            _ => {
                let others = spaces.active.iter().filter(|&&j| j != k);
                Some(others.fold(set(&space.q), |product, &j| &product * &tau(j).square()))
            }
        }
    };
    for (k, space) in spaces.list.iter().enumerate() {
        for n in 0..space.axes.len() {
            axes.push((set(&space.a), if n == 0 { weight(k)? } else { Ball::zero() }, tau(k)));
        }
    }
    let total = axes.iter().fold(Ball::zero(), |sum, (_, weight, _)| &sum + weight);
    let gamma = |k: usize| axes[k].1.over(&total)?.root();
    let gamma = [gamma(0)?, gamma(1)?, gamma(2)?];
    let [a, tau] = [[0, 1, 2].map(|k| axes[k].0.clone()), [0, 1, 2].map(|k| axes[k].2.clone())];
    Some(Rotation { a, gamma, tau, weight: total })
}

/// p(x + 1).
fn shifted<const N: usize>(mut form: Vec<Ball<N>>) -> Vec<Ball<N>> {
    for from in 0..form.len() {
        for k in (from..form.len() - 1).rev() {
            form[k] = &form[k] + &form[k + 1];
        }
    }
    form
}

/// The smallest and the largest number of changes of sign that Descartes' rule counts in (0, 1).
fn changes<const N: usize>(form: &[Ball<N>]) -> [usize; 2] {
    let reversed = shifted(form.iter().rev().cloned().collect());
    let (mut fewest, mut last) = (0, None);
    // Most changes so far that end with this sign.
    let mut most = [Some(0), Some(0)];
    for (k, c) in reversed.iter().enumerate() {
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
