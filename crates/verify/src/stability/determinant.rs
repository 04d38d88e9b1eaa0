//! Arnold's determinant along a stretch, all of it: N = (D₄/s) χ² (β² − 4χ)(4β² − 25χ) p⁹, on an axis (D₄/s) χ (β² −
//! 4χ), is a polynomial of known degree (Theorem 13.13), so its values at equal distances determine where it vanishes.

use dashu_int::IBig;
use dashu_ratio::RBig;

use super::amplitudes::NormalForm;
use super::flow::Flow;
use super::modes::Rotation;
use crate::equilibria::pieces::Branch;
use crate::equilibria::spaces::Spaces;
use crate::numbers::fixed::Fixed;
use crate::numbers::polynomial::Polynomial;

/// Splits at most.
const SPLITS: usize = 400;

/// The polynomial in x, t = from + width x, over the zeros that are known, by rising powers.
pub(super) struct Determinant {
    from: RBig,
    width: RBig,
    known: Vec<RBig>,
    form: Vec<Fixed>,
    bits: usize,
}

/// r on an axis, and rotation about it.
pub(super) fn is_axis(spaces: &Spaces, branch: Branch) -> bool {
    spaces.active.len() == 1 && !matches!(branch, Branch::Over(_))
}

impl Determinant {
    /// From the normal forms inside a range of the parameter, in which there are two imaginary pairs at index 2.
    pub fn new(spaces: &Spaces, branch: Branch, flow: &Flow, [from, to]: [&RBig; 2], bits: usize) -> Option<Self> {
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
        let weights: Vec<RBig> = places.iter().map(|t| squared_length(spaces, branch, t)).collect();
        let most = weights.iter().max()?;
        let values = places.iter().zip(&weights).map(|(t, weight)| {
            let NormalForm { b, c, arnold, .. } =
                NormalForm::new(&rotation(spaces, branch, &Fixed::of(t, bits), bits)?)?;
            let defect = |m: i32, n: i32| &(&Fixed::whole(m) * &b.square()) - &(&Fixed::whole(n) * &c);
            let mut value = &(&arnold * &c) * &defect(1, 4);
            if !is_axis {
                value = &(&value * &c) * &(&defect(4, 25) * &Fixed::of(&(weight / most).pow(9), bits));
            }
            let away = known.iter().fold(RBig::ONE, |product, zero| product * (t - zero) / &width);
            value.over(&Fixed::of(&away, bits))
        });
        let mut differences: Vec<Fixed> = values.collect::<Option<_>>()?;
        for step in 0..degree {
            for k in (step + 1..=degree).rev() {
                differences[k] = &differences[k] - &differences[k - 1];
            }
        }
        // Newton's form in (degree + 1)x − ½, the number of the place.
        let mut form: Vec<Fixed> = Vec::new();
        let slope = Fixed::of(&number(degree + 1), 0);
        for (k, difference) in differences.iter().enumerate().rev() {
            let shift = &Fixed::of(&number(k), 0) + &Fixed::whole(1).half();
            let count = Fixed::of(&number(k + 1), 0);
            let mut next = vec![difference.clone()];
            next.resize(form.len() + 1, Fixed::whole(0));
            for (power, coefficient) in form.iter().enumerate() {
                let coefficient = coefficient.over(&count)?;
                next[power] = &next[power] - &(&coefficient * &shift);
                next[power + 1] = &next[power + 1] + &(&coefficient * &slope);
            }
            form = next;
        }
        Some(Self { from: from.clone(), width, known, form, bits })
    }

    fn at(&self, x: &Fixed) -> Fixed {
        self.form.iter().rev().fold(Fixed::whole(0), |sum, c| &(&sum * x) + c)
    }

    /// The sign of N over a range of the parameter, where it is one.
    pub fn sign(&self, range: &[RBig; 2]) -> Option<i8> {
        let [lo, hi] = range.each_ref().map(|t| Fixed::of(&((t - &self.from) / &self.width), self.bits));
        self.known.iter().try_fold(self.at(&lo.hull(&hi)).strict_sign()?, |sign, zero| match range {
            [lo, _] if zero < lo => Some(sign),
            [_, hi] if zero > hi => Some(-sign),
            _ => None,
        })
    }

