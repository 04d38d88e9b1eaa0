//! Motion near a relative equilibrium by the amplitudes ζ of its modes: the equations of Euler and Poisson, which are quadratic,
//! are solved by x = Σ x_a ζᵃ with ζ̇_j = i(ω_j + σ_j)ζ_j, where σ_j is a series in |ζ₁|², |ζ₂|². Order by order
//!
//! (i⟨ω, a⟩ − L) x_a = Σ ½Q(x_b, x_{a−b}) − Σ i⟨σ_s, a⟩ x_{a−s},
//!
//! and no x_a beyond the first order has a share in the mode of its own frequency.

use std::collections::BTreeMap;

use super::modes::{Complex, Modes, Vector, combined, mapped, nothing, plus, real_combined};
use crate::numbers::ball::Ball;

/// The powers of ζ₁, ζ₂ and of their conjugates.
pub(super) type Powers = [u8; 4];

/// The coefficients, each made when it is needed.
pub(super) struct Expansion<'a, const N: usize> {
    modes: &'a Modes<'a, N>,
    known: BTreeMap<Powers, Vector<N>>,
    shifts: BTreeMap<(usize, [u8; 2]), Ball<N>>,
    /// 1/⟨ω, w⟩ by w.
    inverses: BTreeMap<[i32; 2], Ball<N>>,
}

/// How often each phase is in a monomial.
fn windings([a, b, c, d]: Powers) -> [i32; 2] {
    [i32::from(a) - i32::from(c), i32::from(b) - i32::from(d)]
}

fn order(powers: Powers) -> u8 {
    powers.iter().sum()
}

/// Both factors of a monomial, in all ways, each once.
fn splits(powers: Powers) -> Vec<[Powers; 2]> {
    let [a, b, c, d] = powers;
    let all =
        (0..=a).flat_map(|i| (0..=b).flat_map(move |j| (0..=c).flat_map(move |k| (0..=d).map(move |m| [i, j, k, m]))));
    let other = |first: Powers| -> Powers { std::array::from_fn(|k| powers[k] - first[k]) };
    all.map(|first| [first, other(first)])
        .filter(|[first, second]| order(*first) > 0 && order(*second) > 0 && first <= second)
        .collect()
}

impl<'a, const N: usize> Expansion<'a, N> {
    pub fn new(modes: &'a Modes<'a, N>) -> Self {
        let unit = |n: usize| std::array::from_fn(|k| u8::from(k == n));
        let known = (0..4).map(|n| (unit(n), modes.vectors[n].clone())).collect();
        Self { modes, known, shifts: BTreeMap::new(), inverses: BTreeMap::new() }
    }

    /// The coefficient of |ζ₁|^2s₁ |ζ₂|^2s₂ in σ of a mode.
    pub fn shift(&mut self, mode: usize, s: [u8; 2]) -> Option<Ball<N>> {
        if let Some(shift) = self.shifts.get(&(mode, s)) {
            return Some(shift.clone());
        }
        let mut powers = [s[0], s[1], s[0], s[1]];
        powers[mode] += 1;
        let forced = self.forced(powers)?;
        let shift = self.modes.share(mode, &forced).im;
        self.shifts.insert((mode, s), shift.clone());
        Some(shift)
    }

    /// The coefficient of a monomial of at least second order; `None` at a resonance.
    pub fn coefficient(&mut self, powers: Powers) -> Option<Vector<N>> {
        if let Some(known) = self.known.get(&powers) {
            return Some(known.clone());
        }
        let [a, b, c, d] = powers;
        if let Some(conjugate) = self.known.get(&[c, d, a, b]) {
            return Some(mapped(conjugate, Complex::conjugate));
        }
        let forced = self.forced(powers)?;
        let found = match windings(powers) {
            [0, 0] => {
                // Its own conjugate; so are the modes in pairs.
                let share = |n: usize, inverse: Ball<N>| self.modes.share(n, &forced).turned(&-&inverse);
                let [one, other] = [self.inverse([1, 0])?, self.inverse([0, 1])?];
                let terms = [(share(0, one), &self.modes.vectors[0]), (share(1, other), &self.modes.vectors[1])];
                combined(&real_combined(&nothing(), &terms), &self.at_rest(powers)?)
            }
            [p, q] => {
                // What has no share in a mode grows by 1/(iω), the others by 1/(i(ω − ω_n)).
                let plain = self.inverse([p, q])?;
                let mut over = |of: [i32; 2]| match of {
                    [0, 0] => Some(-&plain),
                    of => Some(&self.inverse(of)? - &plain),
                };
                let over = [[over([p - 1, q])?, over([p + 1, q])?], [over([p, q - 1])?, over([p, q + 1])?]];
                let factors = [0, 1].map(|n| {
                    let [one, other] = self.modes.both_shares(n, &forced);
                    [one.turned(&over[n][0]), other.turned(&over[n][1])]
                });
                self.modes.with_modes(&mapped(&forced, |x| x.turned(&plain)), &factors)
            }
        };
        self.known.insert(powers, found.clone());
        Some(found)
    }

