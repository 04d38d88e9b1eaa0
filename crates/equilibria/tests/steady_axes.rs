//! All steady axes at one spin: against the relative equilibria at their l, and against a search on the whole sphere.

use bifdiag_body::{Body, Number};
use bifdiag_equilibria::critical::{Equilibrium, Multiplicity, RelativeEquilibria, SteadyFamily};
use bifdiag_equilibria::curves::CurveName;
use bifdiag_equilibria::nonlinear::{Nonlinear, NonlinearVerdict, Reason};
use bifdiag_numbers::vector::{cross, dot, norm, normalised};
use bifdiag_schema::SteadyStart;
use dashu_ratio::RBig;
use proptest::prelude::*;
use support::property::holds_for_bodies;
use support::strata::STRATA;

fn rational(x: f64) -> RBig {
    RBig::try_from(x).unwrap()
}

fn largest(v: [f64; 3]) -> f64 {
    v.into_iter().fold(0.0, |most, x| most.max(x.abs()))
}

/// √(|r|/A), or 1 without weight: the spin at which weight and turning are alike.
fn unit(body: &Body) -> f64 {
    let (a, r) = (largest(body.moments_f64()), largest(body.center_f64()));
    if r > 0.0 { (r / a).sqrt() } else { 1.0 }
}

fn apart(p: [f64; 3], q: [f64; 3]) -> f64 {
    (0..3).map(|k| (p[k] - q[k]).abs()).fold(0.0, f64::max)
}

/// In every stratum: what is listed at a spin is listed at its own l, with the same name, γ, index, type and verdict.
#[test]
fn steady_axes_are_the_relative_equilibria_of_their_momentum() {
    for stratum in STRATA {
        holds_for_bodies(stratum, 4, |body| {
            let prepared = RelativeEquilibria::new(body).unwrap();
            for factor in [0.3, 1.1, 4.0] {
                let omega = factor * unit(body);
                let found = prepared.at_spin(&rational(omega)).unwrap();
                prop_assert!(found.complete && found.list.len() >= usize::from(!body.is_euler()) * 2);
                for axis in &found.list {
                    prop_assert_eq!(axis.omega, omega);
                    let same = prepared.at(&Number::from_f64(axis.l).unwrap()).unwrap();
                    let is_it = |other: &&Equilibrium| {
                        (other.curve, other.multiplicity) == (axis.curve, axis.multiplicity)
                            && apart(other.gamma, axis.gamma) < 1e-6
                    };
                    let Some(other) = same.list.iter().find(is_it) else {
                        return Err(TestCaseError::fail(format!("{axis:?} is not among {same:?}")));
                    };
                    prop_assert_eq!(
                        (other.index, other.stability, other.nonlinear.verdict),
                        (axis.index, axis.stability, axis.nonlinear.verdict)
                    );
                    let size = (axis.l * omega).abs() + norm(body.center_f64());
                    prop_assert!((other.h - axis.h).abs() <= 1e-9 * size, "{:?} {:?}", other, axis);
                    prop_assert!((other.omega / omega - 1.0).abs() < 1e-6, "{:?} {:?}", other, axis);
                }
            }
            Ok(())
        });
    }
}

/// s Aγ + r has no part across γ.
fn across(a: [f64; 3], r: [f64; 3], s: f64, gamma: [f64; 3]) -> [f64; 3] {
    cross(gamma, std::array::from_fn(|k| s * a[k] * gamma[k] + r[k]))
}

/// Where Newton's method on the sphere leads from a direction, if anywhere.
fn descended(a: [f64; 3], r: [f64; 3], s: f64, from: [f64; 3]) -> Option<[f64; 3]> {
    let mut gamma = normalised(from);
    for _ in 0..60 {
        let helper = if gamma[0].abs() < 0.6 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] };
        let e = normalised(cross(gamma, helper));
        let f = cross(gamma, e);
        let force: [f64; 3] = std::array::from_fn(|k| s * a[k] * gamma[k] + r[k]);
        let along = dot(force, gamma);
        let form = |u: [f64; 3], v: [f64; 3]| (0..3).map(|k| s * a[k] * u[k] * v[k]).sum::<f64>() - along * dot(u, v);
        let (p, q) = (dot(force, e), dot(force, f));
        let (m11, m12, m22) = (form(e, e), form(e, f), form(f, f));
        let determinant = m11 * m22 - m12 * m12;
        let step = [(m12 * q - m22 * p) / determinant, (m12 * p - m11 * q) / determinant];
        if !step[0].is_finite() || !step[1].is_finite() {
            return None;
        }
        let length = (step[0] * step[0] + step[1] * step[1]).sqrt();
        let scale = if length > 0.3 { 0.3 / length } else { 1.0 };
        gamma = normalised(std::array::from_fn(|k| gamma[k] + scale * (step[0] * e[k] + step[1] * f[k])));
        if length < 1e-14 {
            break;
        }
    }
    (norm(across(a, r, s, gamma)) < 1e-11 * (s * largest(a) + norm(r))).then_some(gamma)
}

