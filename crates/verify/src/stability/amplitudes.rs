//! The normal form at a relative equilibrium with two imaginary pairs, without canonical coordinates: the amplitudes ζ of both
//! modes are followed to third order in the equations of Euler and Poisson, which are quadratic. What they add to the
//! frequencies, and the terms that stay at resonances, are the coefficients of Theorem 13.9 and Proposition 13.11.

use std::ops::{Add, Mul, Sub};

use crate::numbers::fixed::Fixed;

/// A relative equilibrium with Ω = 1, on the three axes.
pub(super) struct Rotation {
    pub a: [Fixed; 3],
    pub gamma: [Fixed; 3],
    /// μ − a.
    pub tau: [Fixed; 3],
}

/// H = ω₁I₁ − ω₂I₂ + K₁₁I₁² + K₁₂I₁I₂ + K₂₂I₂² + …, ω₁ > ω₂ > 0.
pub(super) struct NormalForm {
    /// Of λ⁴ + bλ² + c.
    pub b: Fixed,
    pub c: Fixed,
    /// K₁₁, K₁₂, K₂₂.
    pub twist: [Fixed; 3],
    /// K₁₁ω₂² + K₁₂ω₁ω₂ + K₂₂ω₁².
    pub arnold: Fixed,
}

#[derive(Clone)]
struct Complex {
    re: Fixed,
    im: Fixed,
}

impl Complex {
    fn real(re: Fixed) -> Self {
        Self { re, im: Fixed::whole(0) }
    }

    fn times(&self, x: &Fixed) -> Self {
        Self { re: &self.re * x, im: &self.im * x }
    }

    /// −ix self.
    fn turned(&self, x: &Fixed) -> Self {
        Self { re: &self.im * x, im: -&(&self.re * x) }
    }

    fn over(&self, x: &Fixed) -> Option<Self> {
        Some(Self { re: self.re.over(x)?, im: self.im.over(x)? })
    }

    fn conjugate(&self) -> Self {
        Self { re: self.re.clone(), im: -&self.im }
    }
}

impl Add for &Complex {
    type Output = Complex;
    fn add(self, other: Self) -> Complex {
        Complex { re: &self.re + &other.re, im: &self.im + &other.im }
    }
}

impl Sub for &Complex {
    type Output = Complex;
    fn sub(self, other: Self) -> Complex {
        Complex { re: &self.re - &other.re, im: &self.im - &other.im }
    }
}

impl Mul for &Complex {
    type Output = Complex;
    fn mul(self, other: Self) -> Complex {
        let (re, im) = (&self.re * &other.re, &self.im * &other.im);
        Complex { re: &re - &im, im: &(&self.re * &other.im) + &(&self.im * &other.re) }
    }
}

/// A deviation of ω and of γ.
type Vector = [[Complex; 3]; 2];

fn zero() -> Complex {
    Complex::real(Fixed::whole(0))
}

fn sum(terms: impl IntoIterator<Item = Fixed>) -> Fixed {
    terms.into_iter().fold(Fixed::whole(0), |sum, x| &sum + &x)
}

fn dot(x: &[Fixed; 3], y: &[Fixed; 3]) -> Fixed {
    sum((0..3).map(|k| &x[k] * &y[k]))
}

fn real_cross(x: &[Fixed; 3], y: &[Fixed; 3]) -> [Fixed; 3] {
    [(1, 2), (2, 0), (0, 1)].map(|(j, k)| &(&x[j] * &y[k]) - &(&x[k] * &y[j]))
}

fn cross(x: &[Complex; 3], y: &[Complex; 3]) -> [Complex; 3] {
    [(1, 2), (2, 0), (0, 1)].map(|(j, k)| &(&x[j] * &y[k]) - &(&x[k] * &y[j]))
}

/// A vector and multiples of others.
fn combined(first: &Vector, terms: &[(Complex, &Vector)]) -> Vector {
    let part =
        |n: usize, k: usize| terms.iter().fold(first[n][k].clone(), |sum, (factor, v)| &sum + &(factor * &v[n][k]));
    [0, 1].map(|n| [0, 1, 2].map(|k| part(n, k)))
}

fn mapped(v: &Vector, of: impl Fn(&Complex) -> Complex) -> Vector {
    v.each_ref().map(|part| part.each_ref().map(&of))
}

