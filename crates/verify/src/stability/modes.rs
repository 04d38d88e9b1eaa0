//! The linearised flow by the equations of Euler and Poisson at a relative equilibrium with two imaginary pairs: its modes, and the
//! share that each has in a vector.

use std::ops::{Add, Mul, Sub};

use crate::numbers::ball::Ball;

/// A relative equilibrium with Ω = 1, on the three axes.
pub(super) struct Rotation<const N: usize> {
    pub a: [Ball<N>; 3],
    pub gamma: [Ball<N>; 3],
    /// μ − a.
    pub tau: [Ball<N>; 3],
    /// The sum of the weights that γ² are shares of: p of Theorem 13.13.
    pub weight: Ball<N>,
}

#[derive(Clone)]
pub(super) struct Complex<const N: usize> {
    pub re: Ball<N>,
    pub im: Ball<N>,
}

impl<const N: usize> Complex<N> {
    pub fn real(re: Ball<N>) -> Self {
        Self { re, im: Ball::zero() }
    }

    pub fn times(&self, x: &Ball<N>) -> Self {
        Self { re: &self.re * x, im: &self.im * x }
    }

    pub fn half(&self) -> Self {
        Self { re: self.re.half(), im: self.im.half() }
    }

    /// −ix self.
    pub fn turned(&self, x: &Ball<N>) -> Self {
        Self { re: &self.im * x, im: -&(&self.re * x) }
    }

    pub fn over(&self, x: &Ball<N>) -> Option<Self> {
        Some(Self { re: self.re.over(x)?, im: self.im.over(x)? })
    }

    pub fn conjugate(&self) -> Self {
        Self { re: self.re.clone(), im: -&self.im }
    }
}

impl<const N: usize> Add for &Complex<N> {
    type Output = Complex<N>;
    fn add(self, other: Self) -> Complex<N> {
        Complex { re: &self.re + &other.re, im: &self.im + &other.im }
    }
}

impl<const N: usize> Sub for &Complex<N> {
    type Output = Complex<N>;
    fn sub(self, other: Self) -> Complex<N> {
        Complex { re: &self.re - &other.re, im: &self.im - &other.im }
    }
}

impl<const N: usize> Mul for &Complex<N> {
    type Output = Complex<N>;
    fn mul(self, other: Self) -> Complex<N> {
        let (re, im) = (&self.re * &other.re, &self.im * &other.im);
        Complex { re: &re - &im, im: &(&self.re * &other.im) + &(&self.im * &other.re) }
    }
}

/// A deviation of ω and of γ.
pub(super) type Vector<const N: usize> = [[Complex<N>; 3]; 2];

pub(super) fn zero<const N: usize>() -> Complex<N> {
    Complex::real(Ball::zero())
}

fn sum<const N: usize>(terms: impl IntoIterator<Item = Ball<N>>) -> Ball<N> {
    terms.into_iter().fold(Ball::zero(), |sum, x| &sum + &x)
}

fn dot<const N: usize>(x: &[Ball<N>; 3], y: &[Ball<N>; 3]) -> Ball<N> {
    sum((0..3).map(|k| &x[k] * &y[k]))
}

fn real_cross<const N: usize>(x: &[Ball<N>; 3], y: &[Ball<N>; 3]) -> [Ball<N>; 3] {
    [(1, 2), (2, 0), (0, 1)].map(|(j, k)| &(&x[j] * &y[k]) - &(&x[k] * &y[j]))
}

fn cross<const N: usize>(x: &[Complex<N>; 3], y: &[Complex<N>; 3]) -> [Complex<N>; 3] {
    [(1, 2), (2, 0), (0, 1)].map(|(j, k)| &(&x[j] * &y[k]) - &(&x[k] * &y[j]))
}

/// A vector and multiples of others.
pub(super) fn combined<const N: usize>(first: &Vector<N>, terms: &[(Complex<N>, &Vector<N>)]) -> Vector<N> {
    let part =
        |n: usize, k: usize| terms.iter().fold(first[n][k].clone(), |sum, (factor, v)| &sum + &(factor * &v[n][k]));
    [0, 1].map(|n| [0, 1, 2].map(|k| part(n, k)))
}

pub(super) fn plus<const N: usize>(v: &Vector<N>, w: &Vector<N>) -> Vector<N> {
    [0, 1].map(|n| [0, 1, 2].map(|k| &v[n][k] + &w[n][k]))
}

