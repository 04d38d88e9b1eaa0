//! Damping that conserves l: the eigenvalues of the whole damped linearisation against the index and the rates, and known
//! results on tops with friction.

mod whole;

use bifdiag_body::{Body, BodyAxis, Frame};
use bifdiag_equilibria::critical::{Equilibrium, Multiplicity, RelativeEquilibria};
use bifdiag_equilibria::nonlinear::{NonlinearVerdict, Reason};
use bifdiag_equilibria::permanent::AxisRotation;
use bifdiag_equilibria::stability::LinearType;
use bifdiag_numbers::vector::dot;
use bifdiag_numbers::{Number, Sign};
use nalgebra::Complex;
use support::property::{Verdict as Held, holds_for_bodies};
use support::strata::STRATA;

use proptest::prelude::*;

/// The eigenvalues of the flow at ω = Ωγ with the torque −δ(𝐥 − ⟨γ,𝐥⟩Aγ/J) added, in the frame's units.
fn damped(frame: &Frame, gamma: [f64; 3], omega: f64, damping: f64) -> Vec<Complex<f64>> {
    let mut matrix = whole::matrix(frame, gamma, omega);
    let lever: [f64; 3] = std::array::from_fn(|k| frame.a[k] * gamma[k]);
    let j = dot(lever, gamma);
    for column in 0..3 {
        for row in 0..3 {
            // d(⟨γ,𝐥⟩/J) = (⟨γ,δ𝐥⟩ − Ω⟨Aγ,δγ⟩)/J at 𝐥 = ΩAγ.
            let diagonal = if row == column { 1.0 } else { 0.0 };
            matrix[row + 3][column + 3] -= damping * (diagonal - lever[row] * gamma[column] / j);
            matrix[row + 3][column] += damping * omega * (frame.a[row] * diagonal - lever[row] * lever[column] / j);
        }
    }
    whole::spectrum(&matrix)
}

fn size_of([re, im]: [f64; 2]) -> f64 {
    (re * re + im * im).sqrt()
}

/// At strong damping eigenvalues are apart from zero, and as many grow as the index says; at weak damping they move at the
/// rates.
fn is_damped_as_said(frame: &Frame, found: &Equilibrium) -> Held {
    let gamma = frame.vector_from_body(found.gamma);
    let omega = found.omega.abs() / frame.frequency_unit;
    let pairs = found.eigenvalues.pairs.map(|pair| pair.map(|part| part / frame.frequency_unit));
    let size = pairs.as_flattened().iter().fold(0.0_f64, |size, part| size.max(*part));
    // Where moments differ by much, rounding of the matrix hides slow motions.
    if frame.a[0] < 0.05 * frame.a[2] {
        return Ok(());
    }
    let least = pairs.iter().map(|pair| size_of(*pair)).fold(f64::INFINITY, f64::min);
    // A sixfold eigenvalue would be known to the sixth root of rounding.
    if matches!(found.multiplicity, Multiplicity::Points(1)) && least > 0.1 * size {
        let growing = damped(frame, gamma, omega, size).iter().filter(|x| x.re > 1e-6 * size).count();
        prop_assert_eq!(growing, usize::from(found.friction.growing), "{:?}", found);
        prop_assert_eq!(found.friction.survives, Some(found.index == 0), "{:?}", found);
    }
    let apart = size_of([pairs[0][0] - pairs[1][0], pairs[0][1] - pairs[1][1]]) > 0.1 * size;
    if found.stability == LinearType::Elliptic && apart && least > 0.1 * size {
        let damping = 1e-5 * size;
        let spectrum = damped(frame, gamma, omega, damping);
        for ([_, im], rate) in pairs.into_iter().zip(found.friction.rates) {
            let near = spectrum.iter().min_by(|p, q| (p.im - im).abs().total_cmp(&(q.im - im).abs())).unwrap();
            let rate = rate.expect("a simple pair");
            let slope = near.re / damping;
            // Of second order in the damping, beside a gap of a tenth; and rounding.
            prop_assert!((slope - rate).abs() < 2e-3 * (1.0 + rate * rate), "{slope} {found:?}");
        }
    }
    Ok(())
}

#[test]
fn damping_leaves_as_many_growing_motions_as_the_index() {
    for stratum in STRATA {
        holds_for_bodies(stratum, 8, |body| {
            let frame = body.frame();
            let Ok(equilibria) = RelativeEquilibria::new(body) else { return Ok(()) };
            for factor in [0.4, 1.3, 3.0] {
                let l = Number::from_f64(factor * frame.momentum_unit).unwrap();
                let Ok(found) = equilibria.at(&l) else { continue };
                found.list.iter().try_for_each(|point| is_damped_as_said(&frame, point))?;
            }
            Ok(())
        });
    }
}

/// The pair of negative energy grows, the other one decays; both rates together are −1.
#[test]
fn at_index_two_one_pair_grows_with_damping() {
    let body = Body::parse(&["2", "1.1", "1"], &["0.9", "0.2", "0.6"]).unwrap();
    let equilibria = RelativeEquilibria::new(&body).unwrap();
    let mut seen = 0;
    for l in ["1", "2", "3", "4", "6"] {
        for point in equilibria.at(&l.parse().unwrap()).unwrap().list {
            if point.stability != LinearType::Elliptic {
                continue;
            }
            let [fast, slow] = point.friction.rates.map(|rate| rate.expect("a simple pair"));
            assert!((fast + slow + 1.0).abs() < 1e-9, "{point:?}");
            assert!(fast < 0.0 && (slow > 0.0) == (point.index == 2), "{point:?}");
            seen += usize::from(point.index == 2);
        }
    }
    assert!(seen >= 3, "{seen}");
}

