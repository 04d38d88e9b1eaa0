//! The unstable manifold of an equilibrium p as a power series z = W(x) in coordinates in which motions are ẋ = Λx.
//!
//! The field is X(z) = J(z − p) + B(z − p, z − p) exactly, so that DW(x) Λx = X(W(x)) gives the coefficient of each
//! monomial xᵃ of degree above 1 as (⟨a,λ⟩ − J)⁻¹ ∑ B(w_b, w_c) over b + c = a; those of degree 1 are eigenvectors.

use nalgebra::{Complex, SMatrix, SVector};

use crate::flow::{Phase, Space, Tangent};

/// Complex numbers, used with sums and products only.
type C = Complex<f64>;
type Vector = SVector<C, 6>;
type Double = SMatrix<f64, 12, 12>;

/// The eigenvalues of positive real part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Rates {
    /// One, next to an imaginary pair.
    One(f64),
    /// Two real ones, the smaller first.
    Two([f64; 2]),
    /// A complex pair: real and imaginary part.
    Pair([f64; 2]),
}

/// The series up to a degree.
#[derive(Clone, Debug)]
pub struct Series {
    /// p.
    pub center: Phase,
    /// λ₁, λ₂.
    pub rates: [C; 2],
    /// w of x₁ᵐx₂ⁿ at (m + n)(m + n + 1)/2 + n.
    terms: Vec<Vector>,
    degree: usize,
    /// Half axes of the closed curve on which motions begin: the sizes of x₁ and x₂, for a complex pair twice these.
    pub sizes: [f64; 2],
}

/// The degree to which manifolds are expanded.
const DEGREE: usize = 10;
/// The terms of highest degree are no larger than this where motions begin.
const REMAINDER: f64 = 1e-16;
/// The largest distance from an equilibrium at which motions begin: with two real rates, and otherwise.
const BEGIN: [f64; 2] = [1e-2, 1e-3];
/// Where the rates differ, both sizes correspond to the same time, but the smaller one is at least this.
const LEAST: f64 = 1e-4;
/// How often the distance may be halved.
const HALVINGS: usize = 12;
/// Rates with a smaller relative difference are equal.
const SAME: f64 = 1e-9;
/// Singular values below this share of the largest one count as 0.
const KERNEL: f64 = 1e-9;

const fn place(m: usize, n: usize) -> usize {
    (m + n) * (m + n + 1) / 2 + n
}

impl Series {
    /// At an equilibrium; `None` where a coefficient does not exist because an eigenvalue is a sum of multiples of
    /// others, where the eigenvectors are not independent, or where the terms do not decrease fast enough.
    #[must_use]
    pub fn new(space: &Space, center: Phase, rates: Rates) -> Option<Self> {
        let mut series = Self::expanded(space, center, rates, DEGREE)?;
        series.begin().then_some(series)
    }

    /// The coefficients, without the place where motions begin.
    fn expanded(space: &Space, center: Phase, rates: Rates, degree: usize) -> Option<Self> {
        let turn = space.linearised(&center);
        let real = |x: Phase| x.map(|x| C::new(x, 0.0));
        let (rates, first) = match rates {
            Rates::One(rate) => {
                let [v, _] = eigenvectors(&turn, rate, false)?;
                ([C::new(rate, 0.0), C::new(0.0, 0.0)], [real(v), Vector::zeros()])
            }
            Rates::Two([slow, fast]) if fast - slow <= SAME * fast => {
                let both = eigenvectors(&turn, 0.5 * (slow + fast), true)?;
                ([slow, fast].map(|rate| C::new(rate, 0.0)), both.map(real))
            }
            Rates::Two(pair) => {
                let [[u, _], [v, _]] = [eigenvectors(&turn, pair[0], false)?, eigenvectors(&turn, pair[1], false)?];
                (pair.map(|rate| C::new(rate, 0.0)), [real(u), real(v)])
            }
            Rates::Pair([re, im]) => {
                let v = complex_eigenvector(&turn, [re, im]);
                ([C::new(re, im), C::new(re, -im)], [v, v.map(|x| x.conj())])
            }
        };
        let mut series =
            Self { center, rates, terms: vec![Vector::zeros(); place(0, degree) + 1], degree, sizes: [0.0; 2] };
        series.terms[place(1, 0)] = first[0];
        series.terms[place(0, 1)] = first[1];
        let still = space.linearised(&Phase::zeros());
        let bilinear: [Tangent; 6] = std::array::from_fn(|j| (space.linearised(&Phase::ith(j, 1.0)) - still) * 0.5);
        for d in 2..=degree {
            let last = if series.is_single() { 0 } else { d };
            for n in 0..=last {
                series.terms[place(d - n, n)] = series.coefficient(&turn, &bilinear, [d - n, n])?;
            }
        }
        Some(series)
    }

