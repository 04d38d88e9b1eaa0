//! The equations of motion as quadratic polynomials: a table of terms, exact, and the same table in some precision.

use bifdiag_body::Body;
use bifdiag_numbers::interval::Interval;
use dashu_ratio::RBig;

use crate::bound::{frobenius, spectral, up};
use crate::scalar::Scalar;

/// Coordinates of (γ, ω).
pub const FREE: usize = 6;
/// Coordinates of (q, ω).
pub const ATTITUDE: usize = 7;

/// γ as a quadratic form of the attitude q = (w, x, y, z), Rᵀ e_z: factor, two coordinates.
const VERTICAL: [&[(i32, usize, usize)]; 3] =
    [&[(2, 1, 3), (-2, 0, 2)], &[(2, 2, 3), (2, 0, 1)], &[(1, 0, 0), (-1, 1, 1), (-1, 2, 2), (1, 3, 3)]];

/// q ω by rows: sign, coordinate of q, of ω.
const PRODUCT: [[(i32, usize, usize); 3]; 4] = [
    [(-1, 1, 0), (-1, 2, 1), (-1, 3, 2)],
    [(1, 0, 0), (1, 2, 2), (-1, 3, 1)],
    [(1, 0, 1), (1, 3, 0), (-1, 1, 2)],
    [(1, 0, 2), (1, 1, 1), (-1, 2, 0)],
];

/// ẋ_i = Σ c x_a x_b + Σ c x_a, exactly.
#[derive(Clone, Debug, Default)]
pub struct Equations {
    /// i, a, b, c.
    quadratic: Vec<(usize, usize, usize, RBig)>,
    /// i, a, c.
    linear: Vec<(usize, usize, RBig)>,
}

impl Equations {
    /// γ̇ = γ×ω, Aω̇ = Aω×ω − γ×r in the coordinates (γ, ω), with time in units of 1/`speed` and ω in units of `speed`.
    #[must_use]
    pub fn free(body: &Body, speed: &RBig) -> Self {
        let mut equations = Self::default();
        for i in 0..3 {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            equations.quadratic.push((i, j, 3 + k, RBig::ONE));
            equations.quadratic.push((i, k, 3 + j, -RBig::ONE));
            for (at, factor) in torque(body, speed, i) {
                equations.linear.push((3 + i, at, factor));
            }
            equations.gyroscopic(body, i, 3);
        }
        equations
    }

    /// q̇ = ½ q ω with the same equation for ω, γ being the vertical of the attitude q, in the coordinates (q, ω).
    #[must_use]
    pub fn attitude(body: &Body, speed: &RBig) -> Self {
        let mut equations = Self::default();
        for (i, row) in PRODUCT.iter().enumerate() {
            for (sign, a, b) in row {
                equations.quadratic.push((i, *a, 4 + b, RBig::from(*sign) / RBig::from(2)));
            }
        }
        for i in 0..3 {
            for (at, factor) in torque(body, speed, i) {
                for (c, a, b) in VERTICAL[at] {
                    equations.quadratic.push((4 + i, *a, *b, &factor * RBig::from(*c)));
                }
            }
            equations.gyroscopic(body, i, 4);
        }
        equations
    }

    /// (A_j − A_k) ω_j ω_k / A_i.
    fn gyroscopic(&mut self, body: &Body, i: usize, first: usize) {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        let a = body.moments().each_ref().map(|moment| moment.value().clone());
        let factor = (&a[j] - &a[k]) / &a[i];
        if !factor.is_zero() {
            self.quadratic.push((first + i, first + j, first + k, factor));
        }
    }
}

/// −(γ×r)_i / A_i in units of `speed`²: coordinate of γ and factor.
fn torque(body: &Body, speed: &RBig, i: usize) -> impl Iterator<Item = (usize, RBig)> {
    let (j, k) = ((i + 1) % 3, (i + 2) % 3);
    let r = body.center().each_ref().map(|r| r.value().clone());
    let unit = body.moments()[i].value() * speed * speed;
    [(k, &r[j] / &unit), (j, -(&r[k] / &unit))].into_iter().filter(|(_, factor)| !factor.is_zero())
}

