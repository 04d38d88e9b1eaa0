//! The effective potential in the variable x = l²/2.

use crate::body::Frame;
use crate::numerics::UNIT_ROUNDOFF;

/// U(γ) = x/J(γ) − ⟨γ, r⟩ on the Poisson sphere of a body.
#[derive(Clone, Copy, Debug)]
pub(super) struct Potential<'a> {
    pub frame: &'a Frame,
    /// x = l²/2.
    pub x: f64,
}

pub(super) type Vector = [f64; 3];

pub(super) fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) fn combination(a: f64, u: Vector, b: f64, v: Vector) -> Vector {
    [a * u[0] + b * v[0], a * u[1] + b * v[1], a * u[2] + b * v[2]]
}

pub(super) fn normalised(v: Vector) -> Vector {
    let norm = dot(v, v).sqrt();
    v.map(|c| c / norm)
}

pub(super) fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

impl Potential<'_> {
    /// Aγ.
    pub fn inertia(&self, gamma: Vector) -> Vector {
        let a = self.frame.a;
        [a[0] * gamma[0], a[1] * gamma[1], a[2] * gamma[2]]
    }

    /// U(γ).
    pub fn value(&self, gamma: Vector) -> f64 {
        self.x / dot(gamma, self.inertia(gamma)) - dot(gamma, self.frame.r)
    }

    /// Bound on the rounding error of [`Self::value`].
    pub fn value_error(&self, gamma: Vector) -> f64 {
        let j = dot(gamma, self.inertia(gamma));
        24.0 * UNIT_ROUNDOFF * (self.x / j + self.frame.r_norm)
    }

    /// An orthonormal basis of the tangent plane at γ.
    pub fn tangent_basis(gamma: Vector) -> [Vector; 2] {
        let smallest = (0..3).min_by(|&i, &j| gamma[i].abs().total_cmp(&gamma[j].abs())).unwrap_or(0);
        let mut axis = [0.0; 3];
        axis[smallest] = 1.0;
        let first = normalised(cross(gamma, axis));
        [first, cross(gamma, first)]
    }

    /// Gradient and Hessian of U on S² in a tangent basis: with s = 2x/J², grad U = −(s Aγ + r) and
    /// Hess U = −s A + (8x/J³) Aγ(Aγ)ᵀ + ⟨γ, sAγ + r⟩, both projected.
    pub fn derivatives(&self, gamma: Vector, basis: [Vector; 2]) -> ([f64; 2], [[f64; 2]; 2]) {
        let moment = self.inertia(gamma);
        let j = dot(gamma, moment);
        let s = 2.0 * self.x / (j * j);
        let force = combination(s, moment, 1.0, self.frame.r);
        let normal = dot(gamma, force);
        let gradient = basis.map(|e| -dot(e, force));
        let projected = basis.map(|e| dot(e, moment));
        let entry = |p: usize, q: usize| {
            let identity = if p == q { normal } else { 0.0 };
            identity - s * dot(basis[p], self.inertia(basis[q])) + 4.0 * s / j * projected[p] * projected[q]
        };
        (gradient, [[entry(0, 0), entry(0, 1)], [entry(0, 1), entry(1, 1)]])
    }

    /// True when U ≤ `level` is proved along the great-circle arc between two points less than 90° apart.
    ///
    /// On a chord p(v) = (1−v)γ_a + vγ_b with n = |p| one has U = x n²/J(p) − ⟨p, r⟩/n; n² and J are quadratic, ⟨p, r⟩
    /// linear in v, so their Bernstein coefficients bound them; the chord is halved until the bound holds or a point
    /// above the level shows up.
    pub fn arc_stays_below(&self, from: Vector, to: Vector, level: f64) -> bool {
        const MAX_DEPTH: u32 = 7;
        dot(from, to) > 0.0 && self.chord_stays_below(from, to, level, MAX_DEPTH)
    }

    /// True when d²U/dt² > 0 is proved along the great-circle arc between two points, so that U is largest at an end.
    ///
    /// With J(t) = α + β cos 2t + κ sin 2t the third derivative of J is at most 8√(β²+κ²), and d²U/dt² is at least
    /// ⟨γ, r⟩ − x (d²J/dt²)/J².
    fn arc_is_convex(&self, from: Vector, to: Vector) -> bool {
        let cosine = dot(from, to);
        let across = combination(1.0, to, -cosine, from);
        let sine = dot(across, across).sqrt();
        if sine == 0.0 {
            return true;
        }
        // t ≤ tan t = sine/cosine for arcs below 90°.
        let length = sine / cosine;
        let tangent = across.map(|c| c / sine);
        let (j, moment) = (dot(from, self.inertia(from)), dot(tangent, self.inertia(tangent)));
        let mixed = dot(tangent, self.inertia(from));
        let amplitude = (0.25 * (j - moment) * (j - moment) + mixed * mixed).sqrt();
        let bending = 2.0 * (moment - j) + 8.0 * amplitude * length;
        let middle_moment = dot(from, self.inertia(to));
        let (end_moment, shortest) = (dot(to, self.inertia(to)), 0.5 * (1.0 + cosine));
        let smallest = j.min(middle_moment).min(end_moment);
        let largest = j.max(middle_moment).max(end_moment) / shortest;
        let rho = dot(from, self.frame.r).min(dot(to, self.frame.r));
        let rho = if rho >= 0.0 { rho } else { rho / shortest.sqrt() };
        let divisor = if bending > 0.0 { smallest } else { largest };
        smallest > 0.0 && rho - self.x * bending / (divisor * divisor) > 0.0
    }

    fn chord_stays_below(&self, from: Vector, to: Vector, level: f64, depth: u32) -> bool {
        let cosine = dot(from, to);
        let middle_moment = dot(from, self.inertia(to));
        let smallest_moment = dot(from, self.inertia(from)).min(middle_moment).min(dot(to, self.inertia(to)));
        let smallest_rho = dot(from, self.frame.r).min(dot(to, self.frame.r));
        // 1 ≥ n² ≥ (1 + cosine)/2 on the chord.
        let shortest = (0.5 * (1.0 + cosine)).sqrt();
        let potential = if smallest_rho >= 0.0 { -smallest_rho } else { -smallest_rho / shortest };
        if smallest_moment > 0.0 && self.x / smallest_moment + potential <= level {
            return true;
        }
        if self.value(from).max(self.value(to)) <= level && self.arc_is_convex(from, to) {
            return true;
        }
        let middle = normalised(combination(0.5, from, 0.5, to));
        if depth == 0 || self.value(middle) > level {
            return false;
        }
        self.chord_stays_below(from, middle, level, depth - 1) && self.chord_stays_below(middle, to, level, depth - 1)
    }
}