/// The flow in the six variables.
struct Flow<'a> {
    at: &'a Rotation,
    j: Fixed,
    /// (a_i − a_j)/a_k for cyclic i, j, k, by k.
    torques: [Fixed; 3],
    /// ω₁, ω₂, −ω₁, −ω₂.
    rates: [Fixed; 4],
    /// Of iω₁, iω₂, −iω₁, −iω₂.
    modes: [Vector; 4],
    /// Forms that give the shares of the modes in a vector.
    shares: [Vector; 4],
    /// Twice the energies of modes with amplitude 1.
    energies: [Fixed; 2],
    /// The equilibria beside this one that are longer, and that turn faster.
    beside: [Vector; 2],
}

impl NormalForm {
    /// `None` where the enclosures do not tell that the pairs are imaginary and distinct, at index 2, without ω₁ = 2ω₂.
    pub fn new(at: &Rotation) -> Option<Self> {
        let two = Fixed::whole(2);
        let (flow, b, c) = Flow::new(at)?;
        let [one, other] = [0, 1].map(|k| flow.rates[k].clone());
        let n = flow.actions()?;
        let double = [flow.second(0, 0)?, flow.second(1, 1)?];
        let steady = [flow.second(0, 2)?, flow.second(1, 3)?];
        let k11 = flow.shift(0, &[(0, &steady[0]), (2, &double[0])]).over(&(&two * &n[0]))?;
        let k22 = (-&flow.shift(1, &[(1, &steady[1]), (3, &double[1])])).over(&(&two * &n[1]))?;
        let mixed = [(0, &steady[1]), (1, &flow.second(0, 3)?), (3, &flow.second(0, 1)?)];
        let k12 = flow.shift(0, &mixed).over(&n[1])?;
        let squares = [one.square(), other.square()];
        let arnold = &(&(&k11 * &squares[1]) + &(&k22 * &squares[0])) + &(&k12 * &(&one * &other));
        Some(Self { b, c, twist: [k11, k12, k22], arnold })
    }

    /// B² of the term that stays at ω₁ = 3ω₂: ζ̇₁ = … + βζ₂³ stems from 2n₁|β| √(I₁/n₁) (I₂/n₂)^{3/2} cos(…).
    pub fn quartic(at: &Rotation) -> Option<Fixed> {
        let (flow, ..) = Flow::new(at)?;
        let n = flow.actions()?;
        let beta = flow.share(0, &flow.quadratic(&flow.modes[1], &flow.second(1, 1)?));
        let size = &beta.re.square() + &beta.im.square();
        (&(&Fixed::whole(4) * &size) * &n[0]).over(&(&n[1].square() * &n[1]))
    }
}