/// A term c x_a x_b of row i; `pair` is the number of (a, b) among the products that occur.
#[derive(Clone, Debug)]
struct Quadratic<S> {
    row: usize,
    a: usize,
    b: usize,
    pair: usize,
    exact: S,
    double: f64,
}

#[derive(Clone, Debug)]
struct Linear<S> {
    row: usize,
    a: usize,
    exact: S,
    double: f64,
}

/// The right-hand side f(x) = Bx + Q(x, x) in the precision of S, with bounds.
#[derive(Clone, Debug)]
pub struct QuadraticField<S: Scalar, const N: usize> {
    /// Precision of S.
    pub precision: S::Precision,
    /// The relative size of what may be lost in a step: not below the unit of S.
    pub accuracy: f64,
    pairs: Vec<[usize; 2]>,
    quadratic: Vec<Quadratic<S>>,
    linear: Vec<Linear<S>>,
    /// ‖Q(u, v)‖ ≤ κ‖u‖‖v‖ for the symmetric Q.
    pub kappa: f64,
    /// The symmetric part of 2Q(u, ·) is at most σ‖u‖ in norm: what the logarithmic norm of Df may change by.
    pub sigma: f64,
    /// The same for the sums of the absolute values of the terms, in any order of the factors.
    pub kappa_terms: f64,
    /// ‖|B| |u|‖ ≤ λ‖u‖.
    pub lambda: f64,
    /// More operations than follow a product of coefficients in a row.
    pub depth: f64,
    /// As many summands as a row of f has, by which variables they are derived counted, at most.
    pub width: f64,
}

/// κ and σ from the matrices Q_a = Q(e_a, ·). Q(u, v) = (Σ u_a Q_a)v, and ‖Σ u_a Q_a‖ is at most ‖u‖ times the norm of all Q_a
/// side by side, or one above the other: the root of the largest eigenvalue of Σ Q_a Q_aᵀ, or of Σ Q_aᵀQ_a.
fn sizes<const N: usize>(slices: &[[[f64; N]; N]; N]) -> (f64, f64) {
    let (mut beside, mut above, mut symmetric) = ([[0.0; N]; N], [[0.0; N]; N], [[0.0; N]; N]);
    for q in slices {
        for i in 0..N {
            for j in 0..N {
                for m in 0..N {
                    beside[i][j] += q[i][m] * q[j][m];
                    above[i][j] += q[m][i] * q[m][j];
                    symmetric[i][j] += (q[i][m] + q[m][i]) * (q[j][m] + q[m][j]);
                }
            }
        }
    }
    let [beside, above, symmetric] = [beside, above, symmetric].map(|matrix| up(f64::sqrt(spectral(&matrix))));
    (beside.min(above), symmetric)
}

/// A Taylor polynomial, by rows.
#[derive(Clone, Debug)]
pub struct Series<S, const N: usize> {
    /// The first coefficients.
    pub exact: [Vec<S>; N],
    /// All coefficients; those that are also among the first are rounded.
    pub doubles: [Vec<f64>; N],
}