    /// All zeros inside, by rising parameter, in ranges of 2⁻ᵇ of their distance from the ends, or as narrow as the numbers
    /// allow; `None` where they are not told apart, or one is at an end.
    pub fn zeros(&self, narrow: usize) -> Option<Vec<[RBig; 2]>> {
        self.form.first()?.strict_sign()?;
        self.at(&Fixed::whole(1)).strict_sign()?;
        let mut open = vec![(self.form.clone(), [RBig::ZERO, RBig::ONE])];
        let (mut found, mut splits) = (Vec::new(), 0);
        while let Some((form, [lo, hi])) = open.pop() {
            match changes(&form) {
                [_, 0] => {}
                [1, 1] => found.push(self.narrowed([lo, hi], narrow)?),
                _ if splits == SPLITS => return None,
                _ => {
                    splits += 1;
                    let degree = form.len() - 1;
                    let power = |k: usize| Fixed::of(&RBig::from(IBig::ONE << k), 0);
                    let below: Vec<Fixed> = (0..=degree).map(|k| &form[k] * &power(degree - k)).collect();
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
        let sign = |x: &RBig| self.at(&Fixed::of(x, self.bits)).strict_sign();
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

/// p at a place; 1 over a space without r.
fn squared_length(spaces: &Spaces, branch: Branch, t: &RBig) -> RBig {
    let part = |k: usize| {
        let others = spaces.active.iter().filter(|&&j| j != k);
        others.fold(spaces.list[k].q.clone(), |product, &j| {
            let d = t - &spaces.list[j].a;
            product * &d * d
        })
    };
    if matches!(branch, Branch::Over(_)) {
        return RBig::ONE;
    }
    spaces.active.iter().fold(RBig::ZERO, |sum, &k| sum + part(k))
}

/// The relative equilibrium over a range of the parameter, with Ω = 1, r along the first axis of each space.
pub(super) fn rotation(spaces: &Spaces, branch: Branch, t: &Fixed, bits: usize) -> Option<Rotation> {
    let set = |x: &RBig| Fixed::of(x, bits);
    let mut axes = Vec::new();
    let tau = |k: usize| match branch {
        Branch::Over(base) => set(&(&spaces.list[base].a - &spaces.list[k].a)),
        _ => t - &set(&spaces.list[k].a),
    };
    let weight = |k: usize| {
        let space = &spaces.list[k];
        match branch {
            Branch::Over(base) if k == base => Some(&Fixed::whole(1) - &(t * &set(&spaces.sums(base).1))),
            Branch::Over(_) => (t * &set(&space.q)).over(&tau(k).square()),
            _ if !spaces.active.contains(&k) => Some(Fixed::whole(0)),
            _ => {
                let others = spaces.active.iter().filter(|&&j| j != k);
                Some(others.fold(set(&space.q), |product, &j| &product * &tau(j).square()))
            }
        }
    };
    for (k, space) in spaces.list.iter().enumerate() {
        for n in 0..space.axes.len() {
            axes.push((set(&space.a), if n == 0 { weight(k)? } else { Fixed::whole(0) }, tau(k)));
        }
    }
    let total = axes.iter().fold(Fixed::whole(0), |sum, (_, weight, _)| &sum + weight);
    let gamma = |k: usize| axes[k].1.over(&total)?.root();
    let gamma = [gamma(0)?, gamma(1)?, gamma(2)?];
    Some(Rotation { a: [0, 1, 2].map(|k| axes[k].0.clone()), gamma, tau: [0, 1, 2].map(|k| axes[k].2.clone()) })
}

/// p(x + 1).
fn shifted(mut form: Vec<Fixed>) -> Vec<Fixed> {
    for from in 0..form.len() {
        for k in (from..form.len() - 1).rev() {
            form[k] = &form[k] + &form[k + 1];
        }
    }
    form
}

/// The smallest and the largest number of changes of sign that Descartes' rule counts in (0, 1).
fn changes(form: &[Fixed]) -> [usize; 2] {
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