impl<'a> Flow<'a> {
    fn new(at: &'a Rotation) -> Option<(Self, Fixed, Fixed)> {
        let Rotation { a, gamma, tau } = at;
        let momentum = [0, 1, 2].map(|k| &a[k] * &gamma[k]);
        let j = dot(gamma, &momentum);
        // A basis across γ.
        let nearest = (0..3).min_by(|&i, &k| gamma[i].square().to_f64().total_cmp(&gamma[k].square().to_f64()))?;
        let unit = [0, 1, 2].map(|k| Fixed::whole(i32::from(k == nearest)));
        let e = real_cross(gamma, &unit);
        let length = dot(&e, &e).root()?;
        let [e0, e1, e2] = e.each_ref().map(|x| x.over(&length));
        let e = [e0?, e1?, e2?];
        let basis = [e.clone(), real_cross(gamma, &e)];
        // Theorem 13.1.
        let scale = (&(&a[0] * &a[1]) * &a[2]).over(&j)?;
        let four = Fixed::whole(4).over(&j)?;
        let bend = [0, 1, 2].map(|k| &momentum[k] - &(&j * &gamma[k]));
        let bends = [0, 1].map(|n| dot(&bend, &basis[n]));
        let [i0, i1, i2] = a.each_ref().map(|a| Fixed::whole(1).over(a));
        let inverse = [i0?, i1?, i2?];
        let form =
            |weight: &[Fixed; 3], p: usize, q: usize| sum((0..3).map(|k| &weight[k] * &(&basis[p][k] * &basis[q][k])));
        let places = [(0, 0), (0, 1), (1, 1)];
        let mass = places.map(|(p, q)| &scale * &form(&inverse, p, q));
        let hessian = places.map(|(p, q)| &form(tau, p, q) + &(&four * &(&bends[p] * &bends[q])));
        let twice = (&Fixed::whole(2) * &dot(&momentum, &momentum)).over(&j)?;
        let gyro = &sum(a.iter().cloned()) - &twice;
        let crossed = &Fixed::whole(2) * &(&mass[1] * &hessian[1]);
        let cofactor = &(&(&mass[0] * &hessian[2]) + &(&mass[2] * &hessian[0])) - &crossed;
        let b = (&gyro.square() + &cofactor).over(&scale)?;
        let c = (&(&hessian[0] * &hessian[2]) - &hessian[1].square()).over(&scale)?;
        let discriminant = &b.square() - &(&Fixed::whole(4) * &c);
        if ![&b, &c, &discriminant].into_iter().all(Fixed::is_positive) {
            return None;
        }
        let square = (&b + &discriminant.root()?).half();
        let omega = [square.root()?, c.over(&square)?.root()?];
        let mut flow = Self {
            at,
            rates: [omega[0].clone(), omega[1].clone(), -&omega[0], -&omega[1]],
            modes: [(); 4].map(|()| nothing()),
            shares: [(); 4].map(|()| nothing()),
            energies: [Fixed::whole(0), Fixed::whole(0)],
            beside: [(); 2].map(|()| nothing()),
            j,
            torques: [(1, 2, 0), (2, 0, 1), (0, 1, 2)].map(|(i, j, k)| &(&a[i] - &a[j]) * &inverse[k]),
        };
        let mu = &tau[0] + &a[0];
        for n in 0..2 {
            // (−ω²M + iωΓ + K)g = 0, by its first or its second row.
            let inertia = |k: usize| &hessian[k] - &(&omega[n].square() * &mass[k]);
            let (off, turn) = (inertia(1), &omega[n] * &gyro);
            let rows = [
                [Complex { re: -&off, im: turn.clone() }, Complex::real(inertia(0))],
                [Complex::real(inertia(2)), Complex { re: -&off, im: -&turn }],
            ];
            let candidates = rows.map(|[x, y]| {
                let g = [0, 1, 2].map(|k| &x.times(&basis[0][k]) + &y.times(&basis[1][k]));
                let mode = flow.mode(&omega[n], &momentum, g)?;
                let conjugate = mapped(&mode, Complex::conjugate);
                let form = energy_with(&conjugate, a, &mu);
                let energy = shared(&form, &mode).re;
                energy.strict_sign().map(|_| (mode, conjugate, form, energy))
            });
            let size = |energy: &Fixed| energy.to_f64().abs();
            let best = candidates.into_iter().flatten().max_by(|p, q| size(&p.3).total_cmp(&size(&q.3)));
            let (mode, conjugate, form, energy) = best?;
            let over = Fixed::whole(1).over(&energy)?;
            flow.shares[n] = mapped(&form, |x| x.times(&over));
            flow.shares[n + 2] = mapped(&flow.shares[n], Complex::conjugate);
            (flow.modes[n], flow.modes[n + 2], flow.energies[n]) = (mode, conjugate, energy);
        }
        let still = || [zero(), zero(), zero()];
        let gamma = || gamma.each_ref().map(|x| Complex::real(x.clone()));
        flow.beside = [[still(), gamma()], [gamma(), still()]].map(|v| flow.rest(&v));
        let signs = [0, 1].map(|n| flow.energies[n].sign());
        (signs == [Some(1), Some(-1)]).then_some((flow, b, c))
    }

    /// n of both modes: I = n|ζ|².
    fn actions(&self) -> Option<[Fixed; 2]> {
        Some([self.energies[0].over(&self.rates[0])?, (-&self.energies[1]).over(&self.rates[1])?])
    }

    /// The mode of iω with this part of γ.
    fn mode(&self, omega: &Fixed, momentum: &[Fixed; 3], g: [Complex; 3]) -> Option<Vector> {
        let gamma = self.at.gamma.each_ref().map(|x| Complex::real(x.clone()));
        let turned = cross(&gamma, &g).map(|x| Complex { re: -&(&x.im * omega), im: &x.re * omega });
        let along = (0..3).fold(zero(), |sum, k| {
            let twice = &g[k] + &g[k];
            &sum + &(&turned[k] - &twice).times(&momentum[k])
        });
        let along = along.over(&self.j)?;
        let omega = [0, 1, 2].map(|k| &(&g[k] - &turned[k]) + &along.times(&self.at.gamma[k]));
        Some([omega, g])
    }