impl<S: Scalar, const N: usize> QuadraticField<S, N> {
    /// The equations in a precision.
    #[must_use]
    pub fn new(equations: &Equations, precision: S::Precision, accuracy: f64) -> Self {
        let mut field = Self {
            precision,
            accuracy: accuracy.max(S::unit(precision)),
            pairs: Vec::new(),
            quadratic: Vec::new(),
            linear: Vec::new(),
            kappa: 0.0,
            sigma: 0.0,
            kappa_terms: 0.0,
            lambda: 0.0,
            depth: 0.0,
            width: 0.0,
        };
        let (mut slices, mut rows, mut counts, mut widths) = ([[[0.0; N]; N]; N], [0.0; N], [0.0; N], [0.0; N]);
        let double = |c: &RBig| c.to_f64().value();
        for (row, a, b, c) in &equations.quadratic {
            let (row, a, b, double) = (*row, *a, *b, double(c));
            let pair = field.pairs.iter().position(|pair| *pair == [a, b]).unwrap_or_else(|| {
                field.pairs.push([a, b]);
                field.pairs.len() - 1
            });
            slices[a][row][b] += 0.5 * double;
            slices[b][row][a] += 0.5 * double;
            rows[row] += double.abs();
            counts[row] += 1.0;
            widths[row] += 2.0;
            field.quadratic.push(Quadratic { row, a, b, pair, exact: S::rational(c, precision), double });
        }
        let mut linear = [[0.0; N]; N];
        for (row, a, c) in &equations.linear {
            linear[*row][*a] = double(c).abs();
            counts[*row] += 1.0;
            widths[*row] += 1.0;
            field.linear.push(Linear { row: *row, a: *a, exact: S::rational(c, precision), double: double(c) });
        }
        (field.kappa, field.sigma) = sizes(&slices);
        field.kappa_terms = crate::bound::norm(&rows);
        field.lambda = frobenius(&linear);
        field.width = widths.iter().fold(0.0, |most: f64, width| most.max(*width));
        field.depth = counts.iter().fold(0.0, |most: f64, count| most.max(*count)) + 6.0;
        field
    }

    /// The Taylor coefficients x_0 … x_order of the motion through a point, x_k = x⁽ᵏ⁾/k!: those up to x_exact in S, those
    /// beyond, which are multiplied by small powers of time, in doubles.
    #[must_use]
    pub fn series(&self, start: &[S; N], exact: usize, order: usize) -> Series<S, N> {
        let precision = self.precision;
        let mut x: [Vec<S>; N] = std::array::from_fn(|i| vec![start[i].clone()]);
        let mut products = Vec::with_capacity(self.pairs.len());
        for (k, divisor) in (0..exact).zip(1..) {
            products.clear();
            products.extend(self.pairs.iter().map(|[a, b]| {
                let terms = x[*a].iter().zip(x[*b].iter().rev());
                let products = terms.map(|(u, v)| u.times(v, precision));
                products.reduce(|sum, term| sum.plus(&term, precision)).unwrap_or_else(|| start[0].clone())
            }));
            let mut next: [Option<S>; N] = std::array::from_fn(|_| None);
            let mut add = |row: usize, term: S| {
                next[row] = Some(match next[row].take() {
                    Some(sum) => sum.plus(&term, precision),
                    None => term,
                });
            };
            for term in &self.quadratic {
                add(term.row, term.exact.times(&products[term.pair], precision));
            }
            for term in &self.linear {
                add(term.row, term.exact.times(&x[term.a][k], precision));
            }
            for (x, next) in x.iter_mut().zip(next) {
                x.push(next.unwrap_or_else(|| S::double(0.0, precision)).over(divisor, precision));
            }
        }
        let mut doubles = x.each_ref().map(|row| row.iter().map(S::to_double).collect::<Vec<f64>>());
        let mut products = vec![0.0; self.pairs.len()];
        for k in exact..order {
            for (product, [a, b]) in products.iter_mut().zip(&self.pairs) {
                *product = doubles[*a].iter().zip(doubles[*b].iter().rev()).map(|(u, v)| u * v).sum::<f64>();
            }
            let mut next = [0.0; N];
            for term in &self.quadratic {
                next[term.row] += term.double * products[term.pair];
            }
            for term in &self.linear {
                next[term.row] += term.double * doubles[term.a][k];
            }
            for (row, next) in doubles.iter_mut().zip(next) {
                row.push(next / (k + 1) as f64);
            }
        }
        Series { exact: x, doubles }
    }

