//! Linear types and verdicts against the eigenvalues of the whole linearisation: on the strata, at every coincidence of
//! their curves, and where l meets a coincidence exactly.

mod whole;

use bifdiag_body::{Body, BodyAxis, Frame, Preset};
use bifdiag_equilibria::critical::{Equilibrium, Multiplicity, RelativeEquilibria};
use bifdiag_equilibria::curves::CriticalSet;
use bifdiag_equilibria::nonlinear::{NonlinearVerdict, Reason};
use bifdiag_equilibria::permanent::{AxisRotation, SpinType, permanent_axis};
use bifdiag_equilibria::stability::{LinearType, LinearTypes};
use bifdiag_numbers::{Number, Sign};
use dashu_ratio::RBig;
use proptest::prelude::*;
use support::property::{Verdict as Held, body_text, holds_for_bodies};
use support::strata::STRATA;

/// A sixfold eigenvalue is known to the sixth root of rounding, relative to the matrix.
const CLEAR: f64 = 1e-2;

/// The real parts of the whole spectrum in the body's units, and the size of the matrix.
fn real_parts(frame: &Frame, gamma: [f64; 3], omega: f64) -> (Vec<f64>, f64) {
    let matrix = whole::matrix(frame, frame.vector_from_body(gamma), omega.abs() / frame.frequency_unit);
    let size = matrix.as_flattened().iter().map(|x| x.abs()).fold(0.0, f64::max);
    let real = whole::spectrum(&matrix).iter().map(|x| x.re * frame.frequency_unit).collect();
    (real, size * frame.frequency_unit)
}

/// What the two pairs say of the type; the second one is zero on a circle or sphere of equilibria.
fn is_of_type(found: &Equilibrium) -> bool {
    let [p, q] = found.eigenvalues.pairs;
    let (real, imaginary) = (|[re, im]: [f64; 2]| re > 0.0 && im == 0.0, |[re, im]: [f64; 2]| re == 0.0 && im > 0.0);
    let zero = |pair: [f64; 2]| pair == [0.0, 0.0];
    let is_set = !matches!(found.multiplicity, Multiplicity::Points(_));
    match found.stability {
        LinearType::Elliptic => imaginary(p) && (if is_set { zero(q) } else { imaginary(q) }),
        LinearType::SaddleCentre => real(p) && imaginary(q) && !is_set,
        LinearType::Saddle => real(p) && (if is_set { zero(q) } else { real(q) }),
        LinearType::Complex => p == q && p[0] > 0.0 && p[1] > 0.0,
        LinearType::DoubleElliptic => p == q && imaginary(p),
        LinearType::DoubleReal => p == q && real(p),
        LinearType::Zero => !real(p) && p[0] == 0.0 && zero(q),
        LinearType::ZeroReal => real(p) && zero(q) && !is_set,
    }
}

fn agrees(frame: &Frame, found: &Equilibrium) -> Held {
    let growth = found.eigenvalues.pairs.iter().map(|pair| pair[0]).fold(0.0, f64::max);
    prop_assert!(is_of_type(found), "{found:?}");
    // An eigenvalue with positive real part means unstable, whatever the other pair does.
    prop_assert_eq!(growth > 0.0, found.nonlinear.why == Reason::Spectrum, "{:?}", found);
    prop_assert_eq!(found.stability.is_unstable(), found.nonlinear.why == Reason::Spectrum, "{:?}", found);
    prop_assert!(growth == 0.0 || found.nonlinear.verdict == NonlinearVerdict::Unstable, "{:?}", found);
    let (real, size) = real_parts(frame, found.gamma, found.omega);
    let largest = real.iter().copied().fold(0.0, f64::max);
    prop_assert!((largest - growth).abs() <= CLEAR * size + found.eigenvalues.error, "{real:?} {found:?}");
    Ok(())
}

