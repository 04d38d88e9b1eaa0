//! The closed form of the characteristic polynomial against the eigenvalues of the whole linearisation.

mod whole;

use bifdiag_body::{Body, Frame};
use bifdiag_equilibria::stability::{Constants, LinearType, Reduced, State};
use bifdiag_numbers::enclosure::Enclosure;
use bifdiag_numbers::interval::Interval;

/// Steele, Lea and Flood's SplitMix64.
struct Random(u64);

impl Random {
    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        low + (high - low) * (((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64)
    }
}

fn frame(a: [f64; 3], r: [f64; 3]) -> Frame {
    Body::from_f64(a, r).unwrap().frame()
}

/// γ in the frame, Ω and λ/Ω² = μ less the moments of the frame.
struct Point {
    gamma: [f64; 3],
    omega: f64,
    tau: [f64; 3],
}

impl Point {
    fn moment(&self, frame: &Frame) -> f64 {
        (0..3).map(|j| frame.a[j] * self.gamma[j] * self.gamma[j]).sum()
    }
}

/// Any γ, Ω and λ are a relative equilibrium of the body with r = λγ − sAγ.
fn random_equilibrium(random: &mut Random) -> (Frame, Point) {
    let a: [f64; 3] = std::array::from_fn(|_| random.between(0.2, 2.0));
    let gamma = loop {
        let v: [f64; 3] = std::array::from_fn(|_| random.between(-1.0, 1.0));
        let norm = v.iter().map(|x| x * x).sum::<f64>().sqrt();
        if norm > 0.1 && norm < 1.0 {
            break v.map(|x| x / norm);
        }
    };
    let omega = random.between(0.1, 2.0);
    let lambda = random.between(-4.0, 4.0);
    let r = std::array::from_fn(|j| (lambda - omega * omega * a[j]) * gamma[j]);
    let frame = frame(a, r);
    let (gamma, omega) = (frame.vector_from_body(gamma), omega / frame.frequency_unit);
    // (μ − A_j)γ_j = r_j/Ω²: the smallest of them fixes μ.
    let ratio = |j: usize| frame.r[j] / (gamma[j] * omega * omega);
    let base = (0..3).min_by(|&i, &j| ratio(i).abs().total_cmp(&ratio(j).abs())).unwrap();
    let tau = frame.diff[base].map(|difference| ratio(base) + difference);
    (frame, Point { gamma, omega, tau })
}

/// Eigenvalues of the Hessian of U_l on the tangent plane, from a basis of the plane.
fn hessian_index(frame: &Frame, point: &Point) -> (u8, f64) {
    let gamma = point.gamma;
    let cross =
        |x: [f64; 3], y: [f64; 3]| [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]];
    let dot = |x: [f64; 3], y: [f64; 3]| x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
    let least = (0..3).min_by(|&i, &j| gamma[i].abs().total_cmp(&gamma[j].abs())).unwrap();
    let mut axis = [0.0; 3];
    axis[least] = 1.0;
    let first = cross(gamma, axis);
    let first = first.map(|x| x / dot(first, first).sqrt());
    let second = cross(gamma, first);
    let a_gamma: [f64; 3] = std::array::from_fn(|j| frame.a[j] * gamma[j]);
    let j_gamma = dot(gamma, a_gamma);
    let s = point.omega * point.omega;
    // λ from sAγ + r = λγ.
    let lambda = s * j_gamma + dot(frame.r, gamma);
    let entry = |x: [f64; 3], y: [f64; 3]| {
        let ax: [f64; 3] = std::array::from_fn(|j| frame.a[j] * x[j]);
        lambda * dot(x, y) - s * dot(ax, y) + 4.0 * s / j_gamma * dot(a_gamma, x) * dot(a_gamma, y)
    };
    let (p, q, t) = (entry(first, first), entry(first, second), entry(second, second));
    let root = (0.25 * (p - t) * (p - t) + q * q).sqrt();
    let pair = [0.5 * (p + t) - root, 0.5 * (p + t) + root];
    (pair.iter().map(|&x| u8::from(x < 0.0)).sum(), pair[0].abs().min(pair[1].abs()))
}

/// The reduced flow and the Morse index, from the numbers of the equilibrium as they are.
fn reduced(frame: &Frame, point: &Point) -> (Reduced<Interval>, Option<u8>) {
    let s = point.omega * point.omega;
    let near = |x: f64| Interval::point(x).widened(8.0);
    let constants = Constants::rounded(frame);
    let state = State {
        w: point.gamma.map(|g| near(g * g)),
        gamma: point.gamma.map(near),
        tau: point.tau.map(near),
        j: near(point.moment(frame)),
        s: near(s),
    };
    let reduced = Reduced::new(&constants, &state);
    let index = reduced.index(state.hessian_trace(&constants).sign());
    (reduced, index)
}

#[test]
fn the_closed_form_has_the_eigenvalues_of_the_whole_linearisation() {
    let mut random = Random(6);
    let mut seen = std::collections::HashMap::new();
    let size = |re: f64, im: f64| (re * re + im * im).sqrt();
    for _ in 0..4000 {
        let (frame, point) = random_equilibrium(&mut random);
        let whole = whole::spectrum(&whole::matrix(&frame, point.gamma, point.omega));
        let scale = whole.iter().map(|x| x.norm()).fold(0.0, f64::max);
        let (index, gap) = hessian_index(&frame, &point);
        let (reduced, found) = reduced(&frame, &point);
        if gap > 1e-9 * scale * scale {
            assert_eq!(found, Some(index));
        }
        let Some(kind) = reduced.linear_type() else { continue };
        *seen.entry(kind.word()).or_insert(0) += 1;
        assert_eq!(kind == LinearType::SaddleCentre, index == 1);
        let found = reduced.eigenvalues(kind, false, 1.0);
        // The six are ±λ₁, ±λ₂ (with conjugates) and 0 twice; double eigenvalues are known to the root of rounding.
        let tolerance = 1e-10 * scale + found.error;
        for [re, im] in found.pairs {
            for signs in [[1.0, 1.0], [-1.0, -1.0], [1.0, -1.0], [-1.0, 1.0]] {
                let root = nalgebra::Complex::new(signs[0] * re, signs[1] * im);
                let nearest = whole.iter().map(|x| (x - root).norm()).fold(f64::INFINITY, f64::min);
                let close =
                    found.pairs.iter().any(|[p, q]| size(p - re, q - im) < 1e-3 * scale && [*p, *q] != [re, im]);
                let allowed = if close || size(re, im) < 1e-3 * scale { 1e-5 * scale } else { tolerance };
                assert!(nearest < allowed, "{kind} {root} {whole:?} {:e}", found.error);
            }
        }
    }
    assert_eq!(seen.len(), 4, "{seen:?}");
    assert!(seen.values().all(|&count| count > 50) && seen.values().sum::<i32>() > 3900, "{seen:?}");
}
