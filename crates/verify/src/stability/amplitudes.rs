//! The normal form at a relative equilibrium with two imaginary pairs, without canonical coordinates: the amplitudes ζ of both
//! modes are followed in the equations of Euler and Poisson. What they add to the frequencies, and the terms that stay at
//! resonances, are the coefficients of Theorem 13.9 and Proposition 13.11.

use super::expansion::Expansion;
use super::modes::{Modes, Rotation};
use crate::numbers::ball::Ball;

/// H = ω₁I₁ − ω₂I₂ + K₁₁I₁² + K₁₂I₁I₂ + K₂₂I₂² + …, ω₁ > ω₂ > 0.
pub(super) struct NormalForm<const N: usize> {
    /// Of λ⁴ + bλ² + c.
    pub b: Ball<N>,
    pub c: Ball<N>,
    /// K₁₁, K₁₂, K₂₂.
    pub twist: [Ball<N>; 3],
    /// K₁₁ω₂² + K₁₂ω₁ω₂ + K₂₂ω₁².
    pub arnold: Ball<N>,
}

impl<const N: usize> NormalForm<N> {
    /// `None` where the enclosures do not show that the pairs are imaginary and distinct, at index 2, without ω₁ = 2ω₂.
    pub fn new(at: &Rotation<N>) -> Option<Self> {
        let two = Ball::whole(2);
        let (modes, b, c) = Modes::new(at)?;
        let [one, other] = [0, 1].map(|k| modes.rates[k].clone());
        let n = modes.actions()?;
        let mut expansion = Expansion::new(&modes);
        let k11 = expansion.shift(0, [1, 0])?.over(&(&two * &n[0]))?;
        let k22 = (-&expansion.shift(1, [0, 1])?).over(&(&two * &n[1]))?;
        let k12 = expansion.shift(0, [0, 1])?.over(&n[1])?;
        let squares = [one.square(), other.square()];
        let arnold = &(&(&k11 * &squares[1]) + &(&k22 * &squares[0])) + &(&k12 * &(&one * &other));
        Some(Self { b, c, twist: [k11, k12, k22], arnold })
    }

    /// B² of the term that stays at ω₁ = 3ω₂: ζ̇₁ = … + βζ₂³ stems from 2n₁|β| √(I₁/n₁) (I₂/n₂)^{3/2} cos(…).
    pub fn quartic(at: &Rotation<N>) -> Option<Ball<N>> {
        let (modes, ..) = Modes::new(at)?;
        let n = modes.actions()?;
        let beta = modes.share(0, &Expansion::new(&modes).forced([0, 3, 0, 0])?);
        let size = &beta.re.square() + &beta.im.square();
        (&(&Ball::whole(4) * &size) * &n[0]).over(&(&n[1].square() * &n[1]))
    }

    /// D₆ where D₄ = 0: the terms of degree six of the normal form at I₁ = ω₂, I₂ = ω₁. On the energy level of the equilibrium
    /// dI₂/dI₁ is the ratio of the frequencies, ω₁/ω₂ + 3D₆t²/ω₂² + … at I₁ = ω₂t (proof of Proposition 13.11 (d)).
    /// `None` where the enclosures do not exclude all resonances of order up to six.
    pub fn sixth(at: &Rotation<N>) -> Option<Ball<N>> {
        let (modes, ..) = Modes::new(at)?;
        let [one, other] = [0, 1].map(|k| modes.rates[k].clone());
        for [p, q] in RESONANCES {
            (&(&Ball::whole(p) * &one) - &(&Ball::whole(q) * &other)).strict_sign()?;
        }
        let mut expansion = Expansion::new(&modes);
        let [first, second] = [expansion.energy([1, 0])?, expansion.energy([0, 1])?];
        // |ζ₁|² = n₂ω₂t′, |ζ₂|² = n₁ω₁t′ + …, t = n₁n₂t′.
        let along = [-&second, first.clone()];
        let squares = [[2, 0], [1, 1], [0, 2]];
        let products = [along[0].square(), &along[0] * &along[1], along[1].square()];
        let mut quadratic = |of: &mut dyn FnMut(&mut Expansion<N>, [u8; 2]) -> Option<Ball<N>>| {
            let mut sum = Ball::zero();
            for (s, product) in squares.into_iter().zip(&products) {
                sum = &sum + &(&of(&mut expansion, s)? * product);
            }
            Some(sum)
        };
        let bend = (-&quadratic(&mut |expansion, s| expansion.energy(s))?).over(&first)?;
        let twist = quadratic(&mut |expansion, s| {
            Some(&(&expansion.shift(0, s)? * &other) - &(&expansion.shift(1, s)? * &one))
        })?;
        let slope = &(&expansion.shift(0, [1, 0])? * &other) - &(&expansion.shift(1, [1, 0])? * &one);
        let n = modes.actions()?;
        (&twist + &(&slope * &bend)).over(&(&Ball::whole(3) * &(&n[0] * &n[1]).square()))
    }
}

/// p, q of the resonances pω₁ = qω₂ with p + q ≤ 6, except 1:1.
const RESONANCES: [[i32; 2]; 5] = [[1, 2], [1, 3], [1, 4], [1, 5], [2, 3]];

#[cfg(test)]
mod tests {
    use super::*;
    use dashu_ratio::RBig;

    const N: usize = 4;

    /// A = 2, 1.1, 1, r = 0.9, 0.2, 0.6 at μ.
    fn rotation(mu: &RBig) -> Rotation<N> {
        let number = |p: i32, q: u32| RBig::from_parts(p.into(), q.into());
        let set = |x: &RBig| Ball::of(x);
        let a = [number(2, 1), number(11, 10), number(1, 1)];
        let r = [number(9, 10), number(1, 5), number(3, 5)];
        let tau = a.each_ref().map(|a| mu - a);
        let u: [RBig; 3] = std::array::from_fn(|k| &r[k] / &tau[k]);
        let weight = set(&u.iter().fold(RBig::ZERO, |sum, u| sum + u * u));
        let length = weight.root().unwrap();
        let gamma = u.each_ref().map(|u| set(u).over(&length).unwrap());
        Rotation { a: a.each_ref().map(set), gamma, tau: tau.each_ref().map(set), weight }
    }

    /// Where Arnold's determinant is 0: the number of the test `the_sixth_degree_of_a_body` of `bifdiag_equilibria`,
    /// which computes it from brackets of polynomials in canonical coordinates.
    #[test]
    fn the_sixth_degree_of_amplitudes() {
        let [mut lo, mut hi] = [-2227, -2177].map(|n| RBig::from_parts((11_000 + n).into(), 10_000_u32.into()));
        for _ in 0..100 {
            let middle = (&lo + &hi) / RBig::from(2);
            let arnold = NormalForm::new(&rotation(&middle)).unwrap().arnold;
            if arnold.is_positive() { hi = middle } else { lo = middle }
        }
        let found = NormalForm::sixth(&rotation(&lo)).unwrap().to_f64();
        assert!((found - 14.088_934_015_872).abs() < 1e-11, "{found}");
    }
}