/// Directions spread over the sphere.
fn grid() -> impl Iterator<Item = [f64; 3]> {
    (0..600_u32).map(|k| {
        let z = 1.0 - 2.0 * (f64::from(k) + 0.5) / 600.0;
        let turn = f64::from(k) * 2.399_963_229_728_653;
        let radius = (1.0 - z * z).sqrt();
        [radius * libm::cos(turn), radius * libm::sin(turn), z]
    })
}

/// Whether γ belongs to an entry: a point, or the circle across the two axes with one moment.
fn belongs(body: &Body, entry: &Equilibrium, gamma: [f64; 3]) -> bool {
    match entry.multiplicity {
        Multiplicity::Points(_) => apart(entry.gamma, gamma) < 1e-5,
        Multiplicity::Sphere => true,
        Multiplicity::Circle => {
            let a = body.moments_f64();
            (0..3).filter(|&k| (0..3).all(|j| j == k || a[j] != a[k])).all(|k| (entry.gamma[k] - gamma[k]).abs() < 1e-5)
        }
    }
}

/// Nothing else on the sphere is steady, and of the entries nothing is missed by the search; centres of mass on axes and in
/// planes, equal moments and no weight included.
#[test]
fn a_search_on_the_sphere_finds_the_same_axes() {
    let bodies = [
        (["2", "1.1", "1"], ["0.94868", "0", "0.61623"]),
        (["2", "1", "1.5"], ["0.3", "0.4", "0.5"]),
        (["1.3", "0.7", "1.9"], ["-0.2", "0.1", "0.05"]),
        (["2", "1", "1.5"], ["0", "0.7", "0"]),
        (["1", "2", "3"], ["0", "0", "-1"]),
        (["1", "1", "0.6"], ["0", "0", "1"]),
        (["1", "1", "0.6"], ["0.3", "0.4", "0.2"]),
        (["1", "1", "1"], ["1", "2", "2"]),
        (["1", "2", "2"], ["0.5", "0", "0"]),
        (["1", "2", "3"], ["0", "0", "0"]),
        (["2", "2", "3"], ["0", "0", "0"]),
    ];
    let mut axes = 0;
    for (a, r) in bodies {
        let body = Body::parse(&a, &r).unwrap();
        let prepared = RelativeEquilibria::new(&body).unwrap();
        let (a, r) = (body.moments_f64(), body.center_f64());
        for omega in [0.2, 0.6, 0.9, 1.3, 2.5, 7.0] {
            let found = prepared.at_spin(&rational(omega)).unwrap().list;
            let mut seen = vec![false; found.len()];
            for gamma in grid().filter_map(|from| descended(a, r, omega * omega, from)) {
                let entry = found.iter().position(|entry| belongs(&body, entry, gamma));
                seen[entry.unwrap_or_else(|| panic!("{a:?} {r:?} {omega}: {gamma:?} is missing in {found:?}"))] = true;
            }
            for (entry, seen) in found.iter().zip(seen) {
                let size = omega * omega * largest(a) + norm(r);
                assert!(norm(across(a, r, omega * omega, entry.gamma)) < 1e-12 * size, "{entry:?}");
                // Along a circle Newton's method is singular.
                assert!(seen || entry.multiplicity != Multiplicity::Points(1), "{a:?} {r:?} {omega}: {entry:?}");
            }
            axes += found.len();
        }
    }
    assert!(axes > 200, "{axes}");
}

/// At rest the body hangs or stands; faster, axes come in pairs: at a fold both are one, and at a fork both are on the axis
/// from which they leave.
#[test]
fn axes_appear_in_folds_and_forks() {
    let number = |a: [&str; 3], r: [&str; 3], omega: &str| {
        let body = Body::parse(&a, &r).unwrap();
        let found = RelativeEquilibria::new(&body).unwrap().at_spin(omega.parse::<Number>().unwrap().value()).unwrap();
        (found.list.len(), found.list.iter().filter(|axis| axis.is_fold).count())
    };
    // Ω⁴ = Σ r_k²/(μ − A_k)² is least at μ = 10, where 135²/9³ = 320²/16³, and is 15² + 20² = 5⁴ there.
    let (a, r) = (["1", "2", "26"], ["135", "0", "320"]);
    assert_eq!([number(a, r, "4.99"), number(a, r, "5"), number(a, r, "5.01")], [(2, 0), (3, 1), (4, 0)]);
    // A pair leaves the plane at Ω = 1 with γ = (3, 4, 0)/5.
    let (a, r) = (["1", "2", "3"], ["1.2", "0.8", "0"]);
    let before = number(a, r, "0.999").0;
    assert_eq!([number(a, r, "1").0, number(a, r, "1.001").0], [before, before + 2]);
    assert_eq!(number(["1", "2", "3"], ["1", "1", "1"], "0").0, 2);
    assert_eq!(number(["1", "2", "3"], ["1", "1", "1"], "100").0, 6);
}

