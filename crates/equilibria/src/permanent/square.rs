//! Squares of directions, each containing exactly one steady rotation of every part of a box.
//!
//! With g = −up + x e + y f, where e and f lie across, a steady rotation is a zero of ⟨v × g, e⟩ and ⟨v × g, f⟩,
//! v = s A g + |g| r. Krawczyk's operator shows that a square of (x, y) holds exactly one zero for every part of the box and
//! every spin of an interval; Theorem 13.1 of docs/mathematics.md gives its type over that square (Proposition 13.8).

use bifdiag_numbers::enclosure::{Arithmetic, Enclosure};
use bifdiag_numbers::interval::Interval;
use bifdiag_numbers::vector::{self, normalised};
use bifdiag_schema::SpinType;

/// Three numbers known as intervals.
pub type Vector = [Interval; 3];

/// The tensor about the fixed point and r, of inputs within a box.
#[derive(Clone, Copy, Debug)]
pub struct BoxedBody {
    /// A, symmetric.
    pub tensor: [Vector; 3],
    /// r.
    pub center: Vector,
}

/// Steady rotations tilted by more than about this, in radians, are not called near.
const NEAR: f64 = 0.1;

impl BoxedBody {
    fn times(&self, v: &Vector) -> Vector {
        [0, 1, 2].map(|k| dot(&self.tensor[k], v))
    }
}

/// The type that all boxes share, and the largest tilt.
pub(super) fn kind_of_all(
    boxes: &[BoxedBody],
    basis: &[[f64; 3]; 3],
    s: Interval,
    weight: Interval,
) -> Option<(SpinType, f64)> {
    let mut shared: Option<(SpinType, f64)> = None;
    for body in boxes {
        let rotation = rotation(body, basis, s, weight)?;
        let kind = rotation.kind(s, weight)?;
        let tilt = match shared {
            Some((other, _)) if other != kind => return None,
            Some((_, tilt)) => tilt.max(rotation.tilt),
            None => rotation.tilt,
        };
        shared = Some((kind, tilt));
    }
    shared
}

/// The square that holds exactly one steady rotation of every part of a box.
fn rotation<'a>(body: &'a BoxedBody, basis: &'a [[f64; 3]; 3], s: Interval, weight: Interval) -> Option<Rotation<'a>> {
    let middle = Square { body, basis, half: 0.0 };
    let value = middle.value(s, weight);
    let inverse = inverse(middle.jacobian(s, weight))?;
    let step = apply(&inverse, value).map(Interval::magnitude);
    for inflation in [1.5, 4.0] {
        let half = inflation * step[0].max(step[1]) + 1e-15;
        if half.is_nan() || half > NEAR {
            return None;
        }
        let square = Square { half, ..middle };
        let jacobian = square.jacobian(s, weight);
        let inside = (0..2).all(|i| {
            // −Y F(0) + (1 − Y J) X
            let rest: f64 = (0..2)
                .map(|j| {
                    let product = Interval::point(inverse[i][0]) * jacobian[0][j]
                        + Interval::point(inverse[i][1]) * jacobian[1][j];
                    let unit = if i == j { Interval::point(1.0) } else { Interval::ZERO };
                    ((unit - product) * Interval::point(half)).magnitude()
                })
                .map(f64::next_up)
                .sum();
            (step[i] + rest).next_up().next_up() < half
        });
        if inside {
            return Some(Rotation { square, tilt: 1.001 * std::f64::consts::SQRT_2 * half });
        }
    }
    None
}

/// Points g = −up + x e + y f with |x| and |y| up to `half`.
#[derive(Clone, Copy)]
struct Square<'a> {
    body: &'a BoxedBody,
    basis: &'a [[f64; 3]; 3],
    half: f64,
}

impl Square<'_> {
    fn point(&self) -> Vector {
        let either = Interval::between(-self.half, self.half);
        let [n, e, f] = self.basis.map(|v| v.map(Interval::point));
        [0, 1, 2].map(|k| n[k] + either * e[k] + either * f[k])
    }

    /// s A g + |g| r, r scaled.
    fn force(&self, g: &Vector, s: Interval, weight: Interval) -> Vector {
        let (length, turned) = (dot(g, g).sqrt(), self.body.times(g));
        [0, 1, 2].map(|k| s * turned[k] + weight * length * self.body.center[k])
    }

    fn value(&self, s: Interval, weight: Interval) -> [Interval; 2] {
        let g = self.point();
        let normal = cross(&self.force(&g, s, weight), &g);
        [1, 2].map(|k| dot(&normal, &self.basis[k].map(Interval::point)))
    }

    fn jacobian(&self, s: Interval, weight: Interval) -> [[Interval; 2]; 2] {
        let g = self.point();
        let (force, length) = (self.force(&g, s, weight), dot(&g, &g).sqrt());
        let across = [1, 2].map(|k| self.basis[k].map(Interval::point));
        let columns = across.map(|e| {
            let (turned, longer) = (self.body.times(&e), dot(&g, &e) / length);
            let change = [0, 1, 2].map(|k| s * turned[k] + weight * longer * self.body.center[k]);
            let (first, second) = (cross(&change, &g), cross(&force, &e));
            let normal = [0, 1, 2].map(|k| first[k] + second[k]);
            across.map(|f| dot(&normal, &f))
        });
        [[columns[0][0], columns[1][0]], [columns[0][1], columns[1][1]]]
    }
}