pub(super) fn mapped<const N: usize>(v: &Vector<N>, of: impl Fn(&Complex<N>) -> Complex<N>) -> Vector<N> {
    v.each_ref().map(|part| part.each_ref().map(&of))
}

/// Both modes, and the directions in the six variables that belong to neither.
pub(super) struct Modes<'a, const N: usize> {
    pub at: &'a Rotation<N>,
    pub j: Ball<N>,
    /// (a_i − a_j)/a_k for cyclic i, j, k, by k.
    torques: [Ball<N>; 3],
    /// ω₁, ω₂, −ω₁, −ω₂.
    pub rates: [Ball<N>; 4],
    /// Of iω₁, iω₂, −iω₁, −iω₂.
    pub vectors: [Vector<N>; 4],
    /// Forms that give the shares of the modes in a vector.
    shares: [Vector<N>; 4],
    /// Twice the energies of modes with amplitude 1.
    energies: [Ball<N>; 2],
    /// The equilibria beside this one that are longer, and that turn faster.
    pub beside: [Vector<N>; 2],
}

impl<'a, const N: usize> Modes<'a, N> {
    /// Also b and c of λ⁴ + bλ² + c; `None` where the enclosures do not show that the pairs are imaginary and distinct,
    /// at index 2.
    pub fn new(at: &'a Rotation<N>) -> Option<(Self, Ball<N>, Ball<N>)> {
        let Rotation { a, gamma, tau, .. } = at;
        let momentum = [0, 1, 2].map(|k| &a[k] * &gamma[k]);
        let j = dot(gamma, &momentum);
        // A basis across γ.
        let nearest = (0..3).min_by(|&i, &k| gamma[i].square().to_f64().total_cmp(&gamma[k].square().to_f64()))?;
        let unit = [0, 1, 2].map(|k| Ball::whole(i32::from(k == nearest)));
        let e = real_cross(gamma, &unit);
        let length = dot(&e, &e).root()?;
        let [e0, e1, e2] = e.each_ref().map(|x| x.over(&length));
        let e = [e0?, e1?, e2?];
        let basis = [e.clone(), real_cross(gamma, &e)];
        // Theorem 13.1.
        let scale = (&(&a[0] * &a[1]) * &a[2]).over(&j)?;
        let four = Ball::whole(4).over(&j)?;
        let bend = [0, 1, 2].map(|k| &momentum[k] - &(&j * &gamma[k]));
        let bends = [0, 1].map(|n| dot(&bend, &basis[n]));
        let [i0, i1, i2] = a.each_ref().map(|a| Ball::whole(1).over(a));
        let inverse = [i0?, i1?, i2?];
        let form = |weight: &[Ball<N>; 3], p: usize, q: usize| {
            sum((0..3).map(|k| &weight[k] * &(&basis[p][k] * &basis[q][k])))
        };
        let places = [(0, 0), (0, 1), (1, 1)];
        let mass = places.map(|(p, q)| &scale * &form(&inverse, p, q));
        let hessian = places.map(|(p, q)| &form(tau, p, q) + &(&four * &(&bends[p] * &bends[q])));
        let twice = (&Ball::whole(2) * &dot(&momentum, &momentum)).over(&j)?;
        let gyro = &sum(a.iter().cloned()) - &twice;
        let crossed = &Ball::whole(2) * &(&mass[1] * &hessian[1]);
        let cofactor = &(&(&mass[0] * &hessian[2]) + &(&mass[2] * &hessian[0])) - &crossed;
        let b = (&gyro.square() + &cofactor).over(&scale)?;
        let c = (&(&hessian[0] * &hessian[2]) - &hessian[1].square()).over(&scale)?;
        let discriminant = &b.square() - &(&Ball::whole(4) * &c);
        if ![&b, &c, &discriminant].into_iter().all(Ball::is_positive) {
            return None;
        }
        let square = (&b + &discriminant.root()?).half();
        let omega = [square.root()?, c.over(&square)?.root()?];
        let mut found = Self {
            at,
            rates: [omega[0].clone(), omega[1].clone(), -&omega[0], -&omega[1]],
            vectors: [(); 4].map(|()| nothing()),
            shares: [(); 4].map(|()| nothing()),
            energies: [Ball::zero(), Ball::zero()],
            beside: [(); 2].map(|()| nothing()),
            j,
            torques: [(1, 2, 0), (2, 0, 1), (0, 1, 2)].map(|(i, j, k)| &(&a[i] - &a[j]) * &inverse[k]),
        };
        let mu = &tau[0] + &a[0];
        for n in 0..2 {
            // (−ω²M + iωΓ + K)g = 0, by its larger row or else the other.
            let inertia = |k: usize| &hessian[k] - &(&omega[n].square() * &mass[k]);
            let (off, turn) = (inertia(1), &omega[n] * &gyro);
            let mut rows = [
                [Complex { re: -&off, im: turn.clone() }, Complex::real(inertia(0))],
                [Complex::real(inertia(2)), Complex { re: -&off, im: -&turn }],
            ];
            let size =
                |row: &[Complex<N>; 2]| row.iter().fold(0.0, |sum, x| x.re.to_f64().abs() + x.im.to_f64().abs() + sum);
            rows.sort_by(|p, q| size(q).total_cmp(&size(p)));
            let found_mode = rows.iter().find_map(|[x, y]| {
                let g = [0, 1, 2].map(|k| &x.times(&basis[0][k]) + &y.times(&basis[1][k]));
                let mode = found.mode(&omega[n], &momentum, g)?;
                let conjugate = mapped(&mode, Complex::conjugate);
                let form = energy_with(&conjugate, a, &mu);
                let energy = shared(&form, &mode).re;
                energy.strict_sign().map(|_| (mode, conjugate, form, energy))
            });
            let (mode, conjugate, form, energy) = found_mode?;
            let over = Ball::whole(1).over(&energy)?;
            found.shares[n] = mapped(&form, |x| x.times(&over));
            found.shares[n + 2] = mapped(&found.shares[n], Complex::conjugate);
            (found.vectors[n], found.vectors[n + 2], found.energies[n]) = (mode, conjugate, energy);
        }
        let still = || [zero(), zero(), zero()];
        let gamma = || gamma.each_ref().map(|x| Complex::real(x.clone()));
        found.beside = [[still(), gamma()], [gamma(), still()]].map(|v| found.rest(&v));
        let signs = [0, 1].map(|n| found.energies[n].strict_sign());
        (signs == [Some(1), Some(-1)]).then_some((found, b, c))
    }