    fn is_single(&self) -> bool {
        self.rates[1].re == 0.0
    }

    fn coefficient(&self, turn: &Tangent, bilinear: &[Tangent; 6], [m, n]: [usize; 2]) -> Option<Vector> {
        let mut sum = Vector::zeros();
        for i in 0..=m {
            for j in 0..=n {
                if (1..m + n).contains(&(i + j)) {
                    let (u, v) = (&self.terms[place(i, j)], &self.terms[place(m - i, n - j)]);
                    for (matrix, factor) in bilinear.iter().zip(u.iter()) {
                        let [re, im] = [matrix * v.map(|x| x.re), matrix * v.map(|x| x.im)];
                        sum += Vector::from_fn(|k, _| C::new(re[k], im[k]) * factor);
                    }
                }
            }
        }
        let rate = self.rates[0] * m as f64 + self.rates[1] * n as f64;
        let right = SVector::<f64, 12>::from_fn(|k, _| if k < 6 { sum[k].re } else { sum[k - 6].im });
        let found = (-blocks(turn, [rate.re, rate.im])).lu().solve(&right)?;
        Some(Vector::from_fn(|k, _| C::new(found[k], found[k + 6])))
    }

    /// Chooses where motions begin.
    fn begin(&mut self) -> bool {
        let [first, second] = self.rates;
        let is_real = first.im == 0.0 && !self.is_single();
        let mut size = BEGIN[usize::from(!is_real)];
        for _ in 0..HALVINGS {
            let other = if is_real { libm::pow(size, second.re / first.re).max(LEAST).min(size) } else { size };
            self.sizes = [size, other];
            let terms = |d: usize| (0..=d).map(move |n| [d - n, n]);
            let length = |[m, n]: [usize; 2]| {
                let term = &self.terms[place(m, n)];
                let square: f64 = term.iter().map(|x| x.re * x.re + x.im * x.im).sum();
                square.sqrt() * power(size, m) * power(other, n)
            };
            if terms(self.degree).map(length).sum::<f64>() <= REMAINDER {
                return true;
            }
            size *= 0.5;
        }
        false
    }

    /// The coordinates of the motion at an angle, at a time after it left the closed curve.
    #[must_use]
    pub fn coordinates(&self, angle: f64, time: f64) -> [C; 2] {
        let (sin, cos) = libm::sincos(angle);
        let [a, b] = self.sizes;
        let first = if self.rates[0].im == 0.0 {
            [C::new(a * cos, 0.0), C::new(b * sin, 0.0)]
        } else {
            [C::new(0.5 * a * cos, 0.5 * a * sin), C::new(0.5 * a * cos, -0.5 * a * sin)]
        };
        std::array::from_fn(|k| {
            let (sin, cos) = libm::sincos(self.rates[k].im * time);
            first[k] * (C::new(cos, sin) * libm::exp(self.rates[k].re * time))
        })
    }

    /// The point at coordinates.
    #[must_use]
    pub fn at(&self, [x, y]: [C; 2]) -> Phase {
        let mut sum = Phase::zeros();
        // Small terms first.
        for d in (1..=self.degree).rev() {
            for n in 0..=d {
                let monomial = complex_power(x, d - n) * complex_power(y, n);
                sum += self.terms[place(d - n, n)].map(|w| (w * monomial).re);
            }
        }
        self.center + sum
    }
}

/// [[J − re, im], [−im, J − re]], which is J − λ on pairs of a real and an imaginary part.
fn blocks(turn: &Tangent, [re, im]: [f64; 2]) -> Double {
    Double::from_fn(|i, j| {
        let diagonal = f64::from(u8::from(i % 6 == j % 6));
        match (i < 6, j < 6) {
            (true, true) | (false, false) => turn[(i % 6, j % 6)] - re * diagonal,
            (true, false) => im * diagonal,
            (false, true) => -im * diagonal,
        }
    })
}

/// The eigenvector of a simple rate, or two for a double rate.
fn eigenvectors(turn: &Tangent, rate: f64, is_double: bool) -> Option<[Phase; 2]> {
    let svd = (turn - Tangent::identity() * rate).svd(false, true);
    let (sizes, rows) = (svd.singular_values, svd.v_t?);
    let mut order: Vec<usize> = (0..6).collect();
    order.sort_by(|&i, &j| sizes[i].total_cmp(&sizes[j]));
    let vanishes = |k: usize| sizes[order[k]] < KERNEL * sizes[order[5]];
    let vector = |k: usize| rows.row(order[k]).transpose();
    (vanishes(0) && vanishes(1) == is_double).then(|| [vector(0), vector(1)])
}