fn all_agree(body: &Body, l: &Number) -> Held {
    let frame = body.frame();
    let Ok(equilibria) = RelativeEquilibria::new(body) else { return Ok(()) };
    let Ok(found) = equilibria.at(l) else { return Ok(()) };
    found.list.iter().try_for_each(|point| agrees(&frame, point))
}

/// l of cusps, pitchforks and collisions, rounded, and three others.
fn momenta(body: &Body) -> Vec<Number> {
    let Ok(set) = CriticalSet::new(body.frame()) else { return Vec::new() };
    let unit = set.frame.momentum_unit;
    let ends = set.cusps.iter().map(|cusp| &cusp.point).chain(set.pitchforks.iter().map(|fork| &fork.point));
    let mut momenta: Vec<f64> = ends.map(|point| (2.0 * point.x).sqrt() * unit).collect();
    momenta.extend(LinearTypes::new(body, &set).changes().iter().map(|change| change.l));
    momenta.extend([0.0, 0.4 * unit, 1.7 * unit, 6.0 * unit]);
    momenta.into_iter().filter_map(|l| Number::from_f64(l).ok()).collect()
}

#[test]
fn verdicts_and_types_agree_with_the_whole_spectrum() {
    for stratum in STRATA {
        holds_for_bodies(stratum, 10, |body| momenta(body).iter().try_for_each(|l| all_agree(body, l)));
    }
    for preset in Preset::all() {
        let body = preset.body();
        let simple = ["1/2", "1", "2", "3", "4"].map(|l| l.parse().unwrap());
        for l in momenta(&body).iter().chain(&simple) {
            all_agree(&body, l).unwrap_or_else(|why| panic!("{} l = {}: {why}", body_text(&body), l.text()));
        }
    }
}