    /// Bounds of the roundings in (k + 1) x_{k+1} for k = 0, 1, … below `count`, in units of the arithmetic: more operations than
    /// follow each product, times the sum of the absolute values of the terms.
    #[must_use]
    pub fn roundings(&self, doubles: &[Vec<f64>; N], count: usize) -> Vec<f64> {
        let mut depth = [7.0; N];
        for row in self.quadratic.iter().map(|term| term.row).chain(self.linear.iter().map(|term| term.row)) {
            depth[row] += 1.0;
        }
        let of_order = |k: usize| {
            let mut sums = [0.0; N];
            for term in &self.quadratic {
                let product = |j: usize| (doubles[term.a][j] * doubles[term.b][k - j]).abs();
                sums[term.row] += term.double.abs() * (0..=k).map(product).sum::<f64>();
            }
            for term in &self.linear {
                sums[term.row] += (term.double * doubles[term.a][k]).abs();
            }
            crate::bound::norm(&std::array::from_fn::<f64, N, _>(|i| (k as f64 + depth[i]) * sums[i]))
        };
        (0..count).map(of_order).collect()
    }

    /// f over a box.
    #[must_use]
    pub fn enclosed(&self, x: &[Interval; N]) -> [Interval; N] {
        let mut f = [Interval::ZERO; N];
        for term in &self.quadratic {
            f[term.row] = f[term.row] + Interval::rounded(term.double) * x[term.a] * x[term.b];
        }
        for term in &self.linear {
            f[term.row] = f[term.row] + Interval::rounded(term.double) * x[term.a];
        }
        f
    }

    /// Df at a point, in doubles.
    #[must_use]
    pub fn jacobian(&self, x: &[f64; N]) -> [[f64; N]; N] {
        let mut matrix = [[0.0; N]; N];
        for term in &self.quadratic {
            matrix[term.row][term.a] += term.double * x[term.b];
            matrix[term.row][term.b] += term.double * x[term.a];
        }
        for term in &self.linear {
            matrix[term.row][term.a] += term.double;
        }
        matrix
    }

    /// The coefficients V_0 … V_order of a solution of V̇ = Df(x(t)) V, V(0) = 1, in doubles; `x` are those of x(t), by rows.
    #[must_use]
    pub fn variation(&self, x: &[Vec<f64>; N], order: usize) -> Vec<[[f64; N]; N]> {
        // The entries of Df that are not zero, by rows, as series in time.
        let mut entries: [Vec<(usize, Vec<f64>)>; N] = std::array::from_fn(|_| Vec::with_capacity(N));
        let mut add = |row: usize, column: usize, factor: f64, of: &[f64]| {
            let row = &mut entries[row];
            let at = row.iter().position(|(known, _)| *known == column).unwrap_or_else(|| {
                row.push((column, vec![0.0; order]));
                row.len() - 1
            });
            for (sum, x) in row[at].1.iter_mut().zip(of) {
                *sum += factor * x;
            }
        };
        for term in &self.quadratic {
            add(term.row, term.a, term.double, &x[term.b]);
            add(term.row, term.b, term.double, &x[term.a]);
        }
        for term in &self.linear {
            add(term.row, term.a, term.double, &[1.0]);
        }
        let mut identity = [[0.0; N]; N];
        for (i, row) in identity.iter_mut().enumerate() {
            row[i] = 1.0;
        }
        let mut series = vec![identity];
        for k in 0..order {
            let factor = 1.0 / (k + 1) as f64;
            let mut next = [[0.0; N]; N];
            for (next, entries) in next.iter_mut().zip(&entries) {
                let mut sum = [0.0; N];
                for (column, entry) in entries {
                    for (factor, v) in entry.iter().zip(series.iter().rev()) {
                        for (sum, v) in sum.iter_mut().zip(&v[*column]) {
                            *sum += factor * v;
                        }
                    }
                }
                *next = sum.map(|x| factor * x);
            }
            series.push(next);
        }
        series
    }
}
