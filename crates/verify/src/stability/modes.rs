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

    /// −ix self.
    pub fn turned(&self, x: &Ball<N>) -> Self {
        Self { re: &self.im * x, im: -&(&self.re * x) }
    }

    /// i self.
    fn quarter_turn(&self) -> Self {
        Self { re: -&self.im, im: self.re.clone() }
    }

    /// The real part of a product.
    pub fn real_product(&self, other: &Self) -> Ball<N> {
        &(&self.re * &other.re) - &(&self.im * &other.im)
    }

    fn negative(&self) -> Self {
        Self { re: -&self.re, im: -&self.im }
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

const CYCLIC: [(usize, usize, usize); 3] = [(1, 2, 0), (2, 0, 1), (0, 1, 2)];

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

/// A real vector, and multiples of others with their conjugates.
pub(super) fn real_combined<const N: usize>(first: &Vector<N>, terms: &[(Complex<N>, &Vector<N>)]) -> Vector<N> {
    let twice = |n: usize, k: usize| sum(terms.iter().map(|(factor, v)| factor.real_product(&v[n][k]))).times_two_to(1);
    [0, 1].map(|n| [0, 1, 2].map(|k| Complex::real(&first[n][k].re + &twice(n, k))))
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
    /// 1/J.
    pub inverse_j: Ball<N>,
    /// (a_i − a_j)/a_k for cyclic i, j, k, by k.
    torques: [Ball<N>; 3],
    /// ω₁, ω₂.
    pub rates: [Ball<N>; 2],
    /// Of iω₁, iω₂, −iω₁, −iω₂.
    pub vectors: [Vector<N>; 4],
    /// Forms that give the shares of the first two in a vector.
    shares: [Vector<N>; 2],
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
        let inverse_length = dot(&e, &e).root()?.recip()?;
        let e = e.each_ref().map(|x| x * &inverse_length);
        let basis = [e.clone(), real_cross(gamma, &e)];
        // Theorem 13.1.
        let inverse_j = j.recip()?;
        let determinant = &(&a[0] * &a[1]) * &a[2];
        let scale = &determinant * &inverse_j;
        let four = inverse_j.times_two_to(2);
        let bend = [0, 1, 2].map(|k| &momentum[k] - &(&j * &gamma[k]));
        let bends = [0, 1].map(|n| dot(&bend, &basis[n]));
        let inverse_determinant = determinant.recip()?;
        let inverse = [(1, 2), (2, 0), (0, 1)].map(|(i, k)| &(&a[i] * &a[k]) * &inverse_determinant);
        let form = |weight: &[Ball<N>; 3], p: usize, q: usize| {
            sum((0..3).map(|k| &weight[k] * &(&basis[p][k] * &basis[q][k])))
        };
        let places = [(0, 0), (0, 1), (1, 1)];
        let mass = places.map(|(p, q)| &scale * &form(&inverse, p, q));
        let hessian = places.map(|(p, q)| &form(tau, p, q) + &(&four * &(&bends[p] * &bends[q])));
        let twice = (&dot(&momentum, &momentum) * &inverse_j).times_two_to(1);
        let gyro = &sum(a.iter().cloned()) - &twice;
        let crossed = (&mass[1] * &hessian[1]).times_two_to(1);
        let cofactor = &(&(&mass[0] * &hessian[2]) + &(&mass[2] * &hessian[0])) - &crossed;
        let inverse_scale = &j * &inverse_determinant;
        let b = &(&gyro.square() + &cofactor) * &inverse_scale;
        let c = &(&(&hessian[0] * &hessian[2]) - &hessian[1].square()) * &inverse_scale;
        let discriminant = &b.square() - &c.times_two_to(2);
        if ![&b, &c, &discriminant].into_iter().all(Ball::is_positive) {
            return None;
        }
        let square = (&b + &discriminant.root()?).half();
        let omega = [square.root()?, c.over(&square)?.root()?];
        let mut found = Self {
            at,
            rates: omega.clone(),
            vectors: [(); 4].map(|()| nothing()),
            shares: [(); 2].map(|()| nothing()),
            energies: [Ball::zero(), Ball::zero()],
            beside: [(); 2].map(|()| nothing()),
            inverse_j,
            torques: CYCLIC.map(|(i, j, k)| &(&a[i] - &a[j]) * &inverse[k]),
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
                let mode = found.mode(&omega[n], &momentum, g);
                let conjugate = mapped(&mode, Complex::conjugate);
                let form = energy_with(&conjugate, a, &mu);
                let energy = shared(&form, &mode).re;
                energy.strict_sign().map(|_| (mode, conjugate, form, energy))
            });
            let (mode, conjugate, form, energy) = found_mode?;
            let over = energy.recip()?;
            found.shares[n] = mapped(&form, |x| x.times(&over));
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
    fn mode(&self, omega: &Ball<N>, momentum: &[Ball<N>; 3], g: [Complex<N>; 3]) -> Vector<N> {
        let gamma = self.at.gamma.each_ref().map(|x| Complex::real(x.clone()));
        let turned = cross(&gamma, &g).map(|x| Complex { re: -&(&x.im * omega), im: &x.re * omega });
        let along = (0..3).fold(zero(), |sum, k| {
            let twice = &g[k] + &g[k];
            &sum + &(&turned[k] - &twice).times(&momentum[k])
        });
        let along = along.times(&self.inverse_j);
        let omega = [0, 1, 2].map(|k| &(&g[k] - &turned[k]) + &along.times(&self.at.gamma[k]));
        [omega, g]
    }

    /// The share of one of the first two modes in a vector.
    pub fn share(&self, mode: usize, of: &Vector<N>) -> Complex<N> {
        shared(&self.shares[mode], of)
    }

    /// The shares of one of the first two modes and of its conjugate: by the real and the imaginary part of its form.
    pub fn both_shares(&self, mode: usize, of: &Vector<N>) -> [Complex<N>; 2] {
        let by = |part: fn(&Complex<N>) -> &Ball<N>| {
            let parts = self.shares[mode].iter().flatten().zip(of.iter().flatten());
            parts.fold(zero(), |sum, (form, x)| &sum + &x.times(part(form)))
        };
        let (plain, turned) = (by(|form| &form.re), by(|form| &form.im).quarter_turn());
        [&plain + &turned, &plain - &turned]
    }

    /// A vector, and multiples of both modes and of their conjugates: of their real and imaginary parts.
    pub fn with_modes(&self, first: &Vector<N>, factors: &[[Complex<N>; 2]; 2]) -> Vector<N> {
        let parts = factors.each_ref().map(|[one, other]| [one + other, (one - other).quarter_turn()]);
        let part = |n: usize, k: usize| {
            parts.iter().zip(&self.vectors).fold(first[n][k].clone(), |sum, ([plain, turned], v)| {
                let Complex { re, im } = &v[n][k];
                &sum + &(&plain.times(re) + &turned.times(im))
            })
        };
        [0, 1].map(|n| [0, 1, 2].map(|k| part(n, k)))
    }

    /// What no mode has a share in, of a real vector: the directions of other relative equilibria.
    fn rest(&self, of: &Vector<N>) -> Vector<N> {
        let terms = [0, 1].map(|n| (self.share(n, of).negative(), &self.vectors[n]));
        real_combined(of, &terms)
    }

    /// Twice the symmetric bilinear part of the equations for ω and γ.
    pub fn quadratic(&self, [p, g]: &Vector<N>, [q, h]: &Vector<N>) -> Vector<N> {
        let omega = CYCLIC.map(|(i, j, k)| (&(&p[i] * &q[j]) + &(&q[i] * &p[j])).times(&self.torques[k]));
        let (one, other) = (cross(g, q), cross(h, p));
        [omega, [0, 1, 2].map(|k| &one[k] + &other[k])]
    }

    /// The quadratic part of the equations.
    pub fn square(&self, [p, g]: &Vector<N>) -> Vector<N> {
        [CYCLIC.map(|(i, j, k)| (&p[i] * &p[j]).times(&self.torques[k])), cross(g, p)]
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
