//! The closed form of the characteristic polynomial against the eigenvalues of the whole linearisation.

use top::body::{Body, Frame};
use top::stability::Stability;
use top::stability::{Linearisation, RelativeEquilibrium, whole_spectrum};

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

/// Any γ, Ω and λ are a relative equilibrium of the body with r = λγ − sAγ.
fn random_equilibrium(random: &mut Random) -> (Frame, RelativeEquilibrium) {
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
    let turned = std::array::from_fn(|j| (0..3).map(|i| frame.to_body[i][j] * gamma[i]).sum());
    let equilibrium = RelativeEquilibrium::new(&frame, turned, omega / frame.frequency_unit);
    (frame, equilibrium)
}

/// Eigenvalues of the Hessian of U_l on the tangent plane, from a basis of the plane.
fn hessian_index(frame: &Frame, point: &RelativeEquilibrium) -> (u8, f64) {
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

#[test]
fn the_closed_form_has_the_eigenvalues_of_the_whole_linearisation() {
    let mut random = Random(6);
    let mut seen = std::collections::HashMap::new();
    let mut worst = 0.0f64;
    for _ in 0..4000 {
        let (frame, point) = random_equilibrium(&mut random);
        let linearisation = Linearisation::new(&frame, &point);
        let whole = whole_spectrum(&frame, &point).unwrap();
        let scale = whole.iter().map(|x| x.norm()).fold(0.0, f64::max);
        // λ²(λ⁴ + bλ² + c): b and c from power sums of all six eigenvalues.
        let powers = |n: i32| whole.iter().map(|x| x.powi(n)).sum::<nalgebra::Complex<f64>>();
        let (second, fourth) = (powers(2), powers(4));
        let b = -0.5 * second;
        let c = (0.125 * second * second) - 0.25 * fourth;
        worst = worst.max((b - linearisation.b).norm() / (scale * scale));
        worst = worst.max((c - linearisation.c).norm() / (scale * scale * scale * scale));
        // Double eigenvalues are known to the square root of rounding.
        for root in linearisation.eigenvalues() {
            let nearest = whole.iter().map(|x| (x - root).norm()).fold(f64::INFINITY, f64::min);
            assert!(nearest < 1e-5 * scale, "{root} {whole:?}");
        }
        let (index, gap) = hessian_index(&frame, &point);
        if gap > 1e-9 * scale * scale {
            assert_eq!(linearisation.index(), Some(index));
        }
        let far = |x: f64| x.abs() > 1e-4 * scale;
        let complex = whole.iter().any(|x| far(x.re) && far(x.im));
        let real = whole.iter().filter(|x| far(x.re) && !far(x.im)).count();
        let imaginary = whole.iter().filter(|x| far(x.im) && !far(x.re)).count();
        let expected = match (complex, real, imaginary) {
            (true, 0, 0) => Stability::Complex,
            (false, 2, 2) => Stability::SaddleCentre,
            (false, 4, 0) => Stability::Saddle,
            (false, 0, 4) => Stability::Elliptic,
            _ => continue,
        };
        // A quadruple close to an axis looks like two pairs to the rounded spectrum.
        if linearisation.discriminant().abs() > 1e-8 * scale * scale * scale * scale {
            assert_eq!(linearisation.stability(), expected, "{whole:?} {linearisation:?}");
            *seen.entry(format!("{expected:?}")).or_insert(0) += 1;
        }
    }
    assert!(worst < 1e-12, "{worst:e}");
    assert_eq!(seen.len(), 4, "{seen:?}");
    assert!(seen.values().all(|&count| count > 50) && seen.values().sum::<i32>() > 3500, "{seen:?}");
}

#[test]
fn index_one_has_exactly_one_real_pair() {
    let mut random = Random(7);
    let mut saddles = 0;
    for _ in 0..2000 {
        let (frame, point) = random_equilibrium(&mut random);
        let linearisation = Linearisation::new(&frame, &point);
        let saddle = linearisation.index() == Some(1);
        assert_eq!(saddle, linearisation.c < -linearisation.c_error);
        assert_eq!(saddle, linearisation.stability() == Stability::SaddleCentre);
        if saddle {
            saddles += 1;
            let roots = linearisation.eigenvalues();
            assert_eq!(roots.iter().filter(|x| x.im == 0.0 && x.re != 0.0).count(), 2);
            assert_eq!(roots.iter().filter(|x| x.re == 0.0 && x.im != 0.0).count(), 2);
        }
        if linearisation.index() == Some(0) {
            assert!(linearisation.discriminant() >= -linearisation.discriminant_error());
            assert!(linearisation.b > 0.0);
        }
    }
    assert!(saddles > 200);
}

fn on_axis(frame: &Frame, gamma: [f64; 3], l: f64) -> Linearisation {
    let moment: f64 = (0..3).map(|j| frame.a[j] * gamma[j] * gamma[j]).sum();
    Linearisation::new(frame, &RelativeEquilibrium::new(frame, gamma, l / moment))
}

#[test]
fn a_sleeping_lagrange_top_is_stable_above_l_squared_4_a1_r() {
    // Frame: moments (0.5, 1, 1) in units of 1 (a quarter of an exponent: none), r = 1.
    let frame = frame([1.0, 1.0, 0.5], [0.0, 0.0, 1.0]);
    assert_eq!([frame.energy_unit, frame.momentum_unit], [1.0, 1.0]);
    let (hanging, upright) = (frame.r_hat(), frame.r_hat().map(|x| -x));
    for l in [0.0, 0.3, 1.9, 1.999_999, 2.000_001, 5.0, 1e3] {
        assert_eq!(on_axis(&frame, hanging, l).stability(), Stability::Elliptic, "{l}");
        let expected = if l == 0.0 {
            // Both real pairs agree.
            Stability::Degenerate
        } else if l < 2.0 {
            Stability::Complex
        } else {
            Stability::Elliptic
        };
        assert_eq!(on_axis(&frame, upright, l).stability(), expected, "{l}");
        assert_eq!(on_axis(&frame, upright, l).index(), Some(2));
    }
    assert_eq!(on_axis(&frame, upright, 2.0).stability(), Stability::Degenerate);
}

#[test]
fn kovalevskaya_axis_rotations() {
    let frame = frame([2.0, 2.0, 1.0], [1.0, 0.0, 0.0]);
    assert_eq!([frame.energy_unit, frame.momentum_unit], [1.0, 1.0]);
    let upright = frame.r_hat().map(|x| -x);
    for l in [0.5, 1.0, 1.9, 2.1, 4.0, 40.0] {
        assert_eq!(on_axis(&frame, frame.r_hat(), l).stability(), Stability::Elliptic);
        assert_eq!(on_axis(&frame, upright, l).index(), Some(if l < 2.0 { 2 } else { 1 }));
    }
    assert_eq!(on_axis(&frame, upright, 2.0).index(), None);
}

#[test]
fn permanent_rotations_of_a_free_body_are_stable_about_the_largest_and_smallest_moment() {
    let frame = frame([1.0, 2.0, 3.0], [0.0; 3]);
    let expected = [(2, Stability::Elliptic), (1, Stability::SaddleCentre), (0, Stability::Elliptic)];
    for (axis, (index, stability)) in expected.into_iter().enumerate() {
        let mut gamma = [0.0; 3];
        gamma[axis] = 1.0;
        for l in [1e-3, 1.0, 1e6] {
            let linearisation = on_axis(&frame, gamma, l);
            assert_eq!(linearisation.index(), Some(index));
            assert_eq!(linearisation.stability(), stability);
            // λ² = −Ω² and −Ω²(A_k−A_i)(A_k−A_j)/(A_iA_j).
            let square = (l / frame.a[axis]) * (l / frame.a[axis]);
            let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
            let other = square * frame.diff[axis][i] * frame.diff[axis][j] / (frame.a[i] * frame.a[j]);
            assert!((linearisation.b - (square + other)).abs() < 1e-14 * (square + other.abs()));
            assert!((linearisation.c - square * other).abs() < 1e-14 * square * other.abs());
        }
    }
}
