//! What one would do with a general tool: polynomials in μ in the monomial basis, their roots as eigenvalues of the
//! companion matrix. With D = Π(μ − A_i), P = p/D², Q = q/D²: relative equilibria at l are the roots of l⁴p³D² − q⁴,
//! cusps those of 4(q'D − 2qD')p − 3(p'D − 2pD')q.

use bifdiag_body::Body;

type Polynomial = Vec<f64>;

fn product(a: &[f64], b: &[f64]) -> Polynomial {
    let mut c = vec![0.0; a.len() + b.len() - 1];
    for (i, x) in a.iter().enumerate() {
        for (j, y) in b.iter().enumerate() {
            c[i + j] += x * y;
        }
    }
    c
}

fn sum(a: &[f64], s: f64, b: &[f64]) -> Polynomial {
    (0..a.len().max(b.len())).map(|k| a.get(k).unwrap_or(&0.0) + s * b.get(k).unwrap_or(&0.0)).collect()
}

fn derivative(a: &[f64]) -> Polynomial {
    a.iter().enumerate().skip(1).map(|(k, c)| k as f64 * c).collect()
}

/// D, p and q, lowest coefficient first.
struct Family {
    a: [f64; 3],
    r: [f64; 3],
    d: Polynomial,
    p: Polynomial,
    q: Polynomial,
}

impl Family {
    fn new(body: &Body) -> Self {
        let (a, r) = (body.moments_f64(), body.center_f64());
        let factor = |k: usize| [-a[k], 1.0];
        let d = product(&product(&factor(0), &factor(1)), &factor(2));
        let (mut p, mut q) = (vec![0.0], vec![0.0]);
        for k in 0..3 {
            let others = product(&factor((k + 1) % 3), &factor((k + 2) % 3));
            let square = product(&others, &others);
            p = sum(&p, r[k] * r[k], &square);
            q = sum(&q, a[k] * r[k] * r[k], &square);
        }
        Self { a, r, d, p, q }
    }

    fn height(&self, mu: f64) -> f64 {
        let total = |f: fn(f64, f64, f64) -> f64| {
            (0..3).map(|k| f(self.a[k], self.r[k] * self.r[k], mu - self.a[k])).sum::<f64>()
        };
        let (p, q, r) = (total(|_, w, d| w / (d * d)), total(|a, w, d| a * w / (d * d)), total(|_, w, d| w / d));
        (0.5 * q - r) / p.sqrt()
    }
}

/// Roots whose imaginary part is at most `real` of their size; `None` when the QR iteration does not converge.
fn real_roots(c: &[f64], real: f64) -> Option<Vec<f64>> {
    let n = c.len() - 1;
    let matrix = faer::Mat::from_fn(n, n, |row, column| {
        let shifted = if row == column + 1 { 1.0 } else { 0.0 };
        if column == n - 1 { shifted - c[row] / c[n] } else { shifted }
    });
    if (0..n).any(|row| !(c[row] / c[n]).is_finite()) {
        return None;
    }
    let roots = matrix.eigenvalues().ok()?;
    Some(roots.into_iter().filter(|z| z.im.abs() <= real * z.re.abs()).map(|z| z.re).collect())
}

/// How many relative equilibria lie below h at l.
pub fn equilibria_below(body: &Body, h: f64, l: f64, real: f64) -> Option<usize> {
    let family = Family::new(body);
    let p3d2 = product(&product(&family.p, &product(&family.p, &family.p)), &product(&family.d, &family.d));
    let q2 = product(&family.q, &family.q);
    let momentum = l * l * l * l;
    let scaled: Polynomial = p3d2.iter().map(|c| momentum * c).collect();
    let roots = real_roots(&sum(&scaled, -1.0, &product(&q2, &q2)), real)?;
    Some(roots.iter().filter(|&&mu| family.height(mu) < h).count())
}

/// How many cusps each of the four intervals of μ holds.
pub fn cusps(body: &Body, real: f64) -> Option<[usize; 4]> {
    let family = Family::new(body);
    let Family { d, p, q, .. } = &family;
    let reduced = |f: &[f64]| sum(&product(&derivative(f), d), -2.0, &product(f, &derivative(d)));
    let first: Polynomial = product(&reduced(q), p).iter().map(|c| 4.0 * c).collect();
    let roots = real_roots(&sum(&first, -3.0, &product(&reduced(p), q)), real)?;
    let mut counts = [0; 4];
    for mu in roots {
        counts[family.a.iter().filter(|&&a| a < mu).count()] += 1;
    }
    Some(counts)
}