/// A square that holds exactly one steady rotation of every part.
struct Rotation<'a> {
    square: Square<'a>,
    tilt: f64,
}

impl Rotation<'_> {
    /// The type by the signs of K, b and b² − 4c; `None` where one is open.
    fn kind(&self, s: Interval, weight: Interval) -> Option<SpinType> {
        let Square { body, basis, .. } = self.square;
        let g = self.square.point();
        let length = dot(&g, &g).sqrt();
        let gamma = g.map(|x| x / length);
        let turned = body.times(&gamma);
        let j = dot(&gamma, &turned);
        let multiplier = s * j + weight * dot(&gamma, &body.center);
        // An orthonormal basis across γ.
        let e = basis[1].map(Interval::point);
        let along = dot(&e, &gamma);
        let across = [0, 1, 2].map(|i| e[i] - along * gamma[i]);
        let size = dot(&across, &across).sqrt();
        let first = across.map(|x| x / size);
        let across = [first, cross(&gamma, &first)];
        let tangential = across.each_ref().map(|e| dot(e, &turned));
        // K, and S with M⁻¹ = S/det S: by Theorem 13.1 M is the adjugate of A′ − aaᵀ/J.
        let form = |p: usize, q: usize| {
            let turned = dot(&across[p], &body.times(&across[q]));
            let coupled = tangential[p] * tangential[q] / j;
            let unit = if p == q { multiplier } else { Interval::ZERO };
            [unit - s * turned + (s * coupled).twice().twice(), turned - coupled, turned]
        };
        let ([k11, s11, a11], [k12, s12, a12], [k22, s22, a22]) = (form(0, 0), form(0, 1), form(1, 1));
        match ((k11 * k22 - k12.square()).is_positive()?, k11.is_positive()) {
            (false, _) => return Some(SpinType::SaddleCentre),
            (true, Some(true)) => return Some(SpinType::Minimum),
            (true, None) => return None,
            (true, Some(false)) => {}
        }
        // tr A − 2 |Aγ|²/J with the trace t of P = A′, d = |a|²/J and c = ⟨a, Pa⟩/J.
        let [x, y] = tangential;
        let (trace, d) = (a11 + a22, (x.square() + y.square()) / j);
        let c = (x.square() * a11 + (x * y * a12).twice() + y.square() * a22) / j;
        let gyroscopic = s * (trace - j - d.twice()).square();
        // g² + 2 tr SK, in which most of both cancels: s (J² − (P₁₁ − P₂₂)² − 4 P₁₂² + 2Jd − 4td − 4d² + 10c) + 2⟨γ, r⟩(t − d).
        let small = (j * d).twice() - (trace * d + d.square()).twice().twice() + c * Interval::point(10.0);
        let turning = s * (j.square() - (a11 - a22).square() - a12.square().twice().twice() + small);
        let excess = turning + (weight * dot(&gamma, &body.center) * (trace - d)).twice();
        // S K
        let product = [[s11 * k11 + s12 * k12, s11 * k12 + s12 * k22], [s12 * k11 + s22 * k12, s12 * k12 + s22 * k22]];
        // b² − 4c times (det S)², with (tr)² − 4 det = (p − v)² + 4 q u, which is small where both pairs are alike.
        let discriminant = gyroscopic * excess
            + (product[0][0] - product[1][1]).square()
            + (product[0][1] * product[1][0]).twice().twice();
        // 2b det S = g² + (g² + 2 tr SK)
        match (discriminant.is_positive()?, (gyroscopic + excess).is_positive()) {
            (false, _) => Some(SpinType::Complex),
            (true, Some(true)) => Some(SpinType::Elliptic),
            (true, Some(false)) => Some(SpinType::Saddle),
            (true, None) => None,
        }
    }
}

/// The inverse of the middle of a matrix, rounded.
fn inverse(matrix: [[Interval; 2]; 2]) -> Option<[[f64; 2]; 2]> {
    let [[a, b], [c, d]] = matrix.map(|row| row.map(|x| x.middle().lo));
    let determinant = a * d - b * c;
    let inverse = [[d, -b], [-c, a]].map(|row| row.map(|x| x / determinant));
    inverse.iter().flatten().all(|x| x.is_finite()).then_some(inverse)
}

fn apply(matrix: &[[f64; 2]; 2], v: [Interval; 2]) -> [Interval; 2] {
    matrix.map(|row| Interval::point(row[0]) * v[0] + Interval::point(row[1]) * v[1])
}

fn dot(v: &Vector, w: &Vector) -> Interval {
    v[0] * w[0] + v[1] * w[1] + v[2] * w[2]
}

fn cross(v: &Vector, w: &Vector) -> Vector {
    [v[1] * w[2] - v[2] * w[1], v[2] * w[0] - v[0] * w[2], v[0] * w[1] - v[1] * w[0]]
}

/// −up and two directions across, all of about unit length.
pub(super) fn basis(up: [f64; 3]) -> [[f64; 3]; 3] {
    let n = normalised(up.map(|x| -x));
    let least = if n[0].abs() <= n[1].abs().min(n[2].abs()) {
        [1.0, 0.0, 0.0]
    } else if n[1].abs() <= n[2].abs() {
        [0.0, 1.0, 0.0]
    } else {
        [0.0, 0.0, 1.0]
    };
    let e = normalised(vector::cross(n, least));
    [n, e, vector::cross(n, e)]
}
