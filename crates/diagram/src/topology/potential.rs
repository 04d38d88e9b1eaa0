//! The effective potential in the variable x = l²/2.

use bifdiag_body::Frame;
use bifdiag_numbers::UNIT_ROUNDOFF;
use bifdiag_numbers::vector::{cross, dot, normalised};

/// U(γ) = x/J(γ) − ⟨γ, r⟩ on the Poisson sphere of a body.
#[derive(Clone, Copy, Debug)]
pub(super) struct Potential<'a> {
    pub frame: &'a Frame,
    /// x = l²/2.
    pub x: f64,
}

pub(super) type Vector = [f64; 3];

pub(super) fn combination(a: f64, u: Vector, b: f64, v: Vector) -> Vector {
    [a * u[0] + b * v[0], a * u[1] + b * v[1], a * u[2] + b * v[2]]
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
    /// With S = L²/8 · max(−d²U/dt²) on an arc of length L, U lies below its chord plus 4S u(1 − u), 0 ≤ u ≤ 1; where
    /// the end values differ by D that exceeds the larger one by at most (4S − D)²/(16S), and not at all when D ≥ 4S
    /// (Lemma 9.3 of docs/algorithms.md). The arc is halved until that bound suffices or a point above the level shows
    /// up.
    pub fn arc_stays_below(&self, from: Vector, to: Vector, level: f64) -> bool {
        const MAX_DEPTH: u32 = 8;
        let ends = [self.value(from), self.value(to)];
        ends[0].max(ends[1]) <= level && dot(from, to) > 0.0 && self.stays_below([from, to], ends, level, MAX_DEPTH)
    }

    fn stays_below(&self, arc: [Vector; 2], ends: [f64; 2], level: f64, depth: u32) -> bool {
        let sag = self.sag(arc[0], arc[1]);
        let excess = (4.0 * sag - (ends[0] - ends[1]).abs()).max(0.0);
        let rise = if excess > 0.0 { excess * excess / (16.0 * sag) } else { 0.0 };
        if ends[0].max(ends[1]) + rise <= level {
            return true;
        }
        let middle = normalised(combination(0.5, arc[0], 0.5, arc[1]));
        let value = self.value(middle);
        depth > 0
            && value <= level
            && self.stays_below([arc[0], middle], [ends[0], value], level, depth - 1)
            && self.stays_below([middle, arc[1]], [value, ends[1]], level, depth - 1)
    }

    /// Bound on how far U rises above its chord on a great-circle arc shorter than 90°: L²/8 times a bound on −d²U/dt².
    ///
    /// With J(t) = α + β cos 2t + κ sin 2t the third derivative of J is at most 8√(β²+κ²), and −d²U/dt² is at most
    /// x (d²J/dt²)/J² − ⟨γ, r⟩.
    fn sag(&self, from: Vector, to: Vector) -> f64 {
        let cosine = dot(from, to);
        let across = combination(1.0, to, -cosine, from);
        let sine = dot(across, across).sqrt();
        if sine == 0.0 {
            return 0.0;
        }
        // t ≤ tan t = sine/cosine for arcs below 90°.
        let length = sine / cosine;
        let tangent = across.map(|c| c / sine);
        let moment = self.inertia(from);
        let (j, j_tangent, mixed) = (dot(from, moment), dot(tangent, self.inertia(tangent)), dot(tangent, moment));
        let amplitude = (0.25 * (j - j_tangent) * (j - j_tangent) + mixed * mixed).sqrt();
        let bending = 2.0 * (j_tangent - j) + 8.0 * amplitude * length;
        // On the chord p between the ends J(p) is at least its smallest Bernstein coefficient, and |p|² ≥ (1 + cos)/2.
        let coefficients = [j, dot(to, moment), dot(to, self.inertia(to))];
        let shortest = 0.5 * (1.0 + cosine);
        let smallest = coefficients.iter().copied().fold(f64::INFINITY, f64::min);
        let largest = coefficients.iter().copied().fold(0.0, f64::max) / shortest;
        if smallest <= 0.0 {
            return f64::INFINITY;
        }
        let rho = dot(from, self.frame.r).min(dot(to, self.frame.r));
        let rho = if rho >= 0.0 { rho } else { rho / shortest.sqrt() };
        let divisor = if bending > 0.0 { smallest } else { largest };
        0.125 * length * length * (self.x * bending / (divisor * divisor) - rho).max(0.0)
    }
}