/// Bodies whose coincidences lie at rational l: A, r, l, γ there, and what is known of that equilibrium.
/// Moments, centre of mass, l, γ, and what is known of the relative equilibrium there.
type Known = ([&'static str; 3], [&'static str; 3], &'static str, [f64; 3], LinearType, Reason);

const EXACT: [Known; 15] = [
    // c = 0 at the pitchfork of a standing top: b < 0, b = 0, b > 0.
    (["2", "2", "1"], ["1", "0", "0"], "2", [-1.0, 0.0, 0.0], LinearType::ZeroReal, Reason::Spectrum),
    (["5", "3", "6"], ["0", "0", "12"], "12", [0.0, 0.0, -1.0], LinearType::ZeroReal, Reason::Spectrum),
    (["3", "4", "5"], ["0", "0", "8"], "10", [0.0, 0.0, -1.0], LinearType::Zero, Reason::Degenerate),
    (["1", "2", "3"], ["0", "0", "1"], "3", [0.0, 0.0, -1.0], LinearType::Zero, Reason::Energy),
    // At the pitchforks of a hanging one: μ is the largest moment, or the second.
    (["3", "5/2", "2"], ["0", "0", "1"], "2", [0.0, 0.0, 1.0], LinearType::Zero, Reason::Energy),
    (["6", "3", "2"], ["0", "0", "4"], "4", [0.0, 0.0, 1.0], LinearType::Zero, Reason::Degenerate),
    // Lagrange's top: the circle leaves the standing and the hanging rotation, and where both pairs agree.
    (["1", "1", "2"], ["0", "0", "4"], "4", [0.0, 0.0, -1.0], LinearType::Zero, Reason::Energy),
    (["1", "1", "5/4"], ["0", "0", "1/4"], "5/4", [0.0, 0.0, -1.0], LinearType::Zero, Reason::Integral),
    (["5", "5", "1"], ["0", "0", "4"], "1", [0.0, 0.0, 1.0], LinearType::Zero, Reason::Energy),
    (["1", "1", "1/2"], ["0", "0", "1"], "2", [0.0, 0.0, -1.0], LinearType::DoubleElliptic, Reason::Integral),
    // b² = 4c: both ends of complex stretches.
    (["1", "4", "7/4"], ["0", "0", "13"], "7", [0.0, 0.0, -1.0], LinearType::DoubleReal, Reason::Spectrum),
    (["1", "4", "7/4"], ["0", "0", "13"], "3", [0.0, 0.0, -1.0], LinearType::DoubleReal, Reason::Spectrum),
    (["25", "1", "1"], ["0", "0", "1"], "12/5", [0.0, 0.0, -1.0], LinearType::DoubleElliptic, Reason::Resonance11),
    (["25", "1", "1"], ["0", "0", "1"], "2/5", [0.0, 0.0, -1.0], LinearType::DoubleReal, Reason::Spectrum),
    // A cusp of the pair over the second axis, at γ₁ = −1/3.
    (["12", "3", "5"], ["3", "0", "0"], "4", [-1.0 / 3.0, f64::NAN, 0.0], LinearType::Zero, Reason::Degenerate),
];

#[test]
fn coincidences_at_a_rational_momentum_are_judged_exactly() {
    for (a, r, l, gamma, kind, why) in EXACT {
        let body = Body::parse(&a, &r).unwrap();
        let number: Number = l.parse().unwrap();
        all_agree(&body, &number).unwrap();
        let found = RelativeEquilibria::new(&body).unwrap().at(&number).unwrap().list;
        let near = |p: &Equilibrium| (0..3).all(|k| gamma[k].is_nan() || (p.gamma[k] - gamma[k]).abs() < 1e-12);
        let here: Vec<_> = found.iter().filter(|point| near(point)).map(|p| (p.stability, p.nonlinear.why)).collect();
        assert!(!here.is_empty() && here.iter().all(|one| *one == (kind, why)), "{a:?} {l}: {here:?}, {found:?}");
    }
}

#[test]
fn kovalevskaya_at_its_pitchfork_is_unstable() {
    let found =
        RelativeEquilibria::new(&Preset::find("kovalevskaya").unwrap().body()).unwrap().at(&"2".parse().unwrap());
    let standing = found.unwrap().list.into_iter().find(|point| point.gamma[0] == -1.0).unwrap();
    assert_eq!((standing.stability.word(), standing.nonlinear.verdict), ("zero", NonlinearVerdict::Unstable));
    let [[growth, still], zero] = standing.eigenvalues.pairs;
    assert!((growth - 0.5_f64.sqrt()).abs() <= standing.eigenvalues.error && still == 0.0 && zero == [0.0, 0.0]);
}

/// Rotation about a principal axis, at spins that are coincidences too, is judged as the relative equilibrium that it is.
#[test]
fn permanent_rotations_are_judged_as_equilibria() {
    let free = [["2", "2", "1"], ["3", "3", "1"], ["2", "1", "1"], ["1", "2", "2"], ["3", "2", "1"], ["2", "2", "2"]];
    let more = free.map(|a| (a, ["0", "0", "0"]));
    let mut compared = 0;
    for (a, r) in EXACT.map(|(a, r, ..)| (a, r)).into_iter().chain(more) {
        let body = Body::parse(&a, &r).unwrap();
        let equilibria = RelativeEquilibria::new(&body).unwrap();
        let ends = BodyAxis::ALL.into_iter().flat_map(|axis| [(axis, Sign::Negative), (axis, Sign::Positive)]);
        for (axis, sign) in ends {
            let Some(rotation) = AxisRotation::new(&body, axis, sign) else { continue };
            for spin in ["1/4", "1/2", "1", "12/7", "2", "12/5", "3", "4"] {
                let omega = spin.parse::<Number>().unwrap().value().clone();
                let l = Number::from_rational(body.moments()[axis].value() * &omega);
                let list = equilibria.at(&l).unwrap().list;
                let is_here = |point: &&Equilibrium| match point.multiplicity {
                    Multiplicity::Points(_) => point.gamma[axis] == f64::from(sign),
                    Multiplicity::Circle | Multiplicity::Sphere => (point.omega - omega.to_f64().value()).abs() < 1e-12,
                };
                let Some(point) = list.iter().find(is_here) else { continue };
                let judged = rotation.stability_at_spin(&omega).unwrap();
                let place = format!("{a:?} {r:?} {axis:?} {sign:?} {spin}: {point:?}");
                let why = judged.nonlinear.why;
                assert_eq!(judged.kind, point.stability, "{place}");
                assert_eq!((judged.nonlinear.verdict, why), (point.nonlinear.verdict, point.nonlinear.why), "{place}");
                assert_eq!(
                    (judged.friction.survives, judged.friction.growing),
                    (point.friction.survives, point.friction.growing),
                    "{place}"
                );
                let between = rotation.type_at_spin(&omega).unwrap();
                let is_zero = between == SpinType::Zero;
                assert!(is_zero || between.is_elliptic() == (why != Reason::Spectrum), "{place}");
                let is_one = !matches!(point.multiplicity, Multiplicity::Points(_));
                assert_eq!(
                    rotation.multiplicity() == point.multiplicity,
                    is_one || point.multiplicity == Multiplicity::Points(1)
                );
                let (_, growth) = rotation.frequencies_and_growth(&(&omega * &omega));
                compared += 1;
                assert!((why == Reason::Spectrum) == (growth > 0.0), "{place} {growth:e}");
            }
        }
    }
    assert!(compared > 200, "{compared}");
}

/// Without weight rotation about every axis of an eigenspace is steady: of one sphere, of a circle, or alone.
#[test]
fn rotations_without_weight_have_the_types_of_the_whole_spectrum() {
    let moment = || (1..=40_u32).prop_map(|n| RBig::from(n) / RBig::from(8));
    let bodies = ([moment(), moment(), moment()], 0..5_u8).prop_map(|([a, b, c], equal)| match equal {
        0 => [a.clone(), a, c],
        1 => [a, c.clone(), c],
        2 => [a.clone(), b, a],
        3 => [a.clone(), a.clone(), a],
        _ => [a, b, c],
    });
    let directions = [-5..=5_i32, -5..=5, -5..=5].prop_filter("no direction", |up| *up != [0; 3]);
    proptest!(ProptestConfig::with_cases(200), |(a in bodies, up in directions)| {
        let body = Body::new(a.map(Number::from_rational), ["0"; 3].map(|x| x.parse().unwrap())).unwrap();
        let frame = body.frame();
        let axis = permanent_axis(&body, up.map(f64::from)).unwrap();
        for sign in [Sign::Negative, Sign::Positive] {
            let rotation = AxisRotation::about(&body, axis, sign).unwrap();
            let judged = rotation.stability_at_spin(&RBig::ONE).unwrap();
            let (kind, verdict) = (judged.kind, judged.nonlinear.verdict);
            let (_, growth) = rotation.frequencies_and_growth(&RBig::ONE);
            let (real, size) = real_parts(&frame, axis.direction.map(|x| f64::from(sign) * x), 1.0);
            let largest = real.into_iter().fold(0.0, f64::max);
            prop_assert!((largest - growth).abs() <= CLEAR * size, "{largest} {growth}");
            prop_assert_eq!(kind.is_unstable(), growth > 0.0);
            prop_assert_eq!(verdict == NonlinearVerdict::Unstable, growth > 0.0);
            prop_assert!(rotation.changes().is_empty());
            let [x, y, z] = BodyAxis::ALL.map(|k| body.moments()[k].value());
            let own = body.moments()[axis.axis].value();
            let is_middle = [x, y, z].iter().any(|other| *other < own) && [x, y, z].iter().any(|other| *other > own);
            prop_assert_eq!(verdict == NonlinearVerdict::Unstable, is_middle);
        }
    });
}