    /// The share of a mode in a vector.
    fn share(&self, mode: usize, of: &Vector) -> Complex {
        shared(&self.shares[mode], of)
    }

    /// What no mode has a share in: the directions of other relative equilibria.
    fn rest(&self, of: &Vector) -> Vector {
        let terms = [0, 1, 2, 3].map(|n| {
            let share = self.share(n, of);
            (Complex { re: -&share.re, im: -&share.im }, &self.modes[n])
        });
        combined(of, &terms)
    }

    /// Twice the symmetric bilinear part of the equations for ω and γ.
    fn quadratic(&self, [p, g]: &Vector, [q, h]: &Vector) -> Vector {
        let cyclic = [(1, 2, 0), (2, 0, 1), (0, 1, 2)];
        let omega = cyclic.map(|(i, j, k)| (&(&p[i] * &q[j]) + &(&q[i] * &p[j])).times(&self.torques[k]));
        let (one, other) = (cross(g, q), cross(h, p));
        [omega, [0, 1, 2].map(|k| &one[k] + &other[k])]
    }

    /// The coefficient of ζᵢζⱼ, where ζ₃ and ζ₄ are the conjugates of ζ₁ and ζ₂.
    fn second(&self, i: usize, j: usize) -> Option<Vector> {
        let (first, second) = (&self.modes[i], &self.modes[j]);
        let mut forced = self.quadratic(first, second);
        if i == j {
            forced = mapped(&forced, |x| x.times(&Fixed::whole(1).half()));
        }
        let shares = [0, 1, 2, 3].map(|n| self.share(n, &forced));
        let over = |rate: &Fixed| Fixed::whole(1).over(rate);
        if i.abs_diff(j) == 2 {
            // Constant: |γ| and ⟨γ, 𝐥⟩ keep their values.
            let a = &self.at.a;
            let of = |f: &dyn Fn(usize) -> Complex| (0..3).fold(zero(), |sum, k| &sum - &f(k));
            let length = of(&|k| &first[1][k] * &second[1][k]);
            let moment = of(&|k| (&(&first[1][k] * &second[0][k]) + &(&second[1][k] * &first[0][k])).times(&a[k]));
            let moment = moment.over(&self.j)?;
            let [longer, faster] = &self.beside;
            let mut terms = vec![(&moment - &length, faster), (length, longer)];
            for (n, share) in shares.iter().enumerate() {
                terms.push((share.turned(&over(&-&self.rates[n])?), &self.modes[n]));
            }
            return Some(combined(&nothing(), &terms));
        }
        // What has no share in a mode grows by 1/(iω), the others by 1/(i(ω − ω_n)).
        let rate = &self.rates[i] + &self.rates[j];
        let plain = over(&rate)?;
        let mut terms = Vec::new();
        for (n, share) in shares.iter().enumerate() {
            let beyond = &over(&(&rate - &self.rates[n]))? - &plain;
            terms.push((share.turned(&beyond), &self.modes[n]));
        }
        Some(combined(&mapped(&forced, |x| x.turned(&plain)), &terms))
    }

    /// What products of modes with terms of second order add to the frequency of a mode.
    fn shift(&self, mode: usize, pairs: &[(usize, &Vector)]) -> Fixed {
        sum(pairs.iter().map(|(n, vector)| self.share(mode, &self.quadratic(&self.modes[*n], vector)).im))
    }
}

fn nothing() -> Vector {
    [(); 2].map(|()| [(); 3].map(|()| zero()))
}

/// The second variation of H − l + μ|γ|²/2 with a vector, as a form: modes of different frequencies are orthogonal.
fn energy_with([p, g]: &Vector, a: &[Fixed; 3], mu: &Fixed) -> Vector {
    let omega = [0, 1, 2].map(|k| (&p[k] - &g[k]).times(&a[k]));
    [omega, [0, 1, 2].map(|k| &g[k].times(mu) - &p[k].times(&a[k]))]
}

/// The value of a form.
fn shared(form: &Vector, of: &Vector) -> Complex {
    let parts = form.iter().flatten().zip(of.iter().flatten());
    parts.fold(zero(), |sum, (x, y)| &sum + &(x * y))
}
