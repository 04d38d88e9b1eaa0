//! The linearised flow by the equations of Euler and Poisson at a relative equilibrium with two imaginary pairs: its modes, and the
//! share that each has in a vector.

use std::ops::{Add, Mul, Sub};

use crate::numbers::fixed::Fixed;

/// A relative equilibrium with Ω = 1, on the three axes.
pub(super) struct Rotation {
    pub a: [Fixed; 3],
    pub gamma: [Fixed; 3],
    /// μ − a.
    pub tau: [Fixed; 3],
}

#[derive(Clone)]
pub(super) struct Complex {
    pub re: Fixed,
    pub im: Fixed,
}

impl Complex {
    pub fn real(re: Fixed) -> Self {
        Self { re, im: Fixed::whole(0) }
    }

    pub fn times(&self, x: &Fixed) -> Self {
        Self { re: &self.re * x, im: &self.im * x }
    }

    pub fn half(&self) -> Self {
        Self { re: self.re.half(), im: self.im.half() }
    }

    /// −ix self.
    pub fn turned(&self, x: &Fixed) -> Self {
        Self { re: &self.im * x, im: -&(&self.re * x) }
    }

    pub fn over(&self, x: &Fixed) -> Option<Self> {
        Some(Self { re: self.re.over(x)?, im: self.im.over(x)? })
    }

    pub fn conjugate(&self) -> Self {
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
pub(super) type Vector = [[Complex; 3]; 2];

pub(super) fn zero() -> Complex {
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
pub(super) fn combined(first: &Vector, terms: &[(Complex, &Vector)]) -> Vector {
    let part =
        |n: usize, k: usize| terms.iter().fold(first[n][k].clone(), |sum, (factor, v)| &sum + &(factor * &v[n][k]));
    [0, 1].map(|n| [0, 1, 2].map(|k| part(n, k)))
}

pub(super) fn plus(v: &Vector, w: &Vector) -> Vector {
    [0, 1].map(|n| [0, 1, 2].map(|k| &v[n][k] + &w[n][k]))
}

pub(super) fn mapped(v: &Vector, of: impl Fn(&Complex) -> Complex) -> Vector {
    v.each_ref().map(|part| part.each_ref().map(&of))
}

/// Both modes, and the directions in the six variables that belong to neither.
pub(super) struct Modes<'a> {
    pub at: &'a Rotation,
    pub j: Fixed,
    /// (a_i − a_j)/a_k for cyclic i, j, k, by k.
    torques: [Fixed; 3],
    /// ω₁, ω₂, −ω₁, −ω₂.
    pub rates: [Fixed; 4],
    /// Of iω₁, iω₂, −iω₁, −iω₂.
    pub vectors: [Vector; 4],
    /// Forms that give the shares of the modes in a vector.
    shares: [Vector; 4],
    /// Twice the energies of modes with amplitude 1.
    energies: [Fixed; 2],
    /// The equilibria beside this one that are longer, and that turn faster.
    pub beside: [Vector; 2],
}

impl<'a> Modes<'a> {
    /// Also b and c of λ⁴ + bλ² + c; `None` where the enclosures do not show that the pairs are imaginary and distinct,
    /// at index 2.
    pub fn new(at: &'a Rotation) -> Option<(Self, Fixed, Fixed)> {
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
        let mut found = Self {
            at,
            rates: [omega[0].clone(), omega[1].clone(), -&omega[0], -&omega[1]],
            vectors: [(); 4].map(|()| nothing()),
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
                let mode = found.mode(&omega[n], &momentum, g)?;
                let conjugate = mapped(&mode, Complex::conjugate);
                let form = energy_with(&conjugate, a, &mu);
                let energy = shared(&form, &mode).re;
                energy.strict_sign().map(|_| (mode, conjugate, form, energy))
            });
            let size = |energy: &Fixed| energy.to_f64().abs();
            let best = candidates.into_iter().flatten().max_by(|p, q| size(&p.3).total_cmp(&size(&q.3)));
            let (mode, conjugate, form, energy) = best?;
            let over = Fixed::whole(1).over(&energy)?;
            found.shares[n] = mapped(&form, |x| x.times(&over));
            found.shares[n + 2] = mapped(&found.shares[n], Complex::conjugate);
            (found.vectors[n], found.vectors[n + 2], found.energies[n]) = (mode, conjugate, energy);
        }
        let still = || [zero(), zero(), zero()];
        let gamma = || gamma.each_ref().map(|x| Complex::real(x.clone()));
        found.beside = [[still(), gamma()], [gamma(), still()]].map(|v| found.rest(&v));
        let signs = [0, 1].map(|n| found.energies[n].sign());
        (signs == [Some(1), Some(-1)]).then_some((found, b, c))
    }

    /// n of both modes: I = n|ζ|².
    pub fn actions(&self) -> Option<[Fixed; 2]> {
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
    pub fn share(&self, mode: usize, of: &Vector) -> Complex {
        shared(&self.shares[mode], of)
    }

    /// What no mode has a share in: the directions of other relative equilibria.
    fn rest(&self, of: &Vector) -> Vector {
        let terms = [0, 1, 2, 3].map(|n| {
            let share = self.share(n, of);
            (Complex { re: -&share.re, im: -&share.im }, &self.vectors[n])
        });
        combined(of, &terms)
    }

    /// Twice the symmetric bilinear part of the equations for ω and γ.
    pub fn quadratic(&self, [p, g]: &Vector, [q, h]: &Vector) -> Vector {
        let cyclic = [(1, 2, 0), (2, 0, 1), (0, 1, 2)];
        let omega = cyclic.map(|(i, j, k)| (&(&p[i] * &q[j]) + &(&q[i] * &p[j])).times(&self.torques[k]));
        let (one, other) = (cross(g, q), cross(h, p));
        [omega, [0, 1, 2].map(|k| &one[k] + &other[k])]
    }
}

pub(super) fn nothing() -> Vector {
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