    /// n of both modes: I = n|ζ|².
    pub fn actions(&self) -> Option<[Ball<N>; 2]> {
        Some([self.energies[0].over(&self.rates[0])?, (-&self.energies[1]).over(&self.rates[1])?])
    }

    /// The mode of iω with this part of γ.
    fn mode(&self, omega: &Ball<N>, momentum: &[Ball<N>; 3], g: [Complex<N>; 3]) -> Option<Vector<N>> {
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
    pub fn share(&self, mode: usize, of: &Vector<N>) -> Complex<N> {
        shared(&self.shares[mode], of)
    }

    /// What no mode has a share in, of a real vector: the directions of other relative equilibria.
    fn rest(&self, of: &Vector<N>) -> Vector<N> {
        let terms = [0, 1].map(|n| {
            let share = self.share(n, of);
            (Complex { re: -&share.re, im: -&share.im }, &self.vectors[n])
        });
        let half = combined(&mapped(of, Complex::half), &terms);
        mapped(&half, |x| Complex::real(&x.re + &x.re))
    }

    /// Twice the symmetric bilinear part of the equations for ω and γ.
    pub fn quadratic(&self, [p, g]: &Vector<N>, [q, h]: &Vector<N>) -> Vector<N> {
        let cyclic = [(1, 2, 0), (2, 0, 1), (0, 1, 2)];
        let omega = cyclic.map(|(i, j, k)| (&(&p[i] * &q[j]) + &(&q[i] * &p[j])).times(&self.torques[k]));
        let (one, other) = (cross(g, q), cross(h, p));
        [omega, [0, 1, 2].map(|k| &one[k] + &other[k])]
    }
}

pub(super) fn nothing<const N: usize>() -> Vector<N> {
    [(); 2].map(|()| [(); 3].map(|()| zero()))
}

/// The second variation of H − l + μ|γ|²/2 with a vector, as a form: modes of different frequencies are orthogonal.
fn energy_with<const N: usize>([p, g]: &Vector<N>, a: &[Ball<N>; 3], mu: &Ball<N>) -> Vector<N> {
    let omega = [0, 1, 2].map(|k| (&p[k] - &g[k]).times(&a[k]));
    [omega, [0, 1, 2].map(|k| &g[k].times(mu) - &p[k].times(&a[k]))]
}

/// The value of a form.
fn shared<const N: usize>(form: &Vector<N>, of: &Vector<N>) -> Complex<N> {
    let parts = form.iter().flatten().zip(of.iter().flatten());
    parts.fold(zero(), |sum, (x, y)| &sum + &(x * y))
}