/// The sleeping top survives friction iff A₃ > A₁ and l² > A₃²r/(A₃ − A₁); without friction it sleeps iff l² ≥ 4A₁r
/// (E. J. Routh, Advanced Rigid Dynamics; N. G. Chetaev 1954 by integrals; R. Krechetnikov and J. E. Marsden, Rev. Mod.
/// Phys. 79, 2007, on dissipation).
#[test]
fn the_sleeping_top_with_and_without_friction() {
    for (a1, a3, r) in [("1", "3/2", "1"), ("1", "1/2", "2"), ("2", "3", "1/3"), ("1", "1", "1")] {
        let body = Body::parse(&[a1, a1, a3], &["0", "0", r]).unwrap();
        let [a1, a3, r] = [a1, a3, r].map(|x| x.parse::<Number>().unwrap().to_f64());
        let top = AxisRotation::new(&body, BodyAxis::ALL[2], Sign::Negative).unwrap();
        let mut seen = [0; 2];
        for spin in 1..60 {
            let omega = dashu_ratio::RBig::from_parts(spin.into(), 7_u8.into());
            let l = a3 * f64::from(spin) / 7.0;
            let judged = top.stability_at_spin(&omega).unwrap();
            // At the threshold too, by the integral.
            let sleeps = l * l > 4.0 * a1 * r - 1e-12;
            assert_eq!(judged.nonlinear.verdict == NonlinearVerdict::Stable, sleeps, "{l} {judged:?}");
            let survives = a3 > a1 && l * l > a3 * a3 * r / (a3 - a1);
            assert_eq!(judged.friction.survives, Some(survives), "{l} {judged:?}");
            assert_eq!(judged.friction.growing, if survives { 0 } else { 2 });
            seen[usize::from(survives)] += 1;
        }
        assert!(seen[0] > 0 && (seen[1] > 0) == (a3 > a1), "{seen:?}");
    }
}

/// Euler's top: rotations about the largest and the smallest moment are stable by integrals, about the middle one not; of
/// these only rotation about the largest survives dissipation (R. N. Bracewell and O. K. Garriott, Nature 182, 1958).
#[test]
fn only_rotation_about_the_largest_moment_survives_without_weight() {
    let body = Body::parse(&["1", "2", "3"], &["0", "0", "0"]).unwrap();
    let judged = BodyAxis::ALL.map(|axis| {
        let rotation = AxisRotation::new(&body, axis, Sign::Positive).unwrap();
        rotation.stability_at_spin(&dashu_ratio::RBig::ONE).unwrap()
    });
    let found = judged.map(|found| (found.nonlinear.verdict, found.nonlinear.why, found.friction.survives));
    assert_eq!(found[0], (NonlinearVerdict::Stable, Reason::Integral, Some(false)));
    assert_eq!(found[1], (NonlinearVerdict::Unstable, Reason::Spectrum, Some(false)));
    assert_eq!(found[2], (NonlinearVerdict::Stable, Reason::Energy, Some(true)));
}

/// Rotation about a principal axis through the centre of mass, with the moment C about it and A, B across (V. V. Rumyantsev,
/// Prikl. Mat. Mekh. 20, 1956): sufficient for stability is that (C − A)Ω² + ρ and (C − B)Ω² + ρ are positive, ρ = ⟨γ, r⟩;
/// where both are negative, gyroscopic forces stabilise, which the normal form confirms outside the resonances (A. M.
/// Kovalev and A. Ya. Savchenko, Prikl. Mat. Mekh. 39, 1975) and friction destroys.
#[test]
fn rotations_about_a_principal_axis() {
    let mut seen = [0; 3];
    for (a, r) in [
        (["1", "3", "2"], "-1/2"),
        (["1", "2", "3"], "1"),
        (["3", "2", "1"], "1/2"),
        (["3", "5/2", "1"], "-1"),
        (["2", "7/4", "3/2"], "-2"),
    ] {
        let body = Body::parse(&a, &["0", "0", r]).unwrap();
        let [first, second, about, weight] = [a[0], a[1], a[2], r].map(|x| x.parse::<Number>().unwrap().to_f64());
        let rotation = AxisRotation::new(&body, BodyAxis::ALL[2], Sign::Positive).unwrap();
        for spin in 1..40 {
            let omega = dashu_ratio::RBig::from_parts(spin.into(), 8_u8.into());
            let s = f64::from(spin * spin) / 64.0;
            let stiffness = [first, second].map(|moment| (about - moment) * s + weight);
            if stiffness.contains(&0.0) {
                continue;
            }
            let judged = rotation.stability_at_spin(&omega).unwrap();
            let negative = stiffness.iter().filter(|k| **k < 0.0).count();
            assert_eq!(judged.friction.survives, Some(negative == 0), "{s} {judged:?}");
            seen[negative] += 1;
            let expected = match (negative, judged.kind) {
                (0, _) => (NonlinearVerdict::Stable, Reason::Energy),
                (2, LinearType::Elliptic) => (NonlinearVerdict::Stable, Reason::Arnold),
                _ => (NonlinearVerdict::Unstable, Reason::Spectrum),
            };
            assert_eq!((judged.nonlinear.verdict, judged.nonlinear.why), expected, "{a:?} {r} {s} {judged:?}");
            assert!(judged.nonlinear.proved);
        }
    }
    assert!(seen.into_iter().all(|count| count > 5), "{seen:?}");
}