    /// 1/⟨ω, w⟩; `None` at a resonance.
    fn inverse(&mut self, [p, q]: [i32; 2]) -> Option<Ball<N>> {
        if [p, q] < [0, 0] {
            return Some(-&self.inverse([-p, -q])?);
        }
        if let Some(known) = self.inverses.get(&[p, q]) {
            return Some(known.clone());
        }
        let rates = &self.modes.rates;
        let inverse = (&(&Ball::whole(p) * &rates[0]) + &(&Ball::whole(q) * &rates[1])).recip()?;
        self.inverses.insert([p, q], inverse.clone());
        Some(inverse)
    }

    /// What drives a coefficient: products of others, and slower phases of those before it. At a monomial whose frequency is a
    /// mode's, without the last shift.
    pub fn forced(&mut self, powers: Powers) -> Option<Vector<N>> {
        let mut sum = nothing();
        for [first, second] in splits(powers) {
            let one = self.coefficient(first)?;
            let product = if first == second {
                self.modes.square(&one)
            } else {
                self.modes.quadratic(&one, &self.coefficient(second)?)
            };
            sum = plus(&sum, &product);
        }
        for s in slower(powers) {
            let mut before = powers;
            (0..4).for_each(|k| before[k] -= s[k % 2]);
            let mut rate = Ball::zero();
            for (mode, winding) in windings(powers).into_iter().enumerate().filter(|(_, winding)| *winding != 0) {
                rate = &rate + &(&Ball::whole(winding) * &self.shift(mode, s)?);
            }
            let earlier = self.coefficient(before)?;
            sum = plus(&sum, &mapped(&earlier, |x| x.turned(&rate)));
        }
        Some(sum)
    }

    /// What |γ| and ⟨γ, 𝐥⟩ demand at a monomial in |ζ₁|², |ζ₂|² to keep their values.
    fn at_rest(&mut self, powers: Powers) -> Option<Vec<(Complex<N>, &'a Vector<N>)>> {
        let (mut length, mut moment) = (Ball::zero(), Ball::zero());
        for [first, second] in splits(powers) {
            let [[p, g], [q, h]] = [self.coefficient(first)?, self.coefficient(second)?];
            let of = |f: &dyn Fn(usize) -> Ball<N>| (0..3).fold(Ball::zero(), |sum, k| &sum - &f(k));
            let longer = of(&|k| g[k].real_product(&h[k]));
            let more = of(&|k| &(&g[k].real_product(&q[k]) + &h[k].real_product(&p[k])) * &self.modes.at.a[k]);
            // A split and its conjugate are both in the list, or it is its own.
            let [longer, more] = [longer, more].map(|x| if first == second { x.half() } else { x });
            (length, moment) = (&length + &longer, &moment + &more);
        }
        let moment = &moment * &self.modes.inverse_j;
        let [longer, faster] = &self.modes.beside;
        Some(vec![(Complex::real(&moment - &length), faster), (Complex::real(length), longer)])
    }

    /// The coefficient of |ζ₁|^2s₁ |ζ₂|^2s₂ in the energy ½⟨ω, 𝐥⟩ − ⟨γ, r⟩.
    pub fn energy(&mut self, s: [u8; 2]) -> Option<Ball<N>> {
        let powers = [s[0], s[1], s[0], s[1]];
        let at = self.modes.at;
        let mut sum = Ball::zero();
        let [omega, gamma] = self.coefficient(powers)?;
        for k in 0..3 {
            let turning = &(&at.a[k] * &at.gamma[k]) * &omega[k].re;
            sum = &sum + &(&turning - &(&(&at.tau[k] * &at.gamma[k]) * &gamma[k].re));
        }
        for [first, second] in splits(powers) {
            let [[p, _], [q, _]] = [self.coefficient(first)?, self.coefficient(second)?];
            let product = (0..3).fold(Ball::zero(), |sum, k| &sum + &(&at.a[k] * &p[k].real_product(&q[k])));
            sum = &sum + &(if first == second { product.half() } else { product });
        }
        Some(sum)
    }
}

/// Powers of |ζ₁|², |ζ₂|² that slow the phases of the rest of a monomial, which does not belong to a mode.
fn slower(powers: Powers) -> Vec<[u8; 2]> {
    let most = [0, 1].map(|j| powers[j].min(powers[j + 2]));
    let all = (0..=most[0]).flat_map(|i| (0..=most[1]).map(move |j| [i, j]));
    let left = |s: &[u8; 2]| order(powers) - 2 * (s[0] + s[1]);
    all.filter(|s| *s != [0, 0] && left(s) > 1).collect()
}