fn complex_eigenvector(turn: &Tangent, rate: [f64; 2]) -> Vector {
    let svd = blocks(turn, rate).svd(false, true);
    let sizes = svd.singular_values;
    let least = (0..12).min_by(|&i, &j| sizes[i].total_cmp(&sizes[j])).unwrap_or(0);
    let rows = svd.v_t.unwrap_or_else(Double::identity);
    Vector::from_fn(|k, _| C::new(rows[(least, k)], rows[(least, k + 6)]))
}

fn power(x: f64, n: usize) -> f64 {
    (0..n).fold(1.0, |product, _| product * x)
}

fn complex_power(x: C, n: usize) -> C {
    (0..n).fold(C::new(1.0, 0.0), |product, _| product * x)
}

#[cfg(test)]
mod tests {
    use bifdiag_body::Body;
    use bifdiag_dynamics::field::HeavyTop;
    use bifdiag_equilibria::critical::critical;

    use super::*;
    use crate::chart::Surface;
    use crate::manifold::rest;

    /// The space, an unstable equilibrium, and the rates with which `critical` says that motions leave it.
    fn unstable(moments: [&str; 3], center: [&str; 3], l: &str) -> (Space, Phase, Rates) {
        let body = Body::parse(&moments, &center).unwrap();
        let top = HeavyTop::new(&body);
        let list = critical(&body, &l.parse().unwrap()).unwrap().list;
        let found = list.into_iter().find(|found| found.stability.is_unstable()).unwrap();
        let surface = Surface::new(&top, found.h, found.l);
        let point = surface.point(&rest(&found, &top));
        let unit = top.units().reduce(1.0, bifdiag_dynamics::field::Dimension::FREQUENCY);
        let [first, second] = found.eigenvalues.pairs.map(|pair| pair.map(|x| x * unit));
        let rates = match (first[1] > 0.0, second[1] > 0.0) {
            (true, true) => Rates::Pair(first),
            (false, false) => Rates::Two([first[0].min(second[0]), first[0].max(second[0])]),
            _ => Rates::One(first[0].max(second[0])),
        };
        (*surface.space(), point, rates)
    }

    fn bodies() -> [(Space, Phase, Rates); 3] {
        [
            unstable(["2", "1.5", "1.2"], ["0.3", "0.5", "0.8"], "0"),
            unstable(["2", "1.5", "1.2"], ["0.3", "0.5", "0.8"], "0.5"),
            unstable(["2", "2", "1"], ["1", "0", "0"], "2.5"),
        ]
    }

    /// Motions on the manifold grow with the rates that `critical` prints: the flow maps W(x) to W(e^(Λt)x).
    #[test]
    fn the_flow_along_the_series_is_linear() {
        let mut kinds = [0; 3];
        for (space, point, rates) in bodies() {
            let series = Series::new(&space, point, rates).unwrap();
            let (kind, fastest) = match rates {
                Rates::One(rate) => (0, rate),
                Rates::Two([_, rate]) => (1, rate),
                Rates::Pair([rate, _]) => (2, rate),
            };
            kinds[kind] += 1;
            let time = 1.5 / fastest;
            for angle in [0.0, 0.4, 1.3, 2.7, 3.1, 4.4, 6.0] {
                let [begin, end] = [-time, 0.0].map(|time| series.at(series.coordinates(angle, time)));
                let missed = (space.ends(&[begin], time).unwrap()[0] - end).norm();
                assert!(missed < 2e-15 && (end - begin).norm() > 1e-4, "{missed:e}");
            }
        }
        assert_eq!(kinds, [1, 1, 1]);
    }

    /// The error of the series of degree n is of order n + 1 in the distance.
    #[test]
    fn the_error_falls_with_the_distance_by_its_order() {
        for (space, point, rates) in bodies() {
            for degree in [1, 2, 3] {
                let mut series = Series::expanded(&space, point, rates, degree).unwrap();
                let time = 0.5;
                let mut missed = |size: f64| {
                    series.sizes = [size, size];
                    let angles = [0.3, 0.9, 2.0, 2.9, 3.8, 5.1];
                    let off = angles.map(|angle| {
                        let [begin, end] = [-time, 0.0].map(|time| series.at(series.coordinates(angle, time)));
                        (space.ends(&[begin], time).unwrap()[0] - end).norm()
                    });
                    off.into_iter().fold(0.0, f64::max)
                };
                let ratio = missed(0.02) / missed(0.01);
                let expected = f64::from(1 << (degree + 1));
                // Where a symmetry makes a term vanish, the error falls faster.
                assert!(ratio > 0.8 * expected && ratio < 2.5 * expected, "{degree} {ratio}");
            }
        }
    }
}