/// What is known without the normal form.
fn verdict_text(verdict: Option<(NonlinearVerdict, Reason)>) -> String {
    verdict.map_or_else(
        || "left to the normal form".to_owned(),
        |(verdict, why)| format!("{} {}", verdict.word(), why.word()),
    )
}

/// What a family says of a spin: branch, type and verdict, once for each axis.
fn of_family(family: &SteadyFamily, omega: f64) -> Vec<String> {
    let is_past = |at: &&bifdiag_equilibria::critical::SteadyStretch| at.from.is_none_or(|place| place.omega <= omega);
    let Some(here) = family.stretches.iter().take_while(is_past).last() else { return Vec::new() };
    let count = if family.axes == Multiplicity::Points(2) { 2 } else { 1 };
    vec![format!("{} {} {}", family.branch, here.kind, verdict_text(here.verdict)); count]
}

/// In every stratum, before, between and after all the spins at which something changes: the families have the axes, types
/// and verdicts that are found at that spin alone, and each place on them is a steady rotation.
#[test]
fn families_agree_with_the_axes_at_every_spin() {
    let spins = std::cell::Cell::new(0);
    for stratum in STRATA {
        holds_for_bodies(stratum, 4, |body| {
            let prepared = RelativeEquilibria::new(body).unwrap();
            let families = prepared.families().unwrap();
            let places = families.iter().flat_map(|family| &family.stretches).filter_map(|stretch| stretch.from);
            let mut changes: Vec<f64> = Vec::new();
            for place in places {
                changes.push(place.omega);
                let (a, r, s) = (body.moments_f64(), body.center_f64(), place.omega * place.omega);
                let force = across(a, r, s, place.gamma);
                prop_assert!(norm(force) <= 1e-9 * (s * largest(a) + norm(r)), "{:?} {:?}", place, force);
                let j: f64 = (0..3).map(|k| a[k] * place.gamma[k] * place.gamma[k]).sum();
                prop_assert!((place.l / (j * place.omega) - 1.0).abs() < 1e-9, "{:?}", place);
            }
            changes.sort_by(f64::total_cmp);
            let ends = [
                changes.first().map_or(unit(body), |first| 0.5 * first),
                changes.last().map_or(0.0, |last| 2.0 * last),
            ];
            let between = changes
                .windows(2)
                .filter(|pair| pair[1] > pair[0] * (1.0 + 1e-9))
                .map(|pair| 0.5 * (pair[0] + pair[1]));
            for omega in between.chain(ends).filter(|omega| *omega > 0.0) {
                let mut expected: Vec<String> = prepared
                    .at_spin(&rational(omega))
                    .unwrap()
                    .list
                    .iter()
                    .map(|axis| {
                        let Some(CurveName::Piece { branch, .. }) = axis.curve else { panic!("{axis:?}") };
                        let Nonlinear { verdict, why, near, .. } = axis.nonlinear;
                        format!(
                            "{branch} {} {}",
                            axis.stability,
                            verdict_text(near.is_none().then_some((verdict, why)))
                        )
                    })
                    .collect();
                let mut found: Vec<String> = families.iter().flat_map(|family| of_family(family, omega)).collect();
                if body.is_euler() {
                    // Without weight both ends of an axis are one entry or two.
                    expected.dedup();
                    found.dedup();
                }
                expected.sort();
                found.sort();
                prop_assert_eq!(found, expected, "at {}", omega);
                spins.set(spins.get() + 1);
            }
            Ok(())
        });
    }
    assert!(spins.get() > 200, "{spins:?}");
}

/// The fold at Ω = 5 and the pair that leaves the plane at Ω = 1 of the test above.
#[test]
fn folds_and_forks_are_the_starts_of_families() {
    let starts = |a: [&str; 3], r: [&str; 3]| {
        let body = Body::parse(&a, &r).unwrap();
        let families = RelativeEquilibria::new(&body).unwrap().families().unwrap();
        let start = |family: &SteadyFamily| {
            (family.start, family.stretches[0].from.map_or(0.0, |place| place.omega), family.axes)
        };
        families.iter().map(start).collect::<Vec<_>>()
    };
    let (one, pair) = (Multiplicity::Points(1), Multiplicity::Points(2));
    let found = starts(["1", "2", "26"], ["135", "0", "320"]);
    assert_eq!(
        found[..4],
        [
            (SteadyStart::Rest, 0.0, one),
            (SteadyStart::Fold, 5.0, one),
            (SteadyStart::Fold, 5.0, one),
            (SteadyStart::Rest, 0.0, one)
        ]
    );
    let found = starts(["1", "2", "3"], ["1.2", "0.8", "0"]);
    assert_eq!(found.last(), Some(&(SteadyStart::Fork, 1.0, pair)));
    let lagrange = starts(["1", "1", "2"], ["0", "0", "1"]);
    assert_eq!(lagrange.last(), Some(&(SteadyStart::Fork, 1.0, Multiplicity::Circle)));
}
